#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "ew/registration/rigid.h"

/// Tissue of soft-edged ellipsoids that can be looked at from any pose, with speckle of each view's own.
namespace ew::registration::test {

struct Blob {
  glm::dvec3 centre_mm;
  glm::dvec3 radius_mm;
  double grey;
};

struct Tissue {
  std::vector<Blob> blobs;
  double base = 110.0;

  [[nodiscard]] double greyAt(const glm::dvec3& p) const {
    double grey = base;
    for (const Blob& blob : blobs) {
      const glm::dvec3 d = (p - blob.centre_mm) / blob.radius_mm;
      const double r2 = glm::dot(d, d);
      if (r2 < 4.0) grey += blob.grey / (1.0 + std::exp(8.0 * (std::sqrt(r2) - 1.0)));
    }
    return grey;
  }
};

/// Fills a cube of `side_mm` around the origin.
inline Tissue tissue(unsigned seed, double side_mm, double perCm3 = 0.35) {
  std::mt19937 random(seed);
  const auto in = [&](double low, double high) { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
  Tissue out;
  const int count = static_cast<int>(perCm3 * side_mm * side_mm * side_mm / 1000.0);
  for (int b = 0; b < count; ++b) {
    Blob blob;
    for (int a = 0; a < 3; ++a) blob.centre_mm[a] = in(-0.5 * side_mm, 0.5 * side_mm);
    for (int a = 0; a < 3; ++a) blob.radius_mm[a] = in(3.0, 9.0);
    blob.grey = (random() & 1u) != 0 ? in(25.0, 60.0) : in(-70.0, -25.0);
    out.blobs.push_back(blob);
  }
  return out;
}

/// A grid of cubes with its middle at the origin.
inline Grid centred(const glm::ivec3& dims, double voxel_mm) {
  Grid grid;
  grid.dims = dims;
  grid.spacing_mm = glm::dvec3(voxel_mm);
  grid.origin_mm = -0.5 * voxel_mm * glm::dvec3(dims - 1);
  return grid;
}

/// What a view whose points m lie at `viewToTissue` m sees: grey levels and independent speckle of `speckle` grey levels.
inline Volume seen(const Tissue& tissue, const Grid& grid, const Transform<frame::Fixed, frame::Moving>& viewToTissue, unsigned seed,
                   double speckle = 18.0, double gain = 1.0, double offset = 0.0) {
  std::mt19937 random(seed);
  Volume out;
  out.grid = grid;
  out.echo.resize(grid.voxelCount());
  const glm::dmat4 toTissue = (viewToTissue * grid.voxelTo<frame::Moving>()).matrix;
  Tissue near;  // what can be seen from here
  near.base = tissue.base;
  const glm::dvec3 middle(toTissue * glm::dvec4(0.5 * glm::dvec3(grid.dims - 1), 1.0));
  const double reach = 0.5 * glm::length(glm::dvec3(grid.dims) * grid.spacing_mm) + 20.0;
  for (const Blob& blob : tissue.blobs) {
    if (glm::length(blob.centre_mm - middle) < reach) near.blobs.push_back(blob);
  }
  for (int k = 0; k < grid.dims.z; ++k) {
    for (int j = 0; j < grid.dims.y; ++j) {
      for (int i = 0; i < grid.dims.x; ++i) {
        double noise = -2.0;  // four uniform values: near enough to a bell
        for (int n = 0; n < 4; ++n) noise += static_cast<double>(random()) / 4294967296.0;
        const double grey = near.greyAt(glm::dvec3(toTissue * glm::dvec4(i, j, k, 1.0))) + 1.732 * speckle * noise;
        out.echo[grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(std::clamp(gain * grey + offset + 0.5, 1.0, 255.0));
      }
    }
  }
  return out;
}

/// Turn by |rotation_deg| about rotation_deg, then shift.
inline Transform<frame::Moving, frame::Fixed> pose(const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg) {
  const double angle = glm::length(rotation_deg) * 0.017453292519943295;
  glm::dmat4 out(1.0);
  if (angle > 0.0) {
    const glm::dvec3 n = glm::normalize(rotation_deg);
    const glm::dmat3 k(glm::dvec3(0.0, n.z, -n.y), glm::dvec3(-n.z, 0.0, n.x), glm::dvec3(n.y, -n.x, 0.0));
    out = glm::dmat4(glm::dmat3(1.0) + std::sin(angle) * k + (1.0 - std::cos(angle)) * (k * k));
  }
  out[3] = glm::dvec4(shift_mm, 1.0);
  return {out};
}
/// The same as a motion within the fixed frame.
inline Transform<frame::Fixed, frame::Fixed> motion(const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg) {
  return renamed<frame::Fixed, frame::Fixed>(pose(shift_mm, rotation_deg));
}

/// Largest distance between where two transforms take the corners of a grid.
template <class To, class From>
double apart_mm(const Transform<To, From>& a, const Transform<To, From>& b, const Grid& grid) {
  double most = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 voxel = glm::dvec3(grid.dims - 1) * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 p = carried(grid.voxelToWorld(), voxel);
    most = std::max(most, glm::length(carried(a, p) - carried(b, p)));
  }
  return most;
}

}  // namespace ew::registration::test
