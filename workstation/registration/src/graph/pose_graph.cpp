#include "ew/registration/pose_graph.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numbers>
#include <numeric>
#include <random>

#include "ew/core/frames.h"
#include "ew/core/numbers.h"
#include "graph/links.h"
#include "graph/pose_residual.h"

namespace ew::registration {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using graph::EdgeResidual;
using graph::kNone;
using graph::Link;
using graph::Matrix6;
using graph::Place;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kNothingKnown_mm = 1e3;   // a standard deviation from which on a translation counts as unknown
constexpr double kNothingKnown_rad = 3.0;  // and a turn
constexpr double kUnknownVariance = 1e10;  // stands for an infinite one
constexpr double kSigmas = 4.0;            // what a covariance explains
constexpr double kMedianSquare = 5.348;    // of chi square with six degrees of freedom
constexpr int kRandomTrees = 64;
constexpr std::size_t kRandomTreesUpTo = 400;  // links: beyond, the chance of a tree without a wrong link is nil anyway

struct Rigid {
  Quaterniond turn = Quaterniond::Identity();
  Vector3d shift = Vector3d::Zero();
  [[nodiscard]] Vector3d operator()(const Vector3d& p) const { return turn * p + shift; }
};
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

enum class Kind { pair, prior, hold };

/// What joins two nodes, the world being the last node: a pair, a tracker's pose, or a pose that is held.
struct Joint {
  Kind kind = Kind::pair;
  std::size_t index = 0;  // of the edge, or of the node
  std::size_t a = 0;
  std::size_t b = 0;
  Rigid aToB;
  Vector3d centre = Vector3d::Zero();  // in a's frame
  Matrix6 covariance = Matrix6::Zero();
  double trust = 1.0;
};

/// How far a joint is from what the poses say.
struct Misfit {
  Vector6 vector = Vector6::Zero();
  double mm = 0.0;
  double deg = 0.0;
};

Misfit misfitOf(const Joint& joint, const std::vector<Rigid>& poses) {
  const Rigid error = inverse(poses[joint.a]) * poses[joint.b] * joint.aToB;
  Misfit misfit;
  misfit.vector.head<3>() = error(joint.centre) - joint.centre;
  misfit.vector.tail<3>() = graph::turnOf<double>(error.turn);
  misfit.mm = misfit.vector.head<3>().norm();
  misfit.deg = angle_rad(error.turn) * kDegrees;
  return misfit;
}

/// A robust loss whose convexity is lowered step by step: Geman and McClure's m s / (m + s), a parabola for large m.
class GradedLoss final : public ceres::LossFunction {
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

class Solver {
 public:
  Solver(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const GraphOptions& options, Progress& progress)
      : nodes_(nodes), edges_(edges), options_(options), progress_(progress), world_(nodes.size()) {}

  Result<GraphResult> run();

 private:
  void collect();
  void centreNodes();
  [[nodiscard]] Matrix6 searchCovariance(const Joint& joint) const;
  [[nodiscard]] Matrix6 finalCovariance(const Joint& joint) const;
  [[nodiscard]] std::vector<int> evidence() const;
  [[nodiscard]] std::vector<Rigid> placedBy(std::span<const std::size_t> inOrder) const;
  [[nodiscard]] std::vector<std::size_t> fixedFirst(std::vector<std::size_t> order) const;
  [[nodiscard]] double distance(std::size_t joint, const std::vector<Rigid>& poses) const;
  [[nodiscard]] double truncatedCost(const std::vector<Rigid>& poses) const;
  [[nodiscard]] std::vector<std::vector<Rigid>> starts() const;
  [[nodiscard]] bool graded(std::vector<Rigid>& poses);
  [[nodiscard]] bool settle(std::vector<Rigid>& poses);
  [[nodiscard]] bool solve(std::vector<Rigid>& poses, bool final, ceres::LossFunction* loss, int iterations, bool wantCovariance);
  void covariances(ceres::Problem& problem, const std::vector<Place>& places, const std::vector<bool>& held);
  [[nodiscard]] bool isWrong(std::size_t joint, const std::vector<Rigid>& poses) const;
  void closure();
  void inflate(const std::vector<Rigid>& poses);
  void report(const std::vector<Rigid>& poses);
  void judge();
  [[nodiscard]] std::string nameOfNode(std::size_t node) const;
  [[nodiscard]] std::string nameOfEdge(std::size_t edge) const;
  [[nodiscard]] std::string nameOfJoint(const Joint& joint) const;

