#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew::stitching {

/// A subvolume and where it lies: toWorld is rigid and takes the coordinates of the volume's own file to the world, mm, LPS.
struct PlacedVolume {
  Volume volume;
  glm::dmat4 toWorld{1.0};
  std::string name;  ///< for messages and the provenance
};

/// The directions of the common grid.
enum class GridAxes {
  first,  ///< those of the first volume as placed, on its lattice: its voxels keep their places when the spacing agrees
  world   ///< left, posterior, superior
};

/// The same for a volume that someone else holds and keeps alive.
struct PlacedView {
  const Volume* volume = nullptr;
  glm::dmat4 toWorld{1.0};
  std::string name;
};

struct StitchOptions {
  double spacing_mm = 0.0;           ///< of the common grid; 0: per axis the finest of the inputs
  double featherWidth_mm = 10.0;     ///< how far from an input's border its weight reaches full height; 0: plain mean in overlaps
  double interpolatedWeight = 0.25;  ///< of an interpolated voxel beside a measured one, > 0
  GridAxes axes = GridAxes::first;
  int threads = 0;                       ///< 0: all cores; the voxels do not depend on it
  std::uint64_t maxBytes = 16ull << 30;  ///< a forecast above this is refused before memory is taken
  bool operator==(const StitchOptions&) const = default;
};

/// What stitching will make and need, known from the grids alone.
struct StitchForecast {
  Grid grid;
  std::uint64_t bytes = 0;  ///< at the peak, the inputs themselves not counted
};

/// A grid and its place, for a forecast before the volumes are read.
struct PlacedGrid {
  Grid grid;
  glm::dmat4 toWorld{1.0};
  std::string name;
};

/// @error emptyVolume (no input), badField (spacing, feather width, interpolated weight, a grid), notRigid (naming the volume), tooLarge
[[nodiscard]] Result<StitchForecast> forecastStitch(std::span<const PlacedGrid> inputs, const StitchOptions& options);
[[nodiscard]] Result<StitchForecast> forecastStitch(std::span<const PlacedVolume> inputs, const StitchOptions& options);
[[nodiscard]] Result<StitchForecast> forecastStitch(std::span<const PlacedView> inputs, const StitchOptions& options);

/// What one input gave.
struct Contribution {
  std::string name;
  std::size_t voxels = 0;          ///< of the result to which it contributed
  std::size_t dominantVoxels = 0;  ///< of the result in which it weighed most
  bool operator==(const Contribution&) const = default;
};

struct StitchResult {
  Volume volume;                     ///< with coverage: measured where a measured voxel contributed
  std::vector<std::uint8_t> source;  ///< per voxel 1 + index of the input that weighed most (the earlier one of equals); 0: absent
  std::vector<Contribution> contributions;
  double overlapShare = 0.0;     ///< of the covered voxels, those to which two or more inputs contributed
  double disagreementRms = 0.0;  ///< grey levels: spread of the inputs about their blend over the overlap; 0 without overlap
  std::vector<Message> notes;    ///< what the user should know: an input that touches no other, one that contributed nothing
  double seconds = 0.0;
};

/// Joins volumes with known places into one: each voxel of the common grid is the mean of the inputs that cover it, weighted by the
/// distance from the border of each input's covered region (clipped at featherWidth_mm), and by interpolatedWeight where an input was
/// interpolated. Inputs are sampled linearly; absent voxels never contribute. Constants are kept exactly; one volume on its own grid passes
/// unchanged; inputs that do not touch are both kept.
/// Cost: one linear sample per voxel and covering input, plus a distance transform per input.
/// @error as forecastStitch, cancelled
[[nodiscard]] Result<StitchResult> stitch(std::span<const PlacedVolume> inputs, const StitchOptions& options, Progress& progress);
[[nodiscard]] Result<StitchResult> stitch(std::span<const PlacedView> inputs, const StitchOptions& options, Progress& progress);

/// Memory the system can give now; empty where it does not say.
[[nodiscard]] std::optional<std::uint64_t> availableMemory_bytes();

}  // namespace ew::stitching
