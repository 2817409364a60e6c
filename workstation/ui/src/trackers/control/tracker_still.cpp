#include "trackers/control/tracker_still.h"

#include <algorithm>

namespace ew::ui {

void TrackerStill::add(const glm::dvec3& at_mm, double time_s) {
  if (!places_.empty() && (time_s <= places_.back().time_s || time_s - places_.back().time_s > kHold_s / 2.0)) {
    if (time_s <= places_.back().time_s) return;
    places_.clear();  // a gap: nobody knows where it was meanwhile
  }
  places_.push_back({at_mm, time_s});
  // From the newest back: what lies too far away belongs to the motion before.
  while (time_s - places_.front().time_s > kHold_s * 1.2) places_.pop_front();
  while (places_.size() > 1 && glm::distance(places_.front().at_mm, at_mm) > 2.0 * kWithin_mm) places_.pop_front();
  if (takenAt_ && glm::distance(*takenAt_, at_mm) > kAway_mm) takenAt_.reset();
}

void TrackerStill::forget() { places_.clear(); }

std::optional<glm::dvec3> TrackerStill::mean() const {
  if (places_.empty()) return std::nullopt;
  glm::dvec3 sum(0.0);
  for (const Place& each : places_) sum += each.at_mm;
  return sum / static_cast<double>(places_.size());
}

double TrackerStill::spread_mm() const {
  const auto middle = mean();
  double largest = 0.0;
  for (const Place& each : places_) largest = std::max(largest, glm::distance(each.at_mm, *middle));
  return largest;
}

double TrackerStill::heldFor_s() const { return places_.empty() ? 0.0 : places_.back().time_s - places_.front().time_s; }

std::optional<glm::dvec3> TrackerStill::taken() {
  constexpr std::size_t kLeast = 5;
  if (takenAt_ || places_.size() < kLeast || heldFor_s() < kHold_s || spread_mm() > kWithin_mm) return std::nullopt;
  takenAt_ = mean();
  return takenAt_;
}

}  // namespace ew::ui
