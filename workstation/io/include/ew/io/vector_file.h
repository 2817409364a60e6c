#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/io/volume_file.h"

namespace ew {

/// Gives the vectors of slices [first, first + count) along k, in voxel order, `components` numbers a voxel.
using VectorSlices = std::function<Result<void>(int first, int count, std::span<float> out)>;

/// Writes a field of vectors as an uncompressed .mha (MET_FLOAT, components as channels): displacements in mm, each at the grid's voxel
/// centre. Slices are asked for a few at a time and go straight to the file, so that the field is never in memory as a whole.
/// @param components 3; or 2 for a grid of one slice, whose file then is two-dimensional
/// @error notWritable, unsupported (ending), emptyVolume, cancelled, and what `slices` says
[[nodiscard]] Result<void> writeVectorField(const Grid& grid, int components, const std::filesystem::path& file, const VectorSlices& slices,
                                            Progress& progress = noProgress());

struct VectorField {
  Grid grid;
  int components = 3;
  std::vector<float> values;  ///< grid.voxelCount() * components
};

/// Reads such a field, ours or another program's, from any file readVolume reads.
/// @error as readVolume; badField (not 2 or 3 components, or numbers that are no floats)
[[nodiscard]] Result<VectorField> readVectorField(const std::filesystem::path& file, const ReaderLimits& limits = {});

}  // namespace ew
