#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

namespace ew::detail {

/// A map of one byte a voxel, as vector code reads it.
struct ByteMap {
  ByteMap(const std::uint8_t* voxels, const glm::ivec3& dims)
      : first(voxels), row(dims.x), plane(row * dims.y), count(plane * dims.z), last(dims - 1) {}

  const std::uint8_t* first;
  std::ptrdiff_t row, plane, count;
  glm::vec3 last;  ///< a place is inside from 0 to here, which is left out: there are eight voxels around it

  /// Whether places of voxels count in 32 bits.
  [[nodiscard]] bool isSmall() const { return count <= std::numeric_limits<std::int32_t>::max(); }
};

}  // namespace ew::detail
