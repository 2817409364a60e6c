#include <gtest/gtest.h>

#include <algorithm>

#include "cli/cli_world.h"
#include "ew/io/image_file.h"

namespace ew::test::slice_test {
namespace {

/// The plane z = 3 of the volume, pixel (0, 0) at voxel (0, 0, 3): the slice's middle column lies on the probe's axis.
std::string poseAt(int width, double z_mm) {
  return "1 0 0 " + std::to_string((width - 1) / 2.0) + " 0 1 0 0 0 0 1 " + std::to_string(z_mm) + " 0 0 0 1";
}

TEST(SliceCommand, CopiesAPlaneOfVoxelsExactlyInBothQualities) {
  const TemporaryFolder folder;
  const auto volume = rampVolume({12, 10, 8});
  ASSERT_TRUE(writeVolume(volume, folder / "v.mha"));
  for (const std::string quality : {"weave", "linear"})
    for (const std::string ending : {".png", ".mha"}) {
      const std::string file = folder / (quality + ending);
      const auto outcome =
          run({"slice", folder / "v.mha", "--pose", poseAt(12, 3), "--size", "12x10", "--pixel", "1", "--quality", quality, "-o", file});
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      const auto image = readImage(file);
      ASSERT_TRUE(image) << image.error();
      ASSERT_EQ(image->width, 12);
      ASSERT_EQ(image->height, 10);
      for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 12; ++x)
          ASSERT_EQ(viewOf(*image).at(x, y), volume.echo[volume.grid.indexOf(x, y, 3)]) << quality << ending << " at " << x << ", " << y;
    }
}

TEST(SliceCommand, ShowsTheSamePixelsFromAMappedFileAsFromMemory) {
  const TemporaryFolder folder;
  const auto volume = rampVolume({41, 30, 20});
  ASSERT_TRUE(writeVolume(volume, folder / "v.mhd", noProgress(), {.compress = false}));
  ASSERT_TRUE(writeVolume(volume, folder / "packed.mha"));
  const std::string pose = "0.8 0.36 0.48 20 0 0.8 -0.6 3 -0.6 0.48 0.64 14 0 0 0 1";
  for (const std::string quality : {"weave", "linear"}) {
    std::vector<std::vector<std::uint8_t>> images;
    for (const bool map : {false, true}) {
      std::vector<std::string> words = {"slice",  folder / "v.mhd", "--pose",    pose,
                                        "--size", "50x40",          "--quality", quality,
                                        "-o",     folder / "o.mha", "--report",  folder / "r.json"};
      if (map) words.emplace_back("--map");
      const auto outcome = run(words);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(readJson(folder / "r.json")["options"]["mapped"], map);
      images.push_back(readImage(folder / "o.mha")->pixels);
    }
    EXPECT_EQ(images[0], images[1]) << quality;
    EXPECT_GT(*std::max_element(images[0].begin(), images[0].end()), 0);
  }
  const auto refused = run({"slice", folder / "packed.mha", "--pose", pose, "--map", "-o", folder / "p.png"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("compressed"), std::string::npos) << refused.err;
}

TEST(SliceCommand, IsZeroOutsideTheVolumeAndSaysWhenThePlaneMissesIt) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(rampVolume({12, 10, 8}), folder / "v.mha"));
  const auto outcome = run({"slice", folder / "v.mha", "--pose", poseAt(12, 500), "--size", "12x10", "--pixel", "1", "-o", folder / "o.png",
                            "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("does not meet the volume"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(" mm; its image is black"), std::string::npos) << outcome.err;
  const auto image = readImage(folder / "o.png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->pixels, std::vector<std::uint8_t>(120, 0));
  EXPECT_EQ(readJson(folder / "r.json")["quality"]["inside_share_min"], 0.0);
}

TEST(SliceCommand, NumbersTheImagesOfSeveralPosesAndReportsEachStep) {
  const TemporaryFolder folder;
  const auto volume = rampVolume({12, 10, 8});
  ASSERT_TRUE(writeVolume(volume, folder / "v.mha"));
  writeText(folder / "poses.txt", "# two planes\n" + poseAt(12, 2) + "\n\n" + poseAt(12, 5) + "\n");
  const auto outcome = run({"slice", folder / "v.mha", "--pose", folder / "poses.txt", "--size", "12x10", "-o", folder / "o.png",
                            "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"o_0000.png", "o_0001.png", "poses.txt", "r.json", "v.mha"}));
  const auto second = readImage(folder / "o_0001.png");
  ASSERT_TRUE(second);
  EXPECT_EQ(viewOf(*second).at(4, 6), volume.echo[volume.grid.indexOf(4, 6, 5)]);
  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["command"], "slice");
  EXPECT_EQ(report["inputs"], nlohmann::json({folder / "v.mha"}));
  EXPECT_EQ(report["outputs"], nlohmann::json({folder / "o_0000.png", folder / "o_0001.png"}));
  EXPECT_EQ(report["options"]["quality"], "linear");
  EXPECT_EQ(report["options"]["pixel_mm"], 1.0) << "by default the smallest spacing";
  std::size_t slices = 0;
  for (const auto& step : report["steps"]) {
    for (const char* key : {"name", "count", "median_us", "p99_us", "max_us"}) EXPECT_TRUE(step.contains(key)) << key;
    if (step["name"] == "slice") slices = step["count"];
  }
  EXPECT_EQ(slices, 2u);
}

TEST(SliceCommand, RepeatRunsTheWholeListAndWritesNothingButTheReport) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(rampVolume({12, 10, 8}), folder / "v.mha"));
  writeText(folder / "poses.txt", poseAt(12, 2) + "\n" + poseAt(12, 5) + "\n");
  const auto outcome = run(
      {"slice", folder / "v.mha", "--pose", folder / "poses.txt", "--repeat", "5", "-o", folder / "o.png", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"poses.txt", "r.json", "v.mha"}));
  const auto report = readJson(folder / "r.json");
  for (const auto& step : report["steps"])
    if (step["name"] == "slice") {
      EXPECT_EQ(step["count"], 10);
    }
}

TEST(SliceCommand, QuietSaysNothing) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(rampVolume({12, 10, 8}), folder / "v.mha"));
  const auto outcome = run({"slice", folder / "v.mha", "--pose", poseAt(12, 500), "-o", folder / "o.png", "--quiet"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
}

TEST(SliceCommand, RefusesPosesThatAreNotRigidAndLeavesNothing) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(rampVolume({4, 4, 4}), folder / "v.mha"));
  for (const std::string pose :
       {"2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "1 0.3 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
        "nan 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2"}) {
    const auto outcome = run({"slice", folder / "v.mha", "--pose", pose, "-o", folder / "o.png", "--report", folder / "r.json"});
    EXPECT_EQ(outcome.status, 1) << pose;
    EXPECT_EQ(outcome.err.rfind("echoweave: ", 0), 0u) << outcome.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"v.mha"}) << pose;
  }
}

