#pragma once

#include <QWidget>
#include <map>
#include <string>

class QTabWidget;
class QToolButton;
class QVBoxLayout;

namespace ew::ui {

/// The column of panels at the left: the tabs of the workspace in front.
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
  /// Whether the column is one of several that take turns: a single panel then needs no tab of its own.
  void setSharesColumn(bool shares);
  /// Of the panel when there is one alone; empty: there are several.
  [[nodiscard]] QString titleOfOnly() const;
  /// Somebody wants a panel to be seen.
  void ask() { Q_EMIT asked(); }
  /// Deletes all panels.
  void clear();

 Q_SIGNALS:
  void changed();      ///< another panel is in front
  void tabsChanged();  ///< a workspace has other tabs than before
  void asked();        ///< a panel is wanted in front of whatever takes turns with the column

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showTabBars();
  /// Where not all tabs have room a button beside them lists them.
  void offerAll(QTabWidget& tabs);
  [[nodiscard]] QToolButton* makeList(QTabWidget& tabs);
  [[nodiscard]] static int shownTabs(const QTabWidget& tabs);
  std::map<std::string, QTabWidget*> tabs_;
  std::map<const QTabWidget*, QToolButton*> lists_;  ///< of the tabs, shown or not
  std::string inFront_;
  int tabsWidth_px_ = 0;
  QVBoxLayout* rows_ = nullptr;
  bool sharesColumn_ = false;
};

}  // namespace ew::ui
