#include <gtest/gtest.h>

#include <algorithm>

#include "bench_page.h"
#include "bench_parts.h"
#include "cli/cli_world.h"

namespace ew::test {
namespace {

TEST(BenchFrame, MeasuresEveryEffectAgainstThePeerAndEveryVariantAgainstItsExactAnswer) {
  const TemporaryFolder folder;
  const auto outcome = run({"bench", "frame", "--side", "128", "--frame", "160x128", "--poses", "2", "--repetitions", "1", "--html",
                            folder / "page", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto quality = readJson(folder / "r.json")["quality"];
  const auto row = [&](const std::string& group, const std::string& method) {
    for (const auto& each : quality["results"])
      if (each["group"] == group && each["method"] == method) return each;
    ADD_FAILURE() << "no row " << group << ", " << method;
    return nlohmann::json();
  };
  const auto psnr = [&](const std::string& group, const std::string& method) { return row(group, method)["psnr_db"].get<double>(); };
  EXPECT_GT(psnr("sampling", "linear"), psnr("sampling", "weave") + 5.0);
  EXPECT_GT(psnr("sampling", "cubic"), psnr("sampling", "linear") + 2.0);
  EXPECT_NEAR(psnr("sampling", "linear"), psnr("sampling", "VTK linear"), 1.0) << "the same plane, the same answer";
  EXPECT_GT(psnr("focus", "lateral kernel"), psnr("focus", "row stretch"));
  EXPECT_GT(psnr("slice thickness", "7 planes"), psnr("slice thickness", "3 planes") - 0.5);
  EXPECT_GT(psnr("slice thickness", "7 planes"), 30.0) << "planes, beams and scan conversion come near the exact mean";
  for (const auto& each : quality["results"]) {
    EXPECT_GT(each["median_us"].get<double>(), 0.0) << each;
    EXPECT_TRUE(each.contains("of_peer"));
  }
  const std::string plan = row("everything", "everything")["plan"].get<std::string>();
  for (const char* step : {"slice thickness", "tissues", "contact", "shadow", "reverberation", "focus", "noise", "scan conversion", "edges",
                           "persistence", "grey table", "M-mode"})
    EXPECT_NE(plan.find(step), std::string::npos) << step << " is missing in " << plan;
  EXPECT_EQ(row("sampling", "linear")["plan"], "display: linear") << "a neutral frame runs nothing else";
  ASSERT_EQ(quality["must_show"].size(), 2u);
  EXPECT_NE(outcome.out.find("of VTK's bare linear slice"), std::string::npos) << outcome.out;

  const std::string page = readText(folder / "page/accuracy-and-time.html");
  EXPECT_NE(page.find("<svg"), std::string::npos);
  for (const char* outside : {"http:", "https:", "<script", "src=", "@import"}) EXPECT_EQ(page.find(outside), std::string::npos) << outside;
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
}  // namespace ew::test
