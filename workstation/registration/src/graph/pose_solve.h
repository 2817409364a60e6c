#pragma once

#include <vector>

#include "ew/core/progress.h"
#include "ew/registration/pose_graph.h"
#include "graph/joints.h"

namespace ew::registration::graph {

/// What a solve came to beside the poses.
struct PoseDescent {
  bool cancelled = false;
  StopReason stop = StopReason::notRun;  ///< of the last solve
  int iterations = 0;                    ///< of all solves
  std::vector<PoseCovariance> covariance;
  std::vector<std::size_t> undetermined;  ///< nodes left free to slide or turn; without a covariance then
};

/// What is believed, and how far.
struct Fit {
  std::vector<bool> believed;  ///< one per joint
  double varianceFactor = 1.0;
};

/// Descends over all joints with a loss that is made less and less convex (Geman and McClure), so that wrong joints lose their pull.
/// @param poses one per node, the world's last; the start, then the answer
[[nodiscard]] PoseDescent searchPoses(const Joints& joints, std::vector<Pose>& poses, Progress& progress);

/// Descends over what is believed, weighted by covariances, with a Cauchy loss.
[[nodiscard]] PoseDescent fitPoses(const Joints& joints, const Fit& fit, bool wantCovariance, std::vector<Pose>& poses, Progress& progress);

}  // namespace ew::registration::graph
