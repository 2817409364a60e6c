#include "graph/rigid_motion.h"

#include <cmath>

namespace ew::registration::graph {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d vectorOf(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

Quaterniond quaternionOf(const glm::dmat4& rigid) {
  Eigen::Matrix3d turn;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) turn(r, c) = rigid[c][r];
  return Quaterniond(turn).normalized();
}

glm::dmat4 matrixOf(const Quaterniond& quaternion, const Vector3d& shift) {
  const Eigen::Matrix3d turn = quaternion.toRotationMatrix();
  glm::dmat4 matrix(1.0);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) matrix[c][r] = turn(r, c);
  for (int r = 0; r < 3; ++r) matrix[3][r] = shift[r];
  return matrix;
}

double angle_rad(const Quaterniond& q) { return 2.0 * std::atan2(q.vec().norm(), std::abs(q.w())); }

}  // namespace ew::registration::graph
