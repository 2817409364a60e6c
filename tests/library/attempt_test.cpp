#include "ew/library/attempt.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <thread>

#include <csignal>
#include <random>

#include "ew/library/step_answer.h"
#include "library/temporary_folder.h"

namespace ew::attempt_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using std::chrono::sys_seconds;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

constexpr sys_seconds kMorning = std::chrono::sys_days(std::chrono::year(2026) / 11 / 26) + std::chrono::minutes(9 * 60 + 30);

StepOutcome outcome(std::string step, StepVerdict verdict = StepVerdict::passed) {
  StepOutcome made;
  made.stepId = std::move(step);
  made.verdict = verdict;
  made.score = 0.75;
  made.seconds = 41.5;
  made.hints = 2;
  made.figures = {{"angle", 4.25, "deg"}, {"share", 0.9, ""}};
  made.remarks = {{true, say<"No such file: '%1'.">(std::string("a"))}, {false, verbatim("Said by an author.")}};
  made.answer = OptionsAnswer{{1, 2}};
  made.recording = "step-01.seq.mha";
  made.images = {"a.png"};
  made.at = kMorning + std::chrono::seconds(50);
  made.otherFields = {{"colour", "blue"}};
  return made;
}

Attempt begun() {
  Attempt attempt;
  attempt.id = "20261126-093000-00000001";
  attempt.caseId = "home";
  attempt.lessonId = "first";
  attempt.lessonTitle = "First";
  attempt.lessonContent = "0123";
  attempt.person = "me";
  attempt.program = "0.1.0";
  attempt.launch = "0a5f-17.4";
  attempt.masteryScore = 0.65;
  attempt.startedAt = kMorning;
  return attempt;
}

TEST(AttemptFromJson, ReadsWhatWasWritten) {
  Attempt attempt = begun();
  attempt.finishedAt = kMorning + std::chrono::hours(20);
  attempt.runningStep = "c";
  attempt.outcomes = {outcome("a"), outcome("b", StepVerdict::failed), outcome("a", StepVerdict::skipped)};
  attempt.otherFields = {{"room", 3}};
  const json written = jsonOf(attempt);
  EXPECT_EQ(written["started_at"], "2026-11-26T09:30:00Z");
  const auto read = attemptFromJson(json::parse(written.dump()));
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, attempt);
  EXPECT_EQ(read->outcomeOf("a")->verdict, StepVerdict::skipped) << "the latest counts";
  EXPECT_EQ(read->outcomeOf("none"), nullptr);
}

TEST(AttemptFromJson, RefusesWhatCannotBeAnAttempt) {
  Attempt attempt = begun();
  attempt.outcomes = {outcome("a")};
  const json good = jsonOf(attempt);
  const std::pair<const char*, json> wrong[] = {{"/id", ""},
                                                {"/started_at", "yesterday"},
                                                {"/started_at", "2026-13-26T09:30:00Z"},
                                                {"/outcomes", 3},
                                                {"/outcomes/0/verdict", "great"},
                                                {"/outcomes/0/score", 1.5},
                                                {"/outcomes/0/recording", "../../elsewhere"},
                                                {"/outcomes/0/pictures/0", "/etc/passwd"},
                                                {"/outcomes/0/figures/0/value", "much"}};
  for (const auto& [pointer, value] : wrong) {
    json changed = good;
    changed[json::json_pointer(pointer)] = value;
    const auto read = attemptFromJson(changed);
    ASSERT_FALSE(read) << pointer << " " << value;
    EXPECT_EQ(read.error().code, ErrorCode::badField) << read.error();
  }
  json newer = good;
  newer["format"] = kAttemptFormat + 1;
  EXPECT_EQ(attemptFromJson(newer).error().code, ErrorCode::newerFormat);
}

TEST(IdOfAttempt, SortsByTimeAndIsNotGivenTwice) {
  const std::string first = idOfAttempt(kMorning);
  EXPECT_TRUE(first.starts_with("20261126-093000-")) << first;
  EXPECT_LT(first, idOfAttempt(kMorning + std::chrono::seconds(1)));
  EXPECT_NE(first, idOfAttempt(kMorning));
}

TEST(IdOfAnAttempt, SortsTheAttemptsOfOneSecond) {
  // From the begin of a second: none of these ends in the next one.
  std::this_thread::sleep_until(std::chrono::ceil<std::chrono::seconds>(std::chrono::system_clock::now()));
  for (int tries = 0; tries < 20; ++tries) {
    const auto before = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    const std::string first = idOfAttempt(before);
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    const auto after = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    EXPECT_LT(first, idOfAttempt(after)) << "the one that was begun later stands behind";
  }
}

