// Calipers on the scan and the worksheets they fill: their menu, and who hears of them.
#include <QDateTime>
#include <QMessageBox>
#include <algorithm>

#include "caliper_words.h"
#include "main_window_parts.h"
#include "save_file.h"
#include "words.h"
#include "worksheet_file.h"
#include "worksheet_words.h"

namespace ew::ui {
namespace {

const auto kWorksheet = QStringLiteral("worksheet");

}  // namespace

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
  addMenuAction(measure, tr("&Worksheet…"), {QKeySequence(QStringLiteral("Shift+F10"))}, [this] { showWorksheet(); });
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
  connect(&p.worksheets, &Worksheets::said, p.scanView, &ScanView::say);
  connect(p.measurePage, &MeasurePage::worksheetAsked, this, &MainWindow::showWorksheet);
  connect(p.caliperLayer, &CaliperLayer::focusChanged, this, &MainWindow::showHistory);
  show();
}

void MainWindow::showWorksheet() {
  Parts& p = *parts_;
  if (p.worksheets.current() == nullptr) {
    p.console->showPage(p.measurePage);
    p.scanView->say(tr("Choose a worksheet on the page of measurements first."));
    return;
  }
  if (p.worksheet.isNull()) {
    p.worksheet = new WorksheetDialog(p.worksheets, this);
    p.worksheet->setAttribute(Qt::WA_DeleteOnClose);
    connect(p.worksheet, &WorksheetDialog::saveAsked, this, &MainWindow::saveWorksheet);
    // Beside the scan, over body and case: the calipers must be reached while it is open.
    const QPoint corner = p.scanView->mapToGlobal(QPoint(0, 0));
    p.worksheet->move(std::max(mapToGlobal(QPoint(8, 0)).x(), corner.x() - p.worksheet->width() - 8), corner.y() + 8);
  }
  p.worksheet->show();
  p.worksheet->raise();
  p.worksheet->activateWindow();
}

bool MainWindow::saveWorksheet() {
  Parts& p = *parts_;
  const measurement::Examination* examination = p.worksheets.current();
  if (examination == nullptr || !p.session.subject()) return false;
  const QString proposal = QString::fromStdString(examination->package().id);
  const QString file = askSaveFile(this, {tr("Save the worksheet"),
                                          proposal + QStringLiteral(".pdf"),
                                          tr("Worksheets (*.pdf *.csv *.json)"),
                                          {QStringLiteral(".pdf"), QStringLiteral(".csv"), QStringLiteral(".json")}});
  if (file.isEmpty()) return false;
  const auto written = saveTogether({pathOf(file)}, [&](const OutputSet& outputs) {
    return writeWorksheet(examination->worksheet(), words(p.session.subject()->title), QDateTime::currentDateTime(),
                          outputs.staged(pathOf(file)));
  });
  if (!written) {
    p.messages->showError(written.error(), kWorksheet);
    return false;
  }
  p.worksheets.setSaved();
  p.messages->showNote(tr("Saved to %1.").arg(file), kWorksheet);
  return true;
}

bool MainWindow::mayLeaveWorksheet(const QString& next) {
  Parts& p = *parts_;
  while (const measurement::Examination* unsaved = p.worksheets.unsaved()) {
    QMessageBox question(this);
    question.setObjectName(QStringLiteral("unsavedWorksheetQuestion"));
    question.setIcon(QMessageBox::NoIcon);
    question.setText(tr("The worksheet '%1' is not saved.").arg(words(unsaved->package().title)));
    if (!next.isEmpty()) question.setInformativeText(tr("'%1' is ready to be shown in its place.").arg(next));
    question.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    question.setDefaultButton(QMessageBox::Save);
    const int answer = question.exec();
    if (answer == QMessageBox::Discard) return true;
    p.worksheets.choose(unsaved->package().id);
    if (answer != QMessageBox::Save || !saveWorksheet()) return false;
  }
  return true;
}

}  // namespace ew::ui
