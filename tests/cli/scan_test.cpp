#include <gtest/gtest.h>

#include <algorithm>

#include "caption.h"
#include "cli/cli_world.h"
#include "ew/imaging/frame.h"
#include "ew/io/image_file.h"
#include "knobs_file.h"

namespace ew::test {
namespace {

/// The scanned volume fills the probe's view: 90 mm cubed of one grey level.
class ScanCommand : public testing::Test {
 protected:
  void SetUp() override {
    Volume volume;
    volume.grid.dims = {90, 90, 90};
    volume.grid.origin_mm = {-45.0, -10.0, -45.0};
    volume.echo.assign(volume.grid.voxelCount(), 100);
    ASSERT_TRUE(writeVolume(volume, folder / "v.mha"));
    writeText(folder / "probe.json", probeText);
  }
  [[nodiscard]] std::vector<std::string> words(const std::string& output) const {
    return {"scan", folder / "v.mha", "--probe", folder / "probe.json", "--pose", kIdentityPose, "--size", "320x240", "-o", output};
  }
  const std::string probeText =
      R"({"format": 1, "name": "Test linear", "kind": "linear", "width_mm": 40, "lines": 64, "carrier_hz": 5e6,
          "elevational_thickness_mm": 2, "min_depth_mm": 20, "max_depth_mm": 80, "default_depth_mm": 60})";
  TemporaryFolder folder;
};

TEST_F(ScanCommand, ShowsTheVolumeInTheFanAndBlackOutside) {
  auto outcome = run(words(folder / "o.mha"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto image = readImage(folder / "o.mha");
  ASSERT_TRUE(image);
  ASSERT_EQ(image->width, 320);
  EXPECT_EQ(viewOf(*image).at(160, 120), 100);
  EXPECT_EQ(viewOf(*image).at(2, 120), 0);
  for (const auto value : image->pixels) ASSERT_TRUE(value == 0 || value == 100);
}

TEST_F(ScanCommand, WritesTheWarningIntoAPictureButNotIntoTheBareFrame) {
  ASSERT_EQ(run(words(folder / "o.mha")).status, 0);
  ASSERT_EQ(run(words(folder / "o.png")).status, 0);
  auto bare = readImage(folder / "o.mha");
  const auto picture = readImage(folder / "o.png");
  ASSERT_TRUE(bare && picture);
  EXPECT_NE(*bare, *picture);
  cli::burnCaption(viewOf(*bare), "simulation, not for diagnosis");
  EXPECT_EQ(*bare, *picture);
}

TEST_F(ScanCommand, GainActsAsTheKnobsFileSays) {
  writeText(folder / "knobs.json", R"({"gain": 1.5, "quality": "weave"})");
  auto with = words(folder / "o.mha");
  with.insert(with.end(), {"--knobs", folder / "knobs.json"});
  ASSERT_EQ(run(with).status, 0);
  const auto image = readImage(folder / "o.mha");
  ASSERT_TRUE(image);
  EXPECT_EQ(viewOf(*image).at(160, 120), 150);
}

TEST_F(ScanCommand, PutsTheMarkedSideAtTheLeftUnlessTheKnobsSayOtherwise) {
  Volume volume;
  volume.grid.dims = {90, 90, 90};
  volume.grid.origin_mm = {-44.5, -10.0, -45.0};
  volume.echo.assign(volume.grid.voxelCount(), 50);
  for (std::size_t n = 0; n < volume.echo.size(); ++n)
    if (n % 90 >= 45) volume.echo[n] = 200;  // the side that +x of the probe points to
  ASSERT_TRUE(writeVolume(volume, folder / "v.mha"));
  for (const bool markerLeft : {true, false}) {
    auto with = words(folder / "o.mha");
    if (!markerLeft) {
      writeText(folder / "knobs.json", R"({"marker_left": false})");
      with.insert(with.end(), {"--knobs", folder / "knobs.json"});
    }
    ASSERT_EQ(run(with).status, 0);
    const auto image = readImage(folder / "o.mha");
    ASSERT_TRUE(image);
    EXPECT_EQ(viewOf(*image).at(120, 120), markerLeft ? 200 : 50);
    EXPECT_EQ(viewOf(*image).at(200, 120), markerLeft ? 50 : 200);
  }
}

TEST_F(ScanCommand, PlanNamesTheStepsWithEstimatedAndMeasuredTimes) {
  writeText(folder / "knobs.json", R"({"gain": 1.5})");
  const auto neutral = run({"scan", folder / "v.mha", "--probe", folder / "probe.json", "--pose", kIdentityPose, "--plan"});
  const auto gained = run(
      {"scan", folder / "v.mha", "--probe", folder / "probe.json", "--pose", kIdentityPose, "--plan", "--knobs", folder / "knobs.json"});
  ASSERT_EQ(neutral.status, 0) << neutral.err;
  ASSERT_EQ(gained.status, 0) << gained.err;
  const std::string table = nameOf(StepKind::table);
  EXPECT_EQ(neutral.out.find("  " + table), std::string::npos) << "a neutral effect costs nothing\n" << neutral.out;
  EXPECT_NE(gained.out.find("  " + table), std::string::npos) << gained.out;
  EXPECT_NE(gained.out.find("us estimated"), std::string::npos);
  EXPECT_NE(gained.out.find("us measured"), std::string::npos);
}

TEST_F(ScanCommand, AKnobsFileIsReadStrictly) {
  const std::vector<std::pair<std::string, std::string>> wrong{{R"({"gian": 2})", "gian"},
                                                               {R"({"gain": "loud"})", "gain"},
                                                               {R"({"gain": -1})", "gain"},
                                                               {R"({"dgc": [1, 2, 3]})", "dgc"},
                                                               {R"({"dgc": [1, 1, 1, 1, 1, 1, 1, -1]})", "dgc"},
                                                               {R"({"zoom": 0.5})", "zoom"},
                                                               {R"({"quality": "best"})", "quality"},
                                                               {R"({"marker_left": 1})", "marker_left"},
                                                               {R"({"depth_mm": 500})", "depth"},
                                                               {R"([1, 2])", "knobs.json"},
                                                               {R"({"gain": )", "knobs.json"}};
  for (const auto& [text, named] : wrong) {
    writeText(folder / "knobs.json", text);
    auto with = words(folder / "o.mha");
    with.insert(with.end(), {"--knobs", folder / "knobs.json"});
    const auto outcome = run(with);
    EXPECT_EQ(outcome.status, 1) << text;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "o.mha")) << text;
  }
}

