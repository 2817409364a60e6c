#include "window/features/measuring.h"

#include <QDateTime>
#include <algorithm>
#include <chrono>

#include "ew/core/ending.h"
#include "ew/export/dicom_study.h"
#include "ew/export/measurement_report.h"
#include "ew/sdk/person.h"
#include "ew/widgets/question.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/words.h"
#include "measure/combine_dialog.h"
#include "measure/words/caliper_words.h"
#include "measure/words/worksheet_words.h"
#include "measure/worksheets/worksheet_dialog.h"
#include "measure/worksheets/worksheet_file.h"
#include "window/features/storing.h"
#include "window/frame/commands.h"
#include "window/frame/undo.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

const auto kWorksheet = QStringLiteral("worksheet");
const auto kMeasurements = QStringLiteral("measurements");

}  // namespace

Measuring::~Measuring() {
  delete worksheet_;
  delete combine_;
}

void Measuring::addMenu(QMenu& measure) {
  Commands& commands = *parts_.commands;
  const auto addTool = [&](measurement::CaliperKind kind) {
    QAction* action = commands.add(measure, caliperCommand(kind), [this, kind] {
      if (parts_.workspaces->showsScan()) parts_.calipers.take(kind);
      Q_EMIT parts_.calipers.changed();  // an action checks itself, whatever came of it
    });
    action->setCheckable(true);
    tools_.push_back(action);
  };
  for (const measurement::CaliperKind kind : measurement::drawnKinds()) addTool(kind);
  measure.addSeparator();
  for (const measurement::CaliperKind kind : measurement::stripKinds()) addTool(kind);
  measure.addSeparator();
  followEdges_ = commands.add(measure, "calipers.followEdges", [this] { parts_.calipers.setFollowsEdges(followEdges_->isChecked()); });
  followEdges_->setCheckable(true);
  snap_ = commands.add(measure, "calipers.snap", [this] { parts_.calipers.setSnaps(snap_->isChecked()); });
  snap_->setCheckable(true);
  measure.addSeparator();
  commands.add(measure, "calipers.combine", [this] { showCombine(); });
  commands.add(measure, "calipers.save", [this] { saveMeasurements(); });
  measure.addSeparator();
  commands.add(measure, "calipers.worksheet", [this] { showWorksheet(); });
  measure.addSeparator();
  commands.add(measure, "calipers.clear", [this] { parts_.calipers.clear(); });
}

void Measuring::connectParts() {
  WindowParts& p = parts_;
  connect(&p.calipers, &Calipers::changed, this, &Measuring::showTools);
  connect(&p.calipers, &Calipers::said, p.scanView, &ScanView::say);
  connect(&p.calipers, &Calipers::pauseAsked, this, [this] {
    parts_.replayBar->setPlaying(false);
    parts_.cineBar->setPlaying(false);
  });
  connect(&p.worksheets, &Worksheets::said, p.scanView, &ScanView::say);
  connect(p.measurePage, &MeasurePage::worksheetAsked, this, &Measuring::showWorksheet);
  connect(p.measurePage, &MeasurePage::combineAsked, this, &Measuring::showCombine);
  connect(p.measurePage, &MeasurePage::saveAsked, this, &Measuring::saveMeasurements);
  for (const CaliperLayer* layer : {p.caliperLayer, p.stripCaliperLayer})
    connect(layer, &CaliperLayer::focusChanged, this, [this] { parts_.undo->refresh(); });
  showTools();
}

void Measuring::holdUnsavedWork(UnsavedWork& list) {
  const std::vector<Loss> anyLoss = {Loss::scan, Loss::opening, Loss::closing};
  list.add({"worksheets", anyLoss, [this] { return parts_.worksheets.unsaved() != nullptr; },
            [this](Loss, const std::string& next) { return mayLeaveWorksheet(words(next)); }});
  list.add({"measurements", anyLoss, [this] { return parts_.calipers.isUnsaved(); },
            [this](Loss, const std::string& next) { return mayLeaveMeasurements(words(next)); }});
}

void Measuring::showTools() {
  WindowParts& p = parts_;
  const auto& kinds = measurement::drawnKinds();
  const auto tool = p.calipers.drawing().tool();
  const auto& inStrip = measurement::stripKinds();
  for (std::size_t n = 0; n < tools_.size(); ++n) tools_[n]->setChecked(tool == (n < kinds.size() ? kinds[n] : inStrip[n - kinds.size()]));
  snap_->setChecked(p.calipers.snaps());
  followEdges_->setChecked(p.calipers.followsEdges());
  if (tool) p.console->showPage(p.measurePage);
  p.undo->refresh();
}

