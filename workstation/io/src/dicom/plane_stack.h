#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "dicom/dicom_fields.h"
#include "ew/core/volume.h"
#include "ew/io/volume_file.h"

namespace ew::detail {

/// A grid along the common normal of planes.
struct PlaneStack {
  Grid grid;
  std::vector<double> along_mm;  ///< of each plane, ascending
  bool even = true;              ///< the planes are the grid's slices as they are
};

/// Sorts planes along their normal and gives their grid; uneven planes get one as fine as their smallest distance.
/// @param file that sentences name
/// @error emptyVolume (a single plane), unsupported (not parallel or shifted sideways: context entry "ask": "sequence"), badField (planes
/// in
///        one place), tooLarge
[[nodiscard]] Result<PlaneStack> stackOf(std::vector<VolumePlane>& planes, int columns, int rows, const std::filesystem::path& file,
                                         const ReaderLimits& limits, std::vector<Message>& notes);

/// The levels of sorted planes on the stack's grid, linearly between the two next ones. @error cancelled
[[nodiscard]] Result<std::vector<std::uint8_t>> echoOnto(const PlaneStack& stack, std::vector<std::uint8_t> planes,
                                                         const std::filesystem::path& file, const Progress& progress);

}  // namespace ew::detail
