#include "graph/joints.h"

#include <algorithm>
#include <numbers>

#include "graph/pose_residual.h"

namespace ew::registration::graph {
namespace {

using Eigen::Vector3d;

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kSigmas = 4.0;  // what a covariance explains

void collect(Joints& joints) {
  for (std::size_t e = 0; e < joints.edges.size(); ++e) {
    const GraphEdge& edge = joints.edges[e];
    Joint joint{
        .kind = Kind::pair, .index = e, .a = edge.fixed, .b = edge.moving, .aToB = rigidOf(renamed<EndB, EndA>(edge.fixedToMoving))};
    joint.centre = vectorOf(edge.centre_mm);
    joint.trust = edge.trust;
    if (edge.covariance) joint.covariance = finiteOf(*edge.covariance);
    if (!edge.covariance || edge.trust <= 0.0 || saysNothing(joint.covariance)) {
      joints.withoutInformation.push_back(e);
      continue;
    }
    joints.all.push_back(joint);
  }
  for (std::size_t n = 0; n < joints.nodes.size(); ++n) {
    Joint joint{.kind = Kind::hold, .index = n, .a = n, .b = joints.world, .aToB = rigidOf(renamed<EndB, EndA>(joints.nodes[n].toWorld))};
    if (joints.nodes[n].fixed) {
      joints.all.push_back(joint);
    } else if (joints.nodes[n].prior) {
      joint.kind = Kind::prior;
      joint.centre = vectorOf(joints.nodes[n].priorCentre_mm);
      joint.covariance = finiteOf(*joints.nodes[n].prior);
      if (!saysNothing(joint.covariance)) joints.all.push_back(joint);
    }
  }
  for (const Joint& joint : joints.all) {
    joints.links.push_back({joint.a, joint.b});
    joints.searchWhiten.push_back(whitenerOf(joints.searchCovariance(joint)));
  }
}

void centreNodes(Joints& joints) {
  joints.centre.assign(joints.nodes.size() + 1, Vector3d::Zero());
  std::vector<double> count(joints.nodes.size() + 1, 0.0);
  for (const Joint& joint : joints.all) {
    if (joint.kind == Kind::hold) continue;
    joints.centre[joint.a] += joint.centre;
    count[joint.a] += 1.0;
    if (joint.kind == Kind::prior) continue;
    joints.centre[joint.b] += joint.aToB(joint.centre);
    count[joint.b] += 1.0;
  }
  for (std::size_t n = 0; n < joints.nodes.size(); ++n)
    if (count[n] > 0.0) joints.centre[n] /= count[n];
}

}  // namespace

Misfit misfitOf(const Joint& joint, const std::vector<Pose>& poses) {
  const Rigid<EndA, EndA> error = inverse(joint.aToWorld(poses)) * joint.bToWorld(poses) * joint.aToB;
  Misfit misfit;
  misfit.vector.head<3>() = error(joint.centre) - joint.centre;
  misfit.vector.tail<3>() = turnOf<double>(error.turn);
  misfit.mm = misfit.vector.head<3>().norm();
  misfit.deg = angle_rad(error.turn) * kDegrees;
  return misfit;
}

Matrix6 Joints::searchCovariance(const Joint& joint) const {
  Matrix6 covariance = kSigmas * kSigmas * joint.covariance;
  const double turn = options.wrongAbove_deg / kDegrees;
  for (int k = 0; k < 6; ++k) covariance(k, k) += k < 3 ? options.wrongAbove_mm * options.wrongAbove_mm : turn * turn;
  return covariance;
}

Matrix6 Joints::finalCovariance(const Joint& joint, double varianceFactor) const {
  Matrix6 covariance = joint.covariance;
  const double turn = options.leastError_deg / kDegrees;
  for (int k = 0; k < 6; ++k) covariance(k, k) += k < 3 ? options.leastError_mm * options.leastError_mm : turn * turn;
  return varianceFactor * covariance;
}

double Joints::distance(std::size_t joint, const std::vector<Pose>& poses) const {
  return (searchWhiten[joint] * misfitOf(all[joint], poses).vector).norm();
}

double Joints::truncatedCost(const std::vector<Pose>& poses) const {
  double sum = 0.0;
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (all[j].kind == Kind::hold) continue;
    const double d = distance(j, poses);
    sum += all[j].trust * std::min(1.0, d * d);
  }
  return sum;
}

bool Joints::isWrong(std::size_t joint, const std::vector<Pose>& poses) const {
  if (all[joint].kind == Kind::hold) return false;
  const Misfit misfit = misfitOf(all[joint], poses);
  return (misfit.mm > options.wrongAbove_mm || misfit.deg > options.wrongAbove_deg) && (searchWhiten[joint] * misfit.vector).norm() > 1.0;
}

std::vector<std::size_t> Joints::fixedFirst(std::vector<std::size_t> order) const {
  std::stable_partition(order.begin(), order.end(), [&](std::size_t j) { return all[j].kind == Kind::hold; });
  return order;
}

std::vector<Pose> Joints::placedBy(std::span<const std::size_t> inOrder) const {
  std::vector<Pose> poses(nodes.size() + 1);
  const std::size_t roots[] = {world};
  for (const auto& step : spanningForest(nodes.size() + 1, links, inOrder, roots)) {
    if (step.parent == kNone) {
      if (step.node != world) poses[step.node] = rigidOf(nodes[step.node].toWorld);
      continue;
    }
    const Joint& joint = all[step.link];
    poses[step.node] = joint.a == step.node ? renamed<frame::World, frame::View>(joint.bToWorld(poses) * joint.aToB)
                                            : renamed<frame::World, frame::View>(joint.aToWorld(poses) * inverse(joint.aToB));
  }
  return poses;
}

Joints jointsOf(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const GraphOptions& options) {
  Joints joints{.nodes = nodes, .edges = edges, .options = options, .world = nodes.size()};
  collect(joints);
  centreNodes(joints);
  return joints;
}

}  // namespace ew::registration::graph