TEST_F(ScanCommand, NumbersSeveralPosesAndRepeatsWithoutWriting) {
  writeText(folder / "poses.txt", kIdentityPose + "\n" + kIdentityPose + "\n");
  const auto before = folder.names();
  auto several = words(folder / "o.png");
  several[5] = folder / "poses.txt";
  auto repeated = several;
  repeated.insert(repeated.end(), {"--repeat", "3", "--report", folder / "r.json"});
  ASSERT_EQ(run(repeated).status, 0);
  auto expected = before;
  expected.push_back("r.json");
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(folder.names(), expected);
  const auto report = readJson(folder / "r.json");
  for (const auto& step : report["steps"])
    if (step["name"] == "frame") {
      EXPECT_EQ(step["count"], 6);
    }
  ASSERT_EQ(run(several).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "o_0000.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "o_0001.png"));
}

TEST_F(ScanCommand, NamesTheProbesThereAreWhenTheOneAskedForIsUnknown) {
  const auto outcome = run({"scan", folder / "v.mha", "--probe", "no-such-probe", "--pose", kIdentityPose, "-o", folder / "o.png"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("convex"), std::string::npos) << outcome.err;
}

TEST_F(ScanCommand, RefusesAPictureTooSmallForItsWarning) {
  auto small = words(folder / "o.png");
  small[7] = "40x30";
  EXPECT_EQ(run(small).status, 2);
  small.back() = folder / "o.mha";
  EXPECT_EQ(run(small).status, 0);
}

}  // namespace
}  // namespace ew::test
