#include "plugins/workspace_panels.h"

#include <QAction>
#include <QEvent>
#include <QMenu>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "ew/widgets/look.h"
#include "ew/widgets/words.h"

namespace ew::ui {

WorkspacePanels::WorkspacePanels(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("authorColumn"));
  setAttribute(Qt::WA_StyledBackground);
  rows_ = new QVBoxLayout(this);
  rows_->setContentsMargins(0, 0, 1, 0);  // the line beside it
  rows_->setSpacing(0);
}

QTabWidget& WorkspacePanels::of(const std::string& workspace) {
  if (const auto found = tabs_.find(workspace); found != tabs_.end()) return *found->second;
  auto* tabs = new QTabWidget;
  tabs->setObjectName(words(workspace) + QStringLiteral("Panel"));
  setLook(tabs, Look::panels);
  tabs->setAttribute(Qt::WA_StyledBackground);
  tabs->setDocumentMode(true);
  tabs->setMinimumWidth(tabsWidth_px_);
  tabs->setVisible(workspace == inFront_);
  rows_->addWidget(tabs, 1);
  connect(tabs, &QTabWidget::currentChanged, this, &WorkspacePanels::changed);
  tabs_[workspace] = tabs;
  lists_[tabs] = makeList(*tabs);
  tabs->installEventFilter(this);
  return *tabs;
}

QToolButton* WorkspacePanels::makeList(QTabWidget& tabs) {
  auto* list = new QToolButton(&tabs);
  list->setObjectName(QStringLiteral("allPanels"));
  list->setArrowType(Qt::DownArrow);
  list->setPopupMode(QToolButton::InstantPopup);
  list->setToolTip(tr("All panels"));
  list->setAccessibleName(list->toolTip());
  auto* menu = new QMenu(list);
  list->setMenu(menu);
  connect(menu, &QMenu::aboutToShow, &tabs, [&tabs, menu] {
    menu->clear();
    for (int tab = 0; tab < tabs.count(); ++tab) {
      if (!tabs.isTabVisible(tab)) continue;
      QAction* action = menu->addAction(tabs.tabText(tab), &tabs, [&tabs, tab] { tabs.setCurrentIndex(tab); });
      action->setCheckable(true);
      action->setChecked(tab == tabs.currentIndex());
    }
  });
  list->hide();
  return list;
}

void WorkspacePanels::offerAll(QTabWidget& tabs) {
  const auto found = lists_.find(&tabs);
  if (found == lists_.end()) return;
  QToolButton* list = found->second;
  const bool isWanted = shownTabs(tabs) > 1 && tabs.tabBar()->sizeHint().width() > tabs.width();
  if (isWanted == (tabs.cornerWidget(Qt::TopRightCorner) == list)) return;
  tabs.setCornerWidget(isWanted ? list : nullptr, Qt::TopRightCorner);
  list->setVisible(isWanted);
}

bool WorkspacePanels::eventFilter(QObject* watched, QEvent* event) {
  const bool isOther = event->type() == QEvent::Resize || event->type() == QEvent::Show || event->type() == QEvent::LayoutRequest;
  if (auto* tabs = isOther ? qobject_cast<QTabWidget*>(watched) : nullptr; tabs != nullptr) offerAll(*tabs);
  return QWidget::eventFilter(watched, event);
}

bool WorkspacePanels::has(const std::string& workspace) const {
  const auto found = tabs_.find(workspace);
  return found != tabs_.end() && shownTabs(*found->second) > 0;
}

void WorkspacePanels::setTabShown(QTabWidget& tabs, int tab, bool shown) {
  if (tabs.isTabVisible(tab) == shown) return;
  tabs.setTabVisible(tab, shown);
  if (shown && !tabs.isTabVisible(tabs.currentIndex())) tabs.setCurrentIndex(tab);
  Q_EMIT tabsChanged();
}

void WorkspacePanels::show(const std::string& workspace) {
  inFront_ = workspace;
  for (const auto& [id, tabs] : tabs_) tabs->setVisible(id == workspace);
}

QTabWidget* WorkspacePanels::inFront() const {
  const auto found = tabs_.find(inFront_);
  return found != tabs_.end() ? found->second : nullptr;
}

void WorkspacePanels::setTabsWidth(int least_px) {
  tabsWidth_px_ = least_px;
  for (const auto& [id, tabs] : tabs_) tabs->setMinimumWidth(least_px);
}

int WorkspacePanels::shownTabs(const QTabWidget& tabs) {
  int shown = 0;
  for (int tab = 0; tab < tabs.count(); ++tab) shown += tabs.isTabVisible(tab) ? 1 : 0;
  return shown;
}

QString WorkspacePanels::titleOfOnly() const {
  const QTabWidget* tabs = inFront();
  if (tabs == nullptr || shownTabs(*tabs) != 1) return {};
  for (int tab = 0; tab < tabs->count(); ++tab)
    if (tabs->isTabVisible(tab)) return tabs->tabText(tab);
  return {};
}

void WorkspacePanels::setSharesColumn(bool shares) {
  sharesColumn_ = shares;
  showTabBars();
}

void WorkspacePanels::showTabBars() {
  for (const auto& [id, tabs] : tabs_) tabs->tabBar()->setVisible(!sharesColumn_ || shownTabs(*tabs) > 1);
}

void WorkspacePanels::clear() {
  lists_.clear();
  for (const auto& [id, tabs] : std::exchange(tabs_, {})) delete tabs;
}

}  // namespace ew::ui