TEST(AttemptFolder, HoldsEveryStepThatEnded) {
  const TemporaryFolder folder;
  auto kept = AttemptFolder::begin(folder.path(), begun());
  ASSERT_TRUE(kept) << kept.error();
  ASSERT_TRUE(kept->beginStep("a"));
  EXPECT_EQ(AttemptFolder::open(kept->folder())->attempt().runningStep, "a");
  ASSERT_TRUE(kept->endStep(outcome("a")));
  ASSERT_TRUE(kept->beginStep("b"));
  ASSERT_TRUE(kept->leaveStep());
  ASSERT_TRUE(kept->finish(kMorning));
  const auto again = AttemptFolder::open(kept->folder());
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(again->attempt(), kept->attempt());
  EXPECT_EQ(again->attempt().outcomes.size(), 1u);
  EXPECT_TRUE(again->attempt().runningStep.empty());
}

TEST(AttemptFolder, GivesFilesNamesThatAreFree) {
  const TemporaryFolder folder;
  auto kept = AttemptFolder::begin(folder.path(), begun());
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->nameForFile("Find it", ".png"), "step-01-find-it.png");
  writeText(kept->folder() / "step-01-find-it.png", "x");
  EXPECT_EQ(kept->nameForFile("Find it", ".png"), "step-01-find-it-2.png");
}

TEST(AttemptFolder, SaysThatAFolderCannotBeWritten) {
  const TemporaryFolder folder;
  writeText(folder / "file", "");
  const auto kept = AttemptFolder::begin(folder / "file", begun());
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().code, ErrorCode::notWritable);
}

TEST(ListAttempts, ListsTheLatestFirstAndNamesWhatIsBroken) {
  const TemporaryFolder folder;
  EXPECT_TRUE(listAttempts(folder / "none").attempts.empty());
  Attempt second = begun();
  second.id = "20261127-093000-00000001";
  ASSERT_TRUE(AttemptFolder::begin(folder.path(), begun()));
  ASSERT_TRUE(AttemptFolder::begin(folder.path(), second));
  writeText(folder / "broken/attempt.json", "{");
  const AttemptList list = listAttempts(folder.path());
  ASSERT_EQ(list.attempts.size(), 2u);
  EXPECT_EQ(list.attempts[0].second.id, second.id);
  ASSERT_EQ(list.problems.size(), 1u);
  EXPECT_NE(list.problems[0].sentence().find("broken"), std::string::npos);
}

/// Goes through steps as fast as it can, and tells through the pipe how many have ended.
[[noreturn]] void workUntilKilled(const fs::path& root, int pipe) {
  auto kept = AttemptFolder::begin(root, begun());
  for (unsigned n = 1; kept; ++n) {
    const std::string id = "step-" + std::to_string(n);
    if (!kept->beginStep(id)) break;
    StepOutcome ended = outcome(id);
    ended.recording = kept->nameForFile(id, ".seq.mha");
    writeText(kept->folder() / ended.recording, "recording");
    if (!kept->endStep(std::move(ended))) break;
    if (::write(pipe, &n, sizeof n) != sizeof n) break;
  }
  ::_exit(1);
}

TEST(AttemptFolder, LosesAtMostTheStepThatRanWhenItIsKilled) {
  std::mt19937 random(17);
  std::uniform_int_distribution<int> wait_us(200, 30'000);
  for (int trial = 0; trial < 50; ++trial) {
    const TemporaryFolder folder;
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) workUntilKilled(folder.path(), ends[1]);
    ::close(ends[1]);
    unsigned first = 0;
    ASSERT_EQ(::read(ends[0], &first, sizeof first), static_cast<ssize_t>(sizeof first)) << "one step has ended";
    ::usleep(static_cast<useconds_t>(wait_us(random)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    unsigned told = first;
    for (unsigned next = 0; ::read(ends[0], &next, sizeof next) == static_cast<ssize_t>(sizeof next);) told = next;
    ::close(ends[0]);
    const AttemptList list = listAttempts(folder.path());
    ASSERT_TRUE(list.problems.empty()) << list.problems.front();
    ASSERT_EQ(list.attempts.size(), 1u);
    const Attempt& found = list.attempts[0].second;
    EXPECT_GE(found.outcomes.size(), told);
    EXPECT_LE(found.outcomes.size(), told + 1);
    for (const StepOutcome& ended : found.outcomes)
      EXPECT_EQ(textOf(list.attempts[0].first / ended.recording), "recording") << ended.recording;
    if (!found.runningStep.empty()) {
      EXPECT_EQ(found.runningStep, "step-" + std::to_string(found.outcomes.size() + 1));
    }
  }
}

}  // namespace
}  // namespace ew::attempt_test
