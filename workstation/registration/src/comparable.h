#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/registration/verdict.h"

/// Images of two subvolumes made comparable: where the beam was, and there the echo without its gain. Private to this library.
namespace ew::registration {

/// One per voxel: 255 where the beam covered tissue, 0 elsewhere. With coverage in the volume that decides. Without it, black that reaches
/// the border of the volume and is thick (10 mm somewhere, three voxels everywhere) is outside the sector; zeros scattered by the noise
/// floor, thin vessels and black inside the tissue are not.
/// @error cancelled
[[nodiscard]] Result<std::vector<std::uint8_t>> coveredMask(const Volume& volume, Progress& progress);
[[nodiscard]] inline std::vector<std::uint8_t> coveredMask(const Volume& volume) { return *coveredMask(volume, noProgress()); }

/// An echo image at one resolution, on the axes of its volume.
struct ComparableImage {
  Grid grid;
  std::vector<float> value;          ///< (echo - local mean) / (local deviation + softness), clipped to +-4; 0 where weight is 0
  std::vector<std::uint8_t> weight;  ///< confidence inside the covered area, 0..255
  std::vector<std::uint8_t> inner;   ///< weight where all 26 neighbours are covered too, else 0: there derivatives and interpolation hold
  [[nodiscard]] double coveredVolume_mm3() const;
};

struct ComparableOptions {
  double window_mm = 8.0;  ///< standard deviation of the window of local mean and deviation
  double softness = 4.0;   ///< grey levels added to the deviation: what lies far below is flat
  /// Levels of such voxels and coarser are smoothed once more over neighbouring voxels, against speckle. Finer ones are not: where speckle
  /// moves with the tissue it carries the last tenths of a millimetre.
  double suppressFrom_mm = 1.0;
  int threads = 0;
};

/// The grid of `voxel_mm` cubes with the axes and the middle of `grid`.
[[nodiscard]] Grid levelGrid(const Grid& grid, double voxel_mm);

/// Voxels of the levels: finest (or the finer input, when that is coarser) times powers of two up to coarsest; coarse first.
[[nodiscard]] std::vector<double> levelVoxels_mm(const Grid& fixed, const Grid& moving, double coarsest_mm, double finest_mm);

/// One image per asked voxel size, in the order asked (coarse first). Each level is made from the next finer one.
/// @param voxel_mm decreasing, each > 0
/// @error emptyVolume, badField (sizes of echo, coverage or confidence), cancelled
[[nodiscard]] Result<std::vector<ComparableImage>> comparableImages(const Input& input, std::span<const double> voxel_mm,
                                                                    const ComparableOptions& options, Progress& progress);

/// Memory comparableImages takes at its peak beyond the volume, and what its result holds.
struct ComparableMemory {
  std::uint64_t peak_bytes = 0;
  std::uint64_t result_bytes = 0;
};
[[nodiscard]] ComparableMemory forecastComparable(const Grid& grid, std::span<const double> voxel_mm);

/// Whether an input can be used at all.
/// @error emptyVolume (no voxel, none covered), badField (sizes, a confidence outside 0..1)
[[nodiscard]] Result<void> checkInput(const Input& input, const Message& side);

/// The confidence of a side; empty where there is none, or where it says nothing (see Input).
[[nodiscard]] std::span<const float> usedConfidence(const Input& input);

}  // namespace ew::registration
