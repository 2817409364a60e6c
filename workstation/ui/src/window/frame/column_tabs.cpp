#include "window/frame/column_tabs.h"

#include <QSignalBlocker>

namespace ew::ui {

ColumnTabs::ColumnTabs(QWidget* parent) : QTabBar(parent) {
  setObjectName(QStringLiteral("columnTabs"));
  setAccessibleName(tr("Columns beside the scan"));
  setDrawBase(false);
  setExpanding(true);
  setElideMode(Qt::ElideNone);
  setUsesScrollButtons(false);
  setFocusPolicy(Qt::TabFocus);  // a click must not take the arrow keys away from the probe
  connect(this, &QTabBar::currentChanged, this, [this](int index) {
    if (index >= 0 && index < static_cast<int>(tabs_.size())) Q_EMIT asked(tabs_[static_cast<std::size_t>(index)].column);
  });
  hide();
}

void ColumnTabs::showTabs(const std::vector<Tab>& tabs, Column front) {
  const QSignalBlocker quiet(this);
  if (tabs != tabs_) {
    while (count() > 0) removeTab(count() - 1);
    tabs_ = tabs;
    for (const Tab& each : tabs_) setTabToolTip(addTab(each.title), each.tip);
  }
  for (std::size_t i = 0; i < tabs_.size(); ++i)
    if (tabs_[i].column == front) setCurrentIndex(static_cast<int>(i));
  setVisible(tabs_.size() > 1);
}

}  // namespace ew::ui
