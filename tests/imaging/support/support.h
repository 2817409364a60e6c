#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "ew/core/frames.h"
#include "ew/core/image.h"
#include "ew/core/volume.h"

namespace ew::testing {

using ImageToVoxel = Transform<frame::Voxel, frame::Image>;

/// How far a pixel may lie from exact arithmetic, rounding to whole grey levels included. Linear: the position is rounded to 2^-15 voxels
/// and each of three blends to 2^-7 levels; `step_grey` adds up how much neighbouring voxels differ along the three axes. Cubic: on noise.
constexpr double linearBound_grey(double step_grey) { return 0.5 + step_grey / 65536.0 + 3.0 / 256.0; }
constexpr double kLinearBoundOnNoise_grey = linearBound_grey(3.0 * 255.0);
constexpr double kCubicBound_grey = 0.5 + 0.1;

inline Volume volumeOf(glm::ivec3 dims, const std::function<double(int, int, int)>& value, glm::dvec3 spacing_mm = glm::dvec3(1.0)) {
  Volume volume;
  volume.grid.dims = dims;
  volume.grid.spacing_mm = spacing_mm;
  volume.echo.resize(volume.grid.voxelCount());
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        volume.echo[volume.grid.indexOf(i, j, k)] =
            static_cast<std::uint8_t>(std::lround(std::fmin(255.0, std::fmax(0.0, value(i, j, k)))));
  return volume;
}

inline Volume noiseVolume(glm::ivec3 dims, unsigned seed, glm::dvec3 spacing_mm = glm::dvec3(1.0)) {
  std::mt19937 random(seed);
  return volumeOf(
      dims, [&](int, int, int) { return 1.0 + random() % 255; }, spacing_mm);
}

/// A rotation drawn evenly from all rotations.
inline glm::dmat3 randomRotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return glm::mat3_cast(glm::normalize(glm::dquat(w, x, y, z)));
}

/// The plane through `middle_voxel` with this rotation and pixel step, seen by the middle of a width x height image.
inline ImageToVoxel planeThrough(glm::dvec3 middle_voxel, const glm::dmat3& rotation, double step_voxel, int width, int height) {
  ImageToVoxel plane;
  for (int axis = 0; axis < 3; ++axis) plane.matrix[axis] = glm::dvec4(step_voxel * rotation[axis], 0.0);
  const glm::dvec3 corner = middle_voxel - 0.5 * (width - 1) * step_voxel * rotation[0] - 0.5 * (height - 1) * step_voxel * rotation[1];
  plane.matrix[3] = glm::dvec4(corner, 1.0);
  return plane;
}

inline ImageToVoxel randomPlane(std::mt19937& random, const Grid& grid, int width, int height, double step_voxel = 1.0) {
  std::uniform_real_distribution<double> unit(0.2, 0.8);
  const double a = unit(random), b = unit(random), c = unit(random);
  return planeThrough(glm::dvec3(a, b, c) * glm::dvec3(grid.dims), randomRotation(random), step_voxel, width, height);
}

inline glm::dvec3 voxelAt(const ImageToVoxel& plane, int x, int y) { return glm::dvec3(plane.matrix * glm::dvec4(x, y, 0.0, 1.0)); }

/// Distance of a coordinate from the nearest place where rounding to a voxel changes.
inline double distanceFromTie(double voxel) { return std::abs(voxel + 0.5 - std::round(voxel + 0.5)); }

}  // namespace ew::testing
