#pragma once

#include <optional>
#include <vector>

#include "ew/core/pose.h"
#include "scanner/trajectory.h"

namespace ew::phantom {

/// What a tracker says about each image of a sweep.
struct TrackerPoses {
  std::vector<Pose> poses;               ///< as the tracker sees them; invalid ones have plausible numbers; time_s is the image's
  std::vector<double> unfilteredTime_s;  ///< when the images' arrival was noticed
};

/// Looks at a probe on its way with a tracker's errors: with image n, formed at n / framesPerSecond, comes the pose of latency_s before,
/// off by a normally distributed time, turned about the probe's origin and moved by normally distributed amounts. Round
/// (dropOutShare x frames) poses are INVALID, in runs of about five: half of the runs hold the last pose the tracker saw, half something
/// near the identity, as trackers do. Empty when cancelled.
[[nodiscard]] std::optional<TrackerPoses> track(const Trajectory& trajectory, const SweepRecipe& recipe, int threads, Progress& progress);

}  // namespace ew::phantom
