#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>

#include "ew/core/memory.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew::stitching {

/// The directions of the common grid.
enum class GridAxes {
  first,  ///< those of the first volume as placed, on its lattice: its voxels keep their places when the spacing agrees
  world   ///< left, posterior, superior
};

struct StitchOptions {
  double spacing_mm = 0.0;           ///< of the common grid; 0: per axis the finest of the inputs
  double featherWidth_mm = 10.0;     ///< how far from an input's border its weight reaches full height; 0: plain mean in overlaps
  double interpolatedWeight = 0.25;  ///< of an interpolated voxel beside a measured one, > 0
  GridAxes axes = GridAxes::first;
  int threads = 0;                                ///< 0: all cores; the voxels do not depend on it
  std::uint64_t maxBytes = kLargestVolume_bytes;  ///< a forecast above this is refused before memory is taken
  bool operator==(const StitchOptions&) const = default;
};

/// What stitching will make and need, known from the grids alone.
struct StitchForecast {
  Grid grid;
  std::uint64_t bytes = 0;  ///< at the peak, the inputs themselves not counted
};

/// A grid and where it lies, for a forecast before the volumes are read: toWorld is rigid and takes the coordinates of the volume's own
/// file to the world, mm, LPS.
struct GridPlacement {
  Grid grid;
  Transform<frame::World, frame::View> toWorld = {};
  std::string name;  ///< for messages
};

/// @error emptyVolume (no input), badField (spacing, feather width, interpolated weight, a grid), notRigid (naming the volume), tooLarge
[[nodiscard]] Result<StitchForecast> forecastStitch(std::span<const GridPlacement> inputs, const StitchOptions& options);

/// What one input gave.
struct Contribution {
  std::string name;
  std::size_t voxels = 0;          ///< of the result to which it contributed
  std::size_t dominantVoxels = 0;  ///< of the result in which it weighed most
  bool operator==(const Contribution&) const = default;
};

}  // namespace ew::stitching
