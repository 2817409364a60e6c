#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew::registration {

/// Displacements at nodes, i fastest; between nodes trilinear, outside the lattice that of the nearest point of it.
struct ControlGrid {
  Grid nodes;                              ///< its voxel centres are the nodes
  std::vector<glm::vec3> displacement_mm;  ///< nodes.voxelCount() vectors along world axes; empty: none anywhere
  bool operator==(const ControlGrid&) const = default;
};
[[nodiscard]] glm::dvec3 displacementAt(const ControlGrid& control, const glm::dvec3& p_mm);
/// Every point p to p + u(p). The lattice is made ready once: for the many points of an image.
void displace(const ControlGrid& control, std::span<glm::dvec3> points_mm);

/// Elastic, then rigid: moving point = rigid * (p + u(p)), with u in the fixed frame. The Jacobian of the whole is that of p + u(p).
struct Deformation {
  Transform<frame::Moving, frame::Fixed> rigid = {};  ///< fixed to moving
  ControlGrid control;
};
[[nodiscard]] glm::dvec3 movingPoint(const Deformation& fixedToMoving, const glm::dvec3& fixed_mm);

/// A displacement per voxel: fixed point + displacement = moving point, the rigid part included. What `--field` writes.
struct DisplacementField {
  Grid grid;
  std::vector<glm::vec3> displacement_mm;
};
[[nodiscard]] Result<DisplacementField> fieldOf(const Deformation& fixedToMoving, const Grid& fixedGrid, int threads, Progress& progress);

/// Smallest and largest determinant of the Jacobian of p + u(p), exact over the whole lattice for trilinear u (cells have their extremes
/// where this looks), and how many of `nodes` cells fold (<= 0).
struct JacobianSummary {
  double smallest = 1.0;
  double largest = 1.0;
  std::size_t folded = 0;
};
[[nodiscard]] JacobianSummary jacobianOf(const ControlGrid& control);
/// The same by central differences over a voxel field (one-sided at the border), as yardsticks measure it.
[[nodiscard]] JacobianSummary jacobianOf(const DisplacementField& field);

/// The moving volume seen on the fixed grid: echo linear, coverage and all; absent where it lies outside.
[[nodiscard]] Result<Volume> warped(const Volume& moving, const Deformation& fixedToMoving, const Grid& fixedGrid, int threads,
                                    Progress& progress);

}  // namespace ew::registration
