#include <gtest/gtest.h>

#include "cli/cli_world.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/tissue_level.h"
#include "ew/io/image_file.h"

namespace ew::test::scan_effects_test {
namespace {

/// Grey tissue with a bright plate 20 mm below the face, over the left half of the image (+x of the probe).
class ScanEffects : public testing::Test {
 protected:
  void SetUp() override {
    Volume volume;
    volume.grid.dims = {90, 90, 90};
    volume.grid.origin_mm = {-44.5, -10.0, -45.0};
    volume.echo.assign(volume.grid.voxelCount(), 100);
    for (std::size_t n = 0; n < volume.echo.size(); ++n) {
      const auto i = n % 90, j = n / 90 % 90;
      if (i >= 45 && j >= 30 && j < 33) volume.echo[n] = 250;
    }
    ASSERT_TRUE(writeVolume(volume, folder / "v.mha"));
    writeText(folder / "probe.json",
              R"({"format": 1, "name": "Test linear", "kind": "linear", "width_mm": 40, "lines": 64, "carrier_hz": 5e6,
                  "elevational_thickness_mm": 2, "min_depth_mm": 20, "max_depth_mm": 80, "default_depth_mm": 60})");
  }
  /// `scan` of the volume with a scene and further words.
  Outcome scan(const std::string& scene, const std::vector<std::string>& more, const std::string& knobs = "{}",
               const std::string& pose = kIdentityPose) {
    writeText(folder / "scene.json", scene);
    writeText(folder / "knobs.json", knobs);
    std::vector<std::string> words{"scan",   folder / "v.mha", "--probe", folder / "probe.json", "--pose",  pose,
                                   "--size", "320x240",        "--scene", folder / "scene.json", "--knobs", folder / "knobs.json"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  TemporaryFolder folder;
};

std::vector<std::string> namesOf(const nlohmann::json& plan) {
  std::vector<std::string> names;
  for (const auto& step : plan) names.push_back(step["name"]);
  return names;
}

TEST_F(ScanEffects, AShadowLiesBehindThePlateAndNowhereElse) {
  ASSERT_EQ(scan(R"({"attenuation": true})", {"-o", folder / "o.mha"}).status, 0);
  const auto image = readImage(folder / "o.mha");
  ASSERT_TRUE(image);
  EXPECT_LT(viewOf(*image).at(120, 180), 40);
  EXPECT_NEAR(viewOf(*image).at(200, 180), 100, 12);
  EXPECT_NEAR(viewOf(*image).at(120, 40), 100, 12);
}

TEST_F(ScanEffects, LiveEchoesOfARecordedVolumeAreFormedFromALevelThatIsFoundFirst) {
  const auto live = scan(R"({"live_echoes": {"own_grain": 0.5}})", {"--plan", "--report", folder / "r.json"});
  ASSERT_EQ(live.status, 0) << live.err;
  EXPECT_NE(live.out.find("own grain"), std::string::npos) << live.out;
  EXPECT_NE(live.out.find("Made the level of the recorded tissue"), std::string::npos) << live.out;
  const auto mapped = scan(R"({"live_echoes": true})", {"--map", "--plan"});
  EXPECT_NE(mapped.status, 0);
}

TEST_F(ScanEffects, TheLevelOfAVolumeIsWrittenBesideIt) {
  const auto made = run({"level", folder / "v.mha", "-o", folder / "level.mha", "--sigma-mm", "1", "--report", folder / "r.json"});
  ASSERT_EQ(made.status, 0) << made.err;
  const auto level = readLabelVolume(folder / "level.mha");
  const auto volume = readVolume(folder / "v.mha");
  ASSERT_TRUE(level && volume);
  EXPECT_EQ(level->volume.grid, volume->volume.grid);
  EXPECT_EQ(level->volume.echo, *levelOf(volume->volume, {.sigma_mm = 1.0}));
  EXPECT_NE(made.out.find("100.0 % of the voxels"), std::string::npos) << made.out;
  EXPECT_NE(run({"level", folder / "v.mha", "-o", folder / "v.mha"}).status, 0) << "never over its input";
  EXPECT_NE(run({"level", folder / "v.mha", "-o", folder / "l.mha", "--sigma-mm", "9"}).status, 0);
}

TEST_F(ScanEffects, PlanSaysWhereItSamplesAndTheReportHasBothTimesOfEachStep) {
  const auto bare = scan("{}", {"--plan"});
  ASSERT_EQ(bare.status, 0) << bare.err;
  EXPECT_NE(bare.out.find("sampled on the display's pixels"), std::string::npos) << bare.out;
  const auto shadowed = scan(R"({"attenuation": true, "focus": {"strength": 2}})", {"--plan", "--report", folder / "r.json"});
  ASSERT_EQ(shadowed.status, 0) << shadowed.err;
  EXPECT_NE(shadowed.out.find("sampled on beams"), std::string::npos) << shadowed.out;
  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["on_beams"], true);
  EXPECT_EQ(namesOf(report["plan"]), (std::vector<std::string>{"linear", "shadow", "focus", "scan conversion"}));
  for (const auto& step : report["plan"]) {
    EXPECT_GT(step["estimated_us"].get<double>(), 0.0);
    EXPECT_GT(step["measured_us"].get<double>(), 0.0);
  }
  EXPECT_EQ(report["options"]["scene"]["focus"]["strength"], 2.0);
  EXPECT_EQ(report["options"]["scene"]["attenuation"], true);
}

TEST_F(ScanEffects, APartOfTheFaceOffTheSkinGoesDark) {
  ASSERT_EQ(scan(R"({"contact": true})", {"-o", folder / "o.mha"}).status, 0);
  auto image = readImage(folder / "o.mha");
  ASSERT_TRUE(image);
  EXPECT_NEAR(viewOf(*image).at(100, 200), 100, 2);
  EXPECT_NEAR(viewOf(*image).at(220, 200), 100, 2);
  // The marked side, +x of the probe, is at the left of the image.
  ASSERT_EQ(scan(R"({"contact": true})", {"-o", folder / "o.mha", "--off-skin", "0.4:1"}).status, 0);
  image = readImage(folder / "o.mha");
  ASSERT_TRUE(image);
  EXPECT_LT(viewOf(*image).at(100, 200), 10);
  EXPECT_NEAR(viewOf(*image).at(220, 200), 100, 2);
  const auto several = scan(R"({"contact": true})", {"-o", folder / "o.mha", "--off-skin", "0.4:1", "--off-skin=-1:-0.4"});
  ASSERT_EQ(several.status, 0) << several.err;
  image = readImage(folder / "o.mha");
  EXPECT_LT(viewOf(*image).at(100, 200), 10);
  EXPECT_LT(viewOf(*image).at(220, 200), 10);
}

TEST_F(ScanEffects, OffSkinIsReadStrictlyAndSaysWhenNothingShowsIt) {
  for (const char* wrong : {"0.4", "1:0.4", "-2:0", "a:b", "0.4:", ""}) {
    const auto outcome = scan(R"({"contact": true})", {"-o", folder / "o.mha", std::string("--off-skin=") + wrong});
    EXPECT_EQ(outcome.status, 2) << wrong;
  }
  const auto unseen = scan("{}", {"-o", folder / "o.mha", "--off-skin", "0.4:1"});
  EXPECT_EQ(unseen.status, 0);
  EXPECT_NE(unseen.err.find("contact"), std::string::npos) << unseen.err;
}

TEST_F(ScanEffects, SaysThatNothingIsKnownOfBloodWhereColourIsAskedFor) {
  const auto asked = scan("{}", {"-o", folder / "o.mha"}, R"({"colour": {"persistence": 0.2}})");
  EXPECT_EQ(asked.status, 0) << asked.err;
  EXPECT_NE(asked.err.find("does not say how blood flows, so the image has no colour"), std::string::npos) << asked.err;
  const auto plain = scan("{}", {"-o", folder / "o.mha"});
  EXPECT_EQ(plain.err.find("blood"), std::string::npos) << plain.err;
}

TEST_F(ScanEffects, TheImageDoesNotDependOnTheThreads) {
  const std::string scene = R"({"attenuation": true, "focus": true, "noise": true, "slice_thickness": true, "reverberation": true})";
  ASSERT_EQ(scan(scene, {"-o", folder / "one.mha"}).status, 0);
  ASSERT_EQ(scan(scene, {"-o", folder / "two.mha", "--threads", "2"}).status, 0);
  const auto one = readImage(folder / "one.mha"), two = readImage(folder / "two.mha");
  ASSERT_TRUE(one && two);
  EXPECT_EQ(*one, *two);
}

TEST_F(ScanEffects, MModeWritesTheStripOfOneBeamOverThePoses) {
  std::string poses;
  for (int n = 0; n < 60; ++n) poses += "1 0 0 0  0 1 0 " + std::to_string(n < 30 ? 0 : 5) + "  0 0 1 0  0 0 0 1\n";
  writeText(folder / "poses.txt", poses);
  const auto strip = scan("{}", {"-o", folder / "o.mha"}, R"({"mode": "m", "m_line": 0.5, "m_sweep_s": 2})", folder / "poses.txt");
  ASSERT_EQ(strip.status, 0) << strip.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "o_0000.mha"));
  const auto image = readImage(folder / "o.mha");
  ASSERT_TRUE(image);
  ASSERT_EQ(image->width, 320);
  // The plate lies 20 mm deep; after a second the probe has come 5 mm nearer. 60 mm are 240 rows.
  const auto plateRow = [&](int x) {
    for (int y = 0; y < 240; ++y)
      if (viewOf(*image).at(x, y) > 200) return y;
    return -1;
  };
  EXPECT_NEAR(plateRow(50), 80, 4);
  EXPECT_NEAR(plateRow(250), 60, 4);
}

