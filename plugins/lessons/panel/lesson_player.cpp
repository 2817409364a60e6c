#include "panel/lesson_player.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ew/imaging/orientation_marker.h"
#include "ew/library/learning_progress.h"
#include "ew/scanning/display_image_file.h"
#include "ew/sdk/case_parts.h"
#include "ew/sdk/window.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/wrong_settings.h"
#include "panel/aids_drawer.h"
#include "panel/outcome_page.h"
#include "panel/step_page.h"

namespace ew::lessons {

namespace {

enum PlayerPage { kWaiting, kStep, kOutcome };
constexpr int kTick_ms = 250;
constexpr double kKeepEvery_s = 1.0;  ///< so much of a step a crash may take

std::filesystem::path partFolder(const std::filesystem::path& caseFolder) { return caseFolder / "parts" / std::string(kLessonsPart); }

}  // namespace

Result<std::filesystem::path> folderOfCase(const std::string& id) {
  if (auto found = findCase(id, libraryFolder())) return std::move(*found);
  return failure(ErrorCode::notFound, say<"The case '%1', which this step scans, is not in the library; import it first.">(id));
}

LessonPlayer::LessonPlayer(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host), folder_(host.cases().currentFolder()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget;
  pages_->addWidget(makeWaiting());
  step_ = new StepPage(host_);
  pages_->addWidget(step_);
  outcome_ = new OutcomePage;
  pages_->addWidget(outcome_);
  column->addWidget(pages_);

  connect(step_, &StepPage::doneAsked, this, &LessonPlayer::endStep);
  connect(step_, &StepPage::skipAsked, this, &LessonPlayer::skipStep);
  connect(step_, &StepPage::leaveAsked, this, &LessonPlayer::leave);
  connect(step_, &StepPage::pauseAsked, this, [this](bool paused) {
    if (!run_) return;
    const double now_s = host_.scan().now_s();
    if (paused)
      run_->pause(now_s);
    else
      run_->goOn(now_s);
  });
  connect(outcome_, &OutcomePage::againAsked, this, &LessonPlayer::openStep);
  connect(outcome_, &OutcomePage::nextAsked, this, &LessonPlayer::nextStep);
  connect(outcome_, &OutcomePage::stepAsked, this, [this](int step) {
    if (!run_ || !run_->isOver()) return;
    run_->goBackTo(static_cast<std::size_t>(step));
    openStep();
  });
  timer_.setInterval(kTick_ms);
  connect(&timer_, &QTimer::timeout, this, &LessonPlayer::tick);
  tickets_ = {host_.caseParts().onOpened([this](const std::filesystem::path&) { takeCase(); }),
              host_.scan().onEvent([this](const ScanEvent& event) {
                if (run_ && run_->isRunning()) take(event);
              })};
}

LessonPlayer::~LessonPlayer() {
  tickets_.clear();
  if (run_ && run_->isRunning()) static_cast<void>(run_->leave());  // the window closes: the step begins anew next time
}

QWidget* LessonPlayer::makeWaiting() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  leaveWaiting_ = new QPushButton(tr("Leave"));
  leaveWaiting_->setObjectName(QStringLiteral("leaveWaiting"));
  leaveWaiting_->setToolTip(tr("Back to the lessons; the lesson can be gone on with later"));
  QSizePolicy place = leaveWaiting_->sizePolicy();
  place.setRetainSizeWhenHidden(true);
  leaveWaiting_->setSizePolicy(place);
  connect(leaveWaiting_, &QPushButton::clicked, this, &LessonPlayer::leave);
  auto* top = new QHBoxLayout;
  top->addWidget(leaveWaiting_);
  top->addStretch(1);
  column->addLayout(top);
  waiting_ = quietLabel({});
  waiting_->setObjectName(QStringLiteral("lessonWaiting"));
  waiting_->setAlignment(Qt::AlignCenter);
  column->addWidget(waiting_, 1);
  return page;
}

std::optional<Case> LessonPlayer::openCase() const { return host_.cases().forPractice(); }

