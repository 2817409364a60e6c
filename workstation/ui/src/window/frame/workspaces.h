#pragma once

#include <QAction>
#include <QActionGroup>
#include <memory>
#include <string>
#include <vector>

#include "ew/sdk/workspaces.h"
#include "window/frame/feature.h"

class QMenu;

namespace ew::sdk {
class PanelDocument;
}

namespace ew::ui {

inline const std::string kExplore = "explore";
inline const std::string kAuthor = "author";

/// What is in front: the page of cases or the work, which workspace, and whether a panel's stage stands in place of the views.
class Workspaces final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addMenu(QMenu& view);  ///< Explore, Author; later those of plugins
  void connectParts() override;
  void refresh() override;

  void showStartPage();
  void backToWork();  ///< from the start page to what is open
  /// "explore", "author" or one of a plugin's; any other changes nothing.
  void show(const std::string& id);
  /// One of a plugin's. @return false: its name is taken, or none
  [[nodiscard]] bool add(const sdk::Workspace& workspace);
  void showPanels();  ///< of the workspace in front, when it has any
  /// Puts the stage of the panel in front in place of the views, or the views back.
  void showStage();

  [[nodiscard]] const std::string& current() const { return current_; }
  [[nodiscard]] bool isAuthor() const { return current_ == kAuthor; }
  /// Of a plugin, when such a one is in front.
  [[nodiscard]] const sdk::Workspace* own() const;
  [[nodiscard]] bool hasPanels() const;
  [[nodiscard]] bool keepsBody() const { return own() == nullptr || own()->keepsBody; }
  [[nodiscard]] bool keepsScan() const { return own() == nullptr || own()->keepsScan; }
  [[nodiscard]] bool isStaged() const { return isStaged_; }
  [[nodiscard]] bool isAtStart() const;  ///< the page of cases is shown
  [[nodiscard]] bool isAtWork() const;   ///< the work is shown
  /// Whether the scan has a place in what is in front; a stage may lie over it.
  [[nodiscard]] bool showsScan() const { return isAtWork() && keepsScan(); }
  [[nodiscard]] std::shared_ptr<sdk::PanelDocument> panelDocument() const;  ///< of the stage that is shown
  [[nodiscard]] QString authorText() const;                                 ///< what the entry of Author says

 Q_SIGNALS:
  void shown();        ///< another workspace came to the front
  void pageChanged();  ///< the page of cases or the work came to the front, or the page of cases is wanted as it is now

 private:
  struct Own {
    sdk::Workspace what;
    QAction* action;
  };
  std::string current_ = kExplore;
  bool isStaged_ = false;
  QMenu* menu_ = nullptr;
  QAction* explore_ = nullptr;
  QAction* author_ = nullptr;
  QAction* behind_ = nullptr;  ///< in the menu, behind the workspaces
  QActionGroup* group_ = nullptr;
  std::vector<Own> own_;
};

}  // namespace ew::ui