TEST_F(ScanEffects, TheReportCountsHowLongImagesTook) {
  ASSERT_EQ(scan("{}", {"--repeat", "20", "--report", folder / "r.json"}).status, 0);
  const auto quality = readJson(folder / "r.json")["quality"];
  EXPECT_EQ(quality["pose_to_picture_count"], 20);
  EXPECT_GT(quality["pose_to_picture_p50_us"].get<double>(), 0.0);
  EXPECT_LE(quality["pose_to_picture_p50_us"].get<double>(), quality["pose_to_picture_p95_us"].get<double>());
  EXPECT_LE(quality["pose_to_picture_p95_us"].get<double>(), quality["pose_to_picture_p99_us"].get<double>());
  EXPECT_GT(quality["pose_to_picture_max_us"].get<double>(), 0.0);
}

TEST_F(ScanEffects, ASceneFileIsReadStrictly) {
  const std::vector<std::pair<std::string, std::string>> wrong{{R"({"shadow": true})", "shadow"},
                                                               {R"({"focus": "yes"})", "focus"},
                                                               {R"({"noise": {"at_face_db": 10}})", "noise.at_face_db"},
                                                               {R"({"tissues": [{"label": 300}]})", "tissues[0].label"},
                                                               {R"([])", "scene.json"}};
  for (const auto& [text, named] : wrong) {
    const auto outcome = scan(text, {"-o", folder / "o.mha"});
    EXPECT_EQ(outcome.status, 1) << text;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "o.mha")) << text;
  }
}

TEST_F(ScanEffects, TheHelpNamesEveryKeyOfKnobsAndScenes) {
  const auto help = run({"scan", "--help"});
  for (const char* key : {"focus_method", "grey_map", "steering_deg", "m_sweep_s", "upside_down", "slice_thickness", "reverberation",
                          "expected_db_per_cm_mhz", "tissues", "--off-skin", "--threads", "--rate"})
    EXPECT_NE(help.out.find(key), std::string::npos) << key;
}

}  // namespace
}  // namespace ew::test::scan_effects_test