void LessonPlayer::play(LessonRun run, const Case& home, CaseWords words, std::optional<StepAutosave::Left> left) {
  Q_EMIT problemGone();
  homeCase_ = home.id;
  homeFolder_ = home.folder;
  homeTitle_ = titleForTrainees(home);
  left_ = std::move(left);
  words_ = std::move(words);
  run_.emplace(std::move(run));
  truth_.reset();  // the case may have been edited since
  ++loads_;
  if (run_->isOver()) {  // the window was closed on its last outcome
    if (left_) left_->kept->discard();
    left_.reset();
    return showSummary();
  }
  openStep();
}

void LessonPlayer::takeCase() {
  leaveForAnotherCase();
  folder_ = host_.cases().currentFolder();
  truth_.reset();
  ++loads_;
  if (run_ && !run_->isOver() && !run_->isRunning() && pages_->currentIndex() == kWaiting) openStep();
}

void LessonPlayer::openStep() {
  target_.reset();
  const std::string wanted = run_->step().caseId.empty() ? homeCase_ : run_->step().caseId;
  Q_EMIT problemGone();
  waiting_->setText(tr("Getting the step ready…"));
  leaveWaiting_->hide();  // what is gone in a moment is not to be pressed by mistake
  pages_->setCurrentIndex(kWaiting);
  const auto opened = openCase();
  if (!opened || opened->id != wanted) return wanted == homeCase_ ? openCaseIn(homeFolder_) : findAndOpen(wanted);
  if (truth_) return startStep(truth_);
  loadTruth(*opened);
}

void LessonPlayer::openCaseIn(const std::filesystem::path& folder) {
  if (auto opening = host_.cases().open(folder); !opening) return fail(opening.error());
  waitFor(tr("Opening the case of this step…"));
}

void LessonPlayer::findAndOpen(const std::string& caseId) {
  const int load = ++loads_;
  waitFor(tr("Getting the step ready…"));  // every case of the library may have to be read
  auto found = std::make_shared<std::filesystem::path>();
  host_.jobs().start(
      tr("Looking for the case of this step").toStdString(),
      [found, caseId](Progress&) -> Result<void> {
        auto folder = folderOfCase(caseId);
        if (!folder) return passOn(folder.error());
        *found = std::move(*folder);
        return {};
      },
      [panel = QPointer<LessonPlayer>(this), found, load](const Result<void>& done) {
        if (!panel || panel->loads_ != load || !panel->run_) return;
        if (!done) return panel->fail(done.error());
        panel->openCaseIn(*found);
      });
}

void LessonPlayer::waitFor(const QString& what) {
  waiting_->setText(what);
  leaveWaiting_->show();
}

void LessonPlayer::loadTruth(const Case& opened) {
  const int load = ++loads_;
  auto found = std::make_shared<CaseTruth>();
  host_.jobs().start(
      tr("Getting the step ready").toStdString(),
      [found, opened](Progress& progress) -> Result<void> {
        auto truth = loadCaseTruth(opened, progress);
        if (!truth) return passOn(truth.error());
        *found = std::move(*truth);
        return {};
      },
      [panel = QPointer<LessonPlayer>(this), found, load](const Result<void>& done) {
        if (!panel || panel->loads_ != load || !panel->run_) return;
        if (!done) return panel->fail(done.error());
        panel->truth_ = found;
        panel->startStep(found);
      });
}

void LessonPlayer::startStep(std::shared_ptr<const CaseTruth> truth) {
  const auto scanned = host_.scan().scanned();
  if (!scanned) {  // the volume is being prepared: the first image of it goes on
    waitFor(tr("The volume of this case is being made ready…"));
    timer_.start();
    return;
  }
  const LessonStep& step = run_->step();
  std::optional<ScanRecording> recording;
  if (const auto* watch = std::get_if<WatchTask>(&step.task)) {
    auto read = readRecording(partFolder(homeFolder_) / watch->recording);
    if (!read) return fail(read.error());
    recording = std::move(*read);
  }
  std::filesystem::path image;
  if (const auto* read = std::get_if<ReadingTask>(&step.task); read != nullptr && !read->image.empty())
    image = partFolder(homeFolder_) / read->image;
  if (auto frozen = host_.scan().setFrozen(false); !frozen) return fail(frozen.error());
  truth_ = std::move(truth);
  const StepScene scene = sceneOf(*scanned);
  const auto* settings = std::get_if<SettingsTask>(&step.task);
  const bool isImageComing = settings != nullptr && setWrong(*settings, *scanned);
  if (auto started = run_->startStep(scene, host_.scan().now_s()); !started) return fail(started.error());
  takeUpLeft();
  Lesson one;
  one.steps = {step};
  step_->showStep(*run_, translated(one, words_).steps.front(), scene, std::move(recording), image);
  // A probe that rests makes no image by itself: what is shown already counts.
  if (const auto state = host_.scan().state(); state && !isImageComing)
    take({state->time_s, FrameMade{state->pose, state->gaps_mm, state->number, state->body}});
  pages_->setCurrentIndex(kStep);
  timer_.start();
}

