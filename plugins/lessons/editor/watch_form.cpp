#include "editor/watch_form.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "editor/expert_take.h"
#include "editor/order_list.h"
#include "ew/sdk/window.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/time_line.h"
#include "ew/widgets/words.h"
#include "panel/expert_player.h"

namespace ew::lessons {

WatchForm::WatchForm(const StepEdit& edited, ExpertTake& take, QWidget* parent) : TaskForm(edited, parent), take_(take) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  column->addWidget(headingLabel(tr("The expert's scan")));
  state_ = quietLabel({});
  state_->setObjectName(QStringLiteral("recordingState"));
  column->addWidget(state_);
  column->addWidget(makeTakePart());
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  record_ = smallButton({}, "recordExpert", tr("Then scan as the trainee is to see it, with mouse or keys"));
  choose_ = smallButton(tr("Choose a recording…"), "chooseRecording", tr("One that was saved from this body before (.seq.mha)"));
  row->addWidget(record_);
  row->addWidget(choose_);
  row->addStretch(1);
  column->addLayout(row);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("recording_problem"));
  column->addWidget(problem_);
  playPart_ = makePlayPart();
  column->addWidget(playPart_);
  connect(record_, &QPushButton::clicked, this, &WatchForm::start);
  connect(choose_, &QPushButton::clicked, this, [this] {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Choose a recording"), {}, tr("Recordings of a scan (*.seq.mha *.igs.mha *.mha)"));
    if (!file.isEmpty()) choose(file.toStdString());
  });
  connect(&take_, &ExpertTake::changed, this, &WatchForm::showTake);
  connect(&take_, &ExpertTake::full, this, [this] {
    setProblem(problem_, tr("The recording is as long as it may be, %1 min; stop it here.").arg(std::lround(kLongestExpertScan_s / 60.0)));
  });
}

WatchForm::~WatchForm() = default;

