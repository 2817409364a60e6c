#pragma once

#include <ceres/rotation.h>

#include <Eigen/Geometry>

#include "graph/covariance.h"

namespace ew::registration::graph {

/// Where a subvolume lies: p -> turn (p - centre) + place. About a centre in its middle, so that a turn does not sweep it away.
struct Place {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  ///< stored x, y, z, w, as ceres::EigenQuaternionManifold expects
  Eigen::Vector3d at = Eigen::Vector3d::Zero();              ///< of the centre, in the world
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();          ///< in the subvolume's own frame

  [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return turn * (p - centre) + at; }
};

/// The turn of a unit quaternion as axis times angle.
template <class T>
Eigen::Matrix<T, 3, 1> turnOf(const Eigen::Quaternion<T>& q) {
  const T wxyz[4] = {q.w(), q.x(), q.y(), q.z()};
  Eigen::Matrix<T, 3, 1> turn;
  ceres::QuaternionToAngleAxis(wxyz, turn.data());
  return turn;
}

/// What an edge's measured M (fixed to moving) says too much: with E = T_a^-1 T_b M, which is the identity when the poses agree with M,
/// the residual is (E(c) - c, log of E's turn) in mm and rad, in the frame of the fixed subvolume, about the edge's centre c.
struct EdgeResidual {
  Eigen::Vector3d fixedCentre;   ///< c, from the centre of node a
  Eigen::Vector3d movingCentre;  ///< M(c), from the centre of node b
  Eigen::Quaterniond turn;       ///< of M
  Matrix6 whiten = Matrix6::Identity();

  template <class T>
  Eigen::Matrix<T, 6, 1> plain(const T* turnA, const T* atA, const T* turnB, const T* atB) const {
    const Eigen::Map<const Eigen::Quaternion<T>> qa(turnA);
    const Eigen::Map<const Eigen::Quaternion<T>> qb(turnB);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> pa(atA);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> pb(atB);
    const Eigen::Quaternion<T> back = qa.conjugate();
    const Eigen::Matrix<T, 3, 1> inWorld = qb * movingCentre.cast<T>().eval() + pb;
    Eigen::Matrix<T, 6, 1> residual;
    residual.template head<3>() = back * (inWorld - pa).eval() - fixedCentre.cast<T>();
    const Eigen::Quaternion<T> turned = back * qb * turn.cast<T>();
    residual.template tail<3>() = turnOf<T>(turned);
    return residual;
  }

  template <class T>
  bool operator()(const T* turnA, const T* atA, const T* turnB, const T* atB, T* residual) const {
    Eigen::Map<Eigen::Matrix<T, 6, 1>> out(residual);
    out = whiten.cast<T>() * plain(turnA, atA, turnB, atB);
    return true;
  }
};

}  // namespace ew::registration::graph
