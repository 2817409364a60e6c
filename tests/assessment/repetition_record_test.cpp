#include "ew/assessment/repetition_record.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <set>
#include <thread>

#include "ew/core/json_fields.h"
#include "ew/io/safe_file.h"
#include "library/temporary_folder.h"

namespace ew::repetition_record_test {
namespace {

namespace fs = std::filesystem;
using std::chrono::sys_seconds;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

constexpr sys_seconds kNow{std::chrono::seconds(1'790'000'000)};

int triesOf(const RepetitionRecord& kept) {
  int tries = 0;
  for (const RepetitionState& each : kept.states) tries += each.tries;
  return tries;
}

TEST(RepetitionRecord, KnowsNothingBeforeTheFirstTryAndEachTryAfterwards) {
  const TemporaryFolder folder;
  const fs::path file = repetitionFile(folder.path(), {});
  const auto nothing = readRepetition(file);
  ASSERT_TRUE(nothing);
  EXPECT_TRUE(nothing->states.empty());
  EXPECT_FALSE(fs::exists(file.parent_path())) << "reading makes nothing";
  ASSERT_TRUE(keepTry(file, "a", 5, kNow));
  ASSERT_TRUE(keepTry(file, "b", 1, kNow));
  const auto kept = keepTry(file, "a", 4, kNow + std::chrono::hours(30));
  ASSERT_TRUE(kept);
  std::vector<RepetitionState> expected;
  expected = withTry(expected, "a", 5, kNow);
  expected = withTry(expected, "b", 1, kNow);
  expected = withTry(expected, "a", 4, kNow + std::chrono::hours(30));
  EXPECT_EQ(kept->states, expected);
  EXPECT_EQ(readRepetition(file)->states, expected);
  EXPECT_FALSE(kept->note);
}

TEST(RepetitionRecord, HasAFileForEachPerson) {
  std::set<fs::path> files;
  const std::vector<std::string> names = {"", "Ada", "ada", "A/da", "../Ada", "Ä", "Ö", std::string(5000, 'x'), "\n"};
  for (const std::string& name : names) {
    const fs::path file = repetitionFile("/library", name);
    files.insert(file);
    EXPECT_EQ(file.filename(), "repetition.json");
    EXPECT_EQ(file.lexically_normal(), file) << "no name leads out of the folder";
    EXPECT_TRUE(file.string().starts_with("/library/learning/"));
    EXPECT_LT(file.string().size(), 160u);
  }
  EXPECT_EQ(files.size(), names.size());
}

TEST(RepetitionRecord, PutsAsideWhatCannotBeReadAndBeginsAnew) {
  const TemporaryFolder folder;
  const fs::path file = repetitionFile(folder.path(), {});
  const std::vector<std::string> broken = {"", "{", "[]", R"({"format": 0})", R"({"format": 1, "exercises": [{"id": 3}]})"};
  for (const std::string& text : broken) {
    writeText(file, text);
    const auto kept = readRepetition(file);
    ASSERT_TRUE(kept) << kept.error();
    EXPECT_TRUE(kept->states.empty());
    ASSERT_TRUE(kept->note) << text;
    EXPECT_NE(kept->note->english().find("repetition-unreadable"), std::string::npos) << kept->note->english();
    EXPECT_FALSE(fs::exists(file));
  }
  std::set<std::string> aside;
  for (const auto& each : fs::directory_iterator(file.parent_path()))
    if (each.path().filename() != ".lock") aside.insert(textOf(each.path()));
  EXPECT_EQ(aside, std::set<std::string>(broken.begin(), broken.end())) << "nothing of it is lost";
  writeText(file, "{");
  const auto tried = keepTry(file, "a", 5, kNow);
  ASSERT_TRUE(tried);
  EXPECT_TRUE(tried->note);
  EXPECT_EQ(readRepetition(file)->states, tried->states);
}

TEST(RepetitionRecord, LeavesTheFileOfANewerProgramAlone) {
  const TemporaryFolder folder;
  const fs::path file = repetitionFile(folder.path(), {});
  const std::string newer = R"({"format": 2, "exercises": {"something": "else"}})";
  writeText(file, newer);
  const auto read = readRepetition(file);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::newerFormat);
  EXPECT_FALSE(keepTry(file, "a", 5, kNow));
  EXPECT_EQ(textOf(file), newer);
}

TEST(RepetitionRecord, SaysThatTheLibraryCannotBeWritten) {
  const TemporaryFolder folder;
  writeText(folder / "learning", "a file");
  const auto kept = keepTry(repetitionFile(folder.path(), {}), "a", 5, kNow);
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().code, ErrorCode::notWritable);
}

TEST(RepetitionRecord, KeepsTheTriesOfWindowsThatWorkAtOnce) {
  const TemporaryFolder folder;
  const fs::path file = repetitionFile(folder.path(), "Ada");
  constexpr int kWindows = 4, kTries = 12;
  std::vector<pid_t> windows;
  for (int window = 0; window < kWindows; ++window) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (int n = 0; n < kTries; ++n)
        if (!keepTry(file, n % 2 == 0 ? "shared" : "own-" + std::to_string(window), n % 6, kNow)) ::_exit(1);
      ::_exit(0);
    }
    windows.push_back(child);
  }
  for (const pid_t child : windows) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const auto kept = readRepetition(file);
  ASSERT_TRUE(kept);
  EXPECT_EQ(triesOf(*kept), kWindows * kTries);
}

TEST(RepetitionRecord, LosesNoTryThatWasKeptWhenItIsKilled) {
  std::mt19937 random(29);
  std::uniform_int_distribution<int> wait_us(200, 30'000);
  for (int trial = 0; trial < 30; ++trial) {
    const TemporaryFolder folder;
    const fs::path file = repetitionFile(folder.path(), {});
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      for (int n = 0; keepTry(file, "exercise-" + std::to_string(n % 7), n % 6, kNow) && ::write(ends[1], "t", 1) == 1; ++n) {
      }
      ::_exit(1);
    }
    ::close(ends[1]);
    char one = 0;
    ASSERT_EQ(::read(ends[0], &one, 1), 1);
    ::usleep(static_cast<useconds_t>(wait_us(random)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    int told = 1;
    while (::read(ends[0], &one, 1) == 1) ++told;
    ::close(ends[0]);
    const auto kept = keepTry(file, "afterwards", 5, kNow);
    ASSERT_TRUE(kept) << kept.error();
    EXPECT_FALSE(kept->note);
    EXPECT_GE(triesOf(*kept), told + 1);
    EXPECT_LE(triesOf(*kept), told + 2);
  }
}

}  // namespace
}  // namespace ew::repetition_record_test
