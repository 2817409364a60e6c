#include "window/features/zoom_and_wide.h"

#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {

void ZoomAndWide::addActions(QMenu& console) {
  Commands& commands = *parts_.commands;
  boxZoom_ =
      commands.add(console, "zoom.box", [this] { boxZoom_->setChecked(parts_.workspaces->showsScan() && parts_.boxZoom->toggle()); });
  boxZoom_->setCheckable(true);
  commands.add(console, "zoom.whole", [this] { parts_.session.console().setDetail(1.0, {}); });
  wide_ = commands.add(console, "wide", [this] {
    if (parts_.workspaces->showsScan()) parts_.wide.toggle();
    showState();
  });
  wide_->setCheckable(true);
}

void ZoomAndWide::connectParts() {
  WindowParts& p = parts_;
  connect(p.boxZoom, &BoxZoom::changed, this, [this] { boxZoom_->setChecked(parts_.boxZoom->isDrawing()); });
  connect(p.boxZoom, &BoxZoom::said, p.scanView, &ScanView::say);
  connect(&p.wide, &WideScan::said, p.scanView, &ScanView::say);
  connect(&p.wide, &WideScan::changed, this, &ZoomAndWide::showState);
  connect(p.console, &ConsolePanel::boxZoomAsked, boxZoom_, &QAction::trigger);
  connect(p.console, &ConsolePanel::wideAsked, wide_, &QAction::trigger);
}

void ZoomAndWide::showState() {
  const WideScan::State state = parts_.wide.state();
  wide_->setChecked(state == WideScan::State::growing || state == WideScan::State::kept);
}

}  // namespace ew::ui
