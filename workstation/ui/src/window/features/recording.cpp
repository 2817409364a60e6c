#include "window/features/recording.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <optional>
#include <utility>

#include "ew/scanning/recording.h"
#include "ew/widgets/question.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/words.h"
#include "window/features/opening.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
void Recording::addMenu(QMenu& recording) {
  Commands& commands = *parts_.commands;
  record_ = commands.add(recording, "record", [this] { toggle(); });
  record_->setCheckable(true);
  mark_ = commands.add(recording, "record.mark", [this] { parts_.recorder.addNote("mark", nullptr); });
  save_ = commands.add(recording, "record.save", [this] { save(); });
}

void Recording::connectParts() {
  WindowParts& p = parts_;
  const auto showWhetherHandRests = [this] {
    if (parts_.hand.isEnabled() == parts_.session.probeControl().handRests()) showState();
  };
  connect(&p.session, &Session::frozenChanged, this, &Recording::showState);
  connect(&p.session.console(), &ScanConsole::probeChanged, this, &Recording::showState);
  connect(&p.session.probeControl(), &ProbeControl::holdChanged, this, showWhetherHandRests);
  connect(&p.session.probeControl(), &ProbeControl::trackingChanged, this, showWhetherHandRests);
  connect(&p.recorder, &Recorder::changed, this, &Recording::showState);
  connect(p.replayBar, &ReplayBar::saveAsked, this, &Recording::save);
  connect(p.replayBar, &ReplayBar::closeAsked, this, [this] {
    if (mayLeave({})) close();
  });
  connect(p.workspaces, &Workspaces::pageChanged, this,
          [this] { parts_.replayBar->setVisible(parts_.replayBar->recording() && parts_.workspaces->isAtWork()); });
}

void Recording::refresh() {
  record_->setEnabled(parts_.session.subject().has_value());
  showState();
}

void Recording::holdUnsavedWork(UnsavedWork& list) {
  list.add({"recording",
            {Loss::scan, Loss::opening, Loss::closing},
            [this] { return parts_.recorder.isRecording() || isUnsaved(); },
            [this](Loss, const std::string& next) { return mayLeave(words(next)); }});
}

void Recording::toggle() {
  WindowParts& p = parts_;
  if (p.recorder.isRecording()) return end();
  record_->setChecked(false);
  if (!p.session.subject() || !mayLeave({})) return;
  close();
  p.session.setFrozen(false);
  p.recorder.start(caseId());
}

std::string Recording::caseId() const {
  const auto& opened = parts_.document.current();
  return opened && parts_.opener->showsCase() ? opened->id : std::string();
}

void Recording::end() {
  WindowParts& p = parts_;
  auto made = p.recorder.stop();
  p.autosave.takeRecording(made);
  if (!made) return;
  file_.clear();
  p.replayBar->load(std::move(made));
  p.replayBar->setSaved(false);
  p.messages->showNote(tr("The recording is kept until another one begins. Play it below, or save it (%1).")
                           .arg(save_->shortcut().toString(QKeySequence::NativeText)),
                       kRecordingTopic);
}

void Recording::showState() {
  WindowParts& p = parts_;
  const bool isRecording = p.recorder.isRecording();
  record_->setChecked(isRecording);
  record_->setText(isRecording ? tr("End &recording") : tr("&Record"));
  mark_->setEnabled(isRecording);
  save_->setEnabled(p.replayBar->recording() != nullptr);
  p.scanView->setRecording(isRecording ? std::optional(p.recorder.length_s()) : std::nullopt);
  p.hand.setEnabled(!p.session.probeControl().handRests());
  p.console->setEnabled(!p.session.isPlaying());
  p.scanView->setControlsEnabled(!p.session.isPlaying());
}

bool Recording::isUnsaved() const {
  const auto& recording = parts_.replayBar->recording();
  return recording != nullptr && recording != saved_;
}

void Recording::close() {
  parts_.replayBar->unload();
  file_.clear();
  parts_.autosave.dropRecording();
  parts_.messages->forget(kRecordingTopic);
  showState();
}

bool Recording::mayLeave(const QString& next) {
  if (parts_.recorder.isRecording()) end();
  if (!isUnsaved()) return true;
  const auto answer = askBeforeLeaving(
      &parts_.window,
      {"unsavedRecordingQuestion", tr("The recording of '%1' is not saved.").arg(words(parts_.replayBar->recording()->title)), {}}, next);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save() && parts_.isSavedNow());
}

bool Recording::save() {
  const auto recording = parts_.replayBar->recording();
  if (!recording) return false;
  return saveAs(recording, tr("Save the recording"), [this, recording] {
    saved_ = recording;
    parts_.replayBar->setSaved(!isUnsaved());
    if (!isUnsaved()) parts_.autosave.dropRecording();
  });
}

bool Recording::saveAs(const std::shared_ptr<const ScanRecording>& recording, const QString& title, std::function<void()> saved) {
  const QString file = askSaveFile(&parts_.window, dated({title,
                                                          words(recording->title) + QStringLiteral(".seq.mha"),
                                                          tr("Sequences of poses (*.seq.mha *.mha)"),
                                                          {QStringLiteral(".seq.mha"), QStringLiteral(".mha")}}));
  if (file.isEmpty()) return false;
  startSaving(recording, file, std::move(saved));
  return true;
}

void Recording::startSaving(const std::shared_ptr<const ScanRecording>& recording, const QString& file, std::function<void()> saved) {
  parts_.jobs.start(
      tr("Saving %1").arg(QFileInfo(file).fileName()),
      [recording, file](Progress& progress) {
        return saveTogether({pathOf(file)},
                            [&](const OutputSet& outputs) { return writeRecording(*recording, outputs.staged(pathOf(file)), progress); });
      },
      [this, file, saved = std::move(saved)](const Result<void>& outcome) {
        if (outcome) {
          saved();
          parts_.messages->showNote(tr("Saved to %1.").arg(file), kRecordingTopic);
        } else if (outcome.error().code != ErrorCode::cancelled) {
          parts_.messages->showError(outcome.error(), kRecordingTopic);
        }
      },
      Jobs::Kind::saving);
}

bool Recording::play(const QString& path, const std::shared_ptr<const ScanRecording>& recording) {
  WindowParts& p = parts_;
  if (!p.session.subject() || caseId() != recording->caseId) return false;
  if (!mayLeave(QFileInfo(path).fileName())) return true;
  p.messages->forgetWhatIsPast();
  p.autosave.dropRecording();
  saved_ = recording;
  file_ = pathOf(path);
  p.replayBar->load(recording);
  p.replayBar->setSaved(true);
  p.pages->setCurrentWidget(p.workspacePage);
  if (!recording->notes.empty())
    p.messages->showNotes(
        tr("%1 is open; %n notes say how it was read.", nullptr, static_cast<int>(recording->notes.size())).arg(QFileInfo(path).fileName()),
        recording->notes, kRecordingTopic);
  p.opening->remember(path);
  showState();
  return true;
}

void Recording::showAgain(const std::shared_ptr<const ScanRecording>& recording, bool isSaved) {
  WindowParts& p = parts_;
  if (isSaved) saved_ = recording;
  file_.clear();
  p.replayBar->load(recording);
  p.replayBar->setSaved(!isUnsaved());
  p.pages->setCurrentWidget(p.workspacePage);
  p.session.makeImageNow();
  if (!isSaved) p.autosave.takeRecording(recording);
  showState();
}

}  // namespace ew::ui
