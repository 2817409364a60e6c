#include "graph/rigid_motion.h"

#include <cmath>

namespace ew::registration::graph {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Rigid operator*(const Rigid& b, const Rigid& a) { return {(b.turn * a.turn).normalized(), b(a.shift)}; }

Rigid inverse(const Rigid& a) {
  const Quaterniond back = a.turn.conjugate();
  return {back, -(back * a.shift)};
}

Vector3d vectorOf(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

Rigid rigidOf(const glm::dmat4& matrix) {
  Eigen::Matrix3d turn;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) turn(r, c) = matrix[c][r];
  return {Quaterniond(turn).normalized(), {matrix[3][0], matrix[3][1], matrix[3][2]}};
}

glm::dmat4 matrixOf(const Rigid& rigid) {
  const Eigen::Matrix3d turn = rigid.turn.toRotationMatrix();
  glm::dmat4 matrix(1.0);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) matrix[c][r] = turn(r, c);
  for (int r = 0; r < 3; ++r) matrix[3][r] = rigid.shift[r];
  return matrix;
}

double angle_rad(const Quaterniond& q) { return 2.0 * std::atan2(q.vec().norm(), std::abs(q.w())); }

}  // namespace ew::registration::graph