/// What a crash has left of the step that has just started, if it is of this one; then it is kept here.
void LessonPlayer::takeUpLeft() {
  const double now_s = host_.scan().now_s();
  const auto left = std::exchange(left_, std::nullopt);
  if (left && left->stepId == run_->step().id && left->log.frameCount() > 0) {
    run_->resume(left->log, left->used_s, left->hints, now_s);
    // The machine and the probe stand as they stood: what is not there any more (another probe) stays as it is.
    const ScanState last = left->log.frame(left->log.frameCount() - 1);
    for (const Result<void>& done :
         {host_.scan().chooseProbe(last.probe.id), host_.scan().apply(last.knobs), host_.scan().placeProbe(last.pose.probeToWorld)})
      if (!done) host_.log().info(done.error().sentence());
  }
  kept_.begin(*run_, homeFolder_, homeTitle_);
  kept_.grow(*run_, now_s);
  keptAt_s_ = now_s;
  if (left) kept_.discardOnceKept(left->kept);
}

StepScene LessonPlayer::sceneOf(const sdk::Scanned& scanned) const {
  const auto opened = openCase();
  return {truth_, scanned, opened && opened->sealed};
}

/// A machine that is right already would pass the step before anybody touched it. @return whether it was set otherwise
bool LessonPlayer::setWrong(const SettingsTask& task, const sdk::Scanned& scanned) {
  const auto state = host_.scan().state();
  if (!state) return false;
  const WrongSettings wrong = wrongSettings(task, *state, scanned.probes);
  if (!before_) before_ = state;
  if (wrong.probe != state->probe.id)
    if (auto chosen = host_.scan().chooseProbe(wrong.probe); !chosen) host_.log().warn(chosen.error().sentence());
  if (auto set = host_.scan().apply(wrong.knobs); !set) host_.log().warn(set.error().sentence());
  return wrong != WrongSettings{state->probe.id, state->knobs};
}

/// A step that was set wrong and not worked through leaves the machine as it found it.
void LessonPlayer::giveSettingsBack() {
  if (!before_) return;
  const ScanState before = *std::exchange(before_, std::nullopt);
  static_cast<void>(host_.scan().setFrozen(false));  // a frozen image is set by nobody
  static_cast<void>(host_.scan().chooseProbe(before.probe.id));
  static_cast<void>(host_.scan().apply(before.knobs));
}

void LessonPlayer::take(const ScanEvent& event) {
  const auto image = host_.scan().state();
  run_->see(event, image);
  if (const auto* freeze = std::get_if<FreezeChanged>(&event.what)) step_->setFrozen(freeze->isFrozen);
  if (image && std::holds_alternative<FrameMade>(event.what)) step_->see(*image);
}

void LessonPlayer::tick() {
  if (!run_) return timer_.stop();
  if (!run_->isRunning()) {
    if (pages_->currentIndex() == kWaiting && truth_ && host_.scan().scanned()) startStep(truth_);
    return;
  }
  const double now_s = host_.scan().now_s();
  step_->refresh(now_s);
  if (now_s - keptAt_s_ >= kKeepEvery_s) {
    kept_.grow(*run_, now_s);
    keptAt_s_ = now_s;
  }
  if (!run_->takeTimeUp(now_s)) return;
  endStep();
  // What cannot be written now is not tried again and again: the step's time stands, and Done tries once more.
  if (run_ && run_->isRunning()) run_->pause(now_s);
}

