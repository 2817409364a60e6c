// Calipers on the scan: their menu, and who hears of them.
#include "caliper_words.h"
#include "main_window_parts.h"

namespace ew::ui {

bool MainWindow::Parts::editsCalipers() const {
  const measurement::CaliperDrawing& drawing = calipers.drawing();
  if (staged || !(drawing.canUndo() || drawing.canRedo())) return false;
  return !isAuthor() || caliperLayer->hasFocus();
}

void MainWindow::addMeasureMenu(QMenu& measure) {
  Parts& p = *parts_;
  int key = Qt::Key_4;
  for (const measurement::CaliperKind kind : measurement::drawnKinds()) {
    QAction* action = addMenuAction(measure, CaliperWords::nameOf(kind), {QKeySequence(key++)}, [this, kind] {
      if (parts_->pages->currentWidget() == parts_->workspacePage && parts_->keepsScan()) parts_->calipers.take(kind);
      Q_EMIT parts_->calipers.changed();  // an action checks itself, whatever came of it
    });
    action->setCheckable(true);
    p.caliperActions.push_back(action);
  }
  measure.addSeparator();
  p.followEdgesAction = addMenuAction(measure, tr("Outlines follow edges"), {QKeySequence(Qt::Key_0)},
                                      [this] { parts_->calipers.setFollowsEdges(parts_->followEdgesAction->isChecked()); });
  p.followEdgesAction->setCheckable(true);
  measure.addSeparator();
  addMenuAction(measure, tr("Delete all measurements"), {QKeySequence(QStringLiteral("Ctrl+Del"))},
                [this] { parts_->calipers.change([](measurement::CaliperDrawing& drawing) { drawing.clear(); }); });
}

void MainWindow::connectCalipers() {
  Parts& p = *parts_;
  const auto show = [this] {
    Parts& parts = *parts_;
    const auto& kinds = measurement::drawnKinds();
    const auto tool = parts.calipers.drawing().tool();
    for (std::size_t n = 0; n < kinds.size(); ++n) parts.caliperActions[n]->setChecked(tool == kinds[n]);
    parts.followEdgesAction->setChecked(parts.calipers.followsEdges());
    if (tool) parts.console->showPage(parts.measurePage);
    showHistory();
  };
  connect(&p.calipers, &Calipers::changed, this, show);
  connect(&p.calipers, &Calipers::said, p.scanView, &ScanView::say);
  connect(&p.calipers, &Calipers::pauseAsked, this, [this] {
    parts_->replayBar->setPlaying(false);
    parts_->cineBar->setPlaying(false);
  });
  connect(p.caliperLayer, &CaliperLayer::focusChanged, this, &MainWindow::showHistory);
  show();
}

}  // namespace ew::ui
