#include "ew/tracking/tracked_probe.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>
#include <vector>

#include "ew/core/contract.h"
#include "ew/core/order_statistics.h"
#include "ew/tracking/tracker_clock.h"
#include "ew/tracking/tracking_words.h"
#include "tracked_probe_readings.h"

namespace ew {

namespace {

using tracking::FreezeDetector;
using tracking::ReferencePairing;
using tracking::Stamped;

constexpr double kReported_s = 2.0;
constexpr std::size_t kMostReported = 4096;
/// However slow a tracker is, a pose is shown as one of now no longer than this without a good reading.
constexpr double kLongestBridge_s = 0.3;

double deviationOf(const std::vector<double>& values) {
  if (values.size() < 2) return 0.0;
  double sum = 0.0, squares = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

PoseStatus statusOf(TrackingState state) {
  switch (state) {
    case TrackingState::live:
      return PoseStatus::ok;
    case TrackingState::outOfRange:
    case TrackingState::invalid:
    case TrackingState::duplicate:
      return PoseStatus::invalid;
    case TrackingState::outOfView:
    case TrackingState::stale:
    case TrackingState::lost:
    case TrackingState::off:
      return PoseStatus::missing;
  }
  return PoseStatus::missing;
}

Message toolIsUnknown(const std::string& tool, const std::vector<std::string>& heardOf) {
  std::vector<Message> names;
  for (const std::string& each : heardOf) names.push_back(verbatim("'" + each + "'"));
  return say<"The tracker does not send '%1', but %2; choose which of them carries the probe.">(tool, joined(std::move(names), ", "));
}

}  // namespace

struct TrackedProbe::State {
  std::mutex mutex;
  std::shared_ptr<TrackerDevice> device;
  TrackedProbeOptions options;
  TrackerCalibration calibration;
  double steadyMinusScan_s = 0.0;

  TrackerClock clock;
  FreezeDetector frozen;
  ReferencePairing referenced;
  PoseFilter filter;
  std::string tool;               ///< that is used; empty: none was heard of
  std::optional<Stamped> latest;  ///< of the tool, in the reference, whatever its state
  std::optional<double> good_s;   ///< arrival of the latest one that became a pose
  std::optional<double> other_s;  ///< arrival of the latest reading of another tool
  struct Arrived {
    double arrival_s, measured_s;
  };
  std::deque<Arrived> arrived;  ///< that became poses
  TrackingState state = TrackingState::off;
  std::optional<double> stateSince_s;

  void forgetTool() {
    frozen = {};
    referenced.reset();
    filter.reset();
    tool = options.tool;
    latest.reset();
    good_s.reset();
    other_s.reset();
    arrived.clear();
  }

  /// A pose whose spread at the face is large is not one to show: the lever from the tool makes it large where the tool's own is not.
  [[nodiscard]] double faceSpread_mm(const ToolReading& reading) const {
    const double lever_mm = glm::length(glm::dvec3(calibration.probeToTool.matrix[3]));
    return std::hypot(reading.spread_mm, lever_mm * reading.spread_rad);
  }

  void takeNews(double now_s) {
    for (const ToolReading& reading : device->take()) {
      const double measured_s = clock.steadyOf(reading.device_s, reading.arrival_s);
      const bool isReference = !options.reference.empty() && reading.tool == options.reference;
      if (tool.empty() && !isReference && reading.state == TrackingState::live) tool = reading.tool;
      if (isReference || reading.tool == tool) referenced.add({measured_s, reading}, isReference);
      if (!tool.empty() && reading.tool == tool)
        frozen.add(reading);
      else
        other_s = reading.arrival_s;
    }
    for (Stamped& ready : referenced.take(now_s, !options.reference.empty(), options.staleAfter_s)) follow(std::move(ready));
    while (!arrived.empty() && (arrived.size() > kMostReported || arrived.back().arrival_s - arrived.front().arrival_s > kReported_s))
      arrived.pop_front();
  }

