#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "ew/core/volume.h"

namespace ew::test {

/// Tissue that fills space: echo levels that vary smoothly over some millimetres, from one seed everywhere the same.
class Tissue {
 public:
  explicit Tissue(unsigned seed, double size_mm = 5.0, double contrast = 45.0)
      : size_mm_(size_mm), contrast_(contrast), values_(kSide * kSide * kSide) {
    std::mt19937 random(seed);
    for (float& v : values_) v = static_cast<float>(static_cast<double>(random()) / 4294967295.0 * 2.0 - 1.0);
  }
  /// Grey level at a point: Gaussian blobs at the places of a lattice.
  [[nodiscard]] double at(const glm::dvec3& p_mm) const {
    const glm::dvec3 q = p_mm / size_mm_ + 1000.0 * kSide;
    const glm::ivec3 low(glm::floor(q));
    const glm::dvec3 t = q - glm::dvec3(low);
    double sum = 0.0, weight[3][4];
    for (int axis = 0; axis < 3; ++axis) {
      for (int n = 0; n < 4; ++n) weight[axis][n] = std::exp(-1.4 * (t[axis] - n + 1) * (t[axis] - n + 1));
    }
    for (int k = 0; k < 4; ++k) {
      for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
          const auto index = static_cast<std::size_t>((((low.z + k) & 15) * kSide + ((low.y + j) & 15)) * kSide + ((low.x + i) & 15));
          sum += weight[0][i] * weight[1][j] * weight[2][k] * static_cast<double>(values_[index]);
        }
      }
    }
    return 110.0 + contrast_ * sum;
  }

 private:
  static constexpr int kSide = 16;
  double size_mm_;
  double contrast_;
  std::vector<float> values_;
};

/// A volume of `grid` whose voxel at p shows level(p), with independent noise of `noise` grey levels.
inline Volume imaged(const Grid& grid, const std::function<double(const glm::dvec3&)>& level, double noise = 0.0, unsigned seed = 1) {
  Volume volume{grid, {}, {}};
  volume.echo.reserve(grid.voxelCount());
  std::mt19937 random(seed);
  const auto toWorld = grid.voxelToWorld();
  for (int k = 0; k < grid.dims.z; ++k) {
    for (int j = 0; j < grid.dims.y; ++j) {
      for (int i = 0; i < grid.dims.x; ++i) {
        double value = level((toWorld * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at);
        // Twelve uniform numbers make a normal one that is the same on every machine.
        double normal = -6.0;
        for (int n = 0; n < 12 && noise > 0.0; ++n) normal += static_cast<double>(random()) / 4294967296.0;
        if (noise > 0.0) value += noise * normal;
        volume.echo.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)));
      }
    }
  }
  return volume;
}

}  // namespace ew::test
