#include "panel/player_panel.h"

#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ew/library/lesson_links.h"
#include "ew/scanning/picture_file.h"
#include "ew/sdk/case_parts.h"
#include "ew/sdk/panel.h"
#include "ew/sdk/window.h"
#include "panel/lesson_list.h"
#include "panel/outcome_page.h"
#include "panel/step_page.h"

namespace ew::lessons {

using sdk::words;

namespace {

enum Page { kEmpty, kList, kWaiting, kStep, kOutcome };
constexpr int kTick_ms = 250;

std::filesystem::path attemptsFolder() { return libraryFolder() / "attempts"; }
std::filesystem::path partFolder(const std::filesystem::path& caseFolder) { return caseFolder / "parts" / std::string(kLessonsPart); }

}  // namespace

Result<std::filesystem::path> folderOfCase(const std::string& id) {
  std::vector<std::filesystem::path> roots;
  if (auto shipped = shippedCasesFolder()) roots.push_back(*shipped);
  roots.push_back(ownCasesFolder());
  for (const auto& root : roots)
    for (const Case& each : listCases(root).cases)
      if (each.id == id) return each.folder;
  return failure(ErrorCode::notFound, say<"The case '%1', which this step scans, is not in the library; import it first.">(id));
}

PlayerPanel::PlayerPanel(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  setObjectName(QStringLiteral("lessonPlayer"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  problem_ = sdk::problemLabel();
  problem_->setObjectName(QStringLiteral("lessonProblem"));
  problem_->setMargin(2 * sdk::kGap_px);
  column->addWidget(problem_);
  pages_ = new QStackedWidget;
  pages_->addWidget(sdk::emptyState(tr("No lessons here"), tr("Open a case that has lessons: the start page says how many each has.")));
  list_ = new LessonList;
  pages_->addWidget(list_);
  waiting_ = sdk::quietLabel({});
  waiting_->setObjectName(QStringLiteral("lessonWaiting"));
  waiting_->setAlignment(Qt::AlignCenter);
  pages_->addWidget(waiting_);
  step_ = new StepPage(host_);
  pages_->addWidget(step_);
  outcome_ = new OutcomePage;
  pages_->addWidget(outcome_);
  column->addWidget(pages_, 1);

  connect(list_, &LessonList::startAsked, this, [this](const QString& id) { begin(id.toStdString()); });
  connect(list_, &LessonList::goOnAsked, this, [this](const QString& id) { goOn(id.toStdString()); });
  connect(step_, &StepPage::doneAsked, this, &PlayerPanel::endStep);
  connect(step_, &StepPage::skipAsked, this, &PlayerPanel::skipStep);
  connect(step_, &StepPage::leaveAsked, this, &PlayerPanel::leave);
  connect(step_, &StepPage::pauseAsked, this, [this](bool paused) {
    if (!run_) return;
    const double now_s = host_.scan().now_s();
    if (paused)
      run_->pause(now_s);
    else
      run_->goOn(now_s);
  });
  connect(outcome_, &OutcomePage::againAsked, this, &PlayerPanel::openStep);
  connect(outcome_, &OutcomePage::nextAsked, this, &PlayerPanel::nextStep);
  timer_.setInterval(kTick_ms);
  connect(&timer_, &QTimer::timeout, this, &PlayerPanel::tick);

  tickets_ = {host_.cases().onChanged([this] { showCase(); }), host_.caseParts().onOpened([this](const std::filesystem::path&) {
                leaveForAnotherCase();
                truth_.reset();
                ++loads_;
                showCase();
                if (run_ && !run_->isOver() && !run_->isRunning() && pages_->currentIndex() == kWaiting) openStep();
              }),
              host_.caseParts().onAsked(std::string(kLessonsPart),
                                        [this](const std::string& item) {
                                          if (lessonOf(item) != nullptr && !run_) begin(item);
                                        }),
              host_.scan().onEvent([this](const ScanEvent& event) {
                if (run_ && run_->isRunning()) take(event);
              })};
  showCase();
}

PlayerPanel::~PlayerPanel() {
  tickets_.clear();
  if (run_ && run_->isRunning()) static_cast<void>(run_->leave());  // the window closes: the step begins anew next time
}

const Lesson* PlayerPanel::lessonOf(const std::string& id) const {
  for (const Lesson& lesson : lessons_)
    if (lesson.id == id) return &lesson;
  return nullptr;
}

void PlayerPanel::showCase() {
  const auto manifest = host_.cases().current();
  const std::vector<Lesson> before = std::move(lessons_);
  const std::filesystem::path folderBefore = case_ ? case_->folder : std::filesystem::path();
  case_.reset();
  lessons_.clear();
  if (manifest) {
    if (auto opened = caseFromManifest(*manifest, host_.cases().currentFolder())) case_ = std::move(*opened);
  }
  if (case_) {
    auto lessons = lessonsOf(*case_);
    if (lessons)
      lessons_ = std::move(*lessons);
    else
      sdk::setProblem(problem_, words(lessons.error()));
  }
  // Told of every edit of the case; attempts are read again only when what is listed is another.
  const bool isListed = pages_->currentIndex() == kList && case_ && case_->folder == folderBefore && lessons_ == before;
  if (!run_ && !isListed) showLessons();
}

void PlayerPanel::showLessons() {
  timer_.stop();
  step_->end();
  if (lessons_.empty()) return pages_->setCurrentIndex(kEmpty);
  const AttemptList attempts = listAttempts(attemptsFolder());
  words_ = wordsOf(case_->folder, QLocale().name().toStdString());
  std::vector<LessonProgress> progress;
  std::vector<Lesson> shown;
  for (const Lesson& lesson : lessons_) {
    progress.push_back(progressOf(lesson, case_->id, attempts));
    shown.push_back(translated(lesson, words_));
  }
  list_->showLessons(shown, progress);
  pages_->setCurrentIndex(kList);
}

void PlayerPanel::begin(const std::string& lessonId) {
  const Lesson* lesson = lessonOf(lessonId);
  if (lesson == nullptr || !case_) return;
  take(LessonRun::begin(*lesson, case_->id, {}, attemptsFolder()));
}

void PlayerPanel::goOn(const std::string& lessonId) {
  const Lesson* lesson = lessonOf(lessonId);
  if (lesson == nullptr || !case_) return;
  const LessonProgress progress = progressOf(*lesson, case_->id, listAttempts(attemptsFolder()));
  if (!progress.interrupted) return begin(lessonId);
  auto kept = KeptAttempt::open(*progress.interrupted);
  if (!kept) return fail(kept.error());
  const bool isChanged = kept->attempt().lessonContent != contentOf(*lesson);
  take(LessonRun(*lesson, std::move(*kept)));
  if (isChanged && run_)
    host_.window().info(tr("The lesson was changed since this attempt began; its steps are those of today.").toStdString());
  if (run_ && !run_->lostStep().empty())
    host_.window().info(tr("The step that was running when the program ended was not kept; it begins anew.").toStdString());
}

void PlayerPanel::take(Result<LessonRun> run) {
  if (!run) return fail(run.error());
  sdk::setProblem(problem_, {});
  homeCase_ = case_->id;
  homeFolder_ = case_->folder;
  run_.emplace(std::move(*run));
  if (run_->isOver()) return nextStep();
  openStep();
}

void PlayerPanel::openStep() {
  const std::string wanted = run_->step().caseId.empty() ? homeCase_ : run_->step().caseId;
  sdk::setProblem(problem_, {});
  waiting_->setText(tr("Getting the step ready…"));
  pages_->setCurrentIndex(kWaiting);
  if (!case_ || case_->id != wanted) {
    const auto folder = wanted == homeCase_ ? Result<std::filesystem::path>(homeFolder_) : folderOfCase(wanted);
    if (!folder) return fail(folder.error());
    if (auto opening = host_.cases().open(*folder); !opening) return fail(opening.error());
    waiting_->setText(tr("Opening the case of this step…"));
    return;
  }
  if (truth_) return startStep(truth_);
  loadTruth();
}

void PlayerPanel::loadTruth() {
  const int load = ++loads_;
  auto found = std::make_shared<CaseTruth>();
  host_.jobs().start(
      tr("Getting the step ready").toStdString(),
      [found, opened = *case_](Progress& progress) -> Result<void> {
        auto truth = loadCaseTruth(opened, progress);
        if (!truth) return passOn(truth.error());
        *found = std::move(*truth);
        return {};
      },
      [panel = QPointer<PlayerPanel>(this), found, load](const Result<void>& done) {
        if (!panel || panel->loads_ != load || !panel->run_) return;
        if (!done) return panel->fail(done.error());
        panel->truth_ = found;
        panel->startStep(found);
      });
}

void PlayerPanel::startStep(std::shared_ptr<const CaseTruth> truth) {
  const auto scanned = host_.scan().scanned();
  if (!scanned) {  // the volume is being prepared: the first image of it goes on
    waiting_->setText(tr("The volume of this case is being made ready…"));
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
  std::filesystem::path picture;
  if (const auto* read = std::get_if<ReadTask>(&step.task); read != nullptr && !read->picture.empty())
    picture = partFolder(homeFolder_) / read->picture;
  if (auto frozen = host_.scan().setFrozen(false); !frozen) return fail(frozen.error());
  StepScene scene{std::move(truth), *scanned};
  if (auto started = run_->startStep(scene, host_.scan().now_s()); !started) return fail(started.error());
  Lesson one;
  one.steps = {step};
  step_->showStep(*run_, translated(one, words_).steps.front(), scene, std::move(recording), picture);
  // A probe that rests makes no image by itself: what is shown already counts.
  if (const auto state = host_.scan().state()) take({state->time_s, FrameMade{state->pose, state->gaps_mm, state->number, state->body}});
  pages_->setCurrentIndex(kStep);
  timer_.start();
}

void PlayerPanel::take(const ScanEvent& event) {
  const auto image = host_.scan().state();
  run_->see(event, image);
  if (image && std::holds_alternative<FrameMade>(event.what)) step_->see(*image);
}

void PlayerPanel::tick() {
  if (!run_) return timer_.stop();
  if (!run_->isRunning()) {
    if (pages_->currentIndex() == kWaiting && truth_ && host_.scan().scanned()) startStep(truth_);
    return;
  }
  const double now_s = host_.scan().now_s();
  step_->refresh(now_s);
  if (const auto left_s = run_->left_s(now_s); left_s && *left_s <= 0.0) endStep();
}

std::vector<std::string> PlayerPanel::keepPicture(const KeptAttempt& attempt) const {
  const auto state = host_.scan().state();
  const Picture picture = host_.scan().picture();
  if (!state || picture.isEmpty()) return {};
  const std::string name = attempt.nameForFile(run_->step().id, ".png");
  if (const auto written = writePicture(picture, host_.scan().geometry().pixel_mm, attempt.folder() / name); !written)
    return {};  // the outcome is worth keeping without
  return {name};
}

void PlayerPanel::endStep() {
  if (!run_ || !run_->isRunning()) return;
  const auto outcome =
      run_->endStep(step_->handed(), host_.scan().now_s(), [this](const KeptAttempt& attempt) { return keepPicture(attempt); });
  if (!outcome) return fail(outcome.error());
  timer_.stop();
  step_->end();
  Lesson one;
  one.steps = {run_->step()};
  StepOutcome shown = *outcome;
  for (AttemptRemark& remark : shown.remarks)
    if (remark.text.text() == nullptr) remark.text = verbatim(words_.of(remark.text.english()));
  outcome_->showStep(translated(one, words_).steps.front(), shown, run_->at() + 1 == run_->lesson().steps.size());
  pages_->setCurrentIndex(kOutcome);
}

void PlayerPanel::skipStep() {
  if (!run_ || !run_->isRunning()) return;
  if (const auto outcome = run_->skipStep(host_.scan().now_s()); !outcome) return fail(outcome.error());
  step_->end();
  nextStep();
}

void PlayerPanel::nextStep() {
  if (!run_) return;
  if (run_->isOver()) {  // back from the summary
    run_.reset();
    return showCase();
  }
  if (auto gone = run_->next(); !gone) return fail(gone.error());
  if (!run_->isOver()) return openStep();
  timer_.stop();
  outcome_->showLesson(*run_);
  pages_->setCurrentIndex(kOutcome);
}

void PlayerPanel::leave() {
  if (run_ && run_->isRunning())
    if (auto left = run_->leave(); !left) return fail(left.error());
  run_.reset();
  step_->end();
  showCase();
}

void PlayerPanel::leaveForAnotherCase() {
  if (!run_ || pages_->currentIndex() == kWaiting) return;  // the case of the next step is what was waited for
  if (run_->isOver() || (case_ && host_.cases().currentFolder() == case_->folder)) return;
  if (run_->isRunning())
    if (auto left = run_->leave(); !left) host_.log().warn(left.error().sentence());
  run_.reset();
  step_->end();
  host_.window().info(tr("The lesson was left because another case was opened; it can be gone on with in its own case.").toStdString(),
                      "lesson left");
}

void PlayerPanel::fail(const Error& problem) {
  host_.log().warn(problem.sentence());
  sdk::setProblem(problem_, words(problem));
  // A step that runs goes on; anything else leads back to the lessons, and the attempt can be gone on with.
  if (run_ && run_->isRunning()) return;
  run_.reset();
  step_->end();
  showLessons();
}

}  // namespace ew::lessons
