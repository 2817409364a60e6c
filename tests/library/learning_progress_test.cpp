#include "ew/library/learning_progress.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>

#include "ew/library/case.h"
#include "ew/library/published.h"
#include "library/small_case.h"
#include "library/temporary_folder.h"

namespace ew::learning_progress_test {
namespace {

namespace fs = std::filesystem;
using std::chrono::sys_seconds;
using test::EnvironmentValue;
using test::TemporaryFolder;

constexpr sys_seconds kMorning = std::chrono::sys_days(std::chrono::year(2026) / 11 / 26) + std::chrono::minutes(9 * 60 + 30);

StepOutcome ended(const std::string& step, StepVerdict verdict, int minute = 1) {
  StepOutcome made;
  made.stepId = step;
  made.verdict = verdict;
  made.at = kMorning + std::chrono::minutes(minute);
  return made;
}
StepOutcome passed(const std::string& step) { return ended(step, StepVerdict::passed); }
StepOutcome failed(const std::string& step) { return ended(step, StepVerdict::failed); }

struct Tried {
  std::string id;
  std::vector<StepOutcome> outcomes;
  bool finished = true;
  std::string lesson = "first";
  std::string person = {};
};

/// As listAttempts gives them: the latest, the one with the highest id, first.
AttemptList tried(std::vector<Tried> all) {
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.id > b.id; });
  AttemptList list;
  for (const Tried& each : all) {
    Attempt attempt;
    attempt.id = each.id;
    attempt.caseId = "home";
    attempt.lessonId = each.lesson;
    attempt.lessonTitle = "Title of " + each.lesson;
    attempt.person = each.person;
    attempt.startedAt = kMorning;
    if (each.finished) attempt.finishedAt = kMorning + std::chrono::minutes(5);
    attempt.outcomes = each.outcomes;
    list.attempts.emplace_back("/attempts/" + each.id, attempt);
  }
  return list;
}

LessonStanding firstOf(std::vector<Tried> all, const std::string& person = {}, const std::vector<std::string>& steps = {"a", "b"}) {
  return LearningProgress(tried(std::move(all)), person).of("home", "first", steps);
}

TEST(LearningProgress, NobodyHasTriedYet) {
  EXPECT_EQ(firstOf({}), LessonStanding{});
  EXPECT_FALSE(firstOf({}).isPassed(0)) << "a lesson that nobody opened is not passed, though it has no steps";
}

TEST(LearningProgress, CountTheLatestOutcomeOfEachStepOfTheBestAttempt) {
  const LessonStanding standing =
      firstOf({{"1", {passed("a"), passed("b")}}, {"2", {passed("a"), failed("b")}}, {"3", {passed("a"), failed("a"), passed("b")}}});
  EXPECT_EQ(standing.attempts, 3u);
  EXPECT_EQ(standing.bestPassed, 2u);
  EXPECT_TRUE(standing.isPassed(2));
  EXPECT_EQ(firstOf({{"3", {passed("a"), failed("a"), passed("b")}}}).bestPassed, 1u) << "what was passed first and failed then";
}

TEST(LearningProgress, StepsThatTheLessonHasNoMoreDoNotCount) {
  EXPECT_EQ(firstOf({{"1", {passed("a"), passed("gone")}}}).bestPassed, 1u);
  EXPECT_EQ(firstOf({{"1", {passed("a"), passed("gone")}}}, {}, {}).bestPassed, 2u) << "where the steps are not known";
}

TEST(LearningProgress, AnAttemptIsGoneOnWithOnlyWhileItIsTheLatest) {
  const LessonStanding stopped = firstOf({{"1", {passed("a"), passed("b")}}, {"2", {failed("a"), passed("a")}, false}});
  EXPECT_EQ(stopped.interrupted, fs::path("/attempts/2"));
  EXPECT_EQ(stopped.interruptedAt, 1u) << "a step that was repeated is one step";
  EXPECT_EQ(stopped.bestPassed, 2u);
  EXPECT_FALSE(firstOf({{"1", {passed("a")}, false}, {"2", {passed("a"), passed("b")}}}).interrupted);
}

TEST(LearningProgress, AskWhoeverJudgesAttemptsWhatEachAmountsTo) {
  const auto all =
      tried({{"1", {passed("a"), passed("b")}}, {"2", {failed("a")}}, {"3", {passed("a")}, false}, {"4", {}, true, "first", "Bo"}});
  std::vector<std::string> asked;
  const LearningProgress standings(all, "Ada", [&](const fs::path& folder, const Attempt& attempt) {
    EXPECT_EQ(folder.filename(), attempt.id);
    asked.push_back(attempt.id);
    return attempt.id == "2" ? AttemptTally{1, 1, true} : AttemptTally{0, 1, false};
  });
  std::sort(asked.begin(), asked.end());
  EXPECT_EQ(asked, (std::vector<std::string>{"1", "2"})) << "finished ones of this person";
  const LessonStanding standing = standings.of("home", "first", {"a", "b"});
  EXPECT_EQ(standing.attempts, 2u);
  EXPECT_EQ(standing.bestPassed, 1u);
  EXPECT_EQ(standing.counting(2), 1u);
  EXPECT_TRUE(standing.isPassed(2)) << "by an instructor's plan, though no step was passed by the lesson";
}

