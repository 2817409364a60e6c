#include "window/frame/columns.h"

#include <QMenu>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "keys/key_tips.h"
#include "window/frame/column_tabs.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"
#include "window/layout/window_layout.h"

namespace ew::ui {
namespace {

constexpr int kComeBack_px = 20;            ///< what leads from the scan alone to the other columns
constexpr int kExplorePanelWidth_px = 304;  ///< beside a scan that is worked with, which wants the room
constexpr int kStagedPanelWidth_px = 296;   ///< beside a stage, which has columns of its own

}  // namespace

void Columns::makeHandles() {
  WindowParts& p = parts_;
  const std::pair<Column, QWidget*> columns[] = {{Column::panels, p.panels}, {Column::body, p.body}, {Column::console, p.console}};
  for (const auto& [column, widget] : columns) {
    auto* tabs = new ColumnTabs;
    static_cast<QVBoxLayout*>(widget->layout())->insertWidget(0, tabs);
    connect(tabs, &ColumnTabs::asked, this, [this](Column which) {
      // Later: the bar that was pressed is hidden by it.
      QMetaObject::invokeMethod(
          this, [this, which] { show(which); }, Qt::QueuedConnection);
    });
    tabs_.emplace_back(column, tabs);
  }
  comeBack_ = new QPushButton(QStringLiteral("\u25c2"));
  comeBack_->setObjectName(QStringLiteral("showColumns"));
  comeBack_->setAccessibleName(tr("Show the console and the other columns"));
  comeBack_->setToolTip(tipWithKeys(tr("Show the console and the other columns (%1)"), "scanOnly"));
  comeBack_->setFocusPolicy(Qt::TabFocus);
  setLook(comeBack_, Look::edge);
  comeBack_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  holdFixedWidth(*comeBack_, kComeBack_px);
  comeBack_->hide();
  connect(comeBack_, &QPushButton::clicked, this, [this] { setScanOnly(false); });
  p.work->addWidget(comeBack_);
}

void Columns::addMenu(QMenu& view) {
  const auto add = [&](const char* command, Column which) {
    parts_.commands->add(view, command, [this, which] {
      if (!parts_.workspaces->isAtWork()) parts_.workspaces->backToWork();
      show(which);
    });
  };
  add("column.panels", Column::panels);
  add("column.body", Column::body);
  add("column.console", Column::console);
  parts_.commands->add(view, "column.next", [this] { showNext(); });
  scanOnly_ = parts_.commands->add(view, "scanOnly", [this] {
    const bool isThere = parts_.workspaces->isAtWork() && parts_.workspaces->current() == kExplore;
    setScanOnly(isThere && !isScanOnly());
  });
  scanOnly_->setCheckable(true);
}

void Columns::connectParts() {
  connect(parts_.messages, &MessageBar::rearranged, this, &Columns::placeMessages);
  connect(parts_.panels, &WorkspacePanels::asked, this, [this] {
    if (asked_ && *asked_ != Column::panels) show(Column::panels);
    asked_ = Column::panels;
  });
}

LayoutRequest Columns::request() const {
  const WindowParts& p = parts_;
  const Workspaces& workspaces = *p.workspaces;
  LayoutRequest asked;
  asked.width_px = p.window.width();
  asked.height_px = p.window.height() - p.topBar->height() - p.status->height();
  asked.textScale = textSize_percent() / 100.0;
  asked.hasPanels = workspaces.hasPanels();
  asked.hasBody = workspaces.keepsBody();
  asked.hasScan = workspaces.keepsScan();
  asked.hasConsole = workspaces.own() == nullptr || workspaces.own()->keepsConsole;
  asked.panel_px = workspaces.isStaged() ? kStagedPanelWidth_px : workspaces.current() == kExplore ? kExplorePanelWidth_px : kPanelWidth_px;
  asked.isForScanning = workspaces.current() == kExplore;
  asked.isStaged = workspaces.isStaged();
  asked.isScanOnly = isScanOnly();
  asked.front = asked_;
  return asked;
}

void Columns::show() {
  WindowParts& p = parts_;
  const WindowLayout layout = layoutOf(request());
  const bool showsScan = !p.workspaces->isStaged() && p.workspaces->keepsScan();
  const std::pair<QWidget*, bool> columns[] = {
      {p.panels, layout.showsPanels}, {p.body, layout.showsBody}, {p.console, layout.showsConsole}, {p.imageGrid, showsScan}};
  // What goes goes first: the window must not be asked for more room than it has.
  for (const auto& [column, isShown] : columns)
    if (!isShown) column->hide();
  p.panels->setTabsWidth(layout.panel_px);
  p.console->setFixedWidth(layout.console_px);
  p.console->setShort(layout.isConsoleShort);
  const int side = layout.isConsoleAtLeft ? 0 : 1;
  if (p.work->indexOf(p.console) != side) {
    p.work->removeWidget(p.console);
    p.work->insertWidget(side, p.console);
    p.console->setProperty("atLeft", layout.isConsoleAtLeft);
    p.console->style()->unpolish(p.console);
    p.console->style()->polish(p.console);
  }
  for (const auto& [column, isShown] : columns)
    if (isShown) column->show();
  comeBack_->setVisible(isScanOnly() && !p.workspaces->isStaged());
  showTabs(layout);
  p.viewColumns->follow(layout, showsScan, p.workspaces->isStaged());
  placeMessages();
}

void Columns::showTabs(const WindowLayout& layout) {
  WindowParts& p = parts_;
  p.panels->setSharesColumn(layout.tabs.size() > 1);
  const QString only = p.panels->titleOfOnly();
  std::vector<ColumnTabs::Tab> tabs;
  for (const Column each : layout.tabs) {
    switch (each) {
      case Column::panels:
        tabs.push_back({each,
                        !only.isEmpty()            ? only
                        : p.workspaces->isAuthor() ? p.workspaces->authorText()
                                                   : tr("Panels"),
                        tr("What is worked through or edited")});
        break;
      case Column::body:
        tabs.push_back({each, tr("Body"), tr("The probe on the body, and what is known of the case")});
        break;
      case Column::console:
        tabs.push_back({each, tr("Console"), tr("Gain, depth, transducer, freeze, measure")});
        break;
    }
  }
  // A column that takes no turns has nothing to lead to.
  for (const auto& [column, bar] : tabs_) {
    const bool takesTurns = std::find(layout.tabs.begin(), layout.tabs.end(), column) != layout.tabs.end();
    bar->showTabs(takesTurns ? tabs : std::vector<ColumnTabs::Tab>(), layout.front);
  }
}

void Columns::show(Column column) {
  asked_ = column;
  parts_.viewColumns->setScanOnly(false);
  scanOnly_->setChecked(false);
  show();
}

void Columns::showNext() {
  const WindowLayout layout = layoutOf(request());
  if (layout.tabs.size() < 2) return;
  const auto at = std::find(layout.tabs.begin(), layout.tabs.end(), layout.front);
  show(at + 1 != layout.tabs.end() ? *(at + 1) : layout.tabs.front());
}

void Columns::setScanOnly(bool scanOnly) {
  scanOnly_->setChecked(scanOnly);
  if (scanOnly == isScanOnly()) return;
  parts_.viewColumns->setScanOnly(scanOnly);
  show();
}

bool Columns::isScanOnly() const { return parts_.viewColumns->isScanOnly(); }

void Columns::placeMessages() {
  WindowParts& p = parts_;
  const bool isOverScan = p.workspaces->isAtWork() && p.imageGrid->isVisibleTo(p.pages);
  QWidget* below = isOverScan                                                   ? static_cast<QWidget*>(p.imageGrid)
                   : p.workspaces->isStaged() && p.stages->isVisibleTo(p.pages) ? static_cast<QWidget*>(p.stages)
                                                                                : p.pages;
  QRect room(below->mapTo(p.central, QPoint(0, 0)), below->size());
  // Of more than one line it would lie on the button above the sliders.
  if (isOverScan)
    for (const auto* reset : p.imageGrid->findChildren<QPushButton*>(QStringLiteral("dgcReset")))
      if (reset->isVisible()) room.setLeft(std::max(room.left(), reset->mapTo(p.central, QPoint(reset->width(), 0)).x() + 8));
  const int height_px = std::min(p.messages->heightFor(room.width()), room.height());
  p.messages->setGeometry(room.left(), isOverScan ? room.top() : room.bottom() + 1 - height_px, room.width(), height_px);
  p.messages->raise();
}

}  // namespace ew::ui
