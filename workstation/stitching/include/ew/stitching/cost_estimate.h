#pragma once

#include <array>
#include <optional>
#include <span>

#include "ew/stitching/chain.h"

namespace ew::stitching {

/// What a setting is expected to cost and to bring.
struct CostEstimate {
  registration::ElasticEffort effort = registration::ElasticEffort::balanced;
  double seconds = 0.0;
  double error_mm = 0.0;    ///< mean over the overlap
  double error95_mm = 0.0;  ///< below which 95 % of it lie
};
inline constexpr std::array kEfforts = {registration::ElasticEffort::fast, registration::ElasticEffort::balanced,
                                        registration::ElasticEffort::accurate};

/// How this machine compares with the one the figures are from.
struct MachinePace {
  double factor = 1.0;    ///< seconds here for one there
  std::size_t pairs = 0;  ///< that were measured here; 0: the factor is nobody's
  double clock = 1.0;     ///< seconds one waits for one of processor time, which is more where the machine does other things as well
};

/// Bending a pair of volumes on these grids at each effort. The figures are those of `echoweave bench register --side 96` on one thread
/// (resources/docs/science/log/measurements.md): two views of one tissue, moved smoothly by up to 5 mm, with two thirds of their speckle in
/// common. Time goes partly with the volume (coarse levels, lattice) and partly with the voxels of the last level, which are no finer than
/// the effort asks for and the volume has; errors, once voxels are coarser than those of the measurement, with their size.
[[nodiscard]] std::array<CostEstimate, 3> expectedWarps(const Grid& fixed, const Grid& moving, const MachinePace& pace = {});

/// Finding a pair without a start, turning to maxRotation_deg in every direction: seconds, from the same benchmark (`partial`, 30 degrees).
/// Rotations to be searched go with the volume of the ball they fill.
[[nodiscard]] double expectedSearch_s(const Grid& fixed, const Grid& moving, double maxRotation_deg, const MachinePace& pace = {});

struct Timed {
  double expected_s = 0.0;
  double measured_s = 0.0;
};
/// The median of measured over expected.
[[nodiscard]] MachinePace paceOf(std::span<const Timed> timed);
/// The median of what warped pairs took here over what they were expected to take, in processor time: a machine that had other things to do
/// while they were warped is not slower for that; how long one waits for it is told by itself. @param grids one per volume of the pairs
[[nodiscard]] MachinePace paceOf(std::span<const PairDeformation> warped, std::span<const std::optional<Grid>> grids);

}  // namespace ew::stitching
