#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <random>
#include <utility>

#include "ew/scanning/tracking_pace.h"
#include "ew/tracking/tracked_probe.h"
#include "tracking/scripted_tracker.h"

namespace ew::test {

/// A tracked probe and the clock of the window's images, in accelerated time.
struct TrackedScan {
  double rate_hz = 60.0;
  double seconds = 20.0;
  double begin_s = 100.0;   ///< on the scan's clock
  double delay_s = 0.012;   ///< from a measurement to its arrival
  double jitter_s = 0.001;  ///< of the arrival
  double noise_mm = 0.0;    ///< of the origin
  double frame_s = 0.006;   ///< that an image takes
  double phase = 0.4;       ///< of the readings, in periods
  std::function<TrackingState(double t)> stateAt = [](double) { return TrackingState::live; };
};

/// Calls `frame(time_s, pose)` for every image that the window would make, or miss, of a probe on `path` (probe in the world, which is
/// the tracker's frame; time from 0). The order of events is that of Session: an image of a reading that arrives when trackedPace() allows
/// one, and one without news at the latest.
inline void scanTracked(const TrackedScan& scan, const std::function<Transform<frame::World, frame::Probe>(double t)>& path,
                        const std::function<void(double time_s, const Pose& pose)>& frame) {
  constexpr double kSteadyMinusScan_s = 1234.5, kDeviceMinusSteady_s = 17.25;
  auto device = std::make_shared<ScriptedTracker>();
  device->start();
  const TrackedProbe probe(device, {}, {}, kSteadyMinusScan_s);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::uniform_real_distribution<double> late(0.0, 1.0);
  const double end_s = scan.begin_s + scan.seconds;
  int n = 0;
  TrackingPace pace;
  const auto measuredAt = [&](int which) { return (which + scan.phase) / scan.rate_hz; };
  double arrival_s = scan.begin_s + measuredAt(0) + scan.delay_s;
  pace.latest_s = arrival_s;
  for (double now_s = scan.begin_s; now_s < end_s;) {
    now_s = std::min(arrival_s, pace.latest_s);
    if (now_s >= end_s) break;
    bool isDue = pace.latest_s <= now_s;
    if (arrival_s <= now_s) {
      const double t = measuredAt(n++);
      ToolReading reading;
      reading.tool = "probe";
      reading.state = scan.stateAt(t);
      reading.toolToTracker = {path(t).matrix};
      for (int axis = 0; axis < 3; ++axis) reading.toolToTracker.matrix[3][axis] += scan.noise_mm * noise(random);
      reading.device_s = scan.begin_s + t + kSteadyMinusScan_s + kDeviceMinusSteady_s;
      reading.arrival_s = now_s + kSteadyMinusScan_s;
      device->read(std::move(reading));
      arrival_s = std::max(now_s, scan.begin_s + measuredAt(n) + scan.delay_s + scan.jitter_s * late(random));
      isDue = isDue || now_s >= pace.earliest_s;
    }
    if (!isDue) continue;
    frame(now_s, probe.poseAt(now_s));
    pace = trackedPace(now_s, scan.frame_s);
  }
}

}  // namespace ew::test