  std::span<const GraphNode> nodes_;
  std::span<const GraphEdge> edges_;
  const GraphOptions& options_;
  Progress& progress_;
  std::size_t world_;
  std::vector<Joint> joints_;
  std::vector<Link> links_;
  std::vector<Matrix6> searchWhiten_;  // per joint
  std::vector<bool> believed_;         // per joint
  std::vector<Vector3d> centre_;       // per node, the world's last
  std::vector<std::size_t> suspectJoints_;
  std::vector<std::size_t> unchecked_;  // edges
  GraphResult result_;
};

Matrix6 matrixOf(const PoseCovariance& covariance) {
  Matrix6 matrix;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) matrix(r, c) = covariance[static_cast<std::size_t>(6 * r + c)];
  return matrix;
}

/// A covariance with infinite entries on the diagonal made finite: nothing is known there, nor of what goes with it.
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

/// Upper triangular would do as well: any W with W^T W = covariance^-1.
Matrix6 whitenerOf(const Matrix6& covariance) {
  const Eigen::LLT<Matrix6> factor(covariance);
  return factor.matrixL().solve(Matrix6::Identity());
}

Result<void> checkCovariance(const PoseCovariance& covariance, const std::string& whose) {
  const auto bad = [&](const std::string& why) {
    return failure(ErrorCode::badField,
                   "The covariance of " + whose + " " + why + "; a covariance is symmetric and no variance is negative.",
                   {{"field", "covariance"}});
  };
  const Matrix6 matrix = matrixOf(covariance);
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      if (std::isnan(matrix(r, c)) || (r != c && std::isinf(matrix(r, c)))) return bad("has an entry that is not a number");
  const Matrix6 finite = finiteOf(covariance);
  Vector6 deviation;
  for (int k = 0; k < 6; ++k) {
    if (finite(k, k) < 0.0) return bad("has a negative variance");
    deviation[k] = std::sqrt(finite(k, k));
  }
  Matrix6 correlation = Matrix6::Identity();
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) {
      const double scale = deviation[r] * deviation[c];
      if (std::abs(finite(r, c) - finite(c, r)) > 1e-6 * scale + 1e-300) return bad("is not symmetric");
      if (r == c) continue;
      if (scale <= 0.0 && finite(r, c) != 0.0) return bad("correlates what does not vary");
      correlation(r, c) = scale > 0.0 ? finite(r, c) / scale : 0.0;
    }
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(correlation, Eigen::EigenvaluesOnly);
  if (solver.eigenvalues()[0] < -1e-6) return bad("has correlations that cannot be together");
  return {};
}

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string text;
  const std::size_t shown = std::min(names.size(), kMost);
  for (std::size_t n = 0; n < shown; ++n) {
    if (n > 0) text += n + 1 == names.size() ? " and " : ", ";
    text += names[n];
  }
  if (shown < names.size()) text += " and " + std::to_string(names.size() - shown) + " more";
  return text;
}

std::string rounded(double value) { return textOf(std::round(value * 10.0) / 10.0); }

std::string Solver::nameOfNode(std::size_t node) const {
  return nodes_[node].name.empty() ? "subvolume " + std::to_string(node + 1) : "'" + nodes_[node].name + "'";
}
std::string Solver::nameOfEdge(std::size_t edge) const {
  return nameOfNode(edges_[edge].fixed) + " with " + nameOfNode(edges_[edge].moving);
}
std::string Solver::nameOfJoint(const Joint& joint) const {
  return joint.kind == Kind::pair ? nameOfEdge(joint.index) : "the tracker's pose of " + nameOfNode(joint.index);
}

void Solver::collect() {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const GraphEdge& edge = edges_[e];
    Joint joint{.kind = Kind::pair, .index = e, .a = edge.fixed, .b = edge.moving, .aToB = rigidOf(edge.fixedToMoving)};
    joint.centre = vectorOf(edge.centre_mm);
    joint.trust = edge.trust;
    if (edge.covariance) joint.covariance = finiteOf(*edge.covariance);
    if (!edge.covariance || edge.trust <= 0.0 || saysNothing(joint.covariance)) {
      result_.withoutInformation.push_back(e);
      continue;
    }
    joints_.push_back(joint);
  }
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    Joint joint{.kind = Kind::hold, .index = n, .a = n, .b = world_, .aToB = rigidOf(nodes_[n].toWorld)};
    if (nodes_[n].fixed) {
      joints_.push_back(joint);
    } else if (nodes_[n].prior) {
      joint.kind = Kind::prior;
      joint.centre = vectorOf(nodes_[n].priorCentre_mm);
      joint.covariance = finiteOf(*nodes_[n].prior);
      if (!saysNothing(joint.covariance)) joints_.push_back(joint);
    }
  }
  for (const Joint& joint : joints_) {
    links_.push_back({joint.a, joint.b});
    searchWhiten_.push_back(whitenerOf(searchCovariance(joint)));
  }
  believed_.assign(joints_.size(), true);
}

