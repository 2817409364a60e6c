#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "ew/registration/pose_graph.h"
#include "graph/covariance.h"
#include "graph/links.h"
#include "graph/rigid_motion.h"

namespace ew::registration::graph {

enum class Kind { pair, prior, hold };

/// A node's pose; that of the world, which is the last node, is the identity.
using Pose = Rigid<frame::World, frame::View>;

struct EndA {};  ///< the own frame of the first node of a joint, mm: a pair's fixed volume
struct EndB {};  ///< of the second: its moving volume, or the world

/// What joins two nodes, the world being the last node: a pair, a tracker's pose, or a pose that is held.
struct Joint {
  Kind kind = Kind::pair;
  std::size_t index = 0;  ///< of the edge, or of the node
  std::size_t a = 0;
  std::size_t b = 0;
  Rigid<EndB, EndA> aToB;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< in a's frame
  Matrix6 covariance = Matrix6::Zero();
  double trust = 1.0;

  [[nodiscard]] Rigid<frame::World, EndA> aToWorld(const std::vector<Pose>& poses) const { return renamed<frame::World, EndA>(poses[a]); }
  [[nodiscard]] Rigid<frame::World, EndB> bToWorld(const std::vector<Pose>& poses) const { return renamed<frame::World, EndB>(poses[b]); }
};

/// How far a joint is from what the poses say.
struct Misfit {
  Vector6 vector = Vector6::Zero();  ///< mm at the joint's centre, then the turn, rad
  double mm = 0.0;
  double deg = 0.0;
};

/// @param poses one per node, the world's last
[[nodiscard]] Misfit misfitOf(const Joint& joint, const std::vector<Pose>& poses);

/// A graph as all its steps look at it. It does not change once it is made; `nodes`, `edges` and `options` belong to whoever asked.
struct Joints {
  std::span<const GraphNode> nodes;
  std::span<const GraphEdge> edges;
  const GraphOptions& options;
  std::size_t world = 0;                     ///< the node after the last
  std::vector<Joint> all = {};               ///< pairs in the order of the edges, then trackers' and held poses in that of the nodes
  std::vector<Link> links = {};              ///< one per joint
  std::vector<Matrix6> searchWhiten = {};    ///< one per joint: unit length is where it counts as wrong
  std::vector<Eigen::Vector3d> centre = {};  ///< one per node, the world's last: the middle of its joints' centres
  std::vector<std::size_t> withoutInformation = {};  ///< edges that are left out

  /// What a joint's covariance explains, and `wrongAbove` on top.
  [[nodiscard]] Matrix6 searchCovariance(const Joint& joint) const;
  /// Its covariance with the least error, `varianceFactor` times.
  [[nodiscard]] Matrix6 finalCovariance(const Joint& joint, double varianceFactor) const;
  /// Of a joint's misfit, 1 being where it counts as wrong.
  [[nodiscard]] double distance(std::size_t joint, const std::vector<Pose>& poses) const;
  [[nodiscard]] bool isWrong(std::size_t joint, const std::vector<Pose>& poses) const;
  /// The sum over all joints of trust times the squared distance, at most 1.
  [[nodiscard]] double truncatedCost(const std::vector<Pose>& poses) const;

  /// `order` with held poses before everything else.
  [[nodiscard]] std::vector<std::size_t> fixedFirst(std::vector<std::size_t> order) const;
  /// Poses along the spanning forest that takes joints greedily in this order.
  [[nodiscard]] std::vector<Pose> placedBy(std::span<const std::size_t> inOrder) const;
};

/// @param nodes, edges, options as checkGraph takes them; they outlive the answer
[[nodiscard]] Joints jointsOf(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const GraphOptions& options);

}  // namespace ew::registration::graph
