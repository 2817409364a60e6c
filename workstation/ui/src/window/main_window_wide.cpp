// Box zoom and the wide image: their actions, and who hears of them.
#include "window/main_window_parts.h"

namespace ew::ui {

void MainWindow::addZoomAndWideActions(QMenu& scan) {
  Parts& p = *parts_;
  const auto isThere = [this] { return parts_->pages->currentWidget() == parts_->workspacePage && parts_->keepsScan(); };
  p.boxZoomAction =
      addMenuAction(scan, "zoom.box", [this, isThere] { parts_->boxZoomAction->setChecked(isThere() && parts_->boxZoom->toggle()); });
  p.boxZoomAction->setCheckable(true);
  p.wholeImageAction = addMenuAction(scan, "zoom.whole", [this] { parts_->session.setDetail(1.0, {}); });
  p.wideAction = addMenuAction(scan, "wide", [this, isThere] {
    if (isThere()) parts_->wide.toggle();
    showWideState();
  });
  p.wideAction->setCheckable(true);
}

void MainWindow::connectZoomAndWide() {
  Parts& p = *parts_;
  connect(p.boxZoom, &BoxZoom::changed, this, [this] { parts_->boxZoomAction->setChecked(parts_->boxZoom->isDrawing()); });
  connect(p.boxZoom, &BoxZoom::said, p.scanView, &ScanView::say);
  connect(&p.wide, &WideScan::said, p.scanView, &ScanView::say);
  connect(&p.wide, &WideScan::changed, this, &MainWindow::showWideState);
  connect(p.console, &ConsolePanel::boxZoomAsked, p.boxZoomAction, &QAction::trigger);
  connect(p.console, &ConsolePanel::wideAsked, p.wideAction, &QAction::trigger);
}

void MainWindow::showWideState() {
  const WideScan::State state = parts_->wide.state();
  parts_->wideAction->setChecked(state == WideScan::State::growing || state == WideScan::State::kept);
}

void MainWindow::sayWhyRefused() {
  Parts& p = *parts_;
  const QString freeze = p.keys.words("freeze");
  p.scanView->say(p.session.wide() != nullptr
                      ? tr("The wide image is frozen, and made of images that are done: it can be magnified, measured and saved. "
                           "%1 ends it.")
                            .arg(freeze)
                      : tr("The image is frozen, and this needs new echoes: %1 lets it run. Grey map, dynamic range, zoom and "
                           "inversion can be changed now.")
                            .arg(freeze));
}

}  // namespace ew::ui
