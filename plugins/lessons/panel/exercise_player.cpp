#include "panel/exercise_player.h"

#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/sdk/case_parts.h"
#include "ew/sdk/person.h"
#include "ew/sdk/window.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/words.h"
#include "panel/aids_drawer.h"
#include "panel/outcome_page.h"
#include "panel/step_page.h"

namespace ew::lessons {

namespace {

enum ExercisePage { kPlanning, kAtWork, kJudged };
constexpr int kExerciseTick_ms = 250;

std::chrono::sys_seconds thisMoment() { return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()); }

}  // namespace

ExercisePlayer::ExercisePlayer(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  setObjectName(QStringLiteral("exercisePlayer"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget;
  waiting_ = quietLabel({});
  waiting_->setObjectName(QStringLiteral("exerciseWaiting"));
  waiting_->setAlignment(Qt::AlignCenter);
  pages_->addWidget(waiting_);
  step_ = new StepPage(host_);
  pages_->addWidget(step_);
  outcome_ = new OutcomePage;
  pages_->addWidget(outcome_);
  column->addWidget(pages_);

  if (auto* skip = step_->findChild<QPushButton*>(QStringLiteral("skipStep")))
    skip->setToolTip(tr("Take another one; this one does not count"));
  if (auto* leave = step_->findChild<QPushButton*>(QStringLiteral("leaveLesson")))
    leave->setToolTip(tr("Back to the lessons; what was judged is kept"));
  connect(step_, &StepPage::doneAsked, this, &ExercisePlayer::endExercise);
  connect(step_, &StepPage::skipAsked, this, &ExercisePlayer::skip);
  connect(step_, &StepPage::leaveAsked, this, &ExercisePlayer::leave);
  connect(step_, &StepPage::pauseAsked, this, [this](bool paused) {
    if (!run_) return;
    const double now_s = host_.scan().now_s();
    if (paused)
      run_->pause(now_s);
    else
      run_->goOn(now_s);
  });
  connect(outcome_, &OutcomePage::againAsked, this, &ExercisePlayer::leave);
  connect(outcome_, &OutcomePage::nextAsked, this, &ExercisePlayer::next);
  timer_.setInterval(kExerciseTick_ms);
  connect(&timer_, &QTimer::timeout, this, &ExercisePlayer::tick);
  tickets_ = {host_.caseParts().onOpened([this](const std::filesystem::path& folder) {
                if (case_ && folder != case_->folder) leave();
              }),
              host_.scan().onEvent([this](const ScanEvent& event) {
                if (run_ && run_->isRunning()) take(event);
              })};
}

ExercisePlayer::~ExercisePlayer() { tickets_.clear(); }

void ExercisePlayer::begin(const Case& opened, CaseWords words, bool withFindings) {
  Q_EMIT problemGone();
  case_ = opened;
  words_ = std::move(words);
  file_ = repetitionFile(libraryFolder(), sdk::personWhoLearns());
  isKept_ = true;
  states_.clear();
  auto kept = readRepetition(file_);
  if (kept) {
    states_ = std::move(kept->states);
    if (kept->note) host_.window().warn(ew::words(*kept->note).toStdString(), "exercises");
  } else {
    isKept_ = false;
    tell(kept.error());
  }
  waiting_->setText(tr("Looking for exercises in this case…"));
  pages_->setCurrentIndex(kPlanning);
  withFindings_ = withFindings;
  skipped_.clear();
  plan();
}

void ExercisePlayer::plan() {
  const auto scanned = host_.scan().scanned();
  const auto image = host_.scan().state();
  if (!scanned || !scanned->skin || !image) {  // the volume is being prepared: looked at again soon
    waiting_->setText(tr("The volume of this case is being made ready…"));
    timer_.start();
    return;
  }
  timer_.stop();
  const int job = ++jobs_;
  auto made = std::make_shared<ExercisePlan>();
  host_.jobs().start(
      tr("Looking for exercises").toStdString(),
      [made, opened = *case_, scanned = *scanned, image = *image](Progress& progress) -> Result<void> {
        auto planned = planExercises(opened, scanned, image, progress);
        if (!planned) return passOn(planned.error());
        *made = std::move(*planned);
        return {};
      },
      [player = QPointer<ExercisePlayer>(this), made, job](const Result<void>& done) {
        if (!player || player->jobs_ != job || !player->case_) return;
        if (!done) {
          if (done.error().code != ErrorCode::cancelled) player->tell(done.error());
          return player->finish();
        }
        player->plan_ = made;
        player->exercises_ = offered(made->list, player->withFindings_);
        player->next();
      });
}

/// It does not count, and comes again when all others were asked.
void ExercisePlayer::skip() {
  skipped_.insert(exercise_.id);
  if (skipped_.size() >= exercises_.size()) skipped_.clear();
  next();
}

void ExercisePlayer::next() {
  timer_.stop();
  target_.reset();
  run_.reset();
  step_->end();
  std::vector<Exercise> asked;
  for (const Exercise& each : exercises_)
    if (!skipped_.contains(each.id)) asked.push_back(each);
  const auto now = thisMoment();
  const auto seed = static_cast<std::uint64_t>(now.time_since_epoch().count());
  const auto planned = nextExercise(states_, asked, now, seed);
  if (!planned) {
    Q_EMIT failed(
        tr("There is nothing here that the program could ask for: no plane can be reached from the skin, no organ is told apart "
           "by pointing, and nothing is measured with calipers."));
    return finish();
  }
  waiting_->setText(tr("Getting the exercise ready…"));
  pages_->setCurrentIndex(kPlanning);
  const auto exercise = std::find_if(exercises_.begin(), exercises_.end(), [&](const Exercise& e) { return e.id == planned->exerciseId; });
  const int job = ++jobs_;
  auto start = std::make_shared<std::optional<Hold>>();
  host_.jobs().start(
      tr("Getting the exercise ready").toStdString(),
      [start, plan = plan_, exercise = *exercise, level = planned->level, seed](Progress&) -> Result<void> {
        *start = startOf(exercise, plan->ground, level, seed);
        return {};
      },
      [player = QPointer<ExercisePlayer>(this), start, planned = *planned, job](const Result<void>& done) {
        if (!player || player->jobs_ != job || !player->case_) return;
        if (!done) return player->finish();
        player->startAt(planned, *start);
      });
}

void ExercisePlayer::startAt(const NextExercise& planned, const std::optional<Hold>& start) {
  exercise_ = *std::find_if(exercises_.begin(), exercises_.end(), [&](const Exercise& e) { return e.id == planned.exerciseId; });
  level_ = planned.level;
  const auto give = [this](const Error& problem) {
    tell(problem);
    finish();
  };
  const auto scanned = host_.scan().scanned();
  if (!scanned) return finish();
  auto step = stepOf(exercise_, plan_->ground, level_);
  if (!step) return give(step.error());
  if (auto running = host_.scan().setFrozen(false); !running) return give(running.error());
  if (start)
    if (auto placed = host_.scan().placeProbe(poseOf(*start).probeToWorld); !placed) return give(placed.error());
  StepScene scene{std::make_shared<const CaseTruth>(plan_->ground.truth), *scanned};
  auto work = exerciseWork(exercise_, plan_, level_, *step, scene);
  if (!work) return give(work.error());
  Lesson lesson;
  lesson.id = "exercises";
  lesson.steps = {*step};
  run_.emplace(std::move(lesson), std::nullopt);
  if (auto started = run_->startStep(std::move(*work), host_.scan().now_s()); !started) return give(started.error());
  shown_ = *step;
  shown_.title = words(titleOf(exercise_, words_.of(exercise_.target))).toStdString();
  shown_.text = words(taskOf(exercise_)).toStdString();
  step_->showStep(*run_, shown_, scene, std::nullopt, {});
  step_->setHead(tr("Level %1 of %2").arg(level_).arg(kExerciseLevels), level_, kExerciseLevels);
  if (const auto state = host_.scan().state()) take({state->time_s, FrameMade{state->pose, state->gaps_mm, state->number, state->body}});
  pages_->setCurrentIndex(kAtWork);
  timer_.start();
}

void ExercisePlayer::take(const ScanEvent& event) {
  const auto image = host_.scan().state();
  run_->see(event, image);
  if (const auto* freeze = std::get_if<FreezeChanged>(&event.what)) step_->setFrozen(freeze->isFrozen);
  if (image && std::holds_alternative<FrameMade>(event.what)) step_->see(*image);
}

void ExercisePlayer::tick() {
  if (case_ && !plan_) return plan();
  if (!run_ || !run_->isRunning()) return timer_.stop();
  const double now_s = host_.scan().now_s();
  step_->refresh(now_s);
  if (run_->takeTimeUp(now_s)) endExercise();
}

void ExercisePlayer::endExercise() {
  if (!run_ || !run_->isRunning()) return;
  const auto outcome = run_->endStep(step_->handed(), host_.scan().now_s());
  if (!outcome) return tell(outcome.error());
  timer_.stop();
  if (const auto scanned = host_.scan().scanned(); std::holds_alternative<PointTask>(shown_.task) && plan_ && scanned)
    target_ = std::make_unique<TargetShown>(host_, shown_, StepScene{std::make_shared<const CaseTruth>(plan_->ground.truth), *scanned},
                                            step_->point());
  step_->end();
  RepetitionState before;
  for (const RepetitionState& each : states_)
    if (each.exerciseId == exercise_.id) before = each;
  keep(*outcome, before);
  pages_->setCurrentIndex(kJudged);
}

void ExercisePlayer::keep(const StepOutcome& outcome, const RepetitionState& before) {
  const int grade = gradeOf(outcome, outcome.hints);
  const auto when = thisMoment();
  auto kept = isKept_ ? keepTry(file_, exercise_.id, grade, when)
                      : Result<RepetitionRecord>(RepetitionRecord{withTry(states_, exercise_.id, grade, when), {}});
  if (!kept) {
    isKept_ = false;
    tell(kept.error());
    kept = RepetitionRecord{withTry(states_, exercise_.id, grade, when), {}};
  }
  if (kept->note) host_.window().warn(words(*kept->note).toStdString(), "exercises");
  states_ = std::move(kept->states);
  RepetitionState now;
  for (const RepetitionState& each : states_)
    if (each.exerciseId == exercise_.id) now = each;
  const auto days = static_cast<int>(now.interval_days + 0.5);
  QString then = !outcome.passed() ? tr("It comes again in a few minutes.")
                 : days <= 1       ? tr("It comes again tomorrow.")
                                   : tr("It comes again in %1 days.").arg(days);
  if (now.level > before.level) then += QLatin1Char(' ') + tr("Then a little harder: level %1.").arg(now.level);
  if (now.level < before.level) then += QLatin1Char(' ') + tr("Then a little easier: level %1.").arg(now.level);
  outcome_->showExercise(shown_, outcome, then);
}

void ExercisePlayer::leave() {
  if (case_) finish();
}

void ExercisePlayer::tell(const Error& problem) {
  host_.log().warn(problem.sentence());
  Q_EMIT failed(words(problem));
}

void ExercisePlayer::finish() {
  timer_.stop();
  target_.reset();
  ++jobs_;
  run_.reset();
  step_->end();
  plan_.reset();
  case_.reset();
  Q_EMIT ended();
}

}  // namespace ew::lessons
