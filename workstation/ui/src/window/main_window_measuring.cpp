// Calipers on the scan and the worksheets they fill: their menu, and who hears of them.
#include <QDateTime>
#include <algorithm>
#include <chrono>

#include "ew/core/ending.h"
#include "ew/export/measurement_report.h"
#include "ew/sdk/person.h"
#include "measure/words/caliper_words.h"
#include "measure/words/worksheet_words.h"
#include "measure/worksheets/worksheet_file.h"
#include "widgets/save_file.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

const auto kWorksheet = QStringLiteral("worksheet");
const auto kMeasurements = QStringLiteral("measurements");

}  // namespace

bool MainWindow::Parts::editsCalipers() const {
  const measurement::CaliperDrawing& drawing = calipers.drawing();
  if (staged || !(drawing.canUndo() || drawing.canRedo())) return false;
  return !isAuthor() || caliperLayer->hasFocus() || stripCaliperLayer->hasFocus();
}

void MainWindow::addMeasureMenu(QMenu& measure) {
  Parts& p = *parts_;
  const auto addTool = [&](measurement::CaliperKind kind) {
    QAction* action = addMenuAction(measure, caliperCommand(kind), [this, kind] {
      if (parts_->pages->currentWidget() == parts_->workspacePage && parts_->keepsScan()) parts_->calipers.take(kind);
      Q_EMIT parts_->calipers.changed();  // an action checks itself, whatever came of it
    });
    action->setCheckable(true);
    p.caliperActions.push_back(action);
  };
  for (const measurement::CaliperKind kind : measurement::drawnKinds()) addTool(kind);
  measure.addSeparator();
  for (const measurement::CaliperKind kind : measurement::stripKinds()) addTool(kind);
  measure.addSeparator();
  p.followEdgesAction =
      addMenuAction(measure, "calipers.followEdges", [this] { parts_->calipers.setFollowsEdges(parts_->followEdgesAction->isChecked()); });
  p.followEdgesAction->setCheckable(true);
  p.snapAction = addMenuAction(measure, "calipers.snap", [this] { parts_->calipers.setSnaps(parts_->snapAction->isChecked()); });
  p.snapAction->setCheckable(true);
  measure.addSeparator();
  addMenuAction(measure, "calipers.combine", [this] { showCombine(); });
  addMenuAction(measure, "calipers.save", [this] { saveMeasurements(); });
  measure.addSeparator();
  addMenuAction(measure, "calipers.worksheet", [this] { showWorksheet(); });
  measure.addSeparator();
  addMenuAction(measure, "calipers.clear", [this] { parts_->calipers.clear(); });
}

void MainWindow::connectCalipers() {
  Parts& p = *parts_;
  const auto show = [this] {
    Parts& parts = *parts_;
    const auto& kinds = measurement::drawnKinds();
    const auto tool = parts.calipers.drawing().tool();
    const auto& inStrip = measurement::stripKinds();
    for (std::size_t n = 0; n < parts.caliperActions.size(); ++n)
      parts.caliperActions[n]->setChecked(tool == (n < kinds.size() ? kinds[n] : inStrip[n - kinds.size()]));
    parts.snapAction->setChecked(parts.calipers.snaps());
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
  connect(p.measurePage, &MeasurePage::combineAsked, this, &MainWindow::showCombine);
  connect(p.measurePage, &MeasurePage::saveAsked, this, &MainWindow::saveMeasurements);
  connect(p.caliperLayer, &CaliperLayer::focusChanged, this, &MainWindow::showHistory);
  connect(p.stripCaliperLayer, &CaliperLayer::focusChanged, this, &MainWindow::showHistory);
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

void MainWindow::showCombine() {
  Parts& p = *parts_;
  if (p.calipers.findings().all().empty()) {
    p.console->showPage(p.measurePage);
    p.scanView->say(tr("Measure something first: a result is computed from measurements."));
    return;
  }
  if (p.combine.isNull()) {
    p.combine = new CombineDialog(p.calipers, this);
    p.combine->setAttribute(Qt::WA_DeleteOnClose);
    const QPoint corner = p.scanView->mapToGlobal(QPoint(0, 0));
    p.combine->adjustSize();
    p.combine->move(std::max(mapToGlobal(QPoint(8, 0)).x(), corner.x() - p.combine->width() - 8), corner.y() + 8);
  }
  p.combine->show();
  p.combine->raise();
  p.combine->activateWindow();
}

bool MainWindow::saveMeasurements() {
  Parts& p = *parts_;
  if (p.calipers.findings().isEmpty() || !p.session.subject()) {
    p.scanView->say(tr("Nothing is measured yet that could be saved."));
    return false;
  }
  const QString file = askSaveFile(this, {tr("Save the measurements"),
                                          tr("measurements") + QStringLiteral(".csv"),
                                          tr("Measurements (*.csv *.json)"),
                                          {QStringLiteral(".csv"), QStringLiteral(".json")}});
  if (file.isEmpty()) return false;
  const measurement::Findings findings = p.calipers.findings();
  const auto written = saveTogether({pathOf(file)}, [&](const OutputSet& outputs) {
    return writeMeasurements(findings, words(p.session.subject()->title), outputs.staged(pathOf(file)));
  });
  if (!written) {
    p.messages->showError(written.error(), kMeasurements);
    return false;
  }
  p.calipers.setSaved(findings);
  p.messages->showNote(tr("Saved to %1.").arg(file), kMeasurements);
  return true;
}

bool MainWindow::saveWorksheet() {
  Parts& p = *parts_;
  const measurement::Examination* examination = p.worksheets.current();
  if (examination == nullptr || !p.session.subject()) return false;
  const QString proposal = QString::fromStdString(examination->package().id);
  const QString file =
      askSaveFile(this, {tr("Save the worksheet"),
                         proposal + QStringLiteral(".pdf"),
                         tr("Worksheets (*.pdf *.csv *.json);;DICOM reports (*.dcm)"),
                         {QStringLiteral(".pdf"), QStringLiteral(".csv"), QStringLiteral(".json"), QStringLiteral(".dcm")}});
  if (file.isEmpty()) return false;
  const measurement::Examination asWritten = *examination;
  std::vector<ReportPicture> pictures;
  for (const StoredExamination::Item& item : p.stored.items()) pictures.push_back({withWarning(item.picture), item.caption});
  const auto written = saveTogether({pathOf(file)}, [&](const OutputSet& outputs) {
    const QDateTime now = QDateTime::currentDateTime();
    if (!hasEnding(pathOf(file), ".dcm"))
      return writeWorksheet(asWritten.worksheet(), words(p.session.subject()->title), now, outputs.staged(pathOf(file)), pictures,
                            QString::fromStdString(sdk::personWhoLearns()));
    const auto made = std::chrono::sys_seconds(std::chrono::seconds(now.toSecsSinceEpoch()));
    auto report = writeMeasurementReport(asWritten.worksheet(), {.instanceUid = newDicomUid(), .made = made}, studyNow(),
                                         outputs.staged(pathOf(file)));
    return report ? Result<void>() : passOn(report.error());
  });
  if (!written) {
    p.messages->showError(written.error(), kWorksheet);
    return false;
  }
  p.worksheets.setSaved({&asWritten});
  p.messages->showNote(tr("Saved to %1.").arg(file), kWorksheet);
  return true;
}

}  // namespace ew::ui
