#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>

#include "ew/imaging/slice_source.h"

namespace ew::detail {

/// Means of two tables over the eight voxels around a point; the tables' values for label 0 outside.
struct LabelBlend {
  const SliceSource& labels;
  const std::array<float, 256>& own;
  const std::array<float, 256>& reflection;
  glm::vec3 last = glm::vec3(labels.grid.dims - 1);
  std::ptrdiff_t row = labels.grid.dims.x;
  std::ptrdiff_t plane = row * labels.grid.dims.y;

  /// Asks for the voxels around a point.
  void announce(const glm::vec3& p) const {
    if (!(p.x >= 0.0F && p.y >= 0.0F && p.z >= 0.0F && p.x < last.x && p.y < last.y && p.z < last.z)) return;
    const std::uint8_t* first = labels.voxels + static_cast<int>(p.x) + row * static_cast<int>(p.y) + plane * static_cast<int>(p.z);
    __builtin_prefetch(first);
    __builtin_prefetch(first + row);
    __builtin_prefetch(first + plane);
    __builtin_prefetch(first + row + plane);
  }
  void at(const glm::vec3& p, float& ownAt, float& reflectionAt) const {
    // Not a number compares false.
    if (!(p.x >= 0.0F && p.y >= 0.0F && p.z >= 0.0F && p.x < last.x && p.y < last.y && p.z < last.z)) {
      ownAt = own[0];
      reflectionAt = reflection[0];
      return;
    }
    const int i = static_cast<int>(p.x), j = static_cast<int>(p.y), k = static_cast<int>(p.z);
    const std::uint8_t* first = labels.voxels + i + row * j + plane * k;
    std::array<std::uint16_t, 4> pairs;
    std::memcpy(&pairs[0], first, 2);
    std::memcpy(&pairs[1], first + row, 2);
    std::memcpy(&pairs[2], first + plane, 2);
    std::memcpy(&pairs[3], first + row + plane, 2);
    const auto even = static_cast<std::uint16_t>(*first * 0x0101U);
    if (((pairs[0] ^ even) | (pairs[1] ^ even) | (pairs[2] ^ even) | (pairs[3] ^ even)) == 0) {
      ownAt = own[*first];
      reflectionAt = reflection[*first];
      return;
    }
    const glm::vec3 t = p - glm::vec3(i, j, k);
    ownAt = blended(own, pairs, t);
    reflectionAt = blended(reflection, pairs, t);
  }

 private:
  [[nodiscard]] static float blended(const std::array<float, 256>& table, const std::array<std::uint16_t, 4>& pairs, const glm::vec3& t) {
    std::array<float, 4> along;
    for (std::size_t n = 0; n < pairs.size(); ++n) {
      const float low = table[pairs[n] & 0xFFU], high = table[pairs[n] >> 8];
      along[n] = low + t.x * (high - low);
    }
    const float near = along[0] + t.y * (along[1] - along[0]), far = along[2] + t.y * (along[3] - along[2]);
    return near + t.z * (far - near);
  }
};

}  // namespace ew::detail
