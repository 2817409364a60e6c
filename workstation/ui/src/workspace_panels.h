#pragma once

#include <QWidget>
#include <map>
#include <string>

class QTabWidget;
class QVBoxLayout;

namespace ew::ui {

/// The column of panels at the left: the tabs of the workspace in front, and below them room for the cards of running work, so that they
/// cover none of a panel's buttons.
class WorkspacePanels final : public QWidget {
  Q_OBJECT

 public:
  explicit WorkspacePanels(QWidget* parent = nullptr);

  /// The tabs of a workspace, made when they are first asked for.
  [[nodiscard]] QTabWidget& of(const std::string& workspace);
  /// Whether a workspace has a tab that is shown.
  [[nodiscard]] bool has(const std::string& workspace) const;
  void setTabShown(QTabWidget& tabs, int tab, bool shown);
  [[nodiscard]] const std::map<std::string, QTabWidget*>& all() const { return tabs_; }
  /// Brings a workspace's tabs to the front. Whether the column is seen is up to who holds it.
  void show(const std::string& workspace);
  [[nodiscard]] QTabWidget* inFront() const;  ///< null: the workspace has no panels
  void setTabsWidth(int least_px);
  void setCardRoom(int height_px);
  /// Deletes all panels.
  void clear();

 Q_SIGNALS:
  void changed();      ///< another panel is in front
  void tabsChanged();  ///< a workspace has other tabs than before

 private:
  std::map<std::string, QTabWidget*> tabs_;
  std::string inFront_;
  int tabsWidth_px_ = 0;
  QVBoxLayout* rows_ = nullptr;
  QWidget* cardRoom_ = nullptr;
};

}  // namespace ew::ui
