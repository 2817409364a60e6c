#include "ew/registration/pose_graph.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "ew/core/elapsed.h"
#include "ew/core/order_statistics.h"
#include "graph/graph_inputs.h"
#include "graph/graph_verdict.h"
#include "graph/joints.h"
#include "graph/pose_solve.h"
#include "graph/starts.h"

namespace ew::registration {
namespace {

using namespace graph;

constexpr double kMedianSquare = 5.348;  // of chi square with six degrees of freedom

/// Covariances of images are often too hopeful. Loops tell by how much: the median of the whitened residuals, of which a tree would leave
/// 0. The factor by which they are to grow is at least 1.
double inflated(const Joints& joints, const Fit& fit, const std::vector<Pose>& poses) {
  const auto bridge = bridgesOf(joints.nodes.size() + 1, joints.links, fit.believed);
  std::vector<double> squares;
  std::vector<bool> looped(joints.all.size(), false);
  std::size_t pairs = 0;
  for (std::size_t j = 0; j < joints.all.size(); ++j) {
    if (!fit.believed[j] || bridge[j] || joints.all[j].kind == Kind::hold) continue;
    looped[j] = true;
    ++pairs;
    squares.push_back(
        (whitenerOf(joints.finalCovariance(joints.all[j], fit.varianceFactor)) * misfitOf(joints.all[j], poses).vector).squaredNorm());
  }
  if (pairs == 0) return fit.varianceFactor;
  // Unknowns of the loops: the nodes they touch, less one per connected group of them. A held node is as good as the world.
  std::vector<Link> merged = joints.links;
  for (Link& link : merged) {
    if (link.a < joints.nodes.size() && joints.nodes[link.a].fixed) link.a = joints.world;
    if (link.b < joints.nodes.size() && joints.nodes[link.b].fixed) link.b = joints.world;
  }
  std::vector<bool> touched(joints.nodes.size() + 1, false);
  for (std::size_t j = 0; j < joints.all.size(); ++j)
    if (looped[j]) touched[merged[j].a] = touched[merged[j].b] = true;
  const auto part = partsOf(joints.nodes.size() + 1, merged, looped);
  std::vector<bool> seen(joints.nodes.size() + 1, false);
  std::size_t unknowns = 0;
  for (std::size_t i = 0; i <= joints.nodes.size(); ++i) {
    if (!touched[i]) continue;
    const auto number = static_cast<std::size_t>(part[i]);
    if (seen[number])
      ++unknowns;
    else
      seen[number] = true;
  }
  const double redundancy = static_cast<double>(pairs - std::min(pairs, unknowns)) / static_cast<double>(pairs);
  if (redundancy < 0.05) return fit.varianceFactor;
  return fit.varianceFactor * std::max(1.0 / fit.varianceFactor, upperMedianOf(std::span(squares)) / (kMedianSquare * redundancy));
}

/// Along a tree of believed joints every other believed one closes a loop: its misfit there is the loop's error.
void measureClosure(const Joints& joints, const std::vector<bool>& believed, GraphResult& result) {
  std::vector<std::size_t> order;
  for (std::size_t j = 0; j < joints.all.size(); ++j)
    if (believed[j]) order.push_back(j);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return joints.all[a].trust > joints.all[b].trust; });
  const auto poses = joints.placedBy(joints.fixedFirst(order));
  for (const std::size_t j : order) {
    if (joints.all[j].kind == Kind::hold) continue;
    const Misfit misfit = misfitOf(joints.all[j], poses);
    if (misfit.mm < 1e-9 && misfit.deg < 1e-9) continue;
    result.closure_mm = std::max(result.closure_mm, misfit.mm);
    result.closure_deg = std::max(result.closure_deg, misfit.deg);
  }
}

/// Poses, and how each pair stands to them.
void reportPoses(const Joints& joints, const Fit& fit, const std::vector<bool>& bridge, const std::vector<Pose>& poses,
                 GraphResult& result) {
  const std::size_t n = joints.nodes.size();
  for (std::size_t i = 0; i < n; ++i) result.toWorld.push_back(joints.nodes[i].fixed ? joints.nodes[i].toWorld : transformOf(poses[i]));
  for (std::size_t i = 0; i < n; ++i) result.centre_mm.emplace_back(joints.centre[i].x(), joints.centre[i].y(), joints.centre[i].z());
  result.withoutInformation = joints.withoutInformation;
  result.edges.assign(joints.edges.size(), {});
  const double scale2 = joints.options.lossScale * joints.options.lossScale * 6.0;
  for (std::size_t j = 0; j < joints.all.size(); ++j) {
    const Joint& joint = joints.all[j];
    if (joint.kind == Kind::prior && !fit.believed[j]) result.wrongPriors.push_back(joint.index);
    if (joint.kind != Kind::pair) continue;
    const Misfit misfit = misfitOf(joint, poses);
    GraphEdgeReport& edge = result.edges[joint.index];
    edge.residual_mm = misfit.mm;
    edge.residual_deg = misfit.deg;
    edge.weight = 1.0 / (1.0 + (whitenerOf(joints.finalCovariance(joint, fit.varianceFactor)) * misfit.vector).squaredNorm() / scale2);
    edge.wrong = !fit.believed[j];
    edge.confirmed = fit.believed[j] && !bridge[j];
    if (edge.wrong) result.wrong.push_back(joint.index);
  }
  for (const std::size_t e : joints.withoutInformation) {
    const Misfit misfit = misfitOf({.index = e,
                                    .a = joints.edges[e].fixed,
                                    .b = joints.edges[e].moving,
                                    .aToB = rigidOf(renamed<EndB, EndA>(joints.edges[e].fixedToMoving)),
                                    .centre = vectorOf(joints.edges[e].centre_mm)},
                                   poses);
    result.edges[e].residual_mm = misfit.mm;
    result.edges[e].residual_deg = misfit.deg;
  }
}