TEST(SliceCommand, RefusesAnEmptyVolumeAMissingFileAndAFileThatIsNoVolume) {
  const TemporaryFolder folder;
  const std::string head = "ObjectType = Image\nNDims = 3\nBinaryData = True\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n";
  writeText(folder / "empty.mha", head + "DimSize = 0 4 4\nElementDataFile = LOCAL\n");
  writeText(folder / "huge.mha", head + "DimSize = 10000 10000 10000\nElementDataFile = LOCAL\nabc");
  writeText(folder / "short.mha", head + "DimSize = 10 10 10\nElementDataFile = LOCAL\nabc");
  writeText(folder / "noise.mha", "This is not a volume.");
  for (const std::string name : {"empty.mha", "huge.mha", "short.mha", "noise.mha", "missing.mha"}) {
    const auto before = folder.names();
    const auto outcome = run({"slice", folder / name, "--pose", kIdentityPose, "-o", folder / "o.png"});
    EXPECT_EQ(outcome.status, 1) << name;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.substr(outcome.err.size() - 2), ".\n") << outcome.err;
    EXPECT_EQ(folder.names(), before) << name;
  }
}

TEST(SliceCommand, StopsWhenAskedAndLeavesNothing) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(rampVolume({12, 10, 8}), folder / "v.mha"));
  const std::atomic<bool> cancel{true};
  const auto outcome =
      run({"slice", folder / "v.mha", "--pose", kIdentityPose, "-o", folder / "o.png", "--report", folder / "r.json"}, &cancel);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"v.mha"});
}

TEST(SliceCommand, ChecksItsOutputBeforeItReadsTheVolume) {
  const auto outcome = run({"slice", "no-such-volume.mha", "--pose", kIdentityPose, "-o", "/no/such/folder/o.png"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("/no/such/folder"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace ew::test::slice_test
