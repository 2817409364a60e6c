#include <gtest/gtest.h>

#include "bench/volumes/bench_stitch.h"
#include "cli/bench_run.h"

namespace ew::test::bench_stitch_test {
namespace {

TEST(BenchStitch, MeasuresEverySettingAndDrawsThem) {
  const TemporaryFolder folder;
  const auto outcome = runBench({"bench", "stitch", "--side", "80", "--repetitions", "1", "--html", folder / "page", "--report",
                                 folder / "r.json", "--note", "Nothing else ran."});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto quality = readJson(folder / "r.json")["quality"];
  const auto row = [&](const std::string& name) {
    for (const auto& each : quality["results"])
      if (each["name"] == name) return each;
    ADD_FAILURE() << "no row " << name;
    return quality["results"].front();
  };
  const auto cut = row("stitch_graph_cut/cell_1.5mm/blend_3mm");
  // The deepest view shows the shadow, the cut fills it.
  EXPECT_LT(row("stitch_nearest/cell_1.5mm/blend_3mm")["shadow_error_db"].get<double>(), -5.0);
  EXPECT_NEAR(cut["shadow_error_db"].get<double>(), 0.0, 1.0);
  // A paste shows where it is, the blend does not.
  EXPECT_GT(row("stitch_graph_cut/cell_1.5mm/blend_0mm")["derivative_ratio"].get<double>(), 1.15);
  EXPECT_LT(cut["derivative_ratio"].get<double>(), 1.15);
  for (const int block : {32, 64, 128})
    EXPECT_TRUE(row("stitch_graph_cut/cell_1.5mm/blend_3mm/block_" + std::to_string(block))["same_as_whole"].get<bool>());
  for (const auto& threads : quality["threads_measured"]) EXPECT_TRUE(threads["same_voxels"].get<bool>());
  EXPECT_NE(outcome.out.find("derivative across the seam"), std::string::npos);
  EXPECT_EQ(stitchSections(quality).size(), 2u);
  EXPECT_NE(readText(folder / "page/accuracy-and-time.html").find(". Nothing else ran."), std::string::npos) << "said beside the machine";
}

TEST(BenchStitch, RefusesOptionsOutsideTheirRange) {
  EXPECT_EQ(runBench({"bench", "stitch", "--side", "20"}).status, 2);
  EXPECT_EQ(runBench({"bench", "stitch", "--repetitions", "0"}).status, 2);
}

}  // namespace
}  // namespace ew::test::bench_stitch_test
