#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "../even_sweep.h"
#include "ew/core/output_set.h"
#include "ew/library/checksums.h"
#include "ew/library/new_case.h"
#include "library/bundle_world.h"

namespace ew::test::new_case_kill_test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

TEST(NewCaseKilled, LeavesNoFolderOrACompleteCase) {
  const TemporaryFolder folder;
  const Sequence sweep =
      evenSweep({.width = 120, .height = 100, .frames = 60, .from = "Image"}, [](int n, int p) { return (n * 37 + p * 11) % 251; });
  ASSERT_TRUE(writeSequence(sweep, folder / "sweep.igs.mha"));
  NewCase wanted;
  wanted.title = "Killed";
  wanted.source = SweepFile{.file = folder / "sweep.igs.mha", .spacing_mm = 1.0};
  const auto begun = Clock::now();
  ASSERT_TRUE(makeCase(wanted, folder / "whole"));
  const auto usual = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begun);
  std::mt19937 dice(23);
  int killed = 0, complete = 0;
  for (int n = 0; n < 50; ++n) {
    const auto pause = usual * static_cast<int>(dice() % 1300) / 1000;
    const pid_t child = ::fork();
    if (child == 0) {
      (void)makeCase(wanted, folder / "cases/killed");
      ::_exit(0);
    }
    std::this_thread::sleep_for(pause);
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    killed += WIFSIGNALED(status) ? 1 : 0;
    const fs::path made = folder / "cases/killed";
    if (!fs::exists(made)) continue;
    ++complete;
    const auto opened = loadCase(made);
    ASSERT_TRUE(opened) << opened.error();
    ASSERT_TRUE(loadCaseVolume(*opened, noProgress()));
    const auto check = verifyCase(made);
    ASSERT_TRUE(check);
    ASSERT_TRUE(check->problems.empty()) << check->problems.front();
    fs::remove_all(made);
  }
  EXPECT_GT(killed, 10) << "too few were killed in the middle to show anything";
  EXPECT_LT(complete, 50);
  removeLeftovers(folder / "cases");
  EXPECT_TRUE(!fs::exists(folder / "cases") || fs::is_empty(folder / "cases")) << "what killed programs left can be told and taken away";
}

}  // namespace
}  // namespace ew::test::new_case_kill_test