void Measuring::showWorksheet() {
  WindowParts& p = parts_;
  if (p.worksheets.current() == nullptr) {
    p.console->showPage(p.measurePage);
    p.scanView->say(tr("Choose a worksheet on the page of measurements first."));
    return;
  }
  if (worksheet_.isNull()) {
    worksheet_ = new WorksheetDialog(p.worksheets, &p.window);
    worksheet_->setAttribute(Qt::WA_DeleteOnClose);
    connect(worksheet_, &WorksheetDialog::saveAsked, this, &Measuring::saveWorksheet);
    // Beside the scan, over body and case: the calipers must be reached while it is open.
    const QPoint corner = p.scanView->mapToGlobal(QPoint(0, 0));
    worksheet_->move(std::max(p.window.mapToGlobal(QPoint(8, 0)).x(), corner.x() - worksheet_->width() - 8), corner.y() + 8);
  }
  worksheet_->show();
  worksheet_->raise();
  worksheet_->activateWindow();
}

void Measuring::showCombine() {
  WindowParts& p = parts_;
  if (p.calipers.findings().all().empty()) {
    p.console->showPage(p.measurePage);
    p.scanView->say(tr("Measure something first: a result is computed from measurements."));
    return;
  }
  if (combine_.isNull()) {
    combine_ = new CombineDialog(p.calipers, &p.window);
    combine_->setAttribute(Qt::WA_DeleteOnClose);
    const QPoint corner = p.scanView->mapToGlobal(QPoint(0, 0));
    combine_->adjustSize();
    combine_->move(std::max(p.window.mapToGlobal(QPoint(8, 0)).x(), corner.x() - combine_->width() - 8), corner.y() + 8);
  }
  combine_->show();
  combine_->raise();
  combine_->activateWindow();
}

bool Measuring::saveMeasurements() {
  WindowParts& p = parts_;
  if (p.calipers.findings().isEmpty() || !p.session.subject()) {
    p.scanView->say(tr("Nothing is measured yet that could be saved."));
    return false;
  }
  const QString file =
      askSaveFile(&p.window, dated({tr("Save the measurements"),
                                    words(p.session.subject()->title) + QLatin1Char(' ') + tr("measurements") + QStringLiteral(".csv"),
                                    tr("Measurements (*.csv *.json)"),
                                    {QStringLiteral(".csv"), QStringLiteral(".json")}}));
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

bool Measuring::saveWorksheet() {
  WindowParts& p = parts_;
  const measurement::Examination* examination = p.worksheets.current();
  if (examination == nullptr || !p.session.subject()) return false;
  const QString proposal = words(p.session.subject()->title) + QLatin1Char(' ') + QString::fromStdString(examination->package().id);
  const QString file =
      askSaveFile(&p.window, dated({tr("Save the worksheet"),
                                    proposal + QStringLiteral(".pdf"),
                                    tr("Worksheets (*.pdf *.csv *.json);;DICOM reports (*.dcm)"),
                                    {QStringLiteral(".pdf"), QStringLiteral(".csv"), QStringLiteral(".json"), QStringLiteral(".dcm")}}));
  if (file.isEmpty()) return false;
  const measurement::Examination asWritten = *examination;
  std::vector<WorksheetImage> images;
  for (const ExaminationStore::Item& item : p.stored.items()) images.push_back({withWarning(item.image), item.caption});
  const auto written = saveTogether({pathOf(file)}, [&](const OutputSet& outputs) {
    const QDateTime now = QDateTime::currentDateTime();
    if (!hasEnding(pathOf(file), ".dcm"))
      return writeWorksheet(asWritten.worksheet(), words(p.session.subject()->title), now, outputs.staged(pathOf(file)), images,
                            QString::fromStdString(sdk::personWhoLearns()));
    const auto made = std::chrono::sys_seconds(std::chrono::seconds(now.toSecsSinceEpoch()));
    auto report = writeMeasurementReport(asWritten.worksheet(), {.instanceUid = newDicomUid(), .made = made}, p.storing->studyNow(),
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

bool Measuring::mayLeaveWorksheet(const QString& next) {
  WindowParts& p = parts_;
  while (const measurement::Examination* unsaved = p.worksheets.unsaved()) {
    const auto answer = askBeforeLeaving(
        &p.window, {"unsavedWorksheetQuestion", tr("The worksheet '%1' is not saved.").arg(words(unsaved->package().title)), {}}, next);
    if (answer == QMessageBox::Discard) return true;
    p.worksheets.choose(unsaved->package().id);
    if (answer != QMessageBox::Save || !saveWorksheet()) return false;
  }
  return true;
}

bool Measuring::mayLeaveMeasurements(const QString& next) {
  const auto answer = askBeforeLeaving(
      &parts_.window, {"unsavedMeasurementsQuestion", tr("Measurements that were not saved: %1.").arg(parts_.calipers.unsavedCount()), {}},
      next);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveMeasurements());
}

}  // namespace ew::ui
