#include "graph/pose_solve.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <memory>
#include <mutex>

#include "graph/pose_residual.h"

namespace ew::registration::graph {
namespace {

/// A robust loss whose convexity is lowered step by step: Geman and McClure's m s / (m + s), a parabola for large m.
class GemanMcClureLoss final : public ceres::LossFunction {
 public:
  double m = 1.0;
  void Evaluate(double s, double out[3]) const override {
    const double t = m / (m + s);
    out[0] = t * s;
    out[1] = t * t;
    out[2] = -2.0 * t * t / (m + s);
  }
};

class AskToStop final : public ceres::IterationCallback {
 public:
  explicit AskToStop(const Progress& progress) : progress_(progress) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return progress_.cancelRequested() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const Progress& progress_;
};

/// Ceres logs through glog, which writes to the error stream of whoever did not set it up. What it has to say is in its summary.
void keepCeresQuiet() {
  static std::once_flag once;
  std::call_once(once, [] { FLAGS_minloglevel = google::GLOG_FATAL; });
}

/// From the normal equations at the solution.
void addCovariances(ceres::Problem& problem, const std::vector<Place>& places, const std::vector<bool>& held, PoseDescent& descent) {
  const std::size_t n = places.size() - 1;
  ceres::Problem::EvaluateOptions what;
  what.apply_loss_function = true;
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < n; ++i) {
    auto* turn = const_cast<double*>(places[i].turn.coeffs().data());
    if (held[i] || !problem.HasParameterBlock(turn)) continue;
    free.push_back(i);
    what.parameter_blocks.push_back(turn);
    what.parameter_blocks.push_back(const_cast<double*>(places[i].at.data()));
  }
  ceres::CRSMatrix jacobian;
  if (!problem.Evaluate(what, nullptr, nullptr, nullptr, &jacobian)) return;
  using Sparse = Eigen::SparseMatrix<double>;
  const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>> rows(
      jacobian.num_rows, jacobian.num_cols, static_cast<Eigen::Index>(jacobian.values.size()), jacobian.rows.data(), jacobian.cols.data(),
      jacobian.values.data());
  const Sparse j = rows;
  const Sparse normal = j.transpose() * j;
  const Eigen::SimplicialLDLT<Sparse> factor(normal);
  if (factor.info() != Eigen::Success || factor.vectorD().minCoeff() <= 0.0) {
    descent.undetermined = free;
    return;
  }
  std::vector<PoseCovariance> found(n, PoseCovariance{});
  for (std::size_t k = 0; k < free.size(); ++k) {
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(jacobian.num_cols, 6);
    for (int c = 0; c < 6; ++c) unit(static_cast<Eigen::Index>(6 * k) + c, c) = 1.0;
    const Eigen::MatrixXd column = factor.solve(unit);
    Matrix6 block = column.middleRows(static_cast<Eigen::Index>(6 * k), 6);  // half the turn about the world's axes, then the place
    Matrix6 order = Matrix6::Zero();
    for (int c = 0; c < 3; ++c) {
      order(c, 3 + c) = 1.0;
      order(3 + c, c) = 2.0;
    }
    block = order * block * order.transpose();
    if (!block.allFinite() || std::sqrt(block.topLeftCorner<3, 3>().diagonal().maxCoeff()) > kNothingKnown_mm ||
        std::sqrt(block.bottomRightCorner<3, 3>().diagonal().maxCoeff()) > kNothingKnown_rad)
      descent.undetermined.push_back(free[k]);
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c) found[free[k]][static_cast<std::size_t>(6 * r + c)] = 0.5 * (block(r, c) + block(c, r));
  }
  if (descent.undetermined.empty()) descent.covariance = std::move(found);
}

/// One solve: the places of all nodes, and the joints between them as Ceres sees them.
class PoseProblem {
 public:
  /// @param fit of what is believed, with its own covariance; null: of all joints, with the tolerance of the search
  PoseProblem(const Joints& joints, const Fit* fit, ceres::LossFunction& loss, const std::vector<Pose>& poses);

  /// Descends to where the sum of losses is least.
  void solve(int iterations, bool wantCovariance, Progress& progress, std::vector<Pose>& poses, PoseDescent& descent);

 private:
  static ceres::Problem::Options ownership();
  void addJoint(const Joint& joint, const Matrix6& whiten, ceres::LossFunction& loss);
  void holdGauge(const std::vector<bool>& counts);
  [[nodiscard]] bool fixHeld();
  [[nodiscard]] ceres::Solver::Options solverOptions(int iterations) const;
  void readBack(std::vector<Pose>& poses) const;

  const Joints& joints_;
  std::size_t n_;  ///< nodes; the world comes behind them
  std::vector<Place> places_;
  std::vector<bool> used_;  ///< by a joint
  std::vector<bool> held_;
  ceres::EigenQuaternionManifold turns_;
  std::vector<std::unique_ptr<ceres::LossFunction>> losses_;
  ceres::Problem problem_;  ///< refers to all above
};

PoseProblem::PoseProblem(const Joints& joints, const Fit* fit, ceres::LossFunction& loss, const std::vector<Pose>& poses)
    : joints_(joints), n_(joints.nodes.size()), places_(n_ + 1), used_(n_ + 1, false), held_(n_ + 1, false), problem_(ownership()) {
  for (std::size_t i = 0; i <= n_; ++i) places_[i] = {.turn = poses[i].turn, .at = poses[i](joints.centre[i]), .centre = joints.centre[i]};
  for (std::size_t j = 0; j < joints.all.size(); ++j) {
    const Joint& joint = joints.all[j];
    if (joint.kind == Kind::hold || (fit != nullptr && !fit->believed[j])) continue;
    addJoint(joint, fit != nullptr ? whitenerOf(joints.finalCovariance(joint, fit->varianceFactor)) : joints.searchWhiten[j], loss);
  }
  holdGauge(fit != nullptr ? fit->believed : std::vector<bool>(joints.all.size(), true));
}

