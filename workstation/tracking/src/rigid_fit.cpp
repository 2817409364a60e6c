#include "rigid_fit.h"

#include <algorithm>
#include <cmath>

namespace ew {

RigidFit fitRigid(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to, int without) {
  Eigen::Vector3d fromCentre = Eigen::Vector3d::Zero(), toCentre = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (std::size_t n = 0; n < from.size(); ++n) {
    if (static_cast<int>(n) == without) continue;
    fromCentre += from[n];
    toCentre += to[n];
    count += 1.0;
  }
  fromCentre /= count;
  toCentre /= count;
  Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
  for (std::size_t n = 0; n < from.size(); ++n)
    if (static_cast<int>(n) != without) h += (from[n] - fromCentre) * (to[n] - toCentre).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(h, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  RigidFit found;
  found.turn = svd.matrixV() * Eigen::Vector3d(1.0, 1.0, sign).asDiagonal() * svd.matrixU().transpose();
  found.shift = toCentre - found.turn * fromCentre;
  return found;
}

Spread spreadOf(std::span<const Eigen::Vector3d> places, int without) {
  Spread found;
  double count = 0.0;
  for (std::size_t n = 0; n < places.size(); ++n) {
    if (static_cast<int>(n) == without) continue;
    found.centre += places[n];
    count += 1.0;
  }
  found.centre /= count;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (std::size_t n = 0; n < places.size(); ++n)
    if (static_cast<int>(n) != without) second += (places[n] - found.centre) * (places[n] - found.centre).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second / count);
  for (int k = 0; k < 3; ++k) {
    found.axes.col(k) = solver.eigenvectors().col(2 - k);
    found.deviation[k] = std::sqrt(std::max(0.0, solver.eigenvalues()[2 - k]));
  }
  return found;
}

Eigen::Matrix3d turnOf(const glm::dmat4& matrix) {
  Eigen::Matrix3d turn;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) turn(r, c) = matrix[c][r];
  return turn;
}

glm::dmat4 matrixOf(const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift) {
  const Eigen::Matrix3d square = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  glm::dmat4 matrix(1.0);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) matrix[c][r] = square(r, c);
  for (int r = 0; r < 3; ++r) matrix[3][r] = shift[r];
  return matrix;
}

}  // namespace ew
