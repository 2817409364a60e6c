#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "cli/cli_world.h"
#include "ew/imaging/caption.h"
#include "ew/imaging/frame.h"
#include "ew/io/image_file.h"
#include "ew/library/case.h"
#include "run/knobs_file.h"

namespace ew::test::scan_test {
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

TEST_F(ScanCommand, WritesTheWarningIntoAnImageButNotIntoTheBareFrame) {
  ASSERT_EQ(run(words(folder / "o.mha")).status, 0);
  ASSERT_EQ(run(words(folder / "o.png")).status, 0);
  auto bare = readImage(folder / "o.mha");
  const auto image = readImage(folder / "o.png");
  ASSERT_TRUE(bare && image);
  EXPECT_NE(*bare, *image);
  burnCaption(viewOf(*bare), "simulation, not for diagnosis");
  EXPECT_EQ(*bare, *image);
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

TEST_F(ScanCommand, RefusesAnImageTooSmallForItsWarning) {
  auto small = words(folder / "o.png");
  small[7] = "40x30";
  EXPECT_EQ(run(small).status, 2);
  small.back() = folder / "o.mha";
  EXPECT_EQ(run(small).status, 0);
}

/// The shipped case with the gall stone, at 2 mm so that it is made quickly, in a cache of its own.
class ScanOfACase : public testing::Test {
 protected:
  void SetUp() override {
    const auto shipped = shippedCasesFolder();
    ASSERT_TRUE(shipped);
    std::filesystem::copy(*shipped / "upper-abdomen-gall-stone", folder / "case", std::filesystem::copy_options::recursive);
    auto manifest = readJson(folder / "case/case.json");
    manifest["volume"]["recipe_spacing_mm"] = 2.0;
    manifest["volume"].erase("sweeps");  // as the anatomy is drawn: no shadow is in the voxels
    manifest["volume"].erase("reconstruct");
    manifest["start_pose"] = manifest["expert_pose"];  // the stone in the image
    writeText(folder / "case/case.json", manifest.dump());
  }
  TemporaryFolder folder;
  const EnvironmentValue cache{"ECHOWEAVE_CACHE", folder / "cache"};
};

TEST_F(ScanOfACase, CastsTheStonesShadowAwayFromTheProbe) {
  writeText(folder / "plain.json", "{}");
  writeText(folder / "shadow.json", R"({"attenuation": true})");
  std::map<std::string, GreyImage> images;
  for (const std::string scene : {"plain", "shadow"}) {
    const auto outcome = run({"scan", folder / "case", "--scene", folder / (scene + ".json"), "--size", "400x300", "-o",
                              folder / (scene + ".mha"), "--report", folder / "r.json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    images[scene] = *readImage(folder / (scene + ".mha"));
  }
  const auto opened = loadCase(folder / "case");
  ASSERT_TRUE(opened) << opened.error();
  const auto probe = readProbe(*resourceFolder() / "probes" / (opened->probes.front() + ".json"));
  ASSERT_TRUE(probe) << probe.error();
  const auto imageToProbe = fitDisplay(*probe, {}, 400, 300).imageToProbe();
  const glm::dmat4 worldToImage = glm::inverse(opened->startPose->probeToWorld.matrix * imageToProbe.matrix);
  const glm::dvec3 stone_px(worldToImage * glm::dvec4(-51.4, -24.4, -55.2, 1.0));
  const glm::dvec3 apex_px(glm::inverse(imageToProbe.matrix) * glm::dvec4(0.0, -probe->radius_mm, 0.0, 1.0));
  const glm::dvec2 away = glm::normalize(glm::dvec2(stone_px) - glm::dvec2(apex_px));
  const auto meanAt = [&](const std::string& scene, double pastStone_px) {
    const glm::ivec2 p(glm::round(glm::dvec2(stone_px) + pastStone_px * away));
    double sum = 0.0;
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x) sum += viewOf(images[scene]).at(p.x + x, p.y + y);
    return sum / 25.0;
  };
  for (const double behind_px : {35.0, 50.0, 65.0}) {
    EXPECT_GT(meanAt("plain", behind_px), 30.0) << "the volume itself holds no shadow";
    EXPECT_LT(meanAt("shadow", behind_px), 5.0) << behind_px;
  }
}

TEST_F(ScanOfACase, MakesNoMoreOfItThanTheImageShowsAndSaysSo) {
  std::filesystem::create_directories(folder / "cache");
  writeText(folder / "cache/speed.json", R"({"voxels": 50.0})");  // a machine so slow that a part is worth it
  const auto saysSo = [](const Outcome& outcome) { return outcome.err.find("The case is not prepared") != std::string::npos; };
  for (const char* image : {"part.mha", "again.mha"}) {
    const auto outcome = run({"scan", folder / "case", "--size", "400x300", "-o", folder / image});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(saysSo(outcome)) << image << ": " << outcome.err;
    EXPECT_NE(outcome.err.find("case prepare " + (folder / "case")), std::string::npos) << outcome.err;
  }
  // A body that breathes is looked at elsewhere.
  const auto breathing = run({"scan", folder / "case", "--size", "400x300", "--breath", "0.5", "-o", folder / "breath.mha"});
  ASSERT_EQ(breathing.status, 0) << breathing.err;
  EXPECT_FALSE(saysSo(breathing)) << breathing.err;
  const auto whole = run({"scan", folder / "case", "--size", "400x300", "-o", folder / "whole.mha"});
  ASSERT_EQ(whole.status, 0) << whole.err;
  EXPECT_FALSE(saysSo(whole)) << "all of it is there now";
  const auto part = readImage(folder / "part.mha");
  ASSERT_TRUE(part) << part.error();
  EXPECT_EQ(*part, *readImage(folder / "again.mha"));
  EXPECT_EQ(*part, *readImage(folder / "whole.mha"));
  EXPECT_NE(*part, *readImage(folder / "breath.mha"));
}

TEST_F(ScanOfACase, DrawsAContactSheetThatCarriesTheWarning) {
  const auto outcome = run({"scan", folder / "case", "--size", "160x120", "--contact-sheet", folder / "sheet.png"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  auto sheet = readImage(folder / "sheet.png");
  ASSERT_TRUE(sheet) << sheet.error();
  EXPECT_EQ(sheet->width, 960);
  const GreyImage before = *sheet;
  burnCaption(viewOf(*sheet), kNotForDiagnosis);
  EXPECT_EQ(*sheet, before);
  // Off and on differ in every pair.
  int differing = 0;
  for (int pair = 0; pair < 15; ++pair) {
    const int left = pair % 3 * 320, top = pair / 3 * 138;
    bool differs = false;
    for (int y = 0; y < 120 && !differs; ++y) {
      const auto* row = viewOf(*sheet).row(top + y) + left;
      differs = !std::equal(row, row + 160, row + 160);
    }
    EXPECT_TRUE(differs) << "pair " << pair;
    differing += differs ? 1 : 0;
  }
  EXPECT_EQ(differing, 15);
  EXPECT_EQ(run({"scan", folder / "case", "--contact-sheet", folder / "s.png", "-o", folder / "o.png"}).status, 2);
  EXPECT_EQ(run({"scan", folder / "case", "--size", "100x100", "--contact-sheet", folder / "s.png"}).status, 2);
}

}  // namespace
}  // namespace ew::test::scan_test
