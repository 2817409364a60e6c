#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "ew/acquisition/motor_sweep.h"
#include "ew/acquisition/reconstruct.h"
#include "ew/core/numbers.h"
#include "ew/io/gating_fields.h"
#include "ew/io/sweep.h"
#include "scanner/record_sweep.h"
#include "sweeps.h"

namespace ew::sweep_volume_test {
namespace {

using testing::ballPatient;
using testing::shippedProbe;
using testing::Thread;
using testing::ThreadScanner;

constexpr double kVoxel_mm = 0.5;

// Beads near the central beam of a probe at the top of the ball, where every motor passes.
const std::vector<Thread> kBeads = {{{-7, -32, -5}}, {{6, -24, 6}}, {{1, -40, 2}}, {{-2, -18, 1}}, {{8, -36, -1}}};

SweepRecipe sweepOf(SweepKind kind) {
  SweepRecipe recipe;
  recipe.kind = kind;
  recipe.formation.depth_mm = 55.0;
  recipe.pixel_mm = 0.3;
  recipe.stations = {{.near_mm = {0, -60, 0}, .towards_mm = glm::dvec3(0)}};
  switch (kind) {
    case SweepKind::freehand:
      recipe.frames = 81;
      recipe.stations = {
          {.near_mm = {0, -57, -24}}, {.near_mm = {1, -60, 0}, .lateral = {1, 0, 0.1}}, {.near_mm = {0, -57, 24}, .lateral = {1, 0, -0.1}}};
      recipe.unevenness = 0.3;
      break;
    case SweepKind::parallel:
      recipe.frames = 57;
      recipe.stations[0] = {.near_mm = {0, -60, -14}, .towards_mm = glm::dvec3(0, 0, -14)};
      recipe.extent_mm = 28.0;
      break;
    case SweepKind::fan:
      recipe.frames = 81;
      recipe.extent_deg = 50.0;
      recipe.axisBehindFace_mm = 8.0;
      break;
    case SweepKind::rotational:
      recipe.frames = 121;
      recipe.extent_deg = 178.5;
      break;
  }
  return recipe;
}

Clip clipOf(const DeviceSet& set) {
  Clip clip{.origin_px = *set.clipOrigin_px, .size_px = *set.clipSize_px};
  if (set.fanOrigin_px) {
    const glm::dvec2 angles = *set.fanAngles_deg * std::numbers::pi / 180.0;
    clip.fan = ClipFan{*set.fanOrigin_px, angles.x, angles.y, *set.fanRadiusStart_px, *set.fanRadiusStop_px};
  }
  return clip;
}

struct Found {
  double worst_mm = 0.0;  ///< distance between a bead and the centre of gravity of what is seen of it
  int beads = 0;
};

Found findBeads(const Volume& volume, const std::vector<Thread>& beads) {
  Found found;
  const auto worldToVoxel = inverse(volume.grid.voxelToWorld());
  for (const Thread& bead : beads) {
    const glm::ivec3 centre(glm::round((worldToVoxel * Point<frame::World>{bead.at_mm}).at));
    const int reach = 5;
    if (glm::any(glm::lessThan(centre, glm::ivec3(reach))) || glm::any(glm::greaterThanEqual(centre, volume.grid.dims - reach))) continue;
    double sum = 0.0;
    glm::dvec3 mean(0.0);
    for (int k = -reach; k <= reach; ++k)
      for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
          const glm::ivec3 at = centre + glm::ivec3(i, j, k);
          const double level = volume.echo[volume.grid.indexOf(at.x, at.y, at.z)];
          const double weight = level > 0.0 ? std::pow(10.0, (level - 255.0) / 255.0 * 3.0) : 0.0;
          sum += weight;
          mean += weight * glm::dvec3(at);
        }
    if (sum < 5.0) continue;
    ++found.beads;
    found.worst_mm = std::max(found.worst_mm, glm::distance((volume.grid.voxelToWorld() * Point<frame::Voxel>{mean / sum}).at, bead.at_mm));
  }
  return found;
}

Volume volumeOf(const VirtualSweep& sweep, const SweepPoses& poses) {
  std::vector<TrackedFrame> frames;
  const Sequence& sequence = sweep.sequence;
  for (std::size_t n = 0; n < poses.imageToWorld.size(); ++n)
    if (poses.imageToWorld[n])
      frames.push_back({{sequence.framePixels(n).data(), sequence.width, sequence.height, sequence.width}, *poses.imageToWorld[n]});
  auto made = reconstruct(frames, {.spacing_mm = kVoxel_mm, .fillReach_mm = 1.5, .clip = clipOf(sweep.deviceSet)}, noProgress());
  if (!made) {
    ADD_FAILURE() << made.error();
    return {};
  }
  return std::move(made->volume);
}

VirtualSweep recorded(const std::string& id, const SweepRecipe& recipe) {
  static const auto patient = ballPatient();
  Probe probe = shippedProbe(id);
  probe.lines = 96;
  const ThreadScanner scanner(probe, std::max(recipe.formation.depth_mm, probe.minDepth_mm), kBeads, 0.7);
  auto exact = recipe;
  exact.formation.depth_mm = scanner.options().depth_mm;
  auto sweep = phantom::recordWith(scanner, *patient, exact, 0, noProgress(), 1ull << 30);
  if (!sweep) {
    ADD_FAILURE() << sweep.error();
    std::abort();
  }
  return *std::move(sweep);
}

class SweptVolume : public ::testing::TestWithParam<SweepKind> {};

TEST_P(SweptVolume, HasBeadsWhereTheyAreWithinHalfAVoxel) {
  for (const char* id : {"linear-7.5", "convex-3.5"}) {
    const auto sweep = recorded(id, sweepOf(GetParam()));
    const auto poses = sweepPoses(sweep.sequence);
    ASSERT_TRUE(poses) << poses.error();
    const Found found = findBeads(volumeOf(sweep, *poses), kBeads);
    EXPECT_EQ(found.beads, 5) << id;
    EXPECT_LT(found.worst_mm, 0.5 * kVoxel_mm) << id;
    RecordProperty(std::string(id) + "_worst_um", static_cast<int>(1000 * found.worst_mm));
  }
}

class MotorVolume : public SweptVolume {};

TEST_P(MotorVolume, IsTheSameFromWhatTheMotorSays) {
  // The tracker saw nothing of use; the motor knew where it stood.
  auto recipe = sweepOf(GetParam());
  const auto good = recorded("convex-3.5", recipe);
  recipe.tracker.noise_mm = 5.0;
  const auto sweep = recorded("convex-3.5", recipe);
  const auto motor = recordedMotor(sweep.sequence);
  ASSERT_TRUE(motor) << motor.error();
  const auto poses = motorPoses(sweep.sequence, *motor, &sweep.deviceSet);
  ASSERT_TRUE(poses) << poses.error();
  for (std::size_t n = 0; n < poses->imageToWorld.size(); ++n) {
    const glm::dmat4 truth = good.trueProbeToWorld[n].matrix * good.imageToProbe;
    for (int column = 0; column < 4; ++column) EXPECT_LT(glm::distance(poses->imageToWorld[n]->matrix[column], truth[column]), 1e-9) << n;
  }
  const Found found = findBeads(volumeOf(sweep, *poses), kBeads);
  EXPECT_EQ(found.beads, 5);
  EXPECT_LT(found.worst_mm, 0.5 * kVoxel_mm);
}

std::string nameOfKind(const ::testing::TestParamInfo<SweepKind>& info) {
  constexpr std::array<const char*, 4> names{"Freehand", "Parallel", "Fan", "Rotational"};
  return names[static_cast<std::size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Kinds, SweptVolume,
                         ::testing::Values(SweepKind::freehand, SweepKind::parallel, SweepKind::fan, SweepKind::rotational), nameOfKind);
INSTANTIATE_TEST_SUITE_P(Kinds, MotorVolume, ::testing::Values(SweepKind::parallel, SweepKind::fan, SweepKind::rotational), nameOfKind);

TEST(SweptVolumeOfALivingBody, CarriesItsSignalsAndMovesWithThem) {
  const auto patient = ballPatient(R"("motion": {"breathing": {"period_s": 2, "pause": 0, "displacement_mm": [0, 0, -6], "held_depth_mm": 5,
    "free_depth_mm": 20, "free_distance_mm": 5}}, )");
  ASSERT_TRUE(moves(*patient));
  Probe probe = shippedProbe("linear-7.5");
  const ThreadScanner scanner(probe, 55.0, {{{0, -25, 0}, {1, 0, 0}}}, 0.7);
  auto recipe = sweepOf(SweepKind::freehand);
  recipe.frames = 21;
  recipe.framesPerSecond = 10.0;
  // Across the thread's way, held still: the thread wanders through the image.
  recipe.stations = {{.near_mm = {0, -60, 0}, .lateral = {0, 0, 1}, .towards_mm = glm::dvec3(0)}};
  recipe.unevenness = 0.0;
  recipe.breathing = recipe.respiration = recipe.ecg = true;
  const auto sweep = phantom::recordWith(scanner, *patient, recipe, 0, noProgress(), 1ull << 30);
  ASSERT_TRUE(sweep) << sweep.error();
  for (std::size_t n = 0; n < 21; ++n) {
    const double time_s = static_cast<double>(n) / 10.0;
    std::map<std::string, std::string> other(sweep->sequence.frames[n].otherFields.begin(), sweep->sequence.frames[n].otherFields.end());
    EXPECT_EQ(parseNumber(other[std::string(fields::kRespiration)]), stateAt(*patient, time_s).breath);
    EXPECT_EQ(parseNumber(other[std::string(fields::kEcg)]), ecgAt_mv(*patient, time_s));
    EXPECT_EQ(sweep->trueState[n].breath, stateAt(*patient, time_s).breath);
    EXPECT_EQ(sweep->trueState[n].pulse, 0.0) << "not asked for";
    // The brightest pixel lies where the motion has taken the thread.
    const auto body = bodyMotion(*patient, sweep->trueState[n]);
    const glm::dvec3 expected = body->moved({0, -25, 0});
    const auto pixels = sweep->sequence.framePixels(n);
    const auto best = static_cast<int>(std::max_element(pixels.begin(), pixels.end()) - pixels.begin());
    const glm::dvec3 seen = sweep->trueProbeToWorld[n].matrix * sweep->imageToProbe *
                            glm::dvec4(best % sweep->sequence.width, best / sweep->sequence.width, 0, 1);
    EXPECT_LT(glm::distance(seen, expected), 0.5) << n;
  }
}

}  // namespace
}  // namespace ew::sweep_volume_test
