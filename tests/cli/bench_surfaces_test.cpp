#include <gtest/gtest.h>

#include "cli/bench_run.h"

namespace ew::test::bench_surfaces_test {
namespace {

TEST(BenchSurfaces, MeasuresOursAndVtksAgainstTheShapes) {
  const TemporaryFolder folder;
  const auto outcome =
      runBench({"bench", "surfaces", "--side", "64", "--repetitions", "1", "--html", folder / "page", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto quality = readJson(folder / "r.json")["quality"];
  ASSERT_EQ(quality["results"].size(), 3u);
  const auto &own = quality["results"][0], &one = quality["results"][1], &vtk = quality["results"][2];
  EXPECT_EQ(quality["labels"], 12);
  EXPECT_EQ(own["triangles"], one["triangles"]);
  EXPECT_EQ(own["mean_voxel"], one["mean_voxel"]);
  // What does not depend on the machine.
  EXPECT_LT(own["farthest_voxel"].get<double>(), 1.0);
  EXPECT_LT(own["farthest_back_voxel"].get<double>(), 1.0);
  EXPECT_LT(own["mean_voxel"].get<double>(), vtk["mean_voxel"].get<double>());
  EXPECT_LT(own["triangles"].get<int>(), vtk["triangles"].get<int>()) << "shared sheets are there once";
  EXPECT_GT(vtk["median_us"].get<double>(), 0.0);
  EXPECT_EQ(quality["must_show"].size(), 4u);
  EXPECT_NE(outcome.out.find("share of VTK's time"), std::string::npos) << outcome.out;
  EXPECT_GT(std::filesystem::file_size(folder / "page/accuracy-and-time.html"), 1000u);
  const auto alone = runBench({"bench", "surfaces", "--side", "32", "--repetitions", "1", "--threads", "1", "--no-peers"});
  EXPECT_EQ(alone.status, 0) << alone.err;
  EXPECT_EQ(alone.out.find("VTK"), std::string::npos) << alone.out;
}

}  // namespace
}  // namespace ew::test::bench_surfaces_test
