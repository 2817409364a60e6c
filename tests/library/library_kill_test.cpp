#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "ew/library/bundle.h"
#include "ew/library/case.h"
#include "library/bundle_world.h"

namespace ew::test::library_kill_test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kKills = 50;

/// Runs `work` in a process of its own and kills that after a while. @return whether it was killed before it ended
template <class Work>
bool killAfter(std::chrono::microseconds pause, const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  std::this_thread::sleep_for(pause);
  ::kill(child, SIGKILL);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WIFSIGNALED(status);
}

template <class Work>
std::chrono::microseconds durationOf(const Work& work) {
  const auto begun = Clock::now();
  work();
  return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begun);
}

int leftoversIn(const fs::path& folder) {
  int found = 0;
  if (!fs::exists(folder)) return 0;
  for (const auto& each : fs::recursive_directory_iterator(folder)) found += each.path().filename().string().starts_with(".ew-") ? 1 : 0;
  return found;
}

/// Every revision that is listed opens and holds what it should, and nothing is left of those that were not finished.
void expectSoundLibrary(const fs::path& library, int leastRevision) {
  const auto listed = listPublished(library);
  if (leastRevision > 0) {
    ASSERT_EQ(listed.size(), 1u);
    EXPECT_GE(listed.front().revision, leastRevision) << "what was published is lost";
  }
  for (const CaseRevision& each : listed)
    for (const CaseRevision& revision : publishedRevisions(library, each.id)) {
      EXPECT_TRUE(loadCase(revision.folder));
      const auto check = verifyCase(revision.folder);
      ASSERT_TRUE(check);
      EXPECT_TRUE(check->problems.empty()) << check->problems.front();
    }
  EXPECT_EQ(leftoversIn(library), 0);
}

/// Kills spread over the time that the work takes, and a little longer: some find it finished.
template <class Work, class Check>
void killOften(unsigned seed, std::chrono::microseconds usual, const Work& work, const Check& check) {
  std::mt19937 dice(seed);
  int killed = 0;
  for (int n = 0; n < kKills; ++n) {
    const auto pause = usual * static_cast<int>(dice() % 1200) / 1000;
    killed += killAfter(pause, [&] { work(n); }) ? 1 : 0;
    check();
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(killed, kKills / 10) << "too few were killed in the middle to show anything";
}

TEST(LibraryKilled, WhilePublishingKeepsTheLastRevisionAndNoHalfOne) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee", {90, 90, 90});
  const auto usual = durationOf([&] { ASSERT_TRUE(publishCase(folder / "mine", folder / "library")); });
  int last = 1;
  killOften(
      11, usual,
      [&](int n) {
        writeText(folder / "mine/scans/expert.txt", std::to_string(n));
        (void)publishCase(folder / "mine", folder / "library");
      },
      [&] {
        expectSoundLibrary(folder / "library", last);
        last = latestPublished(folder / "library", "knee")->revision;
      });
  const auto after = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(after) << "it goes on as if nothing had happened";
}

TEST(LibraryKilled, WhilePublishingForTheFirstTimeHasNothingOrAll) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee", {90, 90, 90});
  const auto usual = durationOf([&] { ASSERT_TRUE(publishCase(folder / "mine", folder / "other")); });
  killOften(
      12, usual, [&](int) { (void)publishCase(folder / "mine", folder / "library"); },
      [&] {
        expectSoundLibrary(folder / "library", 0);
        fs::remove_all(folder / "library");
      });
}

TEST(LibraryKilled, WhileImportingHasTheRevisionOrNot) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee", {90, 90, 90});
  ASSERT_TRUE(exportBundle(folder / "mine", folder / "1.ewcase"));
  writeText(folder / "mine/scans/expert.txt", "second");
  ASSERT_TRUE(exportBundle(folder / "mine", folder / "2.ewcase"));
  ASSERT_TRUE(importBundle(folder / "1.ewcase", folder / "library"));
  const auto usual = durationOf([&] { ASSERT_TRUE(importBundle(folder / "2.ewcase", folder / "other")); });
  killOften(
      13, usual, [&](int) { (void)importBundle(folder / "2.ewcase", folder / "library"); },
      [&] {
        expectSoundLibrary(folder / "library", 1);
        fs::remove_all(folder / "library/published/knee/2");
      });
  const auto again = importBundle(folder / "2.ewcase", folder / "library");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->revision, 2);
}

TEST(LibraryKilled, WhileExportingLeavesTheEarlierBundleWhole) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee", {90, 90, 90});
  fs::create_directory(folder / "out");
  ASSERT_TRUE(exportBundle(folder / "mine", folder / "out/x.ewcase"));
  const std::string earlier = textOf(folder / "out/x.ewcase");
  writeText(folder / "mine/scans/expert.txt", "second");
  std::string later;
  const auto usual = durationOf([&] { ASSERT_TRUE(exportBundle(folder / "mine", folder / "later.ewcase")); });
  later = textOf(folder / "later.ewcase");
  killOften(
      14, usual, [&](int) { (void)exportBundle(folder / "mine", folder / "out/x.ewcase"); },
      [&] {
        const std::string now = textOf(folder / "out/x.ewcase");
        EXPECT_TRUE(now == earlier || now == later);
        EXPECT_TRUE(verifyBundle(folder / "out/x.ewcase"));
        // Beside a bundle nothing is taken away that may be somebody else's: hidden folders may stay there, and are no bundles.
        for (const auto& each : fs::directory_iterator(folder / "out")) {
          const std::string name = each.path().filename().string();
          EXPECT_TRUE(name == "x.ewcase" || name.starts_with(".ew-")) << name;
        }
      });
}

}  // namespace
}  // namespace ew::test::library_kill_test