void Solver::centreNodes() {
  centre_.assign(nodes_.size() + 1, Vector3d::Zero());
  std::vector<double> count(nodes_.size() + 1, 0.0);
  for (const Joint& joint : joints_) {
    if (joint.kind == Kind::hold) continue;
    centre_[joint.a] += joint.centre;
    count[joint.a] += 1.0;
    if (joint.kind == Kind::prior) continue;
    centre_[joint.b] += joint.aToB(joint.centre);
    count[joint.b] += 1.0;
  }
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (count[n] > 0.0) centre_[n] /= count[n];
    result_.centre_mm.emplace_back(centre_[n].x(), centre_[n].y(), centre_[n].z());
  }
}

/// Unit length of the whitened residual is where a joint counts as wrong: what its covariance explains, and wrongAbove on top.
Matrix6 Solver::searchCovariance(const Joint& joint) const {
  Matrix6 covariance = kSigmas * kSigmas * joint.covariance;
  const double turn = options_.wrongAbove_deg / kDegrees;
  for (int k = 0; k < 6; ++k) covariance(k, k) += k < 3 ? options_.wrongAbove_mm * options_.wrongAbove_mm : turn * turn;
  return covariance;
}

Matrix6 Solver::finalCovariance(const Joint& joint) const {
  Matrix6 covariance = joint.covariance;
  const double turn = options_.leastError_deg / kDegrees;
  for (int k = 0; k < 6; ++k) covariance(k, k) += k < 3 ? options_.leastError_mm * options_.leastError_mm : turn * turn;
  return result_.varianceFactor * covariance;
}

double Solver::distance(std::size_t joint, const std::vector<Rigid>& poses) const {
  return (searchWhiten_[joint] * misfitOf(joints_[joint], poses).vector).norm();
}

double Solver::truncatedCost(const std::vector<Rigid>& poses) const {
  double sum = 0.0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (joints_[j].kind == Kind::hold) continue;
    const double d = distance(j, poses);
    sum += joints_[j].trust * std::min(1.0, d * d);
  }
  return sum;
}

/// Per joint: how many short ways round it say the same (1 and more), or none does though there are some (-1), or there are none (0).
std::vector<int> Solver::evidence() const {
  const std::vector<bool> all(joints_.size(), true);
  std::vector<std::vector<std::size_t>> at(nodes_.size() + 1);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    at[joints_[j].a].push_back(j);
    at[joints_[j].b].push_back(j);
  }
  const auto walked = [&](std::size_t joint, std::size_t from) {  // from -> the other end
    return joints_[joint].a == from ? joints_[joint].aToB : inverse(joints_[joint].aToB);
  };
  const auto other = [&](std::size_t joint, std::size_t from) { return joints_[joint].a == from ? joints_[joint].b : joints_[joint].a; };
  const auto tolerance2 = [&](std::size_t joint) {
    const Matrix6 covariance = searchCovariance(joints_[joint]);
    return std::pair(covariance.topLeftCorner<3, 3>().trace() / 3.0, covariance.bottomRightCorner<3, 3>().trace() / 3.0);
  };
  std::vector<int> found(joints_.size(), 0);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    const auto check = [&](const std::vector<std::size_t>& path) {
      Rigid around;
      std::size_t from = joint.a;
      auto [mm2, rad2] = tolerance2(j);
      for (const std::size_t step : path) {
        around = walked(step, from) * around;
        from = other(step, from);
        const auto [stepMm2, stepRad2] = tolerance2(step);
        mm2 += stepMm2;
        rad2 += stepRad2;
      }
      const Rigid error = inverse(around) * joint.aToB;
      const bool same = (error(joint.centre) - joint.centre).squaredNorm() < mm2 && std::pow(angle_rad(error.turn), 2) < rad2;
      found[j] = same ? std::max(found[j], 0) + 1 : (found[j] > 0 ? found[j] : -1);
    };
    int loops = 0;
    for (const std::size_t first : at[joint.a]) {
      if (first == j || loops >= 64) continue;
      const std::size_t middle = other(first, joint.a);
      if (middle == joint.b) {  // the same two once more
        check({first});
        ++loops;
        continue;
      }
      for (const std::size_t second : at[middle])
        if (second != first && second != j && other(second, middle) == joint.b) {
          check({first, second});
          ++loops;
        }
    }
    if (loops > 0) continue;
    const auto path = graph::pathBetween(nodes_.size() + 1, links_, all, joint.a, joint.b, j);
    if (!path.empty()) check(path);
  }
  return found;
}

std::vector<std::size_t> Solver::fixedFirst(std::vector<std::size_t> order) const {
  std::stable_partition(order.begin(), order.end(), [&](std::size_t j) { return joints_[j].kind == Kind::hold; });
  return order;
}

