#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace ew {

/// A triangle mesh in world coordinates (LPS, mm), outward normals, counter-clockwise seen from outside.
struct SurfaceMesh {
  std::vector<glm::vec3> points_mm;
  std::vector<glm::vec3> normals;
  std::vector<glm::ivec3> triangles;
};

}  // namespace ew
