#include <gtest/gtest.h>

#include "ew/phantom/virtual_sweep.h"
#include "phantom/sweeps.h"
#include "scanner/record_sweep.h"

namespace ew::phantom_sweep_test {
namespace {

using testing::ballPatient;
using testing::bodyRecipe;
using testing::Folder;
using testing::shippedProbe;
using testing::ThreadScanner;

SweepRecipe handSweep(std::vector<SweepRecipe::Station> stations) {
  SweepRecipe recipe;
  recipe.frames = 5;
  recipe.formation.depth_mm = 60.0;
  recipe.pixel_mm = 1.0;
  recipe.stations = std::move(stations);
  return recipe;
}

Probe few(const std::string& id) {
  Probe probe = shippedProbe(id);
  probe.lines = 16;
  return probe;
}

Result<VirtualSweep> record(const Patient& patient, const Probe& probe, const SweepRecipe& recipe) {
  const ThreadScanner scanner(probe, recipe.formation.depth_mm, {{{0, -30, 0}, {0, 0, 1}}});
  return phantom::recordWith(scanner, patient, recipe, 2, noProgress(), 1ull << 30);
}

void expectRigid(const Result<VirtualSweep>& sweep) {
  ASSERT_TRUE(sweep) << sweep.error();
  for (const auto& pose : sweep->trueProbeToWorld) EXPECT_TRUE(checkRigid(pose.matrix, 1e-9)) << pose;
}

TEST(HardSweeps, AStationFarFromTheSkinIsRefusedByItsNumber) {
  const auto sweep = record(*ballPatient(), few("convex-3.5"), handSweep({{.near_mm = {0, -60, 0}}, {.near_mm = {0, -200, 0}}}));
  ASSERT_FALSE(sweep);
  EXPECT_EQ(sweep.error().code, ErrorCode::badField);
  EXPECT_NE(sweep.error().sentence().find("stations[1]"), std::string::npos) << sweep.error();
}

TEST(HardSweeps, AStationInTheMiddleOfTheBodyComesOutOrIsRefused) {
  const auto sweep = record(*ballPatient(), few("convex-3.5"), handSweep({{.near_mm = {0, 0, 0}}}));
  if (!sweep) {
    EXPECT_EQ(sweep.error().code, ErrorCode::badField);
    return;
  }
  expectRigid(sweep);
}

TEST(HardSweeps, EqualStationsHoldTheProbeStill) {
  const SweepRecipe::Station station{.near_mm = {0, -60, 0}};
  for (const std::size_t count : {2u, 5u}) {
    const auto sweep = record(*ballPatient(), few("convex-3.5"), handSweep(std::vector(count, station)));
    expectRigid(sweep);
    for (const auto& pose : sweep->trueProbeToWorld) EXPECT_LT(glm::distance(pose.matrix[3], sweep->trueProbeToWorld[0].matrix[3]), 1e-6);
  }
}

TEST(HardSweeps, EqualStationsOnTheWayAreOnePlace) {
  const auto sweep =
      record(*ballPatient(), few("convex-3.5"),
             handSweep({{.near_mm = {-10, -60, 0}}, {.near_mm = {0, -60, 0}}, {.near_mm = {0, -60, 0}}, {.near_mm = {10, -60, 0}}}));
  expectRigid(sweep);
  for (std::size_t n = 1; n < 5; ++n) {
    const double way = glm::distance(sweep->trueProbeToWorld[n - 1].matrix[3], sweep->trueProbeToWorld[n].matrix[3]);
    EXPECT_GT(way, 2.0);
    EXPECT_LT(way, 8.0);
  }
}

TEST(HardSweeps, OneFrameIsTakenAtTheBeginningOfThePath) {
  for (const auto kind : {SweepKind::freehand, SweepKind::parallel, SweepKind::fan, SweepKind::rotational}) {
    auto recipe = handSweep({{.near_mm = {0, -60, 0}}});
    recipe.kind = kind;
    recipe.frames = 1;
    recipe.extent_mm = kind == SweepKind::parallel ? 20 : 0;
    recipe.extent_deg = kind == SweepKind::fan || kind == SweepKind::rotational ? 40 : 0;
    const auto sweep = record(*ballPatient(), few("linear-7.5"), recipe);
    expectRigid(sweep);
    EXPECT_EQ(sweep->sequence.frames.size(), 1u);
  }
}

TEST(HardSweeps, AMotorThatGoesNowhereTakesTheSameImageAgain) {
  // Files cannot say so, callers can.
  auto recipe = handSweep({{.near_mm = {0, -60, 0}}});
  recipe.kind = SweepKind::parallel;
  const auto sweep = record(*ballPatient(), few("linear-7.5"), recipe);
  expectRigid(sweep);
  const auto first = sweep->sequence.framePixels(0), last = sweep->sequence.framePixels(4);
  EXPECT_TRUE(std::equal(first.begin(), first.end(), last.begin()));
}

TEST(HardSweeps, AProbeWiderThanTheBodyTouchesWithItsMiddle) {
  const Folder folder;
  folder.write("finger.json",
               bodyRecipe(R"({"capsule": {"from_mm": [0, 0, -40], "to_mm": [0, 0, 40], "from_radius_mm": 8, "to_radius_mm": 8}})"));
  const auto finger = readPatient(folder.write("patient.json", R"({"format": 1, "name": "finger", "mannequin": "finger.json",
    "box": {"lowest_mm": [-12, -12, -50], "highest_mm": [12, 12, 50]}, "tissues": [{"name": "even", "echo_level": 100, "speckle": 1}],
    "background": "even",
    "organs": [{"name": "bone", "tissue": "even", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [2, 2, 30]}}}]})"));
  ASSERT_TRUE(finger) << finger.error();
  for (const char* id : {"linear-7.5", "convex-3.5"}) {
    auto recipe = handSweep({{.near_mm = {0, -9, 0}}});
    recipe.indentation_mm = 2.0;
    const auto sweep = record(**finger, few(id), recipe);
    expectRigid(sweep);
    EXPECT_NEAR(sweep->trueProbeToWorld[0].matrix[3].y, -6.0, 0.3) << "on the skin at -8, pressed in by 2";
  }
}

TEST(HardSweeps, EveryPoseLostIsARecordingWithoutPoses) {
  auto recipe = handSweep({{.near_mm = {0, -60, 0}}});
  recipe.tracker.dropOutShare = 1.0;
  const auto sweep = record(*ballPatient(), few("linear-7.5"), recipe);
  expectRigid(sweep);
  for (const auto& frame : sweep->sequence.frames) EXPECT_EQ(frame.transforms.front().status, PoseStatus::invalid);
}

TEST(HardSweeps, TurningTheImageAroundBetweenTwoStationsIsRefused) {
  const auto sweep =
      record(*ballPatient(), few("linear-7.5"), handSweep({{.near_mm = {0, -60, 0}}, {.near_mm = {5, -60, 0}, .lateral = {-1, 0, 0}}}));
  ASSERT_FALSE(sweep);
  EXPECT_NE(sweep.error().sentence().find("stations[1]"), std::string::npos);
}

}  // namespace
}  // namespace ew::phantom_sweep_test