std::vector<Rigid> Solver::placedBy(std::span<const std::size_t> inOrder) const {
  std::vector<Rigid> poses(nodes_.size() + 1);
  const std::size_t roots[] = {world_};
  for (const auto& step : graph::spanningForest(nodes_.size() + 1, links_, inOrder, roots)) {
    if (step.parent == kNone) {
      if (step.node != world_) poses[step.node] = rigidOf(nodes_[step.node].toWorld);
      continue;
    }
    const Joint& joint = joints_[step.link];
    poses[step.node] = joint.a == step.node ? poses[joint.b] * joint.aToB : poses[joint.a] * inverse(joint.aToB);
  }
  return poses;
}

std::vector<std::vector<Rigid>> Solver::starts() const {
  std::vector<Rigid> given(nodes_.size() + 1);
  for (std::size_t n = 0; n < nodes_.size(); ++n) given[n] = rigidOf(nodes_[n].toWorld);
  if (!options_.startFromEdges) return {given};

  std::vector<std::size_t> order(joints_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto votes = evidence();
  const auto rank = [&](std::size_t j) { return votes[j] > 0 ? 2 : votes[j] == 0 ? 1 : 0; };
  const auto size = [&](std::size_t j) { return joints_[j].covariance.topLeftCorner<3, 3>().trace(); };
  const auto better = [&](std::size_t a, std::size_t b) {
    if (rank(a) != rank(b)) return rank(a) > rank(b);
    if (joints_[a].trust != joints_[b].trust) return joints_[a].trust > joints_[b].trust;
    if (votes[a] != votes[b]) return votes[a] > votes[b];
    return size(a) < size(b);
  };
  std::vector<std::size_t> byEvidence = order;
  std::stable_sort(byEvidence.begin(), byEvidence.end(), better);
  std::vector<std::vector<Rigid>> found{placedBy(fixedFirst(byEvidence))};

  const bool priors = std::any_of(joints_.begin(), joints_.end(), [](const Joint& joint) { return joint.kind == Kind::prior; });
  if (priors) {
    std::stable_partition(byEvidence.begin(), byEvidence.end(), [&](std::size_t j) { return joints_[j].kind == Kind::prior; });
    found.push_back(placedBy(fixedFirst(byEvidence)));
  }
  // In a small graph with few wrong joints a tree drawn by lot often holds none of them; the best of many is a good start.
  if (joints_.size() <= kRandomTreesUpTo) {
    std::mt19937_64 draw(1);
    std::vector<double> key(joints_.size());
    double least = std::numeric_limits<double>::infinity();
    std::vector<Rigid> best;
    for (int tree = 0; tree < kRandomTrees; ++tree) {
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        const double even = (static_cast<double>(draw() >> 11) + 0.5) * 0x1.0p-53;
        key[j] = -std::log(even) / std::max(0.05, joints_[j].trust);  // trusted joints come first more often
      }
      std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
      auto poses = placedBy(fixedFirst(order));
      if (const double cost = truncatedCost(poses); cost < least) {
        least = cost;
        best = std::move(poses);
      }
    }
    if (!best.empty()) found.push_back(std::move(best));
  }
  return found;
}

