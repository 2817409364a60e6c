#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/registration/rigid.h"

namespace ew::registration {

/// A subvolume whose pose (its own mm to the world's) is sought.
struct GraphNode {
  std::string name;
  Transform<frame::World, frame::View> toWorld = {};  ///< where to start; with a prior, what the tracker said
  /// How far the tracker is believed, in the subvolume's own frame about priorCentre_mm; absent: the pose is only a start. A tracker's pose
  /// that contradicts the pairs is named and left out like a wrong pair.
  std::optional<PoseCovariance> prior = {};
  glm::dvec3 priorCentre_mm{0.0};
  bool fixed = false;  ///< holds the gauge: never moves
};

/// What registering two of them found.
struct GraphEdge {
  std::size_t fixed = 0;  ///< index of the node
  std::size_t moving = 0;
  Transform<frame::Moving, frame::Fixed> fixedToMoving = {};
  std::optional<PoseCovariance> covariance = {};  ///< about `centre_mm`; absent, or infinite on the diagonal throughout: an edge
                                                  ///< without information, named and left out
  glm::dvec3 centre_mm{0.0};                      ///< of the overlap, in the fixed volume's frame
  double trust = 1.0;                             ///< 0..1 from the verdict; 0 leaves it out
};

struct GraphOptions {
  double lossScale = 2.0;       ///< of the robust loss, in standard deviations
  double wrongAbove_mm = 3.0;   ///< an edge whose residual at its centre is larger, or
  double wrongAbove_deg = 3.0;  ///< whose turn is, and whose covariance does not explain it, is named wrong
  double leastError_mm = 0.1;   ///< added to every covariance: living tissue is not rigid, whatever the images of one pair say
  double leastError_deg = 0.1;
  int iterations = 100;
  bool startFromEdges = true;  ///< nodes without prior start where the most trusted edges put them (spanning tree), not at toWorld
};

struct GraphEdgeReport {
  double residual_mm = 0.0;  ///< at the edge's centre
  double residual_deg = 0.0;
  double weight = 0.0;  ///< of the robust loss, 0..1
  bool wrong = false;
  bool confirmed = false;  ///< lies on a loop of believed edges and priors: another way round says the same
};

struct GraphResult {
  Verdict verdict = Verdict::cannotTell;
  Message reason;                                             ///< names wrong pairs and disconnected parts by the nodes' names
  std::vector<Transform<frame::World, frame::View>> toWorld;  ///< one per node
  std::vector<GraphEdgeReport> edges;                         ///< one per edge
  std::vector<int> part;  ///< one per node: parts that no believed edge or prior joins have different numbers
  int parts = 0;
  std::vector<std::size_t> wrong;  ///< indices of edges
  /// Edges that could be wrong in place of one in `wrong`: every loop through that one runs through them too. The verdict is cannotTell
  /// then.
  std::vector<std::size_t> suspects;
  std::vector<std::size_t> wrongPriors;    ///< indices of nodes whose tracker's pose contradicts the pairs
  std::vector<std::size_t> suspectPriors;  ///< the same, of nodes' tracker poses
  std::vector<std::size_t> undetermined;   ///< indices of nodes that the pairs leave free to slide or turn
  std::vector<std::size_t> withoutInformation;
  /// One per node, relative to the gauge (0 there): along and about the world's axes at `centre_mm`; empty when singular. Larger than the
  /// edges' own say when loops close worse than those promise.
  std::vector<PoseCovariance> covariance;
  std::vector<glm::dvec3> centre_mm;  ///< one per node, in its own frame: the middle of its edges' centres
  double varianceFactor = 1.0;        ///< by which the edges' covariances proved too small, at least 1
  double closure_mm = 0.0;            ///< worst error around a cycle of believed edges before the solve; 0 without a cycle
  double closure_deg = 0.0;
  StopReason stop = StopReason::notRun;
  int iterations = 0;
  double seconds = 0.0;
};

/// Poses of all subvolumes together, by nonlinear least squares (Ceres) over relative poses with a robust loss. In each part the gauge is
/// held by its fixed node or prior, else by its first node.
/// @error badField (an index outside, a covariance that is not one, a matrix that is not finite), notRigid, emptyVolume (no node),
/// cancelled
[[nodiscard]] Result<GraphResult> solveGraph(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges,
                                             const GraphOptions& options, Progress& progress);

}  // namespace ew::registration
