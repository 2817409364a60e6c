// What a person made and has not saved: who holds it, and what is asked before it goes.
#include <QMessageBox>

#include "import/screen_dialog.h"
#include "jobs/saving_dialog.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

/// Save, Discard or Cancel. @param saveable whether there is a way to save it
QMessageBox::StandardButton askAbout(QWidget* parent, const char* name, const QString& text, const QString& next, const QString& more = {},
                                     bool saveable = true) {
  QMessageBox question(parent);
  question.setObjectName(QLatin1String(name));
  question.setIcon(QMessageBox::NoIcon);
  question.setText(text);
  QStringList lines;
  if (!more.isEmpty()) lines << more;
  if (!next.isEmpty()) lines << MainWindow::tr("'%1' is ready to be shown in its place.").arg(next);
  question.setInformativeText(lines.join(QLatin1Char('\n')));
  question.setStandardButtons(saveable ? QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel
                                       : QMessageBox::Discard | QMessageBox::Cancel);
  question.setDefaultButton(saveable ? QMessageBox::Save : QMessageBox::Cancel);
  return static_cast<QMessageBox::StandardButton>(question.exec());
}

const std::vector<Loss> kAnyLoss = {Loss::scan, Loss::opening, Loss::closing};

}  // namespace

void MainWindow::holdUnsavedWork() {
  Parts& p = *parts_;
  p.unsaved.add({"case",
                 {Loss::opening, Loss::closing},
                 [&p] { return p.document.hasUnsavedChanges(); },
                 [this](Loss, const std::string& next) { return mayLeaveCase(words(next)); }});
  p.unsaved.add({"volume", kAnyLoss, [&p] { return !p.made.empty(); },
                 [this](Loss loss, const std::string& next) { return mayLeaveVolumes(loss, words(next)); }});
  p.unsaved.add({"recording", kAnyLoss, [this, &p] { return p.recorder.isRecording() || isRecordingUnsaved(); },
                 [this](Loss, const std::string& next) { return mayLeaveRecording(words(next)); }});
  p.unsaved.add({"worksheets", kAnyLoss, [&p] { return p.worksheets.unsaved() != nullptr; },
                 [this](Loss, const std::string& next) { return mayLeaveWorksheet(words(next)); }});
  p.unsaved.add({"stored images", kAnyLoss, [&p] { return p.stored.atRiskCount() > 0; },
                 [this](Loss, const std::string& next) { return mayLeaveStored(words(next)); }});
  p.unsaved.add({"measurements", kAnyLoss, [&p] { return p.calipers.isUnsaved(); },
                 [this](Loss, const std::string& next) { return mayLeaveMeasurements(words(next)); }});
  p.unsaved.add({"recorded screen",
                 {Loss::closing},
                 [this] {
                   const auto dialogs = findChildren<ScreenDialog*>();
                   return std::any_of(dialogs.begin(), dialogs.end(), [](const ScreenDialog* each) { return each->isUnsaved(); });
                 },
                 [this](Loss, const std::string&) {
                   for (ScreenDialog* each : findChildren<ScreenDialog*>())
                     if (!each->mayLeave(true)) return false;
                   return true;
                 }});
  p.unsaved.add({"panels",
                 {Loss::closing},
                 [&p] {
                   const auto panels = p.host->panelsAdded();
                   return std::any_of(panels.begin(), panels.end(), [](const sdk::StagedPanel* each) {
                     const auto document = each->document.lock();
                     return document && !document->unsaved().empty();
                   });
                 },
                 [this](Loss, const std::string&) { return mayLeavePanels(); }});
  p.unsaved.add({"plugins", kAnyLoss, [&p] { return !p.host->unsaved().empty(); },
                 [this](Loss loss, const std::string& next) { return mayLeavePlugins(loss, words(next)); }});
}

bool MainWindow::mayReplaceShown(const QString& next) {
  if (!parts_->unsaved.mayLose(Loss::opening, next.toStdString())) return false;
  forgetShownVolume();
  closeRecording();
  return true;
}

bool MainWindow::mayReplaceScan(const QString& next) {
  if (!parts_->unsaved.mayLose(Loss::scan, next.toStdString())) return false;
  forgetShownVolume();
  closeRecording();
  return true;
}

