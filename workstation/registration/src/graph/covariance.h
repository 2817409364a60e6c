#pragma once

#include <Eigen/Core>

#include "ew/core/result.h"
#include "ew/registration/rigid.h"

namespace ew::registration::graph {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

inline constexpr double kNothingKnown_mm = 1e3;   ///< a standard deviation from which on a translation counts as unknown
inline constexpr double kNothingKnown_rad = 3.0;  ///< and a turn

/// A covariance with infinite entries on the diagonal made finite: nothing is known there, nor of what goes with it.
[[nodiscard]] Matrix6 finiteOf(const PoseCovariance& covariance);

/// Whether it leaves every translation and every turn unknown.
[[nodiscard]] bool saysNothing(const Matrix6& covariance);

/// Upper triangular would do as well: any W with W^T W = covariance^-1.
[[nodiscard]] Matrix6 whitenerOf(const Matrix6& covariance);

/// @param whose for the sentence, as in "the pair 'left' with 'right'"
/// @error badField, when it is not symmetric, has an entry that is no number (infinite is allowed on the diagonal), a negative variance or
/// correlations that cannot be together
[[nodiscard]] Result<void> checkCovariance(const PoseCovariance& covariance, const Message& whose);

}  // namespace ew::registration::graph
