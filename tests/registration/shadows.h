#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "ew/core/volume.h"

namespace ew::test {

/// Shadows along `beam`, where the probe's own place says: the same wherever the probe is.
inline Volume shadowed(Volume volume, const glm::dvec3& beam, double strength) {
  const glm::dvec3 along = glm::normalize(beam);
  const glm::dvec3 x = glm::normalize(glm::cross(along, glm::dvec3(0.3, 1.0, 0.2)));
  const glm::dvec3 y = glm::cross(along, x);
  for (int k = 0; k < volume.grid.dims.z; ++k) {
    for (int j = 0; j < volume.grid.dims.y; ++j) {
      for (int i = 0; i < volume.grid.dims.x; ++i) {
        const glm::dvec3 p(volume.grid.voxelToWorld().matrix * glm::dvec4(i, j, k, 1.0));
        const double a = glm::dot(p, x);
        const double b = glm::dot(p, y);
        const double dark = std::sin(0.31 * a + 0.9 * std::sin(0.17 * b)) * std::cos(0.27 * b + 0.8 * std::sin(0.13 * a));
        std::uint8_t& echo = volume.echo[volume.grid.indexOf(i, j, k)];
        echo = static_cast<std::uint8_t>(std::clamp(echo * (1.0 + strength * dark), 1.0, 255.0));
      }
    }
  }
  return volume;
}

}  // namespace ew::test
