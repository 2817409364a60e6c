#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>

#include "ew/core/result.h"
#include "ew/core/surface_mesh.h"

namespace ew {

/// Writes a surface as binary .stl or .ply (with normals), in mm.
/// @error unsupported (another ending), notWritable
[[nodiscard]] Result<void> writeSurface(const SurfaceMesh& mesh, const std::filesystem::path& file);

/// A surface among others in a file.
struct SurfacePart {
  std::string name;
  glm::dvec3 colour{0.8};  ///< red, green, blue (sRGB), 0 to 1
  SurfaceMesh mesh;
};

/// Writes surfaces as binary glTF 2.0 (.glb): a node, a mesh and a material for each, with its name. Metres; +Y up (superior), +Z to the
/// front (anterior), +X to the patient's left. What shares points in mm shares them in the file, to the bit. Surfaces without triangles are
/// left out. Source: glTF 2.0 Specification, Khronos Group, 2021.
/// @error unsupported (another ending), emptyVolume (no triangles at all), tooLarge (above 4 GiB, which the format cannot say), notWritable
[[nodiscard]] Result<void> writeGltf(std::span<const SurfacePart> surfaces, const std::filesystem::path& file);

}  // namespace ew
