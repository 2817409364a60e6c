#include "workspace_panels.h"

#include <QTabWidget>
#include <QVBoxLayout>
#include <utility>

#include "words.h"

namespace ew::ui {

WorkspacePanels::WorkspacePanels(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("authorColumn"));
  setAttribute(Qt::WA_StyledBackground);
  rows_ = new QVBoxLayout(this);
  rows_->setContentsMargins(0, 0, 1, 0);  // the line beside it
  rows_->setSpacing(0);
  cardRoom_ = new QWidget;
  cardRoom_->setFixedHeight(0);
  rows_->addWidget(cardRoom_);
}

QTabWidget& WorkspacePanels::of(const std::string& workspace) {
  if (const auto found = tabs_.find(workspace); found != tabs_.end()) return *found->second;
  auto* tabs = new QTabWidget;
  tabs->setObjectName(words(workspace) + QStringLiteral("Panel"));
  tabs->setProperty("panels", true);
  tabs->setAttribute(Qt::WA_StyledBackground);
  tabs->setDocumentMode(true);
  tabs->setMinimumWidth(tabsWidth_px_);
  tabs->setVisible(workspace == inFront_);
  rows_->insertWidget(0, tabs, 1);
  connect(tabs, &QTabWidget::currentChanged, this, &WorkspacePanels::changed);
  tabs_[workspace] = tabs;
  return *tabs;
}

bool WorkspacePanels::has(const std::string& workspace) const {
  const auto found = tabs_.find(workspace);
  if (found == tabs_.end()) return false;
  for (int tab = 0; tab < found->second->count(); ++tab)
    if (found->second->isTabVisible(tab)) return true;
  return false;
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

void WorkspacePanels::setCardRoom(int height_px) { cardRoom_->setFixedHeight(height_px); }

void WorkspacePanels::clear() {
  for (const auto& [id, tabs] : std::exchange(tabs_, {})) delete tabs;
}

}  // namespace ew::ui
