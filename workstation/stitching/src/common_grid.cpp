#include <cmath>
#include <limits>

#include "ew/core/figures.h"
#include "ew/stitching/common_grid.h"
#include "view_sampler.h"

namespace ew::stitching {
namespace {

constexpr std::size_t kMostInputs = 255;  // a source is one byte per voxel

Message gibibytes(double bytes) { return say<"%1 GiB">(fixedNumeral(bytes / (1024.0 * 1024.0 * 1024.0), 1)); }

Result<void> checkOptions(const StitchOptions& options) {
  if (!(options.spacing_mm >= 0.0) || !std::isfinite(options.spacing_mm))
    return failure(ErrorCode::badField,
                   say<"The spacing of the result must be a positive number of mm, or 0 for the finest of the inputs.">(),
                   {{"field", "spacing_mm"}});
  if (!(options.featherWidth_mm >= 0.0) || !std::isfinite(options.featherWidth_mm))
    return failure(ErrorCode::badField, say<"The feather width must be 0 or a positive number of mm.">(), {{"field", "feather_mm"}});
  if (!(options.interpolatedWeight > 0.0 && options.interpolatedWeight <= 1.0))
    return failure(ErrorCode::badField, say<"The weight of interpolated voxels must be above 0 and at most 1.">(),
                   {{"field", "interpolated_weight"}});
  return {};
}

/// Spacing of `grid` along the unit vector `axis`: that of its own axis which points most nearly the same way.
double spacingAlong(const Grid& grid, const glm::dvec3& axis) {
  int closest = 0;
  for (int a = 1; a < 3; ++a)
    if (std::abs(glm::dot(grid.directions[a], axis)) > std::abs(glm::dot(grid.directions[closest], axis))) closest = a;
  return grid.spacing_mm[closest];
}

}  // namespace

Result<StitchForecast> forecastStitch(std::span<const GridPlacement> inputs, const StitchOptions& options) {
  if (inputs.empty()) return failure(ErrorCode::emptyVolume, say<"There is no volume to stitch; add at least one.">());
  if (inputs.size() > kMostInputs)
    return failure(ErrorCode::unsupported, say<"At most %1 volumes can be stitched at once; stitch them in groups.">(kMostInputs));
  if (auto good = checkOptions(options); !good) return passOn(good.error());
  std::vector<Grid> grids;
  for (const auto& input : inputs) {
    const auto about = [&](Error problem) {
      problem.message = say<"Volume '%1' cannot be stitched. %2">(input.name, problem.message);
      problem.context.emplace_back("volume", input.name);
      return passOn(std::move(problem));
    };
    if (auto good = checkGrid(input.grid); !good) return about(good.error());
    if (auto rigid = checkRigid(input.toWorld); !rigid) return about(rigid.error());
    grids.push_back(placed(input.grid, input.toWorld));
  }

  StitchForecast forecast;
  Grid& grid = forecast.grid;
  grid.directions = options.axes == GridAxes::first ? grids.front().directions : glm::dmat3(1.0);
  grid.origin_mm = grids.front().origin_mm;
  for (int axis = 0; axis < 3; ++axis) {
    if (options.spacing_mm > 0.0) {
      grid.spacing_mm[axis] = options.spacing_mm;
      continue;
    }
    grid.spacing_mm[axis] = std::numeric_limits<double>::infinity();
    for (const auto& each : grids) grid.spacing_mm[axis] = std::min(grid.spacing_mm[axis], spacingAlong(each, grid.directions[axis]));
  }
  // Corners of every input on the lattice that runs through the first volume's first voxel.
  const auto worldToLattice = grid.worldToVoxel();
  glm::dvec3 lowest(std::numeric_limits<double>::infinity());
  glm::dvec3 highest(-lowest);
  for (const auto& each : grids) {
    const auto voxelToLattice = worldToLattice * each.voxelToWorld();
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 ijk((corner & 1) ? each.dims.x - 1 : 0, (corner & 2) ? each.dims.y - 1 : 0, (corner & 4) ? each.dims.z - 1 : 0);
      const auto p_lattice = (voxelToLattice * Point<frame::Voxel>{ijk}).at;
      lowest = glm::min(lowest, p_lattice);
      highest = glm::max(highest, p_lattice);
    }
  }
  lowest = glm::floor(lowest + kOnLattice_voxel);
  highest = glm::ceil(highest - kOnLattice_voxel);
  const glm::dvec3 dims = highest - lowest + 1.0;
  const double voxels = dims.x * dims.y * dims.z;
  double inputVoxels = 0.0;
  for (const auto& each : grids) inputVoxels += static_cast<double>(each.voxelCount());
  // Echo, coverage and source of the result; one distance per input voxel.
  const double bytes = 3.0 * voxels + (options.featherWidth_mm > 0.0 ? 4.0 * inputVoxels : 0.0);
  const bool countable = std::isfinite(voxels) && glm::all(glm::lessThan(dims, glm::dvec3(1 << 30)));
  if (!countable || bytes > static_cast<double>(options.maxBytes)) {
    const Message limit = gibibytes(static_cast<double>(options.maxBytes));
    return failure(ErrorCode::tooLarge,
                   countable ? say<"Stitching would need %1, and the limit is %2; choose a coarser spacing, or check whether one of the "
                                   "volumes is placed far away.">(gibibytes(bytes), limit)
                             : say<"Stitching would need more memory than there is, and the limit is %1; choose a coarser spacing, or "
                                   "check whether one of the volumes is placed far away.">(limit),
                   {{"bytes", std::to_string(bytes)}});
  }
  grid.origin_mm = (grid.voxelToWorld() * Point<frame::Voxel>{lowest}).at;
  grid.dims = glm::ivec3(dims);
  forecast.bytes = static_cast<std::uint64_t>(bytes);
  return forecast;
}

}  // namespace ew::stitching