ceres::Problem::Options PoseProblem::ownership() {
  ceres::Problem::Options own;
  own.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  own.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  return own;
}

void PoseProblem::addJoint(const Joint& joint, const Matrix6& whiten, ceres::LossFunction& loss) {
  auto* cost = new ceres::AutoDiffCostFunction<EdgeResidual, 6, 4, 3, 4, 3>(
      new EdgeResidual{.fixedCentre = joint.centre - joints_.centre[joint.a],
                       .movingCentre = joint.aToB(joint.centre) - joints_.centre[joint.b],
                       .turn = joint.aToB.turn,
                       .whiten = whiten});
  losses_.push_back(std::make_unique<ceres::ScaledLoss>(&loss, joint.trust, ceres::DO_NOT_TAKE_OWNERSHIP));
  problem_.AddResidualBlock(cost, losses_.back().get(), places_[joint.a].turn.coeffs().data(), places_[joint.a].at.data(),
                            places_[joint.b].turn.coeffs().data(), places_[joint.b].at.data());
  used_[joint.a] = used_[joint.b] = true;
}

/// Nodes that are held, else the world where a prior joins it, else the first node of the part.
/// @param counts which joints make nodes one part
void PoseProblem::holdGauge(const std::vector<bool>& counts) {
  const auto part = partsOf(n_ + 1, joints_.links, counts);
  std::vector<bool> gauged(n_ + 2, false);
  held_[joints_.world] = true;
  gauged[static_cast<std::size_t>(part[joints_.world])] = true;
  for (std::size_t i = 0; i < n_; ++i) {
    if (joints_.nodes[i].fixed) held_[i] = true;
    if (gauged[static_cast<std::size_t>(part[i])]) continue;
    gauged[static_cast<std::size_t>(part[i])] = true;
    held_[i] = true;
  }
}

/// @return whether anything is left to be moved
bool PoseProblem::fixHeld() {
  bool anythingFree = false;
  for (std::size_t i = 0; i <= n_; ++i) {
    if (!used_[i]) continue;
    problem_.SetManifold(places_[i].turn.coeffs().data(), &turns_);
    if (held_[i]) {
      problem_.SetParameterBlockConstant(places_[i].turn.coeffs().data());
      problem_.SetParameterBlockConstant(places_[i].at.data());
    } else {
      anythingFree = true;
    }
  }
  return anythingFree;
}

ceres::Solver::Options PoseProblem::solverOptions(int iterations) const {
  ceres::Solver::Options how;
  how.max_num_iterations = iterations;
  how.num_threads = 1;  // the answer must not depend on the machine
  how.logging_type = ceres::SILENT;
  how.minimizer_progress_to_stdout = false;
  how.function_tolerance = 1e-12;
  how.parameter_tolerance = 1e-12;
  how.gradient_tolerance = 1e-12;
  how.linear_solver_type = n_ <= 30 ? ceres::DENSE_NORMAL_CHOLESKY : ceres::SPARSE_NORMAL_CHOLESKY;
  how.dense_linear_algebra_library_type = ceres::EIGEN;
  how.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  how.use_nonmonotonic_steps = false;
  return how;
}

void PoseProblem::solve(int iterations, bool wantCovariance, Progress& progress, std::vector<Pose>& poses, PoseDescent& descent) {
  if (!fixHeld()) {
    descent.stop = StopReason::converged;
    if (wantCovariance) descent.covariance.assign(n_, PoseCovariance{});
    return;
  }
  AskToStop ask(progress);
  ceres::Solver::Options how = solverOptions(iterations);
  how.callbacks = {&ask};
  ceres::Solver::Summary summary;
  ceres::Solve(how, &problem_, &summary);
  descent.iterations += static_cast<int>(summary.iterations.size());
  if (summary.termination_type == ceres::USER_FAILURE || progress.cancelRequested()) {
    descent.cancelled = true;
    return;
  }
  descent.stop = summary.termination_type == ceres::CONVERGENCE      ? StopReason::converged
                 : summary.termination_type == ceres::NO_CONVERGENCE ? StopReason::iterationLimit
                                                                     : StopReason::singular;
  if (summary.IsSolutionUsable()) readBack(poses);
  if (wantCovariance && descent.stop != StopReason::singular) addCovariances(problem_, places_, held_, descent);
}

void PoseProblem::readBack(std::vector<Pose>& poses) const {
  for (std::size_t i = 0; i < n_; ++i) {
    if (!used_[i] || held_[i]) continue;
    poses[i].turn = places_[i].turn.normalized();
    poses[i].shift = places_[i].at - poses[i].turn * joints_.centre[i];
  }
}

}  // namespace

PoseDescent searchPoses(const Joints& joints, std::vector<Pose>& poses, Progress& progress) {
  keepCeresQuiet();
  PoseDescent descent;
  GemanMcClureLoss loss;
  for (const double m : {16.0, 4.0, 1.0, 0.5}) {
    loss.m = m;
    PoseProblem(joints, nullptr, loss, poses).solve(15, false, progress, poses, descent);
    if (descent.cancelled) break;
  }
  return descent;
}

PoseDescent fitPoses(const Joints& joints, const Fit& fit, bool wantCovariance, std::vector<Pose>& poses, Progress& progress) {
  keepCeresQuiet();
  PoseDescent descent;
  ceres::CauchyLoss loss(joints.options.lossScale * std::sqrt(6.0));
  PoseProblem(joints, &fit, loss, poses).solve(joints.options.iterations, wantCovariance, progress, poses, descent);
  return descent;
}

}  // namespace ew::registration::graph