bool Solver::solve(std::vector<Rigid>& poses, bool final, ceres::LossFunction* loss, int iterations, bool wantCovariance) {
  const std::size_t n = nodes_.size();
  std::vector<Place> places(n + 1);
  for (std::size_t i = 0; i <= n; ++i) places[i] = {.turn = poses[i].turn, .at = poses[i](centre_[i]), .centre = centre_[i]};

  ceres::Problem::Options own;
  own.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  own.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::EigenQuaternionManifold turns;
  std::vector<std::unique_ptr<ceres::LossFunction>> losses;
  ceres::Problem problem(own);
  std::vector<bool> used(n + 1, false);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    if (joint.kind == Kind::hold || (final && !believed_[j])) continue;
    auto* cost = new ceres::AutoDiffCostFunction<EdgeResidual, 6, 4, 3, 4, 3>(
        new EdgeResidual{.fixedCentre = joint.centre - centre_[joint.a],
                         .movingCentre = joint.aToB(joint.centre) - centre_[joint.b],
                         .turn = joint.aToB.turn,
                         .whiten = final ? whitenerOf(finalCovariance(joint)) : searchWhiten_[j]});
    losses.push_back(std::make_unique<ceres::ScaledLoss>(loss, joint.trust, ceres::DO_NOT_TAKE_OWNERSHIP));
    problem.AddResidualBlock(cost, losses.back().get(), places[joint.a].turn.coeffs().data(), places[joint.a].at.data(),
                             places[joint.b].turn.coeffs().data(), places[joint.b].at.data());
    used[joint.a] = used[joint.b] = true;
  }

  // The gauge: nodes that are held, else the world where a prior joins it, else the first node of the part.
  const std::vector<bool> counts = final ? believed_ : std::vector<bool>(joints_.size(), true);
  const auto part = graph::partsOf(n + 1, links_, counts);
  std::vector<bool> held(n + 1, false);
  std::vector<bool> gauged(n + 2, false);
  held[world_] = true;
  gauged[static_cast<std::size_t>(part[world_])] = true;
  for (std::size_t i = 0; i < n; ++i) {
    if (nodes_[i].fixed) held[i] = true;
    if (gauged[static_cast<std::size_t>(part[i])]) continue;
    gauged[static_cast<std::size_t>(part[i])] = true;
    held[i] = true;
  }
  bool anythingFree = false;
  for (std::size_t i = 0; i <= n; ++i) {
    if (!used[i]) continue;
    problem.SetManifold(places[i].turn.coeffs().data(), &turns);
    if (held[i]) {
      problem.SetParameterBlockConstant(places[i].turn.coeffs().data());
      problem.SetParameterBlockConstant(places[i].at.data());
    } else {
      anythingFree = true;
    }
  }
  if (!anythingFree) {
    result_.stop = StopReason::converged;
    if (wantCovariance) result_.covariance.assign(n, PoseCovariance{});
    return true;
  }

  AskToStop ask(progress_);
  ceres::Solver::Options how;
  how.max_num_iterations = iterations;
  how.num_threads = 1;  // the answer must not depend on the machine
  how.logging_type = ceres::SILENT;
  how.minimizer_progress_to_stdout = false;
  how.function_tolerance = 1e-12;
  how.parameter_tolerance = 1e-12;
  how.gradient_tolerance = 1e-12;
  how.callbacks = {&ask};
  how.linear_solver_type = n <= 30 ? ceres::DENSE_NORMAL_CHOLESKY : ceres::SPARSE_NORMAL_CHOLESKY;
  how.dense_linear_algebra_library_type = ceres::EIGEN;
  how.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  how.use_nonmonotonic_steps = false;
  ceres::Solver::Summary summary;
  ceres::Solve(how, &problem, &summary);
  result_.iterations += static_cast<int>(summary.iterations.size());
  if (summary.termination_type == ceres::USER_FAILURE || progress_.cancelRequested()) return false;
  result_.stop = summary.termination_type == ceres::CONVERGENCE      ? StopReason::converged
                 : summary.termination_type == ceres::NO_CONVERGENCE ? StopReason::iterationLimit
                                                                     : StopReason::singular;
  if (summary.IsSolutionUsable())
    for (std::size_t i = 0; i < n; ++i) {
      if (!used[i] || held[i]) continue;
      poses[i].turn = places[i].turn.normalized();
      poses[i].shift = places[i].at - poses[i].turn * centre_[i];
    }
  if (wantCovariance && result_.stop != StopReason::singular) covariances(problem, places, held);
  return true;
}

void Solver::covariances(ceres::Problem& problem, const std::vector<Place>& places, const std::vector<bool>& held) {
  const std::size_t n = nodes_.size();
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
    result_.undetermined = free;
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
      result_.undetermined.push_back(free[k]);
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c) found[free[k]][static_cast<std::size_t>(6 * r + c)] = 0.5 * (block(r, c) + block(c, r));
  }
  if (result_.undetermined.empty()) result_.covariance = std::move(found);
}

bool Solver::graded(std::vector<Rigid>& poses) {
  GradedLoss loss;
  for (const double m : {16.0, 4.0, 1.0, 0.5}) {
    loss.m = m;
    if (!solve(poses, false, &loss, 15, false)) return false;
  }
  return true;
}

bool Solver::isWrong(std::size_t joint, const std::vector<Rigid>& poses) const {
  if (joints_[joint].kind == Kind::hold) return false;
  const Misfit misfit = misfitOf(joints_[joint], poses);
  return (misfit.mm > options_.wrongAbove_mm || misfit.deg > options_.wrongAbove_deg) &&
         (searchWhiten_[joint] * misfit.vector).norm() > 1.0;
}

/// Least squares over what is believed, until nothing that is believed is wrong and nothing wrong fits.
bool Solver::settle(std::vector<Rigid>& poses) {
  ceres::CauchyLoss loss(options_.lossScale * std::sqrt(6.0));
  for (int round = 0; round < 8; ++round) {
    std::vector<bool> next(joints_.size());
    for (std::size_t j = 0; j < joints_.size(); ++j) next[j] = !isWrong(j, poses);
    if (round > 0 && next == believed_) return true;
    believed_ = next;
    if (!solve(poses, true, &loss, options_.iterations, false)) return false;
  }
  return true;
}

