#include "ew/tracking/tracker_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ew {

namespace {

constexpr double kBucket_s = 0.25, kMemory_s = 60.0;
constexpr double kFirstSlope_s = 5.0;  ///< shorter stretches say more of the delays than of the drift
constexpr double kMostDrift = 500e-6;  ///< a quartz is ten times better
constexpr double kTooEarly_s = 0.02;   ///< a reading that came before it was measured: the clock was set ahead
constexpr double kTooLate_s = 0.05;    ///< all of a second and more come that late: the clock was set back, or the way is longer now
constexpr double kLateFor_s = 1.0;
constexpr double kSettles_s = 2.0;
constexpr double kBackwards_s = 1.0;  ///< stamps fall by more: a restart, not messages that overtook each other

double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::vector<glm::dvec2> lowerHull(const std::deque<glm::dvec2>& points) {
  std::vector<glm::dvec2> hull;
  for (const glm::dvec2& p : points) {
    while (hull.size() >= 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
    hull.push_back(p);
  }
  return hull;
}

}  // namespace

double TrackerClock::steadyOf(double device_s, double arrival_s) {
  isStamped_ = std::isfinite(device_s);
  if (!isStamped_) return arrival_s;
  if (!begun_) {
    begin(device_s, arrival_s);
  } else if (hasJumped(device_s, arrival_s)) {
    jump(arrival_s);
    begin(device_s, arrival_s);
  } else if (device_s >= latestDevice_s_) {
    collect(device_s, arrival_s);
  }
  const double mapped = isOurs_ ? device_s : device_s + lineAt(device_s);
  return std::min(mapped, arrival_s);
}

/// What is corrected in the first seconds is a first message that came late.
void TrackerClock::jump(double arrival_s) {
  if (arrival_s - begun_s_ > kSettles_s) ++jumps_;
}

void TrackerClock::begin(double device_s, double arrival_s) {
  from_ = {device_s, arrival_s - device_s};
  earliest_.assign(1, glm::dvec2(0.0));
  offset_s_ = from_.y;
  slope_ = 0.0;
  bucketEnds_s_ = arrival_s + kBucket_s;
  latestDevice_s_ = device_s;
  lowered_s_ = 0.0;
  late_ = 0;
  begun_s_ = arrival_s;
  begun_ = true;
  // By chance another clock reads the same as ours to within half a second once in days of running.
  isOurs_ = from_.y >= 0.0 && from_.y < 0.5;
}

bool TrackerClock::hasJumped(double device_s, double arrival_s) {
  if (device_s < latestDevice_s_ - kBackwards_s) return true;
  const double above_s = arrival_s - device_s - lineAt(device_s);
  // Against the line as it was fitted: lowered step by step, it would follow a clock that was set ahead.
  if (above_s - lowered_s_ < -kTooEarly_s) return true;
  if (above_s < kTooLate_s) {
    late_ = 0;
    return false;
  }
  if (late_++ == 0) lateSince_s_ = arrival_s;
  return late_ >= 5 && arrival_s - lateSince_s_ >= kLateFor_s;
}

void TrackerClock::collect(double device_s, double arrival_s) {
  latestDevice_s_ = device_s;
  const glm::dvec2 p(device_s - from_.x, arrival_s - device_s - from_.y);
  if (arrival_s >= bucketEnds_s_) {
    bucketEnds_s_ = arrival_s + kBucket_s;
    fit(arrival_s);
    earliest_.push_back(p);
    while (earliest_.size() > 2 && p.x - earliest_.front().x > kMemory_s) earliest_.pop_front();
  } else if (p.y < earliest_.back().y) {
    earliest_.back() = p;
  }
  // An earlier arrival than all counts at once: a pose is never measured after it came.
  const double above_s = p.y + from_.y - lineAt(device_s);
  if (above_s < 0.0) {
    offset_s_ += above_s;
    lowered_s_ -= above_s;
  }
  if (p.y + from_.y < 0.0 || p.y + from_.y > 1.0) isOurs_ = false;
}

void TrackerClock::fit(double arrival_s) {
  lowered_s_ = 0.0;
  slope_ = 0.0;
  if (earliest_.back().x - earliest_.front().x >= kFirstSlope_s) {
    const std::vector<glm::dvec2> hull = lowerHull(earliest_);
    double middle = 0.0;
    for (const glm::dvec2& p : earliest_) middle += p.x / static_cast<double>(earliest_.size());
    std::size_t edge = 1;
    while (edge + 1 < hull.size() && hull[edge].x < middle) ++edge;
    const glm::dvec2 a = hull[edge - 1], b = hull[edge];
    slope_ = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0.0;
    if (std::abs(slope_) > kMostDrift) {
      // No clock drifts like that: it was set by less than is seen at once. What came before says nothing any more.
      jump(arrival_s);
      slope_ = 0.0;
      begun_s_ = arrival_s;
      while (earliest_.size() > 2 && earliest_.back().x - earliest_.front().x > kSettles_s) earliest_.pop_front();
    }
  }
  // In the first seconds the earliest arrival alone counts.
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec2& p : earliest_) least = std::min(least, p.y - slope_ * p.x);
  offset_s_ = from_.y + least;
}

}  // namespace ew
