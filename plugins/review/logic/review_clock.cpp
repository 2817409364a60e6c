#include "logic/review_clock.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"

namespace ew::review {
namespace {

constexpr double kSame_s = 1e-3;

}  // namespace

void ReviewClock::setRange(double first_s, double last_s) {
  EW_EXPECTS(first_s <= last_s);
  first_s_ = first_s;
  last_s_ = last_s;
  at_s_ = std::clamp(at_s_, first_s_, last_s_);
  const auto isOut = [&](const std::optional<double>& time_s) { return time_s && (*time_s < first_s_ || *time_s > last_s_); };
  if (isOut(loopBegin_s_) || isOut(loopEnd_s_)) setLoop({}, {});
}

void ReviewClock::play() {
  const double end_s = isLooping() ? *loopEnd_s_ : last_s_;
  if (at_s_ >= end_s) at_s_ = isLooping() ? *loopBegin_s_ : first_s_;
  playing_ = true;
}

void ReviewClock::setSpeed(double speed) {
  if (std::isfinite(speed)) speed_ = std::clamp(speed, kSlowest, kFastest);
}

void ReviewClock::seek(double time_s) {
  if (std::isfinite(time_s)) at_s_ = std::clamp(time_s, first_s_, last_s_);
}

bool ReviewClock::jump(std::span<const double> events_s, bool forward) {
  std::optional<double> nearest;
  for (const double event_s : events_s) {
    if (event_s < first_s_ || event_s > last_s_) continue;
    if (forward ? event_s <= at_s_ + kSame_s : event_s >= at_s_ - kSame_s) continue;
    if (!nearest || (forward ? event_s < *nearest : event_s > *nearest)) nearest = event_s;
  }
  if (nearest) at_s_ = *nearest;
  return nearest.has_value();
}

void ReviewClock::markBegin() {
  const bool isSame = loopBegin_s_ && std::abs(*loopBegin_s_ - at_s_) < kSame_s;
  setLoop(isSame ? std::nullopt : std::optional(at_s_), loopEnd_s_ && *loopEnd_s_ <= at_s_ && !isSame ? std::nullopt : loopEnd_s_);
}

void ReviewClock::markEnd() {
  const bool isSame = loopEnd_s_ && std::abs(*loopEnd_s_ - at_s_) < kSame_s;
  setLoop(loopBegin_s_ && *loopBegin_s_ >= at_s_ && !isSame ? std::nullopt : loopBegin_s_, isSame ? std::nullopt : std::optional(at_s_));
}

void ReviewClock::setLoop(std::optional<double> begin_s, std::optional<double> end_s) {
  if (begin_s && end_s && *end_s <= *begin_s) begin_s = end_s = std::nullopt;
  loopBegin_s_ = begin_s;
  loopEnd_s_ = end_s;
}

void ReviewClock::advance(double passed_s) {
  if (!playing_ || !(passed_s > 0.0)) return;
  const bool isBefore = at_s_ <= loopEnd_s_.value_or(last_s_);  // somebody who looks behind the loop goes on to the end
  const double begin_s = isLooping() && isBefore ? *loopBegin_s_ : first_s_;
  const double end_s = isLooping() && isBefore ? *loopEnd_s_ : last_s_;
  at_s_ += speed_ * passed_s;
  if (at_s_ < end_s) return;
  if ((!isLooping() || !isBefore) && atEnd_ == AtEnd::rest) {
    at_s_ = end_s;
    playing_ = false;
    return;
  }
  const double length_s = end_s - begin_s;
  at_s_ = length_s > 0.0 ? begin_s + std::fmod(at_s_ - begin_s, length_s) : begin_s;
}

}  // namespace ew::review