  void follow(Stamped next) {
    ToolReading& reading = next.reading;
    const double spread_mm = faceSpread_mm(reading);
    if (reading.state == TrackingState::live && spread_mm > options.wellMeasured_mm) reading.state = TrackingState::outOfRange;
    const bool repeats = latest && latest->reading.state == TrackingState::live && next.measured_s == latest->measured_s;
    latest = next;
    if (reading.state != TrackingState::live || repeats) return;
    switch (filter.add(next.measured_s, reading.toolToTracker * calibration.probeToTool, spread_mm)) {
      case PoseFilter::Taken::used:
        good_s = reading.arrival_s;
        arrived.push_back({reading.arrival_s, next.measured_s});
        break;
      case PoseFilter::Taken::heldBack:
        break;
      case PoseFilter::Taken::refused:
        if (!std::isfinite(glm::determinant(reading.toolToTracker.matrix))) latest->reading.state = TrackingState::invalid;
        break;
    }
  }

  /// One missing reading is bridged: it is known missing half a period after the next should have come.
  [[nodiscard]] double bridge_s() const { return std::min(2.5 * filter.report().period_s, kLongestBridge_s); }

  [[nodiscard]] TrackingState judged(double now_s, LinkState link) const {
    if (link == LinkState::off) return TrackingState::off;
    if (link == LinkState::connecting || link == LinkState::ended) return TrackingState::lost;
    const auto isRecent = [&](const std::optional<double>& when_s) { return when_s && now_s - *when_s <= options.staleAfter_s; };
    if (!latest || !isRecent(latest->reading.arrival_s)) {
      // Some trackers leave out what they do not see.
      return isRecent(other_s) && !tool.empty() ? TrackingState::outOfView : TrackingState::stale;
    }
    if (frozen.isFrozen(options.staleAfter_s)) return TrackingState::duplicate;
    if (good_s && (*good_s >= latest->reading.arrival_s || now_s - *good_s <= bridge_s())) return TrackingState::live;
    if (latest->reading.state != TrackingState::live) return latest->reading.state;
    // Readings come, each the same as the one before or further away than a hand can bring it.
    return isRecent(good_s) ? TrackingState::live : TrackingState::invalid;
  }

  TrackingState update(double now_s, LinkState link) {
    takeNews(now_s);
    const TrackingState next = judged(now_s, link);
    if (next != state || !stateSince_s) {
      state = next;
      stateSince_s = now_s;
    }
    return state;
  }