/// A wrong joint and a bridge on the believed way between its ends lie on the same loops and on no other: either explains them. One that
/// is trusted more than twice as far is not suspected.
void reportSuspects(const Joints& joints, const std::vector<bool>& believed, const std::vector<bool>& bridge, GraphResult& result) {
  const std::size_t n = joints.nodes.size();
  std::vector<bool> suspect(joints.all.size(), false);
  for (std::size_t j = 0; j < joints.all.size(); ++j) {
    if (believed[j]) continue;
    for (const std::size_t other : pathBetween(n + 1, joints.links, believed, joints.all[j].a, joints.all[j].b))
      if (bridge[other] && joints.all[other].kind != Kind::hold && joints.all[other].trust < 2.0 * joints.all[j].trust)
        suspect[other] = true;
  }
  for (std::size_t j = 0; j < joints.all.size(); ++j) {
    if (!suspect[j]) continue;
    if (joints.all[j].kind == Kind::pair) result.suspects.push_back(joints.all[j].index);
    if (joints.all[j].kind == Kind::prior) result.suspectPriors.push_back(joints.all[j].index);
  }
}

void reportParts(const Joints& joints, const std::vector<bool>& believed, GraphResult& result) {
  const std::size_t n = joints.nodes.size();
  const auto part = partsOf(n + 1, joints.links, believed);
  std::vector<int> number(n + 1, -1);
  for (std::size_t i = 0; i < n; ++i) {
    int& mine = number[static_cast<std::size_t>(part[i])];
    if (mine < 0) mine = result.parts++;
    result.part.push_back(mine);
  }
}

/// Poses while they are sought, and what the solves said so far.
struct Search {
  const Joints& joints;
  Progress& progress;
  std::vector<Pose> poses = {};
  Fit fit = {};
  PoseDescent last = {};
  int iterations = 0;

  /// @return false when it was stopped
  bool take(PoseDescent descent) {
    iterations += descent.iterations;
    last = std::move(descent);
    return !last.cancelled;
  }

  /// From every start; what fits most joints is kept.
  bool findPoses() {
    double least = std::numeric_limits<double>::infinity();
    auto candidates = startsOf(joints);
    for (std::size_t s = 0; s < candidates.size(); ++s) {
      auto tried = std::move(candidates[s]);
      if (!take(searchPoses(joints, tried, progress))) return false;
      if (const double cost = joints.truncatedCost(tried); cost < least) {
        least = cost;
        poses = std::move(tried);
      }
      progress.report(say<"Placing subvolumes">(), 0.8 * static_cast<double>(s + 1) / static_cast<double>(candidates.size()));
    }
    return true;
  }

  /// Least squares over what is believed, until nothing that is believed is wrong and nothing wrong fits.
  bool settle() {
    for (int round = 0; round < 8; ++round) {
      std::vector<bool> next(joints.all.size());
      for (std::size_t j = 0; j < joints.all.size(); ++j) next[j] = !joints.isWrong(j, poses);
      if (round > 0 && next == fit.believed) return true;
      fit.believed = next;
      if (!take(fitPoses(joints, fit, false, poses, progress))) return false;
    }
    return true;
  }

  bool run() {
    if (!findPoses() || !settle()) return false;
    for (int round = 0; round < 2; ++round) {
      const double before = fit.varianceFactor;
      fit.varianceFactor = inflated(joints, fit, poses);
      if (fit.varianceFactor == before) break;
      if (!settle()) return false;
    }
    return take(fitPoses(joints, fit, true, poses, progress));
  }
};

Result<GraphResult> solve(const Joints& joints, Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  const auto stopped = [] { return failure(ErrorCode::cancelled, say<"The poses were not solved, as asked.">()); };
  progress.report(say<"Placing subvolumes">(), 0.0);
  if (progress.cancelRequested()) return stopped();
  Search search{.joints = joints, .progress = progress};
  if (!search.run()) return stopped();

  const std::vector<bool>& believed = search.fit.believed;
  const auto bridge = bridgesOf(joints.nodes.size() + 1, joints.links, believed);
  GraphResult result;
  result.stop = search.last.stop;
  result.iterations = search.iterations;
  result.covariance = std::move(search.last.covariance);
  result.undetermined = std::move(search.last.undetermined);
  result.varianceFactor = search.fit.varianceFactor;
  measureClosure(joints, believed, result);
  reportPoses(joints, search.fit, bridge, search.poses, result);
  reportSuspects(joints, believed, bridge, result);
  reportParts(joints, believed, result);
  judge(joints.nodes, joints.edges, result);
  progress.report(say<"Placing subvolumes">(), 1.0);
  result.seconds = secondsSince(begin);
  return result;
}

}  // namespace

Result<GraphResult> solveGraph(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const GraphOptions& options,
                               Progress& progress) {
  if (auto fine = checkGraph(nodes, edges, options); !fine) return passOn(fine.error());
  try {
    return solve(jointsOf(nodes, edges, options), progress);
  } catch (const std::exception& problem) {
    return failure(ErrorCode::internal, say<"The solver of poses failed (%1).">(verbatim(problem.what())));
  }
}

}  // namespace ew::registration