/// Covariances of images are often too hopeful. Loops tell by how much: the median of the whitened residuals, of which a tree would leave
/// 0.
void Solver::inflate(const std::vector<Rigid>& poses) {
  const auto bridge = graph::bridgesOf(nodes_.size() + 1, links_, believed_);
  std::vector<double> squares;
  std::vector<bool> looped(joints_.size(), false);
  std::size_t pairs = 0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (!believed_[j] || bridge[j] || joints_[j].kind == Kind::hold) continue;
    looped[j] = true;
    ++pairs;
    squares.push_back((whitenerOf(finalCovariance(joints_[j])) * misfitOf(joints_[j], poses).vector).squaredNorm());
  }
  if (pairs == 0) return;
  // Unknowns of the loops: the nodes they touch, less one per connected group of them. A held node is as good as the world.
  std::vector<Link> merged = links_;
  for (Link& link : merged) {
    if (link.a < nodes_.size() && nodes_[link.a].fixed) link.a = world_;
    if (link.b < nodes_.size() && nodes_[link.b].fixed) link.b = world_;
  }
  std::vector<bool> touched(nodes_.size() + 1, false);
  for (std::size_t j = 0; j < joints_.size(); ++j)
    if (looped[j]) touched[merged[j].a] = touched[merged[j].b] = true;
  const auto part = graph::partsOf(nodes_.size() + 1, merged, looped);
  std::vector<bool> seen(nodes_.size() + 1, false);
  std::size_t unknowns = 0;
  for (std::size_t i = 0; i <= nodes_.size(); ++i) {
    if (!touched[i]) continue;
    const auto number = static_cast<std::size_t>(part[i]);
    if (seen[number])
      ++unknowns;
    else
      seen[number] = true;
  }
  const double redundancy = static_cast<double>(pairs - std::min(pairs, unknowns)) / static_cast<double>(pairs);
  if (redundancy < 0.05) return;
  std::nth_element(squares.begin(), squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2), squares.end());
  result_.varianceFactor *= std::max(1.0 / result_.varianceFactor, squares[squares.size() / 2] / (kMedianSquare * redundancy));
}

/// Along a tree of believed joints every other believed one closes a loop: its misfit there is the loop's error.
void Solver::closure() {
  std::vector<std::size_t> order;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    if (believed_[j]) order.push_back(j);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return joints_[a].trust > joints_[b].trust; });
  const auto poses = placedBy(fixedFirst(order));
  for (const std::size_t j : order) {
    if (joints_[j].kind == Kind::hold) continue;
    const Misfit misfit = misfitOf(joints_[j], poses);
    if (misfit.mm < 1e-9 && misfit.deg < 1e-9) continue;
    result_.closure_mm = std::max(result_.closure_mm, misfit.mm);
    result_.closure_deg = std::max(result_.closure_deg, misfit.deg);
  }
}

void Solver::report(const std::vector<Rigid>& poses) {
  const std::size_t n = nodes_.size();
  for (std::size_t i = 0; i < n; ++i) result_.toWorld.push_back(nodes_[i].fixed ? nodes_[i].toWorld : matrixOf(poses[i]));
  result_.edges.assign(edges_.size(), {});
  const auto bridge = graph::bridgesOf(n + 1, links_, believed_);
  const double scale2 = options_.lossScale * options_.lossScale * 6.0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    if (joint.kind == Kind::prior && !believed_[j]) result_.wrongPriors.push_back(joint.index);
    if (joint.kind != Kind::pair) continue;
    const Misfit misfit = misfitOf(joint, poses);
    GraphEdgeReport& edge = result_.edges[joint.index];
    edge.residual_mm = misfit.mm;
    edge.residual_deg = misfit.deg;
    edge.weight = 1.0 / (1.0 + (whitenerOf(finalCovariance(joint)) * misfit.vector).squaredNorm() / scale2);
    edge.wrong = !believed_[j];
    edge.confirmed = believed_[j] && !bridge[j];
    if (edge.wrong) result_.wrong.push_back(joint.index);
    if (believed_[j] && bridge[j]) unchecked_.push_back(joint.index);
  }
  for (const std::size_t e : result_.withoutInformation) {
    const Misfit misfit = misfitOf({.index = e,
                                    .a = edges_[e].fixed,
                                    .b = edges_[e].moving,
                                    .aToB = rigidOf(edges_[e].fixedToMoving),
                                    .centre = vectorOf(edges_[e].centre_mm)},
                                   poses);
    result_.edges[e].residual_mm = misfit.mm;
    result_.edges[e].residual_deg = misfit.deg;
  }
  // A wrong joint and a bridge on the believed way between its ends lie on the same loops and on no other: either explains them. One that
  // is trusted more than twice as far is not suspected.
  std::vector<bool> suspect(joints_.size(), false);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (believed_[j]) continue;
    for (const std::size_t other : graph::pathBetween(n + 1, links_, believed_, joints_[j].a, joints_[j].b))
      if (bridge[other] && joints_[other].kind != Kind::hold && joints_[other].trust < 2.0 * joints_[j].trust) suspect[other] = true;
  }
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (!suspect[j]) continue;
    suspectJoints_.push_back(j);
    if (joints_[j].kind == Kind::pair) result_.suspects.push_back(joints_[j].index);
    if (joints_[j].kind == Kind::prior) result_.suspectPriors.push_back(joints_[j].index);
  }
  const auto part = graph::partsOf(n + 1, links_, believed_);
  std::vector<int> number(n + 1, -1);
  for (std::size_t i = 0; i < n; ++i) {
    int& mine = number[static_cast<std::size_t>(part[i])];
    if (mine < 0) mine = result_.parts++;
    result_.part.push_back(mine);
  }
}

