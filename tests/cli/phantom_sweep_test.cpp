#include <gtest/gtest.h>

#include "cli/cli_world.h"
#include "ew/core/pose.h"
#include "ew/io/sweep.h"
#include "ew/io/volume_file.h"

namespace ew::test::phantom_sweep_test {
namespace {

/// A ball with a bead in it, and a sweep over it.
class PhantomSweepCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    writeText(folder / "ball.json",
              R"({"format": 1, "name": "ball", "body": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [40, 40, 40]}}})");
    writeText(folder / "patient.json", R"({"format": 1, "name": "ball", "mannequin": "ball.json",
      "box": {"lowest_mm": [-45, -45, -45], "highest_mm": [45, 45, 45]},
      "tissues": [{"name": "even", "echo_level": 100, "speckle": 1}, {"name": "bright", "echo_level": 200, "speckle": 1}],
      "background": "even",
      "organs": [{"name": "bead", "tissue": "bright", "shape": {"ellipsoid": {"centre_mm": [0, -28, 0], "radii_mm": [3, 3, 3]}}}]})");
    writeText(folder / "sweep.json", sweep("5"));
    inputs = folder.names();
  }
  static std::string sweep(const std::string& frames, const std::string& probe = "linear-12") {
    return R"({"format": 1, "name": "a pass over the bead", "probe": ")" + probe + R"(", "kind": "parallel", "frames": )" + frames +
           R"(, "machine": {"depth_mm": 25}, "stations": [{"near_mm": [0, -45, -4], "towards_mm": [0, 0, -4]}], "extent_mm": 8, "pixel_mm": 0.2,
             "tracker": {"drop_out_share": 0.2}})";
  }
  Outcome record(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"phantom", folder / "patient.json", "--sweep", folder / "sweep.json", "-o", folder / "s.igs.mha"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  TemporaryFolder folder;
  std::vector<std::string> inputs;
};

TEST_F(PhantomSweepCommand, RecordsASweepThatReconstructsAsItIsAndWithItsDeviceSet) {
  const auto outcome =
      record({"--truth-poses", folder / "poses.txt", "--device-set", folder / "s.xml", "--report", folder / "r.json", "--threads", "1"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("5 frames"), std::string::npos) << outcome.out;
  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["quality"]["frames"], 5);
  EXPECT_EQ(report["quality"]["frames_invalid"], 1);
  EXPECT_EQ(report["outputs"].size(), 3u);
  EXPECT_EQ(report["steps"][0]["name"], "record");

  const auto sequence = readSequence(folder / "s.igs.mha");
  ASSERT_TRUE(sequence) << sequence.error();
  const auto truth = posesFromArgument(folder / "poses.txt");
  ASSERT_TRUE(truth) << truth.error();
  ASSERT_EQ(truth->size(), 5u);
  for (std::size_t n = 0; n < 5; ++n) {
    const auto& written = sequence->frames[n].transforms.front();
    if (written.status == PoseStatus::ok) {
      EXPECT_EQ(written.matrix, (*truth)[n].probeToWorld.matrix) << n;
    }
  }

  const auto reconstruct = [&](const std::string& volume, const std::vector<std::string>& more) {
    std::vector<std::string> words{"reconstruct", folder / "s.igs.mha", "-o", folder / volume, "--spacing", "0.5"};
    words.insert(words.end(), more.begin(), more.end());
    const auto made = run(words);
    EXPECT_EQ(made.status, 0) << made.err;
    return readVolume(folder / volume);
  };
  const auto whole = reconstruct("whole.mha", {"--no-clip"}), clipped = reconstruct("clipped.mha", {"--calibration", folder / "s.xml"});
  const auto itself = reconstruct("itself.mha", {});
  ASSERT_TRUE(whole && clipped && itself);
  EXPECT_LT(clipped->volume.grid.voxelCount(), whole->volume.grid.voxelCount()) << "the device set clips to the image";
  EXPECT_TRUE(itself->volume == clipped->volume) << "the recording states the same clip as its device set";
  // The bead is brighter than what surrounds it, where it is in truth.
  const auto levelAt = [&](const glm::dvec3& p_world) {
    const auto& grid = clipped->volume.grid;
    const glm::ivec3 centre(glm::round((inverse(grid.voxelToWorld()) * Point<frame::World>{p_world}).at));
    double sum = 0.0;
    int count = 0;
    for (int k = -1; k <= 1; ++k)
      for (int j = -3; j <= 3; ++j)
        for (int i = -3; i <= 3; ++i, ++count) sum += clipped->volume.echo[grid.indexOf(centre.x + i, centre.y + j, centre.z + k)];
    return sum / count;
  };
  EXPECT_GT(levelAt({0, -28, 0}), levelAt({12, -28, 0}) + 20.0);
}

TEST_F(PhantomSweepCommand, MakesTheSameFileOnEveryNumberOfThreads) {
  ASSERT_EQ(record({"--threads", "1"}).status, 0);
  const std::string one = readText(folder / "s.igs.mha");
  ASSERT_EQ(record({"--threads", "3"}).status, 0);
  EXPECT_EQ(readText(folder / "s.igs.mha"), one);
}

TEST_F(PhantomSweepCommand, SaysWhatIsWrongAndLeavesNothing) {
  const auto refused = [&](const Outcome& outcome, int status, const std::string& part) {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.names(), inputs);
  };
  refused(run({"phantom", folder / "patient.json", "-o", folder / "s.igs.mha"}), 2, "--sweep");
  refused(run({"phantom", folder / "patient.json", "--sweep", folder / "sweep.json"}), 2, "-o");
  refused(run({"phantom", folder / "patient.json"}), 2, "--volume");
  refused(record({"--device-set", folder / "s.txt"}), 2, ".xml");
  writeText(folder / "sweep.json", sweep("5", "linear-99"));
  refused(record(), 1, "linear-99");
  writeText(folder / "sweep.json", sweep("-1"));
  refused(record(), 1, "frames");
  writeText(folder / "sweep.json", sweep("20000", "linear-12"));
  const std::atomic<bool> cancel{true};
  const auto stopped = run({"phantom", folder / "patient.json", "--sweep", folder / "sweep.json", "-o", folder / "s.igs.mha"}, &cancel);
  EXPECT_EQ(stopped.status, 1);
  EXPECT_EQ(folder.names(), inputs);
}

}  // namespace
}  // namespace ew::test::phantom_sweep_test
