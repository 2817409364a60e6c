#include "panel/player_panel.h"

#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <memory>
#include <utility>

#include "ew/assessment/attempt_result.h"
#include "ew/assessment/repetition_record.h"
#include "ew/library/lesson_links.h"
#include "ew/sdk/case_parts.h"
#include "ew/sdk/person.h"
#include "ew/sdk/window.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/exercise_card.h"
#include "panel/exercise_player.h"
#include "panel/lesson_list.h"
#include "panel/lesson_player.h"

namespace ew::lessons {

namespace {

enum PanelPage { kEmpty, kList, kPlayer, kExercises, kReading };

constexpr const char* kListedFolder = "listedFolder";  ///< property of the list: of the case whose lessons it shows

std::filesystem::path ownAttempts() { return attemptsFolder(libraryFolder()); }

/// As the library judges, but by the lessons of the open case while these are as they were tried: it may lie where no library looks. It
/// reads cases, and so belongs into a job.
AttemptJudge judgeBy(const std::vector<Lesson>& lessons) {
  return [lessons, byLibrary = attemptJudgeOf(libraryFolder())](const std::filesystem::path& folder, const Attempt& attempt) {
    const auto lesson = std::find_if(lessons.begin(), lessons.end(), [&](const Lesson& each) { return each.id == attempt.lessonId; });
    if (lesson == lessons.end() || contentOf(*lesson) != attempt.lessonContent) return byLibrary(folder, attempt);
    const auto plan = readPlan(libraryFolder(), attempt.caseId, attempt.lessonId);
    const AttemptResult result = attemptResultOf(attempt, &*lesson, plan ? *plan : AssessmentPlan{}, latestScore(folder));
    return AttemptTally{result.stepsPassed, result.stepsJudged, result.passed().value_or(false)};
  };
}

}  // namespace

/// What the list shows, as a job reads it.
struct PlayerPanel::Listing {
  CaseWords words;
  std::vector<Lesson> translated;
  std::vector<LessonStanding> standings;  ///< of each
  std::vector<RepetitionState> repetitions;
  Message note;  ///< on these; may be empty

