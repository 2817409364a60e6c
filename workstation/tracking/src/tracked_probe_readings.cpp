#include "tracked_probe_readings.h"

#include <algorithm>
#include <cmath>

#include "pose_filter_parts.h"

namespace ew::tracking {

void FreezeDetector::add(const ToolReading& reading) {
  if (before_) {
    const bool sameStamp = std::isfinite(reading.device_s) && reading.device_s == before_->device_s;
    const bool sameNumbers = reading.toolToTracker == before_->toolToTracker;
    if (!sameStamp) sameStamp_ = 0;
    if (!sameNumbers) sameNumbers_ = 0;
    if (sameStamp && sameStamp_++ == 0) stampSince_s_ = before_->arrival_s;
    if (sameNumbers && sameNumbers_++ == 0) numbersSince_s_ = before_->arrival_s;
    if (!sameStamp) learn(reading);
  }
  latest_s_ = reading.arrival_s;
  before_ = reading;
}

void FreezeDetector::learn(const ToolReading& reading) {
  constexpr double kShare = 0.02;
  const bool repeats = sameNumbers_ > 0;
  // A long row is what is judged; it must not become what is usual meanwhile.
  if (sameNumbers_ <= 5) repeats_ += kShare * ((repeats ? 1.0 : 0.0) - repeats_);
  if (repeats) return;
  const glm::dvec3 step(reading.toolToTracker.matrix[3] - before_->toolToTracker.matrix[3]);
  const double lengths = glm::length(step) * glm::length(step_mm_);
  if (lengths > 0.0) turnsBack_ += kShare * (glm::dot(step, step_mm_) / lengths - turnsBack_);
  step_mm_ = step;
  // The cosine between steps: -0.4 for white noise about a place that rests, near 1 for a motion.
  if (++steps_ > 60 && turnsBack_ < -0.25) isNoisy_ = true;
}

bool FreezeDetector::isFrozen(double after_s) const {
  if (sameStamp_ > 0 && latest_s_ - stampSince_s_ >= after_s) return true;
  if (!isNoisy_ || sameNumbers_ < 5 || latest_s_ - numbersSince_s_ < after_s) return false;
  return sameNumbers_ * std::log(std::clamp(repeats_, 0.02, 0.999)) < std::log(1e-9);
}

namespace {

constexpr std::size_t kMostWaiting = 1024;
constexpr double kWaitForReference_s = 0.01;  ///< messages of one moment come one after another

void keepNewest(std::deque<Stamped>& readings, const Stamped& reading) {
  readings.push_back(reading);
  if (readings.size() > kMostWaiting) readings.pop_front();
}

bool isRigidState(TrackingState state) { return state == TrackingState::live || state == TrackingState::outOfRange; }

}  // namespace

void ReferencePairing::add(const Stamped& reading, bool isReference) {
  if (!isReference) return keepNewest(tools_, reading);
  latestReference_ = reading;
  if (reading.reading.state != TrackingState::live) return;
  if (!references_.empty() && reading.measured_s < references_.back().measured_s) references_.clear();
  keepNewest(references_, reading);
  while (references_.size() > 2 && reading.measured_s - references_.front().measured_s > 2.0) references_.pop_front();
}

std::optional<Transform<frame::Tracker, frame::Tool>> ReferencePairing::referenceAt(double measured_s, double staleAfter_s) const {
  if (references_.empty()) return std::nullopt;
  const auto after = std::lower_bound(references_.begin(), references_.end(), measured_s,
                                      [](const Stamped& each, double t) { return each.measured_s < t; });
  const auto poseOf = [](const Stamped& each) { return each.reading.toolToTracker; };
  if (after != references_.end() && (after->measured_s == measured_s || after == references_.begin()))
    return after->measured_s - measured_s <= staleAfter_s ? std::optional(poseOf(*after)) : std::nullopt;
  const Stamped& before = *(after - 1);
  if (after == references_.end() || after->measured_s - before.measured_s > staleAfter_s)
    return measured_s - before.measured_s <= staleAfter_s ? std::optional(poseOf(before)) : std::nullopt;
  const double share = (measured_s - before.measured_s) / (after->measured_s - before.measured_s);
  return transformOf<frame::Tool>(between(placeOf(poseOf(before)), placeOf(poseOf(*after)), share));
}

std::vector<Stamped> ReferencePairing::take(double now_s, bool needsReference, double staleAfter_s) {
  std::vector<Stamped> ready;
  while (!tools_.empty()) {
    Stamped& tool = tools_.front();
    if (needsReference) {
      const bool isKnown = latestReference_ && latestReference_->measured_s >= tool.measured_s;
      if (!isKnown && now_s - tool.reading.arrival_s < kWaitForReference_s) break;
      const auto reference = referenceAt(tool.measured_s, staleAfter_s);
      if (isRigidState(tool.reading.state)) {
        if (reference)
          // From here on the reference is what the tracker measures in.
          tool.reading.toolToTracker = renamed<frame::Tracker, frame::Tool>(rigidInverse(*reference) * tool.reading.toolToTracker);
        else
          tool.reading.state = latestReference_ && !isRigidState(latestReference_->reading.state) ? latestReference_->reading.state
                                                                                                  : TrackingState::outOfView;
      }
    }
    ready.push_back(std::move(tool));
    tools_.pop_front();
  }
  return ready;
}

}  // namespace ew::tracking