QWidget* WatchForm::makeTakePart() {
  takePart_ = new QWidget;
  auto* column = new QVBoxLayout(takePart_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  length_ = new QLabel;
  length_->setObjectName(QStringLiteral("takeLength"));
  column->addWidget(length_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  stop_ = smallButton(tr("Stop"), "stopRecording", tr("End the recording and keep it in the case"));
  setLook(stop_, Look::primary);
  pause_ = smallButton({}, "pauseRecording", {});
  discard_ = smallButton(tr("Discard"), "discardRecording", tr("End the recording without keeping it"));
  row->addWidget(stop_);
  row->addWidget(pause_);
  row->addWidget(discard_);
  row->addStretch(1);
  column->addLayout(row);
  takeMark_ = smallButton(tr("Mark this moment"), "markWhileRecording", tr("It is described afterwards; the trainee's view rests there"));
  column->addWidget(takeMark_, 0, Qt::AlignLeft);
  connect(stop_, &QPushButton::clicked, this, &WatchForm::stop);
  connect(pause_, &QPushButton::clicked, this, [this] { take_.isPaused() ? take_.goOn() : take_.pause(); });
  connect(discard_, &QPushButton::clicked, this, [this] {
    take_.discard();
    say({});
    showTask(false);
  });
  connect(takeMark_, &QPushButton::clicked, this, [this] { take_.mark(); });
  return takePart_;
}

bool WatchForm::isHome() const {
  const LessonStep* step = edited().step();
  const auto& home = edited().document.home();
  return step != nullptr && home && (step->caseId.empty() || step->caseId == home->id);
}

void WatchForm::hideEvent(QHideEvent* event) {
  release();
  TaskForm::hideEvent(event);
}

void WatchForm::start() {
  release();
  if (auto own = edited().document.makeOwn(); !own) return say(own);
  const auto& home = edited().document.home();
  if (!home) return;
  say(take_.start(edited().lessonId, edited().stepId, home->id, home->titleForTrainees.empty() ? home->region : home->titleForTrainees));
}

void WatchForm::stop() {
  std::vector<double> marks_s;
  auto made = take_.stop(marks_s);
  if (!made) return say(tl::unexpected(made.error()));
  if (!take_.isOfOpenCase()) return saveTaken(std::move(*made));
  keep(std::move(*made), marks_s, true);
}

struct WatchForm::ScanToKeep {
  ScanRecording recording;
  std::vector<double> marks_s;
  std::filesystem::path folder;  ///< of the lessons it was made for
  std::string name = {};         ///< it was written by
};

/// @error notFound: the case or the step that it was recorded for is not there any more
Result<void> WatchForm::nameInStep(const StepEdit& at, const ScanToKeep& kept) {
  if (at.document.folder() != kept.folder)
    return failure(ErrorCode::notFound,
                   ew::say<"Another case was opened before the expert's scan was kept; open the case it is for again.">());
  auto named = at.changeTask<WatchTask>(tr("Record the expert's scan"), {}, [&](WatchTask& task) {
    task = {kept.name, {}, {}, {}};
    for (const double mark_s : kept.marks_s) {
      const std::string name = tr("Mark %1").arg(task.marks.size() + 1).toStdString();
      task = withMark(std::move(task), {mark_s, name});
    }
  });
  if (named && at.task<WatchTask>().recording != kept.name)
    return failure(ErrorCode::notFound,
                   ew::say<"The step that the expert's scan was recorded for is not there any more; undo brings it back.">());
  return named;
}

/// @param isTaken it was recorded, for this step or another, and the take goes only when it is kept and named
void WatchForm::keep(ScanRecording made, const std::vector<double>& marks_s, bool isTaken) {
  auto kept = std::make_shared<ScanToKeep>(ScanToKeep{std::move(made), marks_s, edited().document.folder()});
  if (isTaken) take_.setKeeping(true);
  state_->setText(tr("Keeping the recording…"));
  edited().document.host().jobs().startSaving(
      tr("Keeping the expert's scan").toStdString(),
      [kept](Progress& progress) -> Result<void> {
        auto name = keepRecording(kept->recording, kept->folder, progress);
        if (!name) return passOn(name.error());
        kept->name = std::move(*name);
        return {};
      },
      [form = QPointer<WatchForm>(this), document = QPointer<LessonDocument>(&edited().document), take = QPointer<ExpertTake>(&take_),
       at = isTaken ? StepEdit{edited().document, take_.lessonId(), take_.stepId()} : edited(), kept, isTaken](const Result<void>& done) {
        if (!document || !take) return;
        const Result<void> named = done ? nameInStep(at, *kept) : done;
        const QString problem =
            named     ? QString()
            : isTaken ? words(named.error()) + QLatin1Char(' ') + tr("The recording is still there: Stop tries again to keep it.")
                      : words(named.error());
        if (isTaken) named ? take->discard() : take->setKeeping(false);
        const bool isSeen = form && document->folder() == kept->folder;
        if (!isSeen && !named) document->host().window().error(problem.toStdString(), "expert scan");
        if (!isSeen) return;
        setProblem(form->problem_, problem);
        form->showTask(false);
      });
}

/// The step it was recorded for is in a case that is not open: into a file, which is chosen there.
void WatchForm::saveTaken(ScanRecording made) {
  sdk::Host& host = edited().document.host();
  const QPointer<WatchForm> form(this);  // while somebody thinks about a name another case may be opened
  const QPointer<ExpertTake> take(&take_);
  const auto file = host.window().askSaveFile({.title = tr("Save the expert's scan").toStdString(),
                                               .proposal = tr("scan").toStdString() + ".seq.mha",
                                               .filter = tr("Recordings of a scan (*.seq.mha)").toStdString(),
                                               .endings = {".seq.mha"},
                                               .isDated = true});
  if (!file || !take) return;  // it is paused, and still there
  take->setKeeping(true);
  host.jobs().startSaving(
      tr("Keeping the expert's scan").toStdString(),
      [recording = std::make_shared<const ScanRecording>(std::move(made)), to = *file](Progress& progress) {
        return writeRecording(*recording, to, progress);
      },
      [form, take, &host, to = *file](const Result<void>& done) {
        if (!take) return;
        done ? take->discard() : take->setKeeping(false);
        if (!done) return host.window().error(words(done.error()).toStdString(), "expert scan");
        host.window().info(
            tr("Saved to %1. Open the case it is for, and choose it in its step.").arg(QString::fromStdString(to.string())).toStdString(),
            "expert scan");
        if (form) form->showTask(false);
      });
}

void WatchForm::choose(const std::filesystem::path& file) {
  auto read = readRecording(file);
  if (!read) return say(tl::unexpected(read.error()));
  if (auto own = edited().document.makeOwn(); !own) return say(own);
  keep(std::move(*read), {}, false);
}

void WatchForm::showTake() {
  if (takePart_->isHidden() == take_.isRecording()) showTask(true);
  if (!take_.isRecording()) return;
  const bool isMine = take_.isFor(edited().lessonId, edited().stepId);
  for (auto* each : {pause_, takeMark_}) each->setVisible(isMine);
  const QString stops =
      take_.isOfOpenCase() ? tr("End the recording and keep it in the case") : tr("End the recording and save it in a file");
  stop_->setToolTip(stops);
  stop_->setAccessibleName(stops);
  length_->setText((take_.isPaused() ? tr("Paused at %1 of at most %2") : tr("● Recording: %1 of at most %2"))
                       .arg(clockText(take_.length_s()), clockText(kLongestExpertScan_s)));
  pause_->setText(take_.isPaused() ? tr("Go on") : tr("Pause"));
  for (auto* each : {stop_, pause_, discard_, takeMark_}) each->setEnabled(!take_.isKeeping());
  takeMark_->setText(take_.markCount() == 0 ? tr("Mark this moment") : tr("Mark this moment (%1)").arg(take_.markCount()));
}

void WatchForm::showTask(bool typed) {
  const WatchTask task = edited().task<WatchTask>();
  const bool isMine = take_.isFor(edited().lessonId, edited().stepId);
  const bool elsewhere = take_.isRecording() && !isMine;
  takePart_->setVisible(take_.isRecording());
  if (isMine && record_->hasFocus()) stop_->setFocus();  // else the focus would go on by itself, and the form scroll to it
  record_->setVisible(!isMine && isHome());
  record_->setEnabled(!elsewhere);
  record_->setText(task.recording.empty() ? tr("Record here") : tr("Record again"));
  setLook(record_, Look::primary, task.recording.empty());
  choose_->setVisible(!isMine);
  if (elsewhere)
    state_->setText(take_.isOfOpenCase()
                        ? tr("Another step's scan is being recorded; end that first.")
                        : tr("A scan of another case is being recorded. Open that to keep it in its step; Stop saves it in a file, without "
                             "the moments that were marked."));
  else if (isMine)
    state_->setText(tr("Scan now, as the trainee is to see it."));
  else if (task.recording.empty())
    state_->setText(isHome() ? tr("Nothing is recorded yet.")
                             : tr("This step scans another case. Record the scan there, save it, and choose it here."));
  showTake();
  if (shown_ != task.recording) load();
  showRecording();
  if (!typed) showMarks(task);
}

void WatchForm::load() {
  release();
  recording_.reset();
  shown_ = edited().task<WatchTask>().recording;
  const int load = ++loads_;
  if (shown_.empty()) return;
  auto read = std::make_shared<ScanRecording>();
  edited().document.host().jobs().start(
      tr("Reading the expert's scan").toStdString(),
      [read, file = edited().document.folder() / shown_](Progress& progress) -> Result<void> {
        auto recording = readRecording(file, progress);
        if (!recording) return passOn(recording.error());
        *read = std::move(*recording);
        return {};
      },
      [form = QPointer<WatchForm>(this), read, load](const Result<void>& done) {
        if (!form || form->loads_ != load) return;
        if (done) {
          form->recording_ = read;
          form->line_->setSpan(read->log.begin_s(), read->log.end_s());
          form->line_->setPosition(form->edited().task<WatchTask>().begin_s.value_or(read->log.begin_s()));
        }
        if (!done) form->say(done);
        form->showRecording();
      });
}

void WatchForm::showRecording() {
  const WatchTask task = edited().task<WatchTask>();
  const bool isMine = take_.isFor(edited().lessonId, edited().stepId);
  playPart_->setVisible(recording_ != nullptr && !isMine && isHome());
  if (!recording_) return;
  const double first_s = recording_->log.begin_s(), last_s = recording_->log.end_s();
  line_->setSpan(first_s, last_s);
  line_->setRange(task.begin_s.value_or(first_s), task.end_s.value_or(last_s));
  std::vector<double> marks_s;
  for (const ExpertMark& mark : task.marks) marks_s.push_back(mark.time_s);
  line_->setMarks(std::move(marks_s));
  if (!isMine && !take_.isRecording())
    state_->setText(tr("%1 recorded, %2 images; trainees see %3.")
                        .arg(clockText(last_s - first_s))
                        .arg(recording_->log.frameCount())
                        .arg(clockText(task.end_s.value_or(last_s) - task.begin_s.value_or(first_s))));
  showPlace();
}

void WatchForm::change(const QString& what, const std::string& field, const std::function<void(WatchTask&)>& edit) {
  say(edited().changeTask<WatchTask>(what, field, edit));
}

void WatchForm::say(const Result<void>& done) { setProblem(problem_, done ? QString() : words(done.error())); }

TaskForm* makeWatchForm(const StepEdit& edited, ExpertTake& take, QWidget* parent) { return new WatchForm(edited, take, parent); }

}  // namespace ew::lessons