  static Listing of(const Case& home, const std::vector<Lesson>& lessons, const std::string& person, const std::string& language) {
    Listing read;
    AttemptList attempts = listAttempts(ownAttempts());
    std::erase_if(attempts.attempts, [&](const auto& each) { return each.second.caseId != home.id; });
    const LearningProgress standings(attempts, person, judgeBy(lessons));
    read.words = wordsOf(home.folder, language);
    for (const Lesson& lesson : lessons) {
      read.standings.push_back(standings.of(home.id, lesson));
      read.translated.push_back(ew::translated(lesson, read.words));
    }
    // What it cannot be read for is told when they begin.
    if (const auto kept = readRepetition(repetitionFile(libraryFolder(), person))) {
      read.repetitions = kept->states;
      if (kept->note) read.note = *kept->note;
    }
    return read;
  }
};

PlayerPanel::PlayerPanel(sdk::Host& host, std::function<void(bool)> working, QWidget* parent)
    : QWidget(parent), host_(host), working_(std::move(working)) {
  setObjectName(QStringLiteral("lessonPlayer"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("lessonProblem"));
  problem_->setMargin(2 * kGrid_px);
  column->addWidget(problem_);
  pages_ = new QStackedWidget;
  pages_->addWidget(emptyState(tr("No lessons here"), tr("Open a case that has lessons: the start page says how many each has.")));
  auto* listPage = new QWidget;
  auto* listRows = new QVBoxLayout(listPage);
  listRows->setContentsMargins(0, 0, 0, 0);
  listRows->setSpacing(0);
  list_ = new LessonList;
  listRows->addWidget(list_, 1);
  card_ = new ExerciseCard;
  listRows->addWidget(card_);
  pages_->addWidget(listPage);
  player_ = new LessonPlayer(host_);
  pages_->addWidget(player_);
  exercises_ = new ExercisePlayer(host_);
  pages_->addWidget(exercises_);
  pages_->addWidget(new QWidget);
  column->addWidget(pages_, 1);

  connect(list_, &LessonList::startAsked, this, [this](const QString& id) { begin(id.toStdString()); });
  connect(list_, &LessonList::goOnAsked, this, [this](const QString& id) { goOn(id.toStdString(), Asked::byList); });
  connect(card_, &ExerciseCard::startAsked, this, &PlayerPanel::beginExercises);
  connect(card_, &ExerciseCard::personChanged, this, &PlayerPanel::showLessons);
  connect(player_, &LessonPlayer::ended, this, &PlayerPanel::stop);
  connect(exercises_, &ExercisePlayer::ended, this, &PlayerPanel::stop);
  connect(exercises_, &ExercisePlayer::failed, this, [this](const QString& problem) { setProblem(problem_, problem); });
  connect(exercises_, &ExercisePlayer::problemGone, this, [this] { setProblem(problem_, {}); });
  connect(player_, &LessonPlayer::failed, this, [this](const QString& problem) { setProblem(problem_, problem); });
  connect(player_, &LessonPlayer::problemGone, this, [this] { setProblem(problem_, {}); });

  tickets_ = {host_.cases().onChanged([this] { showCase(); }),
              host_.caseParts().onOpened([this](const std::filesystem::path&) { showCase(); }),
              host_.caseParts().onAsked(std::string(kLessonsPart), [this](const std::string& item) {
                if (lessonOf(item) == nullptr) return;
                player_->leave();
                exercises_->leave();
                const bool isLaunched = !launchOfEnvironment().empty() && !std::exchange(hasBegunLaunched_, true);
                const Asked asked = isLaunched ? Asked::byLaunch : Asked::byWindow;
                if (isListing_)
                  askedMeanwhile_.emplace(item, asked);
                else
                  goOn(item, asked);
              })};
  showCase();
}

PlayerPanel::~PlayerPanel() = default;

const Lesson* PlayerPanel::lessonOf(const std::string& id) const {
  for (const Lesson& lesson : lessons_)
    if (lesson.id == id) return &lesson;
  return nullptr;
}

void PlayerPanel::showCase() {
  const std::vector<Lesson> before = std::move(lessons_);
  const std::filesystem::path folderBefore = case_ ? case_->folder : std::filesystem::path();
  case_ = host_.cases().forPractice();
  if (!case_ || case_->folder != folderBefore) askedMeanwhile_.reset();
  lessons_.clear();
  if (case_) {
    auto lessons = lessonsOf(*case_);
    if (lessons)
      lessons_ = std::move(*lessons);
    else
      setProblem(problem_, words(lessons.error()));
  }
  // Told of every edit of the case; attempts are read again only when what is listed is another.
  const bool isListed = pages_->currentIndex() == kList && case_ && case_->folder == folderBefore && lessons_ == before;
  if (!isAtWork() && !isListed) showLessons();
}

bool PlayerPanel::isAtWork() const { return player_->run() != nullptr || exercises_->isRunning(); }

void PlayerPanel::stop() {
  if (working_) working_(false);
  pages_->setCurrentIndex(kReading);  // what is listed is read anew
  showCase();
}

void PlayerPanel::showLessons() {
  const int mine = ++listings_;
  isListing_ = false;
  if (!case_ || (lessons_.empty() && !ExerciseCard::couldAsk(*case_))) return pages_->setCurrentIndex(kEmpty);
  if (pages_->currentIndex() != kList || list_->property(kListedFolder).toString() != words(case_->folder.string()))
    pages_->setCurrentIndex(kReading);
  isListing_ = true;
  auto read = std::make_shared<Listing>();
  host_.jobs().start(
      tr("Reading your attempts").toStdString(),
      [read, home = *case_, lessons = lessons_, person = sdk::personWhoLearns(),
       language = QLocale().name().toStdString()](Progress&) -> Result<void> {
        *read = Listing::of(home, lessons, person, language);
        return {};
      },
      [panel = QPointer<PlayerPanel>(this), read, mine](const Result<void>& done) {
        if (panel && panel->listings_ == mine) panel->takeListing(*read, done);
      });
}

void PlayerPanel::takeListing(const Listing& read, const Result<void>& done) {
  isListing_ = false;
  const auto asked = std::exchange(askedMeanwhile_, std::nullopt);  // who has begun something else meanwhile wants that
  if (isAtWork()) return;
  if (!done && done.error().code != ErrorCode::cancelled) fail(done.error());
  if (done) showListing(read);
  if (asked) goOn(asked->first, asked->second);
}

void PlayerPanel::showListing(const Listing& read) {
  words_ = read.words;
  list_->showLessons(read.translated, read.standings);
  list_->setProperty(kListedFolder, words(case_->folder.string()));
  if (!read.note.empty()) host_.window().warn(words(read.note).toStdString(), "exercises");
  const bool allFinished =
      std::all_of(read.standings.begin(), read.standings.end(), [](const LessonStanding& each) { return each.attempts > 0; });
  card_->showCase(*case_, words_, read.repetitions, allFinished && !lessons_.empty());
  pages_->setCurrentIndex(kList);
}

void PlayerPanel::beginExercises() {
  if (!case_) return;
  if (working_) working_(true);
  pages_->setCurrentIndex(kExercises);
  exercises_->begin(*case_, words_, card_->withFindings());
}

void PlayerPanel::begin(const std::string& lessonId) {
  const Lesson* lesson = lessonOf(lessonId);
  if (lesson == nullptr || !case_) return;
  take(LessonRun::begin(*lesson, case_->id, sdk::personWhoLearns(), ownAttempts(), case_->sealed ? case_->sealed->sha256 : std::string()));
}

std::optional<StepAutosave::Left> PlayerPanel::leftOf(const std::string& lessonId, const AttemptList& attempts) const {
  std::vector<std::filesystem::path> tried;
  for (const auto& [folder, attempt] : attempts.attempts)
    if (attempt.caseId == case_->id && attempt.lessonId == lessonId && countsFor(attempt, sdk::personWhoLearns())) tried.push_back(folder);
  return player_->kept().takeLeftOfAny(tried);
}

void PlayerPanel::goOn(const std::string& lessonId, Asked asked) {
  const Lesson* lesson = lessonOf(lessonId);
  if (lesson == nullptr || !case_) return;
  const AttemptList attempts = listAttempts(ownAttempts());
  const auto interrupted = LearningProgress(attempts, sdk::personWhoLearns()).of(case_->id, *lesson).interrupted;
  auto left = asked != Asked::byList ? leftOf(lessonId, attempts) : interrupted ? player_->kept().takeLeft(*interrupted) : std::nullopt;
  if (!left && !interrupted) return begin(lessonId);
  auto kept = AttemptFolder::open(left ? left->attempt : *interrupted);
  if (!kept) return fail(kept.error());
  const std::string launch = launchOfEnvironment();
  const bool isUntold = !launch.empty() && kept->attempt().launch != launch;
  if (isUntold && asked == Asked::byLaunch) return begin(lessonId);
  const bool hasScanned = left && left->log.frameCount() > 0 && left->stepId == kept->attempt().runningStep;
  if (left && !hasScanned && kept->attempt().finishedAt) {  // the program ended after the lesson did
    left->kept->discard();
    if (interrupted || asked == Asked::byLaunch) return goOn(lessonId, asked);
    return host_.window().info(tr("This lesson was finished before the program ended; nothing of it was lost.").toStdString(), "step lost");
  }
  const bool isChanged = kept->attempt().lessonContent != contentOf(*lesson);
  auto run = LessonRun::goOnWith(*lesson, std::move(*kept));
  if (!run) return fail(run.error());
  if (hasScanned) static_cast<void>(run->goBackToLost());
  const bool isLost = !run->isOver() && run->step().id == run->lostStep();
  const bool isKept = isLost && hasScanned;
  take(std::move(run), std::move(left));
  if (isUntold)
    host_.window().info(tr("This attempt began before the learning system started the lesson; its result is not told there.").toStdString(),
                        "attempt not told");
  if (isChanged)
    host_.window().info(tr("The lesson was changed since this attempt began; its steps are those of today.").toStdString(),
                        "lesson changed");
  if (isKept)
    host_.window().info(
        tr("The step goes on where it stood when the program ended; what was entered by hand has to be entered again.").toStdString(),
        "step lost");
  else if (isLost)
    host_.window().info(tr("The step that was running when the program ended was not kept; it begins anew.").toStdString(), "step lost");
}

void PlayerPanel::take(Result<LessonRun> run, std::optional<StepAutosave::Left> left) {
  if (!run) return fail(run.error());
  if (working_) working_(true);
  pages_->setCurrentIndex(kPlayer);
  player_->play(std::move(*run), *case_, words_, std::move(left));
}

void PlayerPanel::fail(const Error& problem) {
  host_.log().warn(problem.sentence());
  setProblem(problem_, words(problem));
}

}  // namespace ew::lessons
