#include "bench/teaching/bench_metrics.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "bench/teaching/metric_study.h"
#include "cli/bench_run.h"
#include "ew/library/attempt.h"

namespace ew::test::bench_metrics_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

StudyCell cellOf(std::vector<std::optional<double>> novices, std::vector<std::optional<double>> experts) {
  return {"case/lesson", "step", "plane", {std::move(novices), {}, std::move(experts)}};
}

Discrimination compared(const std::vector<StudyCell>& cells, bool moreIsBetter) {
  std::vector<const StudyCell*> all;
  for (const StudyCell& cell : cells) all.push_back(&cell);
  return discriminationOf(all, SkillLevel::novice, SkillLevel::expert, moreIsBetter, {200, 1});
}

TEST(Discrimination, CountsPairsOfOneStepByHand) {
  // Of nine pairs the expert has less in six, and one is a tie.
  const auto found = compared({cellOf({1.0, 4.0, 6.0}, {2.0, 3.0, 4.0})}, false);
  ASSERT_TRUE(found.area);
  EXPECT_NEAR(found.area->value, 5.5 / 9.0, 1e-12);
  EXPECT_LE(found.area->low, found.area->value);
  EXPECT_GE(found.area->high, found.area->value);
  EXPECT_NEAR(compared({cellOf({1.0, 4.0, 6.0}, {2.0, 3.0, 4.0})}, true).area->value, 3.5 / 9.0, 1e-12);
  // Means 11/3 and 3, sums of squares 38/3 and 2, four degrees of freedom.
  ASSERT_TRUE(found.effect);
  EXPECT_NEAR(found.effect->value, (11.0 / 3.0 - 3.0) / std::sqrt((38.0 / 3.0 + 2.0) / 4.0) * (1.0 - 3.0 / 15.0), 1e-12);
}

TEST(Discrimination, DoesNotMixStepsOfOtherLengths) {
  // Experts need less in both steps, and more in the long one than novices in the short one.
  const auto found = compared({cellOf({2.0, 3.0}, {1.0, 1.5}), cellOf({200.0, 300.0}, {100.0, 150.0})}, false);
  EXPECT_EQ(found.area->value, 1.0);
  EXPECT_EQ(found.steps, 2);
  EXPECT_EQ(found.persons, 2);
}

TEST(Discrimination, LeavesOutWhatCouldNotBeWorkedOut) {
  const auto found = compared({cellOf({2.0, std::nullopt, 5.0}, {std::nullopt, 1.0, 4.0})}, false);
  EXPECT_NEAR(found.area->value, 0.75, 1e-12);
  const auto nothing = compared({cellOf({std::nullopt}, {1.0})}, false);
  EXPECT_FALSE(nothing.area);
  EXPECT_FALSE(nothing.effect);
  EXPECT_FALSE(compared({cellOf({1.0, 1.0}, {1.0, 1.0})}, false).effect) << "nothing differs";
  EXPECT_EQ(compared({cellOf({1.0, 1.0}, {1.0, 1.0})}, false).area->value, 0.5);
}

class BenchMetrics : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> command(const std::string& threads, const std::string& name) const {
    return {"bench",      "metrics",
            "--case",     "liver-sweep-recorded",
            "--people",   "3",
            "--draws",    "20",
            "--threads",  threads,
            "--page",     folder_ / "study.md",
            "--defaults", folder_ / (name + ".json"),
            "--keep",     folder_ / name,
            "--report",   folder_ / (name + "-r.json")};
  }
  const TemporaryFolder folder_;
};

TEST_F(BenchMetrics, SaysTheSameOfTheSamePeopleWhateverTheThreads) {
  writeText(folder_ / "study.md", "# Study\n\nBefore.\n\n<!-- bench metrics: begin -->\nold\n<!-- bench metrics: end -->\n\nAfter.\n");
  const auto one = runBench(command("1", "one"));
  ASSERT_EQ(one.status, 0) << one.err;
  const std::string page = readText(folder_ / "study.md");
  const auto two = runBench(command("2", "two"));
  ASSERT_EQ(two.status, 0) << two.err;
  EXPECT_EQ(readJson(folder_ / "one-r.json")["quality"], readJson(folder_ / "two-r.json")["quality"]);
  EXPECT_EQ(readText(folder_ / "one.json"), readText(folder_ / "two.json"));
  EXPECT_EQ(readText(folder_ / "study.md"), page);
  EXPECT_EQ(page.find("old"), std::string::npos);
  EXPECT_TRUE(page.starts_with("# Study\n\nBefore.\n\n<!-- bench metrics: begin -->\n")) << page.substr(0, 200);
  EXPECT_TRUE(page.ends_with("<!-- bench metrics: end -->\n\nAfter.\n"));
  EXPECT_NE(page.find("| liver-sweep-recorded/liver-landmarks | path_length | "), std::string::npos);
  const json defaults = readJson(folder_ / "one.json");
  EXPECT_EQ(defaults["format"], 1);
  EXPECT_EQ(defaults["study"]["seed"], 1);
  const json& path = defaults["metrics"]["path_length"];
  EXPECT_EQ(path["on"], path["auc"].get<double>() >= 0.7);
  EXPECT_LE(path["low"], path["auc"]);
  EXPECT_TRUE(path["kinds"].contains("plane"));
  EXPECT_FALSE(defaults["metrics"].contains("task_score"));
  // Two lessons, three people of three levels.
  const auto kept = listAttempts(folder_ / "one");
  EXPECT_EQ(kept.attempts.size(), 18U);
  EXPECT_TRUE(kept.problems.empty());
}

TEST_F(BenchMetrics, WritesAttemptsOfTheLengthThatIsAskedFor) {
  const auto made = runBench({"bench", "attempts", "--case", "liver-sweep-recorded", "--count", "3", "--minutes", "4", "-o", folder_ / "a",
                              "--report", folder_ / "r.json"});
  ASSERT_EQ(made.status, 0) << made.err;
  const auto kept = listAttempts(folder_ / "a");
  EXPECT_EQ(kept.attempts.size(), 3U);
  const json quality = readJson(folder_ / "r.json")["quality"];
  EXPECT_GE(quality["seconds"].get<double>(), 3 * 238.0);
  EXPECT_GE(quality["images"].get<double>(), 3 * 20.0 * 238.0);
  const auto again = runBench({"bench", "attempts", "--count", "1", "-o", folder_ / "a"});
  EXPECT_EQ(again.status, 1) << "the folder is there";
  EXPECT_EQ(listAttempts(folder_ / "a").attempts.size(), 3U);
}

TEST_F(BenchMetrics, RefusesWhatCannotBeStudied) {
  EXPECT_EQ(runBench({"bench", "metrics", "--people", "2"}).status, 2);
  EXPECT_EQ(runBench({"bench", "metrics", "--case", "no-such-case"}).status, 1);
  EXPECT_EQ(runBench({"bench", "metrics", "--page", folder_ / "study.html"}).status, 2);
  EXPECT_TRUE(folder_.names().empty());
}

}  // namespace
}  // namespace ew::test::bench_metrics_test
