#include "graph/starts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace ew::registration::graph {
namespace {

constexpr int kRandomTrees = 64;
constexpr std::size_t kRandomTreesUpTo = 400;  // links: beyond, the chance of a tree without a wrong link is nil anyway

/// Per joint: how many short ways round it say the same (1 and more), or none does though there are some (-1), or there are none (0).
std::vector<int> evidenceOf(const Joints& joints) {
  const std::vector<bool> all(joints.all.size(), true);
  std::vector<std::vector<std::size_t>> at(joints.nodes.size() + 1);
  for (std::size_t j = 0; j < joints.all.size(); ++j) {
    at[joints.all[j].a].push_back(j);
    at[joints.all[j].b].push_back(j);
  }
  const auto walked = [&](std::size_t joint, std::size_t from) {  // from -> the other end
    return joints.all[joint].a == from ? renamed<frame::View, frame::View>(joints.all[joint].aToB)
                                       : renamed<frame::View, frame::View>(inverse(joints.all[joint].aToB));
  };
  const auto other = [&](std::size_t joint, std::size_t from) {
    return joints.all[joint].a == from ? joints.all[joint].b : joints.all[joint].a;
  };
  const auto tolerance2 = [&](std::size_t joint) {
    const Matrix6 covariance = joints.searchCovariance(joints.all[joint]);
    return std::pair(covariance.topLeftCorner<3, 3>().trace() / 3.0, covariance.bottomRightCorner<3, 3>().trace() / 3.0);
  };
  std::vector<int> found(joints.all.size(), 0);
  for (std::size_t j = 0; j < joints.all.size(); ++j) {
    const Joint& joint = joints.all[j];
    const auto check = [&](const std::vector<std::size_t>& path) {
      Rigid<frame::View, frame::View> around;
      std::size_t from = joint.a;
      auto [mm2, rad2] = tolerance2(j);
      for (const std::size_t step : path) {
        around = walked(step, from) * around;
        from = other(step, from);
        const auto [stepMm2, stepRad2] = tolerance2(step);
        mm2 += stepMm2;
        rad2 += stepRad2;
      }
      const Rigid<EndA, EndA> error = inverse(renamed<EndB, EndA>(around)) * joint.aToB;
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
    const auto path = pathBetween(joints.nodes.size() + 1, joints.links, all, joint.a, joint.b, j);
    if (!path.empty()) check(path);
  }
  return found;
}

}  // namespace

std::vector<std::vector<Pose>> startsOf(const Joints& joints) {
  std::vector<Pose> given(joints.nodes.size() + 1);
  for (std::size_t n = 0; n < joints.nodes.size(); ++n) given[n] = rigidOf(joints.nodes[n].toWorld);
  if (!joints.options.startFromEdges) return {given};

  std::vector<std::size_t> order(joints.all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto votes = evidenceOf(joints);
  const auto rank = [&](std::size_t j) { return votes[j] > 0 ? 2 : votes[j] == 0 ? 1 : 0; };
  const auto size = [&](std::size_t j) { return joints.all[j].covariance.topLeftCorner<3, 3>().trace(); };
  const auto better = [&](std::size_t a, std::size_t b) {
    if (rank(a) != rank(b)) return rank(a) > rank(b);
    if (joints.all[a].trust != joints.all[b].trust) return joints.all[a].trust > joints.all[b].trust;
    if (votes[a] != votes[b]) return votes[a] > votes[b];
    return size(a) < size(b);
  };
  std::vector<std::size_t> byEvidence = order;
  std::stable_sort(byEvidence.begin(), byEvidence.end(), better);
  std::vector<std::vector<Pose>> found{joints.placedBy(joints.fixedFirst(byEvidence))};

  const bool priors = std::any_of(joints.all.begin(), joints.all.end(), [](const Joint& joint) { return joint.kind == Kind::prior; });
  if (priors) {
    std::stable_partition(byEvidence.begin(), byEvidence.end(), [&](std::size_t j) { return joints.all[j].kind == Kind::prior; });
    found.push_back(joints.placedBy(joints.fixedFirst(byEvidence)));
  }
  // In a small graph with few wrong joints a tree drawn by lot often holds none of them; the best of many is a good start.
  if (joints.all.size() <= kRandomTreesUpTo) {
    std::mt19937_64 draw(1);
    std::vector<double> key(joints.all.size());
    double least = std::numeric_limits<double>::infinity();
    std::vector<Pose> best;
    for (int tree = 0; tree < kRandomTrees; ++tree) {
      for (std::size_t j = 0; j < joints.all.size(); ++j) {
        const double even = (static_cast<double>(draw() >> 11) + 0.5) * 0x1.0p-53;
        key[j] = -std::log(even) / std::max(0.05, joints.all[j].trust);  // trusted joints come first more often
      }
      std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
      auto poses = joints.placedBy(joints.fixedFirst(order));
      if (const double cost = joints.truncatedCost(poses); cost < least) {
        least = cost;
        best = std::move(poses);
      }
    }
    if (!best.empty()) found.push_back(std::move(best));
  }
  return found;
}

}  // namespace ew::registration::graph