bool MainWindow::mayClose() {
  if (!parts_->unsaved.mayLose(Loss::closing, {})) return false;
  const auto outcome = SavingDialog(parts_->jobs, true, this).wait();
  return outcome == SavingDialog::Outcome::saved || outcome == SavingDialog::Outcome::lose;
}

bool MainWindow::isSavedNow() { return SavingDialog(parts_->jobs, false, this).wait() == SavingDialog::Outcome::saved; }

bool MainWindow::mayLeaveCase(const QString& next) {
  if (!parts_->document.hasUnsavedChanges() || (parts_->dropsEdits && !next.isEmpty())) return true;
  const auto answer = askAbout(this, "unsavedQuestion",
                               tr("The case '%1' has changes that are not saved.").arg(words(parts_->document.current()->title)), next);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveCase(false));
}

bool MainWindow::mayLeaveVolumes(Loss loss, const QString& next) {
  if (loss != Loss::closing) {
    const MadeVolume* shown = shownMadeVolume();
    return shown == nullptr || mayLeaveVolume(MadeVolume(*shown), next);
  }
  const std::vector<MadeVolume> all = parts_->made;
  return std::all_of(all.begin(), all.end(), [&](const MadeVolume& each) { return mayLeaveVolume(each, next); });
}

bool MainWindow::mayLeaveVolume(const MadeVolume& made, const QString& next) {
  const auto answer = askAbout(this, "unsavedVolumeQuestion", tr("The volume made from '%1' is not saved.").arg(made.title), next,
                               tr("Making it again takes as long as it did."));
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveVolume(made) && isSavedNow());
}

bool MainWindow::mayLeaveRecording(const QString& next) {
  Parts& p = *parts_;
  if (p.recorder.isRecording()) endRecording();
  if (!isRecordingUnsaved()) return true;
  const auto answer = askAbout(this, "unsavedRecordingQuestion",
                               tr("The recording of '%1' is not saved.").arg(words(p.replayBar->recording()->title)), next);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveRecording() && isSavedNow());
}

bool MainWindow::mayLeaveWorksheet(const QString& next) {
  Parts& p = *parts_;
  while (const measurement::Examination* unsaved = p.worksheets.unsaved()) {
    const auto answer =
        askAbout(this, "unsavedWorksheetQuestion", tr("The worksheet '%1' is not saved.").arg(words(unsaved->package().title)), next);
    if (answer == QMessageBox::Discard) return true;
    p.worksheets.choose(unsaved->package().id);
    if (answer != QMessageBox::Save || !saveWorksheet()) return false;
  }
  return true;
}

bool MainWindow::mayLeaveStored(const QString& next) {
  const auto answer = askAbout(this, "unsavedStoredQuestion",
                               tr("Stored images that were neither saved nor sent: %1.").arg(parts_->stored.atRiskCount()), next);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveExamination() && isSavedNow());
}

bool MainWindow::mayLeaveMeasurements(const QString& next) {
  const auto answer =
      askAbout(this, "unsavedMeasurementsQuestion", tr("Measurements that were not saved: %1.").arg(parts_->calipers.unsavedCount()), next);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveMeasurements());
}

bool MainWindow::mayLeavePanels() {
  for (const sdk::StagedPanel* panel : parts_->host->panelsAdded()) {
    const auto document = panel->document.lock();
    const QString unsaved = document ? words(document->unsaved()) : QString();
    if (unsaved.isEmpty()) continue;
    const auto answer = askAbout(this, "unsavedPluginQuestion", unsaved, {}, words(panel->title));
    if (answer == QMessageBox::Discard) continue;
    if (answer != QMessageBox::Save) return false;
    document->save(false);
    if (!isSavedNow() || !document->unsaved().empty()) return false;
  }
  return true;
}

bool MainWindow::mayLeavePlugins(Loss loss, const QString& next) {
  for (const sdk::UnsavedWork& work : parts_->host->unsaved()) {
    if (loss != Loss::closing && !work.goesWithScan) continue;
    const auto answer = askAbout(this, "unsavedPluginQuestion", words(work.sentence()), next, {}, static_cast<bool>(work.save));
    if (answer == QMessageBox::Discard) continue;
    if (answer != QMessageBox::Save || !work.save() || !isSavedNow() || !work.sentence().empty()) return false;
  }
  return true;
}

}  // namespace ew::ui