void Solver::judge() {
  std::vector<std::string> sentences;
  const auto say = [&](const std::string& sentence) { sentences.push_back(sentence); };
  Verdict verdict = Verdict::aligned;
  std::size_t confirmed = 0;
  for (const GraphEdgeReport& edge : result_.edges) confirmed += edge.confirmed ? 1 : 0;

  if (nodes_.size() == 1) {
    say("There is one subvolume; it stays where it is.");
  } else if (result_.parts > 1) {
    verdict = Verdict::cannotTell;
    std::vector<std::string> parts(static_cast<std::size_t>(result_.parts));
    std::vector<std::size_t> size(parts.size(), 0);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const auto p = static_cast<std::size_t>(result_.part[i]);
      ++size[p];
      if (size[p] <= 8) parts[p] += (parts[p].empty() ? "" : ", ") + nameOfNode(i);
    }
    std::string text;
    for (std::size_t p = 0; p < parts.size() && p < 8; ++p)
      text += (p > 0 ? "; " : "") + parts[p] + (size[p] > 8 ? " and " + std::to_string(size[p] - 8) + " more" : "");
    say("Nothing joins these " + std::to_string(result_.parts) + " parts: " + text + (result_.parts > 8 ? "; and more" : "") +
        ". How they lie to each other is not known: match a pair between them.");
  }
  if (!result_.undetermined.empty() && nodes_.size() > 1) {
    verdict = Verdict::cannotTell;
    std::vector<std::string> names;
    for (const std::size_t i : result_.undetermined) names.push_back(nameOfNode(i));
    say("The pairs leave " + listed(names) + " free to slide or turn.");
  }
  if (!result_.wrong.empty() || !result_.wrongPriors.empty()) {
    std::vector<std::string> names;
    for (const std::size_t e : result_.wrong)
      names.push_back(nameOfEdge(e) + " (by " + rounded(result_.edges[e].residual_mm) + " mm and " +
                      rounded(result_.edges[e].residual_deg) + " degrees)");
    for (const std::size_t i : result_.wrongPriors) names.push_back("the tracker's pose of " + nameOfNode(i));
    say((names.size() == 1 ? "Wrong, and left out, is " : "Wrong, and left out, are ") + listed(names) + ".");
  }
  if (!suspectJoints_.empty()) {
    verdict = Verdict::cannotTell;
    std::vector<std::string> names;
    for (const std::size_t j : suspectJoints_) names.push_back(nameOfJoint(joints_[j]));
    say("It could as well be " + listed(names) +
        ": they lie on the same loop and nothing else tells them apart. Match another pair across it.");
  } else if (result_.wrong.size() > confirmed) {
    verdict = Verdict::notAligned;
    say("More pairs contradict each other than agree.");
  }
  if (!unchecked_.empty() && nodes_.size() > 1) {
    std::vector<std::string> names;
    bool doubtful = false;
    for (const std::size_t e : unchecked_) {
      names.push_back(nameOfEdge(e));
      doubtful = doubtful || edges_[e].trust < 0.5;
    }
    say((names.size() == 1 ? "No loop checks the pair " : "No loop checks the pairs ") + listed(names) + ": were " +
        (names.size() == 1 ? "it" : "one of them") + " wrong, nothing would show it.");
    if (doubtful && verdict == Verdict::aligned) verdict = Verdict::cannotTell;
  }
  if (!result_.withoutInformation.empty()) {
    std::vector<std::string> names;
    for (const std::size_t e : result_.withoutInformation) names.push_back(nameOfEdge(e));
    say("Without information, and left out: " + listed(names) + ".");
  }
  if (result_.stop == StopReason::iterationLimit || result_.stop == StopReason::singular) {
    verdict = verdict == Verdict::aligned ? Verdict::cannotTell : verdict;
    say("The solution did not settle; allow more iterations.");
  }
  if (verdict == Verdict::aligned && nodes_.size() > 1)
    sentences.insert(sentences.begin(), std::to_string(nodes_.size()) + " subvolumes lie together, " + std::to_string(confirmed) +
                                            (confirmed == 1 ? " pair" : " pairs") + " confirmed by loops.");
  result_.verdict = verdict;
  for (const auto& sentence : sentences) result_.reason += (result_.reason.empty() ? "" : " ") + sentence;
}