std::vector<std::string> LessonPlayer::keepImage(const AttemptFolder& attempt) const {
  const auto state = host_.scan().state();
  const DisplayImage image = host_.scan().image();
  if (!state || image.isEmpty()) return {};
  const std::string name = attempt.nameForFile(run_->step().id, ".png");
  const DisplayGeometry geometry = host_.scan().geometry();
  RgbImage colours;
  GreyImage grey;
  if (image.hasColour())
    burnMarker(viewOf(colours = composed(image)), state->probe, geometry);
  else
    burnMarker(viewOf(grey = copyOf(image.grey)), state->probe, geometry);
  const auto file = attempt.folder() / name;
  const auto written = image.hasColour() ? writeDisplayImage(colours, geometry.pixel_mm, file)
                                         : writeDisplayImage(DisplayImage{viewOf(std::as_const(grey))}, geometry.pixel_mm, file);
  if (!written) return {};  // the outcome is worth keeping without
  return {name};
}

void LessonPlayer::endStep() {
  if (!run_ || !run_->isRunning()) return;
  const auto outcome =
      run_->endStep(step_->handed(), host_.scan().now_s(), [this](const AttemptFolder& attempt) { return keepImage(attempt); });
  if (!outcome) return fail(outcome.error());
  timer_.stop();
  kept_.endStep(*run_);
  before_.reset();
  const LessonStep& ended = run_->step();
  const auto scanned = host_.scan().scanned();
  if (std::holds_alternative<PointTask>(ended.task) && outcome->verdict != StepVerdict::handedIn && truth_ && scanned)
    target_ = std::make_unique<TargetShown>(host_, ended, sceneOf(*scanned), step_->point());
  step_->end();
  // Nothing was judged, and nothing is said afterwards: there is nothing to show.
  const bool isShown = std::holds_alternative<ReadingTask>(ended.task) || std::holds_alternative<WatchTask>(ended.task);
  if (isShown && ended.after.empty()) return nextStep();
  Lesson one;
  one.steps = {ended};
  StepOutcome shown = *outcome;
  for (AttemptRemark& remark : shown.remarks)
    if (remark.text.text() == nullptr) remark.text = verbatim(words_.of(remark.text.english()));
  outcome_->showStep(translated(one, words_).steps.front(), shown, run_->at() + 1 == run_->lesson().steps.size());
  pages_->setCurrentIndex(kOutcome);
}

void LessonPlayer::skipStep() {
  if (!run_ || !run_->isRunning()) return;
  if (const auto outcome = run_->skipStep(host_.scan().now_s()); !outcome) return fail(outcome.error());
  kept_.endStep(*run_);
  step_->end();
  giveSettingsBack();
  nextStep();
}

void LessonPlayer::nextStep() {
  if (!run_) return;
  target_.reset();
  if (run_->isOver()) return finish();  // back from the summary
  if (auto gone = run_->next(); !gone) return fail(gone.error());
  if (!run_->isOver()) return openStep();
  showSummary();
}

void LessonPlayer::showSummary() {
  timer_.stop();
  kept_.forget();
  const auto plan = readPlan(libraryFolder(), homeCase_, run_->lesson().id);
  outcome_->showLesson(*run_, run_->result(plan ? *plan : AssessmentPlan()));
  pages_->setCurrentIndex(kOutcome);
}

void LessonPlayer::leave() {
  if (run_ && run_->isRunning())
    if (auto left = run_->leave(); !left) return fail(left.error());
  giveSettingsBack();
  finish();
}

void LessonPlayer::finish() {
  timer_.stop();
  kept_.forget();
  left_.reset();
  target_.reset();
  run_.reset();
  step_->end();
  Q_EMIT ended();
}

void LessonPlayer::leaveForAnotherCase() {
  if (!run_ || pages_->currentIndex() == kWaiting) return;  // the case of the next step is what was waited for
  if (run_->isOver() || host_.cases().currentFolder() == folder_) return;
  before_.reset();
  if (run_->isRunning())
    if (auto left = run_->leave(); !left) host_.log().warn(left.error().sentence());
  if (run_->attempt())
    host_.window().info(tr("The lesson was left because another case was opened; it can be gone on with in its own case.").toStdString(),
                        "lesson left");
  Q_EMIT drivenOut();
  finish();
}

void LessonPlayer::fail(const Error& problem) {
  host_.log().warn(problem.sentence());
  Q_EMIT failed(words(problem));
  // A step that runs goes on; anything else leads back, and the attempt can be gone on with.
  if (run_ && run_->isRunning()) return;
  finish();
}

}  // namespace ew::lessons
