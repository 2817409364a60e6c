#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <filesystem>

#include "ew/core/result.h"

class vtkPolyData;

namespace ew::bridge {

/// Points and faces of a PLY file (ascii, binary_little_endian, binary_big_endian), other elements and properties skipped. VTK's own
/// reader ends the program when the file stops early, so a file from outside is read here.
/// @param bytes of the file: nothing is allocated that the file is too short for
/// @error badHeader, badField, truncated, emptyVolume, tooLarge (more than `mostFaces` faces or points)
[[nodiscard]] Result<vtkSmartPointer<vtkPolyData>> readPly(const std::filesystem::path& file, std::uint64_t bytes, std::uint64_t mostFaces);

}  // namespace ew::bridge
