// Recording a scan, playing one, and keeping what was recorded until the user has decided about it.
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "widgets/save_file.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

const QString kRecording = QStringLiteral("recording");  ///< topic of messages

}  // namespace

void MainWindow::toggleRecording() {
  Parts& p = *parts_;
  if (p.recorder.isRecording()) return endRecording();
  p.recordAction->setChecked(false);
  if (!p.session.subject() || !mayLeaveRecording({})) return;
  closeRecording();
  p.session.setFrozen(false);
  p.recorder.start(recordedCase());
}

std::string MainWindow::recordedCase() const {
  const auto& opened = parts_->document.current();
  return opened && parts_->opener->showsCase() ? opened->id : std::string();
}

void MainWindow::showCineState() {
  const bool isOpen = parts_->cineBar->isOpen();
  parts_->status->setCineShown(isOpen);
  for (QAction* action : parts_->cineActions) action->setEnabled(isOpen);
  for (QAction* action : parts_->ofRunningScan) action->setEnabled(!isOpen);
  showOwnKeys();
}

void MainWindow::endRecording() {
  Parts& p = *parts_;
  auto made = p.recorder.stop();
  p.autosave.takeRecording(made);
  if (!made) return;
  p.replayed.clear();
  p.replayBar->load(std::move(made));
  p.replayBar->setSaved(false);
  p.messages->showNote(tr("The recording is kept until another one begins. Play it below, or save it (%1).")
                           .arg(p.saveRecordingAction->shortcut().toString(QKeySequence::NativeText)),
                       kRecording);
}

void MainWindow::showRecordingState() {
  Parts& p = *parts_;
  const bool isRecording = p.recorder.isRecording();
  p.recordAction->setChecked(isRecording);
  p.recordAction->setText(isRecording ? tr("End &recording") : tr("&Record"));
  p.markAction->setEnabled(isRecording);
  p.saveRecordingAction->setEnabled(p.replayBar->recording() != nullptr);
  p.scanView->setRecording(isRecording ? std::optional(p.recorder.length_s()) : std::nullopt);
  p.hand.setEnabled(!p.session.handRests());
  p.console->setEnabled(!p.session.isPlaying());
  p.scanView->setControlsEnabled(!p.session.isPlaying());
}

bool MainWindow::isRecordingUnsaved() const {
  const auto& recording = parts_->replayBar->recording();
  return recording != nullptr && recording != parts_->savedRecording;
}

void MainWindow::closeRecording() {
  parts_->replayBar->unload();
  parts_->replayed.clear();
  parts_->autosave.dropRecording();
  parts_->messages->forget(kRecording);
  showRecordingState();
}

bool MainWindow::saveRecording() {
  const auto recording = parts_->replayBar->recording();
  if (!recording) return false;
  return saveRecordingAs(recording, tr("Save the recording"), tr("scan"), [this, recording] {
    parts_->savedRecording = recording;
    parts_->replayBar->setSaved(!isRecordingUnsaved());
    if (!isRecordingUnsaved()) parts_->autosave.dropRecording();
  });
}

bool MainWindow::saveRecordingAs(const std::shared_ptr<const ScanRecording>& recording, const QString& title, const QString& proposal,
                                 std::function<void()> saved) {
  const QString file = askSaveFile(this, {title,
                                          proposal + QStringLiteral(".seq.mha"),
                                          tr("Sequences of poses (*.seq.mha *.mha)"),
                                          {QStringLiteral(".seq.mha"), QStringLiteral(".mha")}});
  if (file.isEmpty()) return false;
  startSavingRecording(recording, file, std::move(saved));
  return true;
}

void MainWindow::startSavingRecording(const std::shared_ptr<const ScanRecording>& recording, const QString& file,
                                      std::function<void()> saved) {
  parts_->jobs.start(
      tr("Saving %1").arg(QFileInfo(file).fileName()),
      [recording, file](Progress& progress) {
        return saveTogether({pathOf(file)},
                            [&](const OutputSet& outputs) { return writeRecording(*recording, outputs.staged(pathOf(file)), progress); });
      },
      [this, file, saved = std::move(saved)](const Result<void>& outcome) {
        if (outcome) {
          saved();
          parts_->messages->showNote(tr("Saved to %1.").arg(file), kRecording);
        } else if (outcome.error().code != ErrorCode::cancelled) {
          parts_->messages->showError(outcome.error(), kRecording);
        }
      },
      Jobs::Kind::saving);
}

void MainWindow::takeRecording(const QString& path, std::shared_ptr<const ScanRecording> recording) {
  Parts& p = *parts_;
  if (p.session.subject() && recordedCase() == recording->caseId) {
    if (!mayLeaveRecording(QFileInfo(path).fileName())) return;
    p.messages->forgetWhatIsPast();
    p.autosave.dropRecording();
    p.savedRecording = recording;
    p.replayed = pathOf(path);
    p.replayBar->load(recording);
    p.replayBar->setSaved(true);
    p.pages->setCurrentWidget(p.workspacePage);
    if (!recording->notes.empty())
      p.messages->showNotes(tr("%1 is open; %n notes say how it was read.", nullptr, static_cast<int>(recording->notes.size()))
                                .arg(QFileInfo(path).fileName()),
                            recording->notes, kRecording);
    remember(path);
    return showRecordingState();
  }
  if (const auto folder = p.library.folderOf(recording->caseId); !folder.empty()) {
    p.waitingRecording = {path, std::move(recording)};
    return open(wordsOf(folder));
  }
  p.messages->showError({ErrorCode::badUsage,
                         verbatim(tr("%1 is a recording of '%2'. Open what was scanned first, then the recording.")
                                      .arg(QFileInfo(path).fileName(), words(recording->title))
                                      .toStdString()),
                         {}},
                        kRecording);
}

}  // namespace ew::ui
