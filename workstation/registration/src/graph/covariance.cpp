#include "graph/covariance.h"

#include <Eigen/Dense>
#include <cmath>

namespace ew::registration::graph {
namespace {

constexpr double kUnknownVariance = 1e10;  // stands for an infinite one

Matrix6 matrixOf(const PoseCovariance& covariance) {
  Matrix6 matrix;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) matrix(r, c) = covariance[static_cast<std::size_t>(6 * r + c)];
  return matrix;
}

}  // namespace

Matrix6 finiteOf(const PoseCovariance& covariance) {
  Matrix6 matrix = matrixOf(covariance);
  for (int k = 0; k < 6; ++k) {
    if (matrix(k, k) < kUnknownVariance) continue;
    matrix.row(k).setZero();
    matrix.col(k).setZero();
    matrix(k, k) = kUnknownVariance;
  }
  return matrix;
}

bool saysNothing(const Matrix6& covariance) {
  for (int k = 0; k < 6; ++k)
    if (std::sqrt(covariance(k, k)) < (k < 3 ? kNothingKnown_mm : kNothingKnown_rad)) return false;
  return true;
}

Matrix6 whitenerOf(const Matrix6& covariance) {
  const Eigen::LLT<Matrix6> factor(covariance);
  return factor.matrixL().solve(Matrix6::Identity());
}

Result<void> checkCovariance(const PoseCovariance& covariance, const Message& whose) {
  const auto bad = [&](const Message& why) {
    return failure(ErrorCode::badField, say<"The covariance of %1 %2; a covariance is symmetric and no variance is negative.">(whose, why),
                   {{"field", "covariance"}});
  };
  const Matrix6 matrix = matrixOf(covariance);
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      if (std::isnan(matrix(r, c)) || (r != c && std::isinf(matrix(r, c)))) return bad(say<"has an entry that is not a number">());
  const Matrix6 finite = finiteOf(covariance);
  Vector6 deviation;
  for (int k = 0; k < 6; ++k) {
    if (finite(k, k) < 0.0) return bad(say<"has a negative variance">());
    deviation[k] = std::sqrt(finite(k, k));
  }
  Matrix6 correlation = Matrix6::Identity();
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) {
      const double scale = deviation[r] * deviation[c];
      if (std::abs(finite(r, c) - finite(c, r)) > 1e-6 * scale + 1e-300) return bad(say<"is not symmetric">());
      if (r == c) continue;
      if (scale <= 0.0 && finite(r, c) != 0.0) return bad(say<"correlates what does not vary">());
      correlation(r, c) = scale > 0.0 ? finite(r, c) / scale : 0.0;
    }
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(correlation, Eigen::EigenvaluesOnly);
  if (solver.eigenvalues()[0] < -1e-6) return bad(say<"has correlations that cannot be together">());
  return {};
}

}  // namespace ew::registration::graph
