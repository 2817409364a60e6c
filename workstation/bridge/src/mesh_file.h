#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

#include "ew/core/result.h"

class vtkPolyData;

namespace ew::bridge {

/// Points and polygons of a mesh file, checked: every corner exists, every coordinate is finite.
/// @param ending ".stl", ".ply" or ".obj"
/// @error notReadable, truncated, badHeader, badField, emptyVolume, tooLarge
[[nodiscard]] Result<vtkSmartPointer<vtkPolyData>> readMeshFile(const std::filesystem::path& file, const std::string& ending);

}  // namespace ew::bridge