TEST(LearningProgress, SayWhenALessonWasWorkedOnLast) {
  EXPECT_EQ(firstOf({{"1", {passed("a")}}}).last, kMorning + std::chrono::minutes(5));
  EXPECT_EQ(firstOf({{"1", {ended("a", StepVerdict::passed, 3)}, false}}).last, kMorning + std::chrono::minutes(3));
}

TEST(LearningProgress, CountWhatHasThePersonsNameOrNone) {
  const std::vector<Tried> all = {{"1", {passed("a")}, true, "first", "Ada"}, {"2", {passed("a"), passed("b")}, true, "first", "Bo"}};
  EXPECT_EQ(firstOf(all, "Ada").bestPassed, 1u);
  EXPECT_EQ(firstOf(all, "Bo").bestPassed, 2u);
  EXPECT_EQ(firstOf(all).attempts, 0u);
  EXPECT_EQ(firstOf({{"1", {passed("a")}}}, "Ada").bestPassed, 1u);
}

TEST(LearningProgress, ListWhatWasStoppedTheLatestFirst) {
  const LearningProgress standings(
      tried({{"1", {}, false, "early"}, {"2", {passed("a")}, false, "late"}, {"3", {}, false, "done"}, {"4", {}, true, "done"}}), {});
  const auto stopped = standings.interrupted();
  ASSERT_EQ(stopped.size(), 2u);
  EXPECT_EQ(stopped[0], (LessonInterruption{"home", "late", "Title of late", 1, "/attempts/2"}));
  EXPECT_EQ(stopped[1].lessonId, "early");
}

/// A small case with lessons of two steps each.
void makeTaughtCase(const fs::path& folder, const std::string& id, const std::string& title) {
  test::makeSmallCase(folder);
  auto opened = loadCase(folder);
  ASSERT_TRUE(opened);
  opened->id = id;
  opened->title = opened->titleForTrainees = title;
  opened->region = opened->indication = opened->diagnosis = "A ball.";
  opened->findings = {"A ball."};
  opened->startPose = Pose{};
  opened->startPose->probeToWorld.matrix[3] = glm::dvec4(0.0, -60.0, 0.0, 1.0);
  std::vector<Lesson> lessons(2);
  for (std::size_t n = 0; n < 2; ++n) {
    lessons[n].id = n == 0 ? "first" : "second";
    lessons[n].title = "Lesson " + lessons[n].id;
    for (const char* step : {"a", "b"}) {
      LessonStep made;
      made.id = made.title = made.text = step;
      made.task = ReadingTask{};
      lessons[n].steps.push_back(made);
    }
  }
  opened->otherFields["parts"]["lessons"] = jsonOf(lessons);
  ASSERT_TRUE(saveCase(*opened, folder));
}

TEST(CourseProgress, GoesOnAtTheFirstLessonThatIsThereAndNotPassed) {
  const TemporaryFolder folder;
  const EnvironmentValue own("ECHOWEAVE_CASES", (folder / "own").string());
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder.path().string());
  makeTaughtCase(folder / "own/home", "home", "Home");
  test::writeText(folder / "own/home/words/de.json", R"({"format": 1, "words": {"Lesson second": "Zweite Lektion"}})");
  Course course;
  course.lessons = {{"nowhere", "first"}, {"home", "first"}, {"home", "gone"}, {"home", "second"}};
  const LearningProgress standings(tried({{"1", {passed("a"), passed("b")}}}), {});
  const CourseProgress standing = standingIn(course, standings, folder.path(), "de_DE");
  ASSERT_EQ(standing.steps.size(), 4u);
  EXPECT_FALSE(standing.steps[0].isThere());
  EXPECT_TRUE(standing.steps[1].isPassed());
  EXPECT_FALSE(standing.steps[2].isThere());
  EXPECT_EQ(standing.passed(), 1u);
  EXPECT_EQ(standing.next(), 3u);
  EXPECT_EQ(standing.steps[3].title, "Zweite Lektion");
  EXPECT_EQ(standing.steps[3].caseFolder, folder / "own/home");
  EXPECT_EQ(standing.steps[3].steps, 2u);
  EXPECT_EQ(standingIn({}, standings, folder.path(), "en").next(), 0u) << "a course without lessons";
}

