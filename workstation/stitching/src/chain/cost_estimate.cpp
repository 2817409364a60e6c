#include "ew/stitching/cost_estimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ew/core/order_statistics.h"

namespace ew::stitching {
namespace {

/// The measurement: 96 voxels of 0.6 mm a side.
constexpr double kVoxel_mm = 0.6;
constexpr double kSide_mm = 96 * kVoxel_mm;
struct Measured {
  double finest_mm;  ///< what the effort goes down to where the volume allows it
  double seconds, error_mm, error95_mm;
  /// Of the time, what goes with the volume and not with its voxels: coarse levels and the lattice. From one pair at three spacings.
  double volumeShare;
};
constexpr std::array<Measured, 3> kMeasured = {
    {{1.0, 0.15, 0.21, 0.53, 0.45}, {0.5, 0.45, 0.13, 0.33, 0.2}, {0.5, 0.68, 0.11, 0.24, 0.25}}};

/// The search: 96 voxels of 0.9 mm a side, turns to 30 degrees; with steps of 15 degrees instead of 10 there are 0.3 times
/// as many, and it takes 0.7 s.
constexpr double kSearchSide_mm = 96 * 0.9;
constexpr double kSearch_s = 1.8;
constexpr double kSearchRotation_deg = 30.0;
constexpr double kBesideTurns_s = 0.25;

double extent_mm3(const Grid& grid) {
  return static_cast<double>(grid.voxelCount()) * grid.spacing_mm.x * grid.spacing_mm.y * grid.spacing_mm.z;
}
double finestOf(const Grid& grid) { return std::min({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z}); }

/// Of the rotations by up to so much, in parts of all there are.
double ballOfTurns(double rotation_deg) {
  const double turn = std::clamp(rotation_deg, 0.0, 180.0) * std::numbers::pi / 180.0;
  return (turn - std::sin(turn)) / std::numbers::pi;
}

}  // namespace

std::array<CostEstimate, 3> expectedWarps(const Grid& fixed, const Grid& moving, const MachinePace& pace) {
  std::array<CostEstimate, 3> costs;
  const double spacing_mm = finestOf(fixed);
  const double volume_mm3 = 0.5 * (extent_mm3(fixed) + extent_mm3(moving));
  for (std::size_t n = 0; n < costs.size(); ++n) {
    const Measured& measured = kMeasured[n];
    const double then_mm = std::max(measured.finest_mm, kVoxel_mm);
    const double now_mm = std::max(measured.finest_mm, spacing_mm);
    const double volumes = volume_mm3 / std::pow(kSide_mm, 3.0);
    const double voxels = volumes * std::pow(then_mm / now_mm, 3.0);
    const double coarser = std::max(1.0, now_mm / then_mm);
    const double times = measured.volumeShare * volumes + (1.0 - measured.volumeShare) * voxels;
    costs[n] = {kEfforts[n], pace.factor * measured.seconds * times, measured.error_mm * coarser, measured.error95_mm * coarser};
    if (n > 0) {  // on coarse voxels the levels are the same: more effort brings nothing, and is no worse
      costs[n].error_mm = std::min(costs[n].error_mm, costs[n - 1].error_mm);
      costs[n].error95_mm = std::min(costs[n].error95_mm, costs[n - 1].error95_mm);
    }
  }
  return costs;
}

double expectedSearch_s(const Grid& fixed, const Grid& moving, double maxRotation_deg, const MachinePace& pace) {
  const double size = 0.5 * (extent_mm3(fixed) + extent_mm3(moving)) / std::pow(kSearchSide_mm, 3.0);
  const double turns = ballOfTurns(maxRotation_deg) / ballOfTurns(kSearchRotation_deg);
  return pace.factor * size * (kBesideTurns_s + (kSearch_s - kBesideTurns_s) * turns);
}

MachinePace paceOf(std::span<const Timed> timed) {
  std::vector<double> ratios;
  for (const Timed& each : timed)
    if (each.measured_s > 0.0 && each.expected_s > 0.0) ratios.push_back(each.measured_s / each.expected_s);
  if (ratios.empty()) return {};
  return {.factor = upperMedianOf(ratios), .pairs = ratios.size()};
}

MachinePace paceOf(std::span<const PairDeformation> warped, std::span<const std::optional<Grid>> grids) {
  std::vector<Timed> timed;
  for (const PairDeformation& pair : warped) {
    if (pair.fixed >= grids.size() || pair.moving >= grids.size() || !grids[pair.fixed] || !grids[pair.moving]) continue;
    for (const CostEstimate& expected : expectedWarps(*grids[pair.fixed], *grids[pair.moving]))
      if (expected.effort == pair.effort) timed.push_back({expected.seconds, pair.processor_s});
  }
  MachinePace pace = paceOf(timed);
  std::vector<Timed> waited;
  for (const PairDeformation& pair : warped) waited.push_back({pair.processor_s, pair.seconds});
  pace.clock = std::max(1.0, paceOf(waited).factor);
  return pace;
}

}  // namespace ew::stitching
