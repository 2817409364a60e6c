#include "ew/imaging/beam_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "imaging/support/probes_at_random.h"

namespace ew::beam_grid_test {
namespace {

constexpr double kDegree_rad = std::numbers::pi / 180.0;

glm::dvec2 pointOn(const BeamGrid& grid, std::size_t line, double depth_mm) {
  return grid.lines[line].origin_mm + depth_mm * grid.lines[line].direction;
}

RC_GTEST_PROP(BeamGrid, IsInvertedInClosedFormForEveryKindOfProbe, ()) {
  const auto [probe, knobs] = *testing::probeAtRandom();
  const double depth_mm = testing::numberBetween(5.0, 400.0);
  const BeamGrid grid = makeBeamGrid(probe, knobs, depth_mm, testing::numberBetween(0.1, 2.0));
  const auto line = *rc::gen::inRange<std::size_t>(0, grid.lines.size());
  // At depth 0 all lines of a phased array are in one point.
  const int sample = *rc::gen::inRange(probe.radius_mm > 0.0 || !isSector(probe.kind) ? 0 : 1, grid.samples);
  const glm::dvec2 found = lineAndSampleAt(probe, knobs, grid, pointOn(grid, line, grid.depth_mm(sample)));
  RC_ASSERT(std::abs(found.x - static_cast<double>(line)) < 1e-9 * static_cast<double>(grid.lines.size()));
  RC_ASSERT(std::abs(found.y - sample) < 1e-9 * std::max(1, sample));
}

RC_GTEST_PROP(BeamGrid, OfOneDirectionOfACompoundImageIsInvertedInClosedForm, ()) {
  const auto [probe, knobs] = *testing::probeAtRandom();
  RC_PRE(!isSector(probe.kind) || probe.radius_mm > 1.0);
  RC_PRE(!knobs.trapezoid || isSector(probe.kind));
  const double look_rad = testing::numberBetween(-0.2, 0.2), depth_mm = testing::numberBetween(5.0, 300.0);
  const BeamGrid grid = makeBeamGrid(probe, knobs, depth_mm, testing::numberBetween(0.1, 2.0), look_rad);
  const auto line = *rc::gen::inRange<std::size_t>(0, grid.lines.size());
  const int sample = *rc::gen::inRange(0, grid.samples);
  const glm::dvec2 found = lineAndSampleAt(probe, knobs, grid, pointOn(grid, line, grid.depth_mm(sample)), look_rad);
  RC_ASSERT(std::abs(found.x - static_cast<double>(line)) < 1e-8 * static_cast<double>(grid.lines.size()));
  RC_ASSERT(std::abs(found.y - sample) < 1e-8 * std::max(1, grid.samples));
  // Each line leaves the face where it does without, at that angle.
  const BeamGrid straight = makeBeamGrid(probe, knobs, depth_mm, grid.sampleSpacing_mm);
  RC_ASSERT(grid.lines[line].origin_mm == straight.lines[line].origin_mm);
  const double angle_rad = std::atan2(grid.lines[line].direction.x, grid.lines[line].direction.y) -
                           std::atan2(straight.lines[line].direction.x, straight.lines[line].direction.y);
  RC_ASSERT(std::abs(angle_rad - look_rad) < 1e-12);
}

RC_GTEST_PROP(BeamGrid, EndsAtItsDepthAndIsNotCoarserThanAsked, ()) {
  const auto [probe, knobs] = *testing::probeAtRandom();
  const double depth_mm = testing::numberBetween(1.0, 400.0), spacing_mm = testing::numberBetween(0.05, 500.0);
  const BeamGrid grid = makeBeamGrid(probe, knobs, depth_mm, spacing_mm);
  RC_ASSERT(grid.lines.size() == static_cast<std::size_t>(probe.lines));
  RC_ASSERT(grid.samples >= 2);
  RC_ASSERT(std::abs(grid.depth_mm(grid.samples - 1) - depth_mm) < 1e-12 * depth_mm);
  RC_ASSERT(grid.sampleSpacing_mm <= spacing_mm * (1.0 + 1e-9));
  RC_ASSERT(grid.samples == 2 || grid.sampleSpacing_mm > 0.5 * spacing_mm);
  for (const BeamGrid::Line& line : grid.lines) RC_ASSERT(std::abs(glm::length(line.direction) - 1.0) < 1e-14);
}

RC_GTEST_PROP(BeamGrid, IsItsOwnMirrorImageToTheBitUnlessSteered, ()) {
  auto [probe, knobs] = *testing::probeAtRandom();
  const double steering_rad = knobs.steering_rad;
  const BeamGrid grid = makeBeamGrid(probe, knobs, 100.0, 0.3);
  knobs.steering_rad = -steering_rad;
  const BeamGrid other = makeBeamGrid(probe, knobs, 100.0, 0.3);
  for (std::size_t n = 0; n < grid.lines.size(); ++n) {
    const BeamGrid::Line& line = grid.lines[n];
    const BeamGrid::Line& mirrored = other.lines[grid.lines.size() - 1 - n];
    RC_ASSERT(line.origin_mm == glm::dvec2(-mirrored.origin_mm.x, mirrored.origin_mm.y));
    RC_ASSERT(line.direction == glm::dvec2(-mirrored.direction.x, mirrored.direction.y));
  }
}

RC_GTEST_PROP(BeamGrid, SpacingOfLinesIsTheDistanceToTheNextLine, ()) {
  const auto [probe, knobs] = *testing::probeAtRandom();
  const double depth_mm = testing::numberBetween(0.0, 200.0);
  const BeamGrid grid = makeBeamGrid(probe, knobs, 200.0, 0.5);
  const std::size_t middle = grid.lines.size() / 2;
  const glm::dvec2 p_mm = pointOn(grid, middle, depth_mm);
  // Foot of the perpendicular on the next line, searched for.
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (double at_mm = -50.0; at_mm <= 260.0; at_mm += 0.25)
    nearest_mm = std::min(nearest_mm, glm::distance(p_mm, pointOn(grid, middle - 1, at_mm)));
  const double angle_rad = std::acos(std::min(1.0, glm::dot(grid.lines[middle].direction, grid.lines[middle - 1].direction)));
  if (angle_rad < 0.02) RC_ASSERT(std::abs(grid.lineSpacing_mm(depth_mm) - nearest_mm) < 0.2 + 0.01 * nearest_mm);
}

TEST(BeamGrid, OfALinearProbeSteersAllLinesByTheSameAngle) {
  Probe probe;
  probe.maxSteering_rad = 20.0 * kDegree_rad;
  const BeamGrid grid = makeBeamGrid(probe, {.steering_rad = 15.0 * kDegree_rad}, 60.0, 0.2);
  for (const BeamGrid::Line& line : grid.lines) EXPECT_NEAR(std::atan2(line.direction.x, line.direction.y), 15.0 * kDegree_rad, 1e-14);
  EXPECT_EQ(grid.lines.front().origin_mm, glm::dvec2(-20.0, 0.0));
  EXPECT_EQ(grid.lines.back().origin_mm, glm::dvec2(20.0, 0.0));
  EXPECT_NEAR(grid.lineSpacing_mm(30.0), 40.0 / 127.0 * std::cos(15.0 * kDegree_rad), 1e-12);
  EXPECT_EQ(makeBeamGrid(probe, {.steering_rad = 1.0}, 60.0, 0.2), makeBeamGrid(probe, {.steering_rad = 20.0 * kDegree_rad}, 60.0, 0.2));
  EXPECT_EQ(makeBeamGrid(probe, {.steering_rad = std::nan("")}, 60.0, 0.2), makeBeamGrid(probe, {}, 60.0, 0.2));
}

TEST(BeamGrid, OfATrapezoidFansOutFromAnEvenFace) {
  Probe probe;
  probe.trapezoidHalfAngle_rad = 12.0 * kDegree_rad;
  const BeamGrid grid = makeBeamGrid(probe, {.trapezoid = true}, 60.0, 0.2);
  EXPECT_NEAR(std::atan2(grid.lines.back().direction.x, grid.lines.back().direction.y), 12.0 * kDegree_rad, 1e-14);
  EXPECT_NEAR(grid.lines[1].origin_mm.x - grid.lines[0].origin_mm.x, 40.0 / 127.0, 1e-12);
  // All lines meet in the apex.
  for (const BeamGrid::Line& line : grid.lines)
    EXPECT_NEAR(line.origin_mm.x / line.direction.x * line.direction.y, 20.0 / std::tan(12.0 * kDegree_rad), 1e-9);
}

TEST(BeamGrid, OfASectorIsEvenInAngleAndItsLinesPartAsArcs) {
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 60.0;
  probe.halfAngle_rad = 0.5;
  probe.lines = 101;
  const BeamGrid grid = makeBeamGrid(probe, {}, 150.0, 0.25);
  EXPECT_EQ(grid.lines[50].origin_mm, glm::dvec2(0.0));
  EXPECT_EQ(grid.lines[50].direction, glm::dvec2(0.0, 1.0));
  for (std::size_t n = 0; n < 101; ++n)
    EXPECT_NEAR(std::atan2(grid.lines[n].direction.x, grid.lines[n].direction.y), -0.5 + 0.01 * static_cast<double>(n), 1e-12);
  EXPECT_NEAR(grid.lineSpacing_mm(90.0), 150.0 * 0.01, 1e-4);
}

TEST(BeamGrid, RowsOfStartOnTheFaceAndEndAtTheDepth) {
  const auto probe = testing::probeOf(ProbeKind::endocavity);
  const BeamGrid grid = makeBeamGrid(probe, {}, 80.0, 0.3);
  Transform<frame::Voxel, frame::Probe> probeToVoxel;
  probeToVoxel.matrix = glm::dmat4(2.0, 0.1, 0.0, 0.0, -0.2, 1.5, 0.3, 0.0, 0.1, 0.0, 0.8, 0.0, 30.0, 40.0, 50.0, 1.0);
  std::vector<SampleRow> rows;
  rowsOf(grid, probeToVoxel, {1.5, 4.0}, rows);
  ASSERT_EQ(rows.size(), grid.lines.size());
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const glm::dvec3 start = (probeToVoxel * Point<frame::Probe>{{grid.lines[n].origin_mm, 1.5}}).at;
    const glm::dvec3 end = (probeToVoxel * Point<frame::Probe>{{pointOn(grid, n, 80.0), 4.0}}).at;
    EXPECT_LT(glm::distance(rows[n].start_voxel, start), 1e-12);
    EXPECT_LT(glm::distance(rows[n].start_voxel + static_cast<double>(grid.samples - 1) * rows[n].step_voxel, end), 1e-9);
    EXPECT_EQ(rows[n].row, static_cast<int>(n));
    EXPECT_EQ(rows[n].span, (RowSpan{0, grid.samples}));
  }
}

}  // namespace
}  // namespace ew::beam_grid_test