TEST(FindCase, TakesTheAuthorsOwnThenTheLatestPublishedThenTheShipped) {
  const TemporaryFolder folder;
  const EnvironmentValue own("ECHOWEAVE_CASES", (folder / "own").string());
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder.path().string());
  EXPECT_FALSE(findCase("upper-abdomen", folder.path()));
  const auto shipped = findCase("fetal-biometry", folder.path());
  ASSERT_TRUE(shipped);
  EXPECT_TRUE(isShipped(*shipped));
  makeTaughtCase(folder / "own/of another name", "home", "Home");
  ASSERT_TRUE(publishCase(folder / "own/of another name", folder.path()));
  EXPECT_EQ(findCase("home", folder.path()), folder / "own/of another name");
  makeTaughtCase(folder / "own/of another name", "home", "Home, seen again");
  const auto second = publishCase(folder / "own/of another name", folder.path());
  ASSERT_TRUE(second);
  EXPECT_EQ(second->revision, 2);
  fs::remove_all(folder / "own");
  EXPECT_EQ(findCase("home", folder.path()), second->folder);
  for (const char* none : {"", "..", "../own", "a/b"}) EXPECT_FALSE(findCase(none, folder.path())) << none;
}

TEST(OwnCases, AreThoseOfTheIdAndAFolderOfThatNameThatCannotBeOpened) {
  const TemporaryFolder folder;
  const fs::path own = folder / "cases";
  makeTaughtCase(own / "other", "home", "Home");
  makeTaughtCase(own / "elsewhere", "elsewhere", "Elsewhere");
  EXPECT_EQ(ownCases("home", folder.path()), std::vector<fs::path>{own / "other"});
  test::writeText(own / "home/case.json", "{");
  EXPECT_EQ(ownCases("home", folder.path()), (std::vector<fs::path>{own / "other", own / "home"}));
  makeTaughtCase(own / "home", "home", "Home");
  EXPECT_EQ(ownCases("home", folder.path()), (std::vector<fs::path>{own / "home", own / "other"})) << "as findCase takes them";
  makeTaughtCase(own / "home", "far", "Far");
  EXPECT_EQ(ownCases("home", folder.path()), std::vector<fs::path>{own / "other"});
  for (const char* none : {"", ".", "..", "../cases", "a/b", "nowhere"}) EXPECT_TRUE(ownCases(none, folder.path()).empty()) << none;
}

/// Works through lessons of three steps as fast as it can, and tells through the pipe how many steps and lessons have ended.
[[noreturn]] void learnUntilKilled(const fs::path& root, int pipe) {
  for (unsigned n = 1;; ++n) {
    Attempt attempt;
    attempt.id = "20261126-" + std::to_string(100000 + n);
    attempt.caseId = "home";
    attempt.lessonId = "first";
    attempt.startedAt = kMorning;
    auto kept = AttemptFolder::begin(root, attempt);
    for (const char* step : {"a", "b", "c"})
      if (!kept || !kept->beginStep(step) || !kept->endStep(passed(step)) || ::write(pipe, "s", 1) != 1) ::_exit(1);
    if (!kept->finish(kMorning) || ::write(pipe, "f", 1) != 1) ::_exit(1);
  }
}

TEST(LearningProgress, KeepWhatHadEndedWhenTheProgramIsKilledBetweenLessons) {
  std::mt19937 random(23);
  std::uniform_int_distribution<int> wait_us(500, 40'000);
  for (int trial = 0; trial < 30; ++trial) {
    const TemporaryFolder folder;
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) learnUntilKilled(folder.path(), ends[1]);
    ::close(ends[1]);
    char told = 0;
    ASSERT_EQ(::read(ends[0], &told, 1), 1);
    ::usleep(static_cast<useconds_t>(wait_us(random)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    std::size_t steps = 1, lessons = 0;
    for (; ::read(ends[0], &told, 1) == 1;) (told == 's' ? steps : lessons) += 1;
    ::close(ends[0]);
    const AttemptList list = listAttempts(folder.path());
    ASSERT_TRUE(list.problems.empty()) << list.problems.front();
    const LessonStanding standing = LearningProgress(list, {}).of("home", "first", {"a", "b", "c"});
    EXPECT_GE(standing.attempts, lessons);
    EXPECT_LE(standing.attempts, lessons + 1);
    EXPECT_EQ(standing.bestPassed, standing.attempts > 0 ? 3u : 0u);
    std::size_t found = 0;
    for (const auto& each : list.attempts) found += each.second.outcomes.size();
    EXPECT_GE(found, steps);
    EXPECT_LE(found, steps + 1);
  }
}

}  // namespace
}  // namespace ew::learning_progress_test
