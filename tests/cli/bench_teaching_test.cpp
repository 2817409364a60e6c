#include <gtest/gtest.h>

#include "cli/bench_run.h"
#include "ew/library/access.h"

namespace ew::test::bench_teaching_test {
namespace {

constexpr PassphraseCost kCheap{.passes = 1, .memory_bytes = 64 << 10};

TEST(BenchCompass, BringsEveryHandToEveryPlaneOfACase) {
  const TemporaryFolder folder;
  const auto outcome = runBench({"bench", "compass", "--case", "neck-carotid-thyroid", "--starts", "4", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto quality = readJson(folder / "r.json")["quality"];
  ASSERT_GE(quality["planes"].size(), 5U);
  for (const auto& plane : quality["planes"]) {
    EXPECT_TRUE(plane["reachable"].get<bool>()) << plane;
    EXPECT_EQ(plane["reached"], 4) << plane;
  }
  EXPECT_EQ(quality["share"], 1.0);
  EXPECT_NE(outcome.out.find("neck-carotid-thyroid: 100.0 %"), std::string::npos) << outcome.out;
}

TEST(BenchCompass, IsTheSameForTheSameSeedWhateverTheThreads) {
  const TemporaryFolder folder;
  const auto report = [&](const std::string& threads) {
    const std::string file = folder / ("r" + threads + ".json");
    EXPECT_EQ(
        runBench({"bench", "compass", "--case", "neck-carotid-thyroid", "--starts", "3", "--threads", threads, "--report", file}).status,
        0);
    return readJson(file)["quality"]["planes"];
  };
  EXPECT_EQ(report("1"), report("2"));
}

TEST(BenchExercises, ArePassedByWhoKnowsAndTellWhatIsNotOffered) {
  const TemporaryFolder folder;
  const auto outcome = runBench({"bench", "exercises", "--case", "neck-carotid-thyroid", "--draws", "1", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto quality = readJson(folder / "r.json")["quality"];
  const auto& row = quality["results"].front();
  EXPECT_GE(row["offered"].get<int>(), 15);
  EXPECT_EQ(row["expert"], row["draws"]);
  EXPECT_LT(row["chance"].get<double>(), 0.1 * row["draws"].get<double>());
  EXPECT_NE(outcome.out.find("nodule, volume is not offered: Calipers alone cannot measure it."), std::string::npos) << outcome.out;
}

TEST(BenchTeaching, ShowsNothingWhileTheLibraryIsLocked) {
  const TemporaryFolder folder;
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder / "library");
  AccessPolicy policy = AccessPolicy::of(libraryFolder());
  ASSERT_TRUE(setLock(policy, Passphrase("correct horse battery"), {}, kCheap));
  const auto refused = runBench({"bench", "exercises"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("locked for trainees"), std::string::npos) << refused.err;
}

TEST(BenchTeaching, RefusesOptionsOutsideTheirRange) {
  EXPECT_EQ(runBench({"bench", "compass", "--starts", "0"}).status, 2);
  EXPECT_EQ(runBench({"bench", "exercises", "--case", "no-such-case"}).status, 1);
}

}  // namespace
}  // namespace ew::test::bench_teaching_test
