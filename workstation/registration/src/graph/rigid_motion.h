#pragma once

#include <Eigen/Geometry>
#include <glm/glm.hpp>

#include "ew/core/frames.h"

namespace ew::registration::graph {

/// p -> turn p + shift, mm: a rigid Transform<To, From> as the solver takes it.
template <class To, class From>
struct Rigid {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return turn * p + shift; }
};
template <class C, class B, class A>
[[nodiscard]] Rigid<C, A> operator*(const Rigid<C, B>& bToC, const Rigid<B, A>& aToB) {
  return {(bToC.turn * aToB.turn).normalized(), bToC(aToB.shift)};
}
template <class B, class A>
[[nodiscard]] Rigid<A, B> inverse(const Rigid<B, A>& aToB) {
  const Eigen::Quaterniond back = aToB.turn.conjugate();
  return {back, -(back * aToB.shift)};
}
/// As for Transform: the same numbers between frames of other names.
template <class To, class From, class OldTo, class OldFrom>
[[nodiscard]] Rigid<To, From> renamed(const Rigid<OldTo, OldFrom>& rigid) {
  return {rigid.turn, rigid.shift};
}

[[nodiscard]] Eigen::Vector3d vectorOf(const glm::dvec3& p);
[[nodiscard]] Eigen::Quaterniond quaternionOf(const glm::dmat4& rigid);
[[nodiscard]] glm::dmat4 matrixOf(const Eigen::Quaterniond& turn, const Eigen::Vector3d& shift);
/// @param aToB rigid
template <class B, class A>
[[nodiscard]] Rigid<B, A> rigidOf(const Transform<B, A>& aToB) {
  return {quaternionOf(aToB.matrix), vectorOf(glm::dvec3(aToB.matrix[3]))};
}
template <class B, class A>
[[nodiscard]] Transform<B, A> transformOf(const Rigid<B, A>& aToB) {
  return {matrixOf(aToB.turn, aToB.shift)};
}

/// Of the turn, 0 to pi.
[[nodiscard]] double angle_rad(const Eigen::Quaterniond& q);

}  // namespace ew::registration::graph
