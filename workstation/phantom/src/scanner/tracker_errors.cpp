#include "scanner/tracker_errors.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "ew/core/parallel.h"

namespace ew::phantom {
namespace {

constexpr double kTrackerDegree_rad = std::numbers::pi / 180.0;
constexpr int kLongestRun = 9;

enum Stream : std::int64_t { shift = 101, turn, lateness, arrival, runs };

/// Whether each frame is lost: exactly `lost` of them, in runs of 1 to kLongestRun where there is room.
std::vector<bool> dropOuts(int frames, int lost, std::uint64_t seed) {
  std::vector<bool> out(static_cast<std::size_t>(frames), false);
  std::int64_t draw = 0;
  while (lost > 0) {
    const int begin = static_cast<int>(evenAt(seed, Stream::runs, draw++) * frames);
    int length = 1 + static_cast<int>(evenAt(seed, Stream::runs, draw++) * kLongestRun);
    for (int n = 0; n < frames && length > 0 && lost > 0; ++n) {
      const auto at = static_cast<std::size_t>((begin + n) % frames);
      if (out[at]) continue;
      out[at] = true;
      --length, --lost;
    }
  }
  return out;
}

glm::dmat3 smallTurn(const glm::dvec3& about_rad) {
  const double angle = glm::length(about_rad);
  return angle > 0.0 ? glm::mat3_cast(glm::angleAxis(angle, about_rad / angle)) : glm::dmat3(1.0);
}

}  // namespace

std::optional<TrackerPoses> track(const Trajectory& trajectory, const SweepRecipe& recipe, int threads, Progress& progress) {
  const auto& tracker = recipe.tracker;
  const auto normal3 = [&](Stream stream, std::int64_t frame) {
    return glm::dvec3(normalAt(tracker.seed, stream, 3 * frame), normalAt(tracker.seed, stream, 3 * frame + 1),
                      normalAt(tracker.seed, stream, 3 * frame + 2));
  };
  TrackerPoses tracked;
  tracked.poses.resize(static_cast<std::size_t>(recipe.frames));
  tracked.unfilteredTime_s.resize(static_cast<std::size_t>(recipe.frames));
  const bool finished = forEachTask(recipe.frames, threads, progress, say<"Moving the probe">(), [&](int n) {
    const double time_s = n / recipe.framesPerSecond;
    Pose& pose = tracked.poses[static_cast<std::size_t>(n)];
    pose.time_s = time_s;
    pose.probeToWorld = trajectory.poseAt(time_s - tracker.latency_s + tracker.jitter_s * normalAt(tracker.seed, Stream::lateness, n));
    const glm::dmat3 turned =
        glm::dmat3(pose.probeToWorld.matrix) * smallTurn(tracker.noise_deg * kTrackerDegree_rad * normal3(Stream::turn, n));
    for (int axis = 0; axis < 3; ++axis) pose.probeToWorld.matrix[axis] = glm::dvec4(turned[axis], 0.0);
    pose.probeToWorld.matrix[3] += glm::dvec4(tracker.noise_mm * normal3(Stream::shift, n), 0.0);
    tracked.unfilteredTime_s[static_cast<std::size_t>(n)] = time_s + tracker.jitter_s * normalAt(tracker.seed, Stream::arrival, n);
  });
  if (!finished) return std::nullopt;

  const auto lost = dropOuts(recipe.frames, static_cast<int>(std::lround(tracker.dropOutShare * recipe.frames)), tracker.seed);
  Transform<frame::World, frame::Probe> lastSeen;
  bool holdsLast = false;
  for (int n = 0; n < recipe.frames; ++n) {
    Pose& pose = tracked.poses[static_cast<std::size_t>(n)];
    if (!lost[static_cast<std::size_t>(n)]) {
      lastSeen = pose.probeToWorld;
      continue;
    }
    const bool begins = n == 0 || !lost[static_cast<std::size_t>(n) - 1];
    if (begins) holdsLast = n > 0 && evenAt(tracker.seed, Stream::runs, -1 - n) < 0.5;
    pose.status = PoseStatus::invalid;
    pose.probeToWorld = holdsLast ? lastSeen : Transform<frame::World, frame::Probe>{};
    if (!holdsLast) pose.probeToWorld.matrix[3] += glm::dvec4(0.01 * normal3(Stream::shift, n), 0.0);
  }
  return tracked;
}

}  // namespace ew::phantom
