#include <gtest/gtest.h>

#include <cmath>

#include "cli/cli_world.h"
#include "ew/core/numbers.h"
#include "ew/io/gating_fields.h"
#include "ew/io/volume_file.h"

namespace ew::test::reconstruct_phases_test {
namespace {

Outcome reconstruct(const TemporaryFolder& folder, const Sequence& sweep, std::vector<std::string> more) {
  EXPECT_TRUE(writeSequence(sweep, folder / "s.igs.mha"));
  std::vector<std::string> words{"reconstruct", folder / "s.igs.mha", "-o", folder / "v.mha", "--spacing", "1"};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

TEST(ReconstructMotor, AParallelMotorGivesWhatATrackerGave) {
  const TemporaryFolder folder;
  Sequence sweep = parallelSweep(8, 6, 5);
  ASSERT_EQ(reconstruct(folder, sweep, {}).status, 0);
  const auto tracked = readVolume(folder / "v.mha");
  for (auto& frame : sweep.frames) frame.transforms.clear();
  const auto untracked = reconstruct(folder, sweep, {});
  EXPECT_EQ(untracked.status, 1) << "no pose at all";
  writeText(folder / "motor.json", R"({"format": 1, "kind": "parallel", "step_mm": 1, "image": {"pixel_mm": [1, 1], "face_px": [0, 0]}})");
  const auto outcome = reconstruct(folder, sweep, {"--motor", folder / "motor.json", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto moved = readVolume(folder / "v.mha");
  ASSERT_TRUE(tracked && moved);
  EXPECT_EQ(moved->volume.echo, tracked->volume.echo);
  EXPECT_EQ(moved->volume.grid, tracked->volume.grid);
  EXPECT_EQ(readJson(folder / "r.json")["inputs"], nlohmann::json({folder / "s.igs.mha", folder / "motor.json"}));
  writeText(folder / "motor.json", R"({"format": 1, "kind": "parallel"})");
  const auto refused = reconstruct(folder, sweep, {"--motor", folder / "motor.json"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("'step_mm'"), std::string::npos) << refused.err;
  EXPECT_EQ(reconstruct(folder, sweep, {"--motor", "recorded"}).status, 1);
}

/// 200 frames in two seconds, with an R peak every half of one.
Sequence beating() {
  Sequence sweep = parallelSweep(4, 3, 200);
  for (int n = 0; n < 200; ++n) {
    auto& frame = sweep.frames[static_cast<std::size_t>(n)];
    frame.time_s = 0.01 * n;
    double mv = 0.0;
    for (const double beat_s : {0.255, 0.755, 1.255, 1.755}) mv += std::exp(-0.5 * std::pow((0.01 * n - beat_s) / 0.011, 2.0));
    frame.otherFields = {{std::string(fields::kEcg), textOf(mv)}};
  }
  return sweep;
}

TEST(ReconstructPhases, WritesANumberedVolumeForEachPhaseOnOneGrid) {
  const TemporaryFolder folder;
  const auto outcome = reconstruct(folder, beating(), {"--phases", "2", "--coverage", folder / "c.mha", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto first = readVolume(folder / "c_0000.mha"), second = readVolume(folder / "c_0001.mha");
  ASSERT_TRUE(first && second && readVolume(folder / "v_0000.mha") && readVolume(folder / "v_0001.mha"));
  ASSERT_EQ(first->volume.grid.dims, glm::ivec3(4, 3, 200));
  EXPECT_EQ(first->volume.grid, second->volume.grid);
  for (int n = 0; n < 200; ++n) {
    const double since = (0.01 * n - 0.255) / 0.5, phase = since - std::floor(since);
    if (std::abs(phase) < 0.03 || std::abs(phase - 0.5) < 0.03 || phase > 0.97) continue;  // R peaks are timed to a few milliseconds
    const bool gated = n > 25 && n < 176;
    const std::size_t index = first->volume.grid.indexOf(1, 1, n);
    EXPECT_EQ(first->volume.echo[index] != 0, gated && phase < 0.5) << n;
    EXPECT_EQ(second->volume.echo[index] != 0, gated && phase > 0.5) << n;
  }
  const auto report = readJson(folder / "r.json");
  EXPECT_NEAR(report["quality"]["rate_per_min"].get<double>(), 120.0, 0.5);
  EXPECT_EQ(report["gated_by"], "ecg");
  EXPECT_EQ(report["outputs"].size(), 4u);
}

TEST(ReconstructPhases, SayWhyTheyCannotBeMadeAndLeaveNoFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(reconstruct(folder, beating(), {"--gate", "ecg"}).status, 2) << "without --phases";
  EXPECT_EQ(reconstruct(folder, beating(), {"--phases", "0"}).status, 2);
  const auto many = reconstruct(folder, beating(), {"--phases", "500"});
  EXPECT_EQ(many.status, 1);
  EXPECT_NE(many.err.find("500 phases cannot be made"), std::string::npos) << many.err;
  const auto breath = reconstruct(folder, beating(), {"--phases", "2", "--gate", "respiration"});
  EXPECT_EQ(breath.status, 1);
  EXPECT_NE(breath.err.find("RespirationShare"), std::string::npos) << breath.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"s.igs.mha"});
}

TEST(ReconstructTimeOffset, MovesThePosesOrSaysThatItCannotTell) {
  const TemporaryFolder folder;
  const Sequence sweep = parallelSweep(8, 6, 40);
  const auto moved = reconstruct(folder, sweep, {"--time-offset", "0.05", "--report", folder / "r.json"});
  ASSERT_EQ(moved.status, 0) << moved.err;
  const auto volume = readVolume(folder / "v.mha");
  ASSERT_TRUE(volume);
  EXPECT_NEAR(volume->volume.grid.origin_mm.z, 0.5, 1e-9) << "10 mm/s, half a frame later";
  EXPECT_EQ(readJson(folder / "r.json")["quality"]["frames_used"], 39) << "after the last frame there is no pose";
  EXPECT_EQ(readJson(folder / "r.json")["pose_delay"]["delay_s"], 0.05);
  const TemporaryFolder other;
  const auto even = reconstruct(other, sweep, {"--time-offset", "estimate"});
  EXPECT_EQ(even.status, 3) << even.err;
  EXPECT_NE((even.out + even.err).find("cannot be told"), std::string::npos) << even.out << even.err;
  EXPECT_EQ(other.names(), std::vector<std::string>{"s.igs.mha"});
  EXPECT_EQ(reconstruct(other, sweep, {"--time-offset", "soon"}).status, 2);
}

}  // namespace
}  // namespace ew::test::reconstruct_phases_test
