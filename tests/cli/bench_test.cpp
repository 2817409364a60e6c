#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/tools/bench_page.h"
#include "bench/tools/bench_parts.h"
#include "cli/bench_run.h"
#include "ew/cli/run_command.h"

namespace ew::test::bench_test {
namespace {

class BenchFrame : public BenchRun<BenchFrame> {
 public:
  static std::vector<std::string> command() {
    return {"bench", "frame", "--side", "128", "--frame", "160x128", "--poses", "2", "--repetitions", "1"};
  }
};

TEST_F(BenchFrame, MeasuresEveryEffectAgainstThePeerAndEveryVariantAgainstItsExactAnswer) {
  const auto row = [](const std::string& group, const std::string& method) {
    return BenchRun::row({{"group", group}, {"method", method}});
  };
  const auto psnr = [&](const std::string& group, const std::string& method) { return row(group, method)["psnr_db"].get<double>(); };
  EXPECT_GT(psnr("sampling", "linear"), psnr("sampling", "weave") + 5.0);
  EXPECT_GT(psnr("sampling", "cubic"), psnr("sampling", "linear") + 2.0);
  EXPECT_NEAR(psnr("sampling", "linear"), psnr("sampling", "VTK linear"), 1.0) << "the same plane, the same answer";
  EXPECT_GT(psnr("focus", "lateral kernel"), psnr("focus", "row stretch"));
  EXPECT_GT(psnr("slice thickness", "7 planes"), psnr("slice thickness", "3 planes") - 0.5);
  EXPECT_GT(psnr("slice thickness", "7 planes"), 30.0) << "planes, beams and scan conversion come near the exact mean";
  for (const auto& each : quality()["results"]) {
    EXPECT_GT(each["median_us"].get<double>(), 0.0) << each;
    EXPECT_TRUE(each.contains("of_peer"));
  }
  const std::string plan = row("everything", "everything")["plan"].get<std::string>();
  for (const char* step : {"slice thickness", "tissues", "contact", "shadow", "reverberation", "focus", "noise", "scan conversion", "edges",
                           "persistence", "grey table", "M-mode"})
    EXPECT_NE(plan.find(step), std::string::npos) << step << " is missing in " << plan;
  EXPECT_EQ(row("sampling", "linear")["plan"], "display: linear") << "a neutral frame runs nothing else";
  ASSERT_EQ(quality()["must_show"].size(), 2u);
  EXPECT_NE(said().find("of VTK's bare linear slice"), std::string::npos) << said();
  expectOnItsOwn(page());
}

class BenchReconstruct : public BenchRun<BenchReconstruct> {
 public:
  static std::vector<std::string> command() {
    return {"bench", "reconstruct", "--spacing", "1", "--sweep", "14", "--image", "64", "--views", "1", "--repetitions", "1"};
  }
};

TEST_F(BenchReconstruct, MeasuresEverySettingAgainstTheExactField) {
  ASSERT_EQ(quality()["results"].size(), 3u * 3u * 5u);
  for (const auto& each : quality()["results"]) {
    EXPECT_GT(each["median_us"].get<double>(), 0.0);
    EXPECT_GT(each["mpx_per_s"].get<double>(), 0.0);
    ASSERT_TRUE(each["measured"].is_object()) << each;
    const bool filled = each["filled"].is_object();
    if (each["interpolation"] != "linear") {  // which reaches every voxel of these sweeps
      EXPECT_EQ(filled, each["fill_method"] != "none") << each;
    }
    EXPECT_LT(std::abs(each["measured"]["bias"].get<double>()), 1.0) << each;
  }
  for (const std::string sweep : {"parallel", "fan", "freehand"}) {
    const std::string at = "reconstruct_" + sweep + "/1mm/";
    const auto psnr = [&](const std::string& setting, const char* kind) {
      return row({{"name", at + setting}})[kind]["psnr_db"].get<double>();
    };
    EXPECT_GT(psnr("centred/none", "measured"), psnr("nearest/none", "measured")) << sweep;
    if (sweep != "freehand") {  // a hand that goes back is met as well by bridges
      EXPECT_GT(psnr("nearest/sweep_6mm", "filled"), psnr("nearest/bridges_6mm", "filled")) << sweep;
    }
    EXPECT_EQ(row({{"name", at + "nearest/none"}})["measured"], row({{"name", at + "nearest/sweep_6mm"}})["measured"])
        << "filling leaves measured voxels alone";
    EXPECT_GE(row({{"name", at + "nearest/bridges_6mm"}})["filled"]["share"],
              row({{"name", at + "nearest/bridges_2mm"}})["filled"]["share"])
        << sweep;
  }
  ASSERT_EQ(quality()["threads_measured"].size(), 9u);
  for (const auto& each : quality()["threads_measured"]) EXPECT_TRUE(each["same_voxels"].get<bool>()) << each;
  EXPECT_NE(said().find("Mpx/s"), std::string::npos) << said();
}

TEST_F(BenchReconstruct, TellsShadowsOfVirtualFramesByConfidence) {
  ASSERT_EQ(quality()["confidence"].size(), 2u * 6u);
  double fastestWalk_us = 1e300, slowestWalk_us = 0.0;
  for (const auto& each : quality()["confidence"]) {
    const bool used = each["lines"] == 0 || each["lines"] == 96;  // by default; finer graphs are worse, speckle holds their walkers up
    EXPECT_GT(each["area_under_curve"].get<double>(), used ? 0.85 : 0.5) << each;
    EXPECT_LT(each["mean_in_shadow"], each["mean_in_sight"]) << each;
    if (each["method"] != "randomwalk") continue;
    fastestWalk_us = std::min(fastestWalk_us, each["median_us"].get<double>());
    slowestWalk_us = std::max(slowestWalk_us, each["median_us"].get<double>());
  }
  EXPECT_GT(slowestWalk_us, 4.0 * fastestWalk_us) << "a graph of 64 times as many nodes";
}

TEST_F(BenchReconstruct, WritesItsPageWithCurvesOnTheirOwnAxes) {
  const std::string page = BenchRun::page();
  for (const char* words : {"Pasting frames", "parallel sweep", "fan sweep", "freehand sweep", "two threads", "accuracy, PSNR in dB",
                            ">area under the curve<", "beam-wise", "192 x 256"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
  EXPECT_EQ(page.find("nan"), std::string::npos);
}

TEST_F(BenchReconstruct, RefusesWhatItCannotMeasure) {
  EXPECT_EQ(runBench({"bench", "reconstruct", "--spacing", "0.1"}).status, 2);
  EXPECT_EQ(runBench({"bench", "reconstruct", "--spacing", "fine"}).status, 2);
  EXPECT_EQ(runBench({"bench", "reconstruct", "--sweep", "2"}).status, 2);
}

TEST(BenchUsage, EveryBenchExplainsItselfWithAnExampleAndTheSharedOptions) {
  for (const char* name : {"slicing", "frame", "echoes", "reconstruct", "register", "stitch", "surfaces", "tracking", "compass",
                           "exercises", "metrics", "attempts", "library", "all"}) {
    const auto help = runBench({"bench", name, "--help"});
    EXPECT_EQ(help.status, 0) << name;
    for (const std::string& part :
         {std::string("--report"), std::string("--quiet"), std::string("Examples:"), "echoweave bench " + std::string(name)})
      EXPECT_NE(help.out.find(part), std::string::npos) << name << " " << part;
  }
}

TEST(BenchUsage, WrongWordsAreOneSentenceAndStatusTwo) {
  const std::vector<std::vector<std::string>> wrong{{"bench"},
                                                    {"bench", "nothing"},
                                                    {"bench", "slicing", "--side", "3"},
                                                    {"bench", "slicing", "--simd", "avx"},
                                                    {"bench", "all", "--pair-side", "20"},
                                                    {"bench", "surfaces", "--side", "16"},
                                                    {"bench", "tracking"}};
  for (const auto& words : wrong) {
    const auto outcome = runBench(words);
    EXPECT_EQ(outcome.status, cli::kWrongUsage) << words.back() << outcome.err;
    EXPECT_EQ(outcome.out, "") << words.back();
    EXPECT_EQ(outcome.err.rfind("echoweave: ", 0), 0u) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(BenchUsage, AllBenchesAreAskedOnceWhatSeveralHave) {
  const auto help = runBench({"bench", "all", "--help"});
  for (const char* option : {"--side", "--size", "--large", "--frame", "--poses", "--case", "--timed", "--spacing", "--sweep", "--image",
                             "--views", "--pair-side", "--paper", "--view-side", "--seed", "--repetitions", "--no-peers"})
    EXPECT_NE(help.out.find(std::string("\n  ") + option + " "), std::string::npos) << option << "\n" << help.out;
}

TEST(BenchField, HasTheMeanThatItsSamplesHaveUnderANormalDistribution) {
  const BenchField field(64);
  for (const glm::dvec3& sigma : {glm::dvec3(0.0), glm::dvec3(1.5, 0, 0), glm::dvec3(0.7, -1.1, 0.4)}) {
    const glm::dvec3 p(20.3, 31.7, 28.1);
    double sum = 0.0, weights = 0.0;
    for (int n = -400; n <= 400; ++n) {
      const double u = n / 50.0, weight = std::exp(-0.5 * u * u);
      sum += weight * field.at(p + u * sigma);
      weights += weight;
    }
    EXPECT_NEAR(field.meanAt(p, sigma), sum / weights, 1e-6);
  }
}

TEST(BenchPage, KeepsWhatAnotherRunMeasuredAndRenewsWhatThisOneDid) {
  const auto section = [](const std::string& title, const std::string& text) {
    BenchSection made;
    made.title = title;
    made.text = text;
    return made;
  };
  const std::string first = benchPage("t", {"intro"}, {section("frames & more", "old frames"), section("slices", "old slices")});
  const std::string second = benchPage("t", {"intro"}, {section("pairs", "new pairs"), section("slices", "new slices")}, first);
  const auto at = [&](const std::string& words) { return second.find(words); };
  EXPECT_LT(at("old frames"), at("new slices")) << "each stays where it was";
  EXPECT_LT(at("new slices"), at("new pairs"));
  EXPECT_NE(at("new pairs"), std::string::npos);
  EXPECT_EQ(at("old slices"), std::string::npos);
  EXPECT_EQ(at("intro"), second.rfind("intro")) << "no words before the sections are doubled";
  EXPECT_EQ(benchPage("t", {"intro"}, {section("pairs", "new pairs"), section("slices", "new slices")}, second), second);
  EXPECT_EQ(benchPage("t", {}, {section("a", "b")}, "<h2>no page of ours"), benchPage("t", {}, {section("a", "b")}));
}

TEST(BenchPage, EscapesWhatItShows) {
  BenchSection section;
  section.title = "a < b & c";
  section.points = {{"<i>", "\"quoted\"", 1.0, 40.0, BenchMark::own, ""}};
  section.table = {1, {"x"}, {{"<td>"}}};
  const std::string page = benchPage("t", {"<p>"}, {section});
  EXPECT_NE(page.find("a &lt; b &amp; c"), std::string::npos);
  EXPECT_EQ(page.find("<i>"), std::string::npos);
  EXPECT_NE(page.find("&lt;td&gt;"), std::string::npos);
}

}  // namespace
}  // namespace ew::test::bench_test