Result<GraphResult> Solver::run() {
  const auto begin = std::chrono::steady_clock::now();
  const auto stopped = [] { return failure(ErrorCode::cancelled, "The poses were not solved, as asked."); };
  keepCeresQuiet();
  collect();
  centreNodes();
  progress_.report("Placing subvolumes", 0.0);
  if (progress_.cancelRequested()) return stopped();

  std::vector<Rigid> best;
  double least = std::numeric_limits<double>::infinity();
  auto candidates = starts();
  for (std::size_t s = 0; s < candidates.size(); ++s) {
    auto poses = std::move(candidates[s]);
    if (!graded(poses)) return stopped();
    if (const double cost = truncatedCost(poses); cost < least) {
      least = cost;
      best = std::move(poses);
    }
    progress_.report("Placing subvolumes", 0.8 * static_cast<double>(s + 1) / static_cast<double>(candidates.size()));
  }
  if (!settle(best)) return stopped();
  for (int round = 0; round < 2; ++round) {
    const double before = result_.varianceFactor;
    inflate(best);
    if (result_.varianceFactor == before) break;
    if (!settle(best)) return stopped();
  }
  ceres::CauchyLoss loss(options_.lossScale * std::sqrt(6.0));
  if (!solve(best, true, &loss, options_.iterations, true)) return stopped();
  closure();
  report(best);
  judge();
  progress_.report("Placing subvolumes", 1.0);
  result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result_;
}

Result<void> check(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const GraphOptions& options) {
  if (nodes.empty()) return failure(ErrorCode::emptyVolume, "There is no subvolume to place; add at least one.");
  for (const auto& [value, name] : {std::pair{options.lossScale, "lossScale"},
                                    {options.wrongAbove_mm, "wrongAbove_mm"},
                                    {options.wrongAbove_deg, "wrongAbove_deg"},
                                    {options.leastError_mm, "leastError_mm"},
                                    {options.leastError_deg, "leastError_deg"}})
    if (!std::isfinite(value) || value <= 0.0)
      return failure(ErrorCode::badField, std::string("The option ") + name + " must be above 0.", {{"field", name}});
  if (options.iterations < 1) return failure(ErrorCode::badField, "At least one iteration is needed.", {{"field", "iterations"}});
  const auto nameOfNode = [&](std::size_t n) {
    return nodes[n].name.empty() ? "subvolume " + std::to_string(n + 1) : "'" + nodes[n].name + "'";
  };
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (auto rigid = checkRigid(nodes[n].toWorld); !rigid)
      return failure(ErrorCode::notRigid, "The pose of " + nameOfNode(n) + " cannot be used: " + rigid.error().sentence);
    if (!finite(nodes[n].priorCentre_mm))
      return failure(ErrorCode::badField, "The centre of the tracker's covariance of " + nameOfNode(n) + " is not a number.",
                     {{"field", "priorCentre_mm"}});
    if (nodes[n].prior)
      if (auto fine = checkCovariance(*nodes[n].prior, "the tracker's pose of " + nameOfNode(n)); !fine) return fine;
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const GraphEdge& edge = edges[e];
    const std::string number = "Pair " + std::to_string(e + 1);
    if (edge.fixed >= nodes.size() || edge.moving >= nodes.size())
      return failure(ErrorCode::badField,
                     number + " names a subvolume that does not exist; there are " + std::to_string(nodes.size()) + ".",
                     {{"field", "edges"}});
    if (edge.fixed == edge.moving)
      return failure(ErrorCode::badField, number + " joins " + nameOfNode(edge.fixed) + " with itself.", {{"field", "edges"}});
    const std::string name = nameOfNode(edge.fixed) + " with " + nameOfNode(edge.moving);
    if (auto rigid = checkRigid(edge.fixedToMoving); !rigid)
      return failure(ErrorCode::notRigid, "The transform of the pair " + name + " cannot be used: " + rigid.error().sentence);
    if (!finite(edge.centre_mm) || !std::isfinite(edge.trust) || edge.trust < 0.0 || edge.trust > 1.0)
      return failure(ErrorCode::badField, "The pair " + name + " has a centre that is not a number or a trust outside 0..1.",
                     {{"field", "edges"}});
    if (edge.covariance)
      if (auto fine = checkCovariance(*edge.covariance, "the pair " + name); !fine) return fine;
  }
  return {};
}

}  // namespace

Result<GraphResult> solveGraph(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const GraphOptions& options,
                               Progress& progress) {
  if (auto fine = check(nodes, edges, options); !fine) return passOn(fine.error());
  try {
    return Solver(nodes, edges, options, progress).run();
  } catch (const std::exception& problem) {
    return failure(ErrorCode::internal, std::string("The solver of poses failed (") + problem.what() + ").");
  }
}

}  // namespace ew::registration
