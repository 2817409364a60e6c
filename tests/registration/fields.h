#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "ew/registration/deformation.h"

namespace ew::test {

/// A lattice around the origin's octant with axes that are neither the world's nor right-handed.
inline Grid obliqueGrid(const glm::ivec3& dims, double spacing_mm) {
  Grid grid;
  grid.dims = dims;
  grid.spacing_mm = glm::dvec3(spacing_mm, 1.25 * spacing_mm, 0.75 * spacing_mm);
  grid.origin_mm = glm::dvec3(-12.5, 40.0, 7.25);
  grid.directions = glm::dmat3(glm::dvec3(0.6, 0.8, 0.0), glm::dvec3(-0.8, 0.6, 0.0), glm::dvec3(0.0, 0.0, -1.0));
  return grid;
}

inline Grid uprightGrid(const glm::ivec3& dims, double spacing_mm) {
  Grid grid;
  grid.dims = dims;
  grid.spacing_mm = glm::dvec3(spacing_mm);
  return grid;
}

/// u(p) = M p + t at every node.
inline registration::ControlGrid affineField(const Grid& nodes, const glm::dmat3& m, const glm::dvec3& t) {
  registration::ControlGrid control{nodes, {}};
  const auto toWorld = nodes.voxelToWorld();
  for (int k = 0; k < nodes.dims.z; ++k) {
    for (int j = 0; j < nodes.dims.y; ++j) {
      for (int i = 0; i < nodes.dims.x; ++i)
        control.displacement_mm.push_back(glm::vec3(m * (toWorld * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at + t));
    }
  }
  return control;
}

/// Waves of `amplitude_mm` and `period_mm`, different along each axis.
inline registration::ControlGrid wavyField(const Grid& nodes, double amplitude_mm, double period_mm) {
  registration::ControlGrid control{nodes, {}};
  const auto toWorld = nodes.voxelToWorld();
  const double turn = 2.0 * 3.14159265358979323846 / period_mm;
  for (int k = 0; k < nodes.dims.z; ++k) {
    for (int j = 0; j < nodes.dims.y; ++j) {
      for (int i = 0; i < nodes.dims.x; ++i) {
        const glm::dvec3 p = (toWorld * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at;
        control.displacement_mm.push_back(
            glm::vec3(amplitude_mm * glm::dvec3(std::sin(turn * p.y + 0.3), std::cos(turn * (p.z + 0.5 * p.x)),
                                                std::sin(turn * p.x) * std::cos(turn * p.y))));
      }
    }
  }
  return control;
}

}  // namespace ew::test
