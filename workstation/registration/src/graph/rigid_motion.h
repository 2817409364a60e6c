#pragma once

#include <Eigen/Geometry>
#include <glm/glm.hpp>

namespace ew::registration::graph {

/// p -> turn p + shift, mm.
struct Rigid {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return turn * p + shift; }
};
/// First a, then b.
[[nodiscard]] Rigid operator*(const Rigid& b, const Rigid& a);
[[nodiscard]] Rigid inverse(const Rigid& a);

[[nodiscard]] Eigen::Vector3d vectorOf(const glm::dvec3& p);
/// @param matrix rigid
[[nodiscard]] Rigid rigidOf(const glm::dmat4& matrix);
[[nodiscard]] glm::dmat4 matrixOf(const Rigid& rigid);

/// Of the turn, 0 to pi.
[[nodiscard]] double angle_rad(const Eigen::Quaterniond& q);

}  // namespace ew::registration::graph
