#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

#include "ew/core/frames.h"
#include "ew/tracking/tool_reading.h"

namespace ew {

/// A rotation and a translation in Eigen's numbers.
struct RigidFit {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return turn * p + shift; }
};

/// The rigid motion that takes `from` to `to` with the least sum of squares. Source: Arun, Huang and Blostein, IEEE PAMI 9(5), 1987, with
/// the guard against mirrors of Umeyama, IEEE PAMI 13(4), 1991. @param without index that takes no part; -1: all do
[[nodiscard]] RigidFit fitRigid(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to, int without = -1);

/// How places are spread: root mean square along the principal axes, widest first.
struct Spread {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns
  Eigen::Vector3d deviation = Eigen::Vector3d::Zero();
};
[[nodiscard]] Spread spreadOf(std::span<const Eigen::Vector3d> places, int without = -1);

[[nodiscard]] inline Eigen::Vector3d eigenOf(const glm::dvec3& p) { return {p.x, p.y, p.z}; }
[[nodiscard]] inline glm::dvec3 glmOf(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
[[nodiscard]] Eigen::Matrix3d turnOf(const glm::dmat4& matrix);
[[nodiscard]] glm::dmat4 matrixOf(const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift);

}  // namespace ew