  [[nodiscard]] Message sentence(const DeviceStatus& status) const {
    if (state == TrackingState::lost && !status.sentence.empty()) return status.sentence;
    const bool hasNothing = state == TrackingState::stale || state == TrackingState::outOfView;
    if (hasNothing && !latest && !tool.empty() && !status.tools.empty() &&
        std::find(status.tools.begin(), status.tools.end(), tool) == status.tools.end())
      return toolIsUnknown(tool, status.tools);
    const auto& reference = referenced.latestReference();
    if (state == TrackingState::outOfView && !options.reference.empty() && (!reference || reference->reading.state != TrackingState::live))
      return stateSentence(state, options.reference);
    if (state == TrackingState::invalid && !status.lastRefusal.empty()) return joined({stateSentence(state, tool), status.lastRefusal});
    return stateSentence(state, tool);
  }
};

TrackedProbe::TrackedProbe(std::shared_ptr<TrackerDevice> device, const TrackedProbeOptions& options, TrackerCalibration calibration,
                           double steadyMinusScan_s)
    : state_(std::make_unique<State>()) {
  EW_EXPECTS(device != nullptr);
  state_->device = std::move(device);
  state_->calibration = std::move(calibration);
  state_->steadyMinusScan_s = steadyMinusScan_s;
  setOptions(options);
}

TrackedProbe::~TrackedProbe() = default;

Pose TrackedProbe::poseAt(double time_s) const {
  const LinkState link = state_->device->status().link;
  const std::scoped_lock lock(state_->mutex);
  State& s = *state_;
  const double now_s = time_s + s.steadyMinusScan_s;
  Pose pose;
  pose.status = statusOf(s.update(now_s, link));
  pose.time_s = time_s;
  if (s.filter.empty()) {
    // Nothing is known yet, whatever the link says.
    if (pose.status == PoseStatus::ok) pose.status = PoseStatus::missing;
    return pose;
  }
  const double latest_s = s.filter.latest_s();
  pose.time_s = std::min(latest_s - s.steadyMinusScan_s, time_s);
  const auto probeToTracker = s.filter.at(pose.status == PoseStatus::ok ? now_s : latest_s);
  pose.probeToWorld = s.calibration.trackerToWorld * probeToTracker;
  return pose;
}

bool TrackedProbe::movesAfter(double /*time_s*/) const {
  const LinkState link = state_->device->status().link;
  return link != LinkState::off && link != LinkState::ended;
}

TrackingReport TrackedProbe::report(double time_s) const {
  const DeviceStatus status = state_->device->status();
  const std::scoped_lock lock(state_->mutex);
  State& s = *state_;
  const double now_s = time_s + s.steadyMinusScan_s;
  TrackingReport report;
  report.state = s.update(now_s, status.link);
  report.sentence = s.sentence(status);
  report.since_s = std::max(now_s - *s.stateSince_s, 0.0);
  report.tool = s.tool;
  report.reference = s.options.reference;
  report.drift_ppm = s.clock.drift_ppm();

  std::vector<double> delays_s, intervals_s;
  std::optional<double> before_s;
  for (const State::Arrived& each : s.arrived) {
    if (now_s - each.arrival_s > kReported_s) continue;
    delays_s.push_back(each.arrival_s - each.measured_s);
    if (before_s) intervals_s.push_back(each.arrival_s - *before_s);
    before_s = each.arrival_s;
  }
  report.rate_hz = static_cast<double>(delays_s.size()) / kReported_s;
  report.delay_s = s.clock.isStamped() && !delays_s.empty() ? upperMedianOf(delays_s) : std::numeric_limits<double>::quiet_NaN();
  report.jitterTime_s = deviationOf(intervals_s);

  const PoseFilterReport filter = s.filter.report();
  report.noise_mm = filter.noise_mm;
  report.noise_rad = filter.noise_rad;
  report.left_mm = filter.left_mm;
  report.left_rad = filter.left_rad;
  report.filterDelay_s = filter.delay_s;
  report.filter = filter.used;
  report.predicted_s = report.state == TrackingState::live ? s.filter.ahead_s(now_s) : 0.0;
  return report;
}

std::optional<ToolReading> TrackedProbe::reading(double time_s) const {
  const LinkState link = state_->device->status().link;
  const std::scoped_lock lock(state_->mutex);
  State& s = *state_;
  const TrackingState state = s.update(time_s + s.steadyMinusScan_s, link);
  if (!s.latest) return std::nullopt;
  ToolReading reading = s.latest->reading;
  // A bad reading that is bridged in the image is none to calibrate with.
  if (state != TrackingState::live) reading.state = state;
  return reading;
}

void TrackedProbe::setOptions(const TrackedProbeOptions& options) {
  const std::scoped_lock lock(state_->mutex);
  State& s = *state_;
  const bool isOther = options.tool != s.options.tool || options.reference != s.options.reference;
  s.options = options;
  s.filter.setOptions({.kind = options.filter, .predict = options.predict});
  if (isOther) s.forgetTool();
}

TrackedProbeOptions TrackedProbe::options() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->options;
}

void TrackedProbe::setCalibration(const TrackerCalibration& calibration) {
  const std::scoped_lock lock(state_->mutex);
  State& s = *state_;
  // What is filtered is the face: another face is another path.
  if (!(calibration.probeToTool == s.calibration.probeToTool)) s.filter.reset();
  s.calibration = calibration;
}

TrackerCalibration TrackedProbe::calibration() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->calibration;
}

}  // namespace ew
