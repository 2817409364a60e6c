#pragma once

#include <QTranslator>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew {
struct Thrown;
}

namespace ew::door {
struct PluginStatus;
}

namespace ew::sdk {
struct MenuEntry;
}

namespace ew::ui {

enum class Loss;

/// Plugins in the window: their words, workspaces, panels and entries of menus, and what they throw.
class PluginHosting final : public Feature {
  Q_OBJECT

 public:
  /// An entry of a menu that a plugin brought.
  struct Tool {
    QAction* action;
    std::string workspace;  ///< in which it acts; empty: in all
  };

  using Feature::Feature;
  ~PluginHosting() override;

  void setToolsMenu(QMenu& tools);
  void setFileMenu(QMenu& file) { file_ = &file; }
  void connectParts() override;
  void refresh() override;
  void holdUnsavedWork(UnsavedWork& list) override;

  /// Finds and opens the plugins; their panels become tabs of their workspaces.
  void open();
  [[nodiscard]] const std::vector<Tool>& tools() const { return tools_; }

 private:
  void loadWordsOf(const door::PluginStatus& plugin);
  [[nodiscard]] std::shared_ptr<void> addTool(const sdk::MenuEntry& entry, std::function<void()> run);
  /// Says what a handler of an event let through, and of whom: of the plugin whose panel `receiver` is a part of, or of the program.
  void showThrown(const QObject* receiver, const Thrown& thrown);
  [[nodiscard]] bool mayLeavePanels();
  [[nodiscard]] bool mayLeave(Loss loss, const QString& next);

  QMenu* toolsMenu_ = nullptr;
  QMenu* file_ = nullptr;
  std::vector<Tool> tools_;
  std::vector<std::unique_ptr<QTranslator>> words_;
};

}  // namespace ew::ui
