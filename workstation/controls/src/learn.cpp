#include "ew/controls/learn.h"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace ew::controls {
namespace {

constexpr std::size_t kFew = 6;       ///< events before anything is said
constexpr std::size_t kMost = 256;    ///< kept of one control
constexpr int kFastest = 16;          ///< steps of an encoder in one event
constexpr std::size_t kCounted = 10;  ///< single steps that make a counter

struct Shape {
  std::size_t repeats = 0;  ///< a value that is the one before
  std::size_t turns = 0;    ///< changes of direction
  int widest = 0;           ///< the largest way from one to the next
  int lowest = 0, highest = 0;
};

Shape shapeOf(const std::vector<int>& values) {
  Shape shape;
  shape.lowest = *std::min_element(values.begin(), values.end());
  shape.highest = *std::max_element(values.begin(), values.end());
  int direction = 0;
  for (std::size_t n = 1; n < values.size(); ++n) {
    const int way = values[n] - values[n - 1];
    shape.widest = std::max(shape.widest, std::abs(way));
    if (way == 0) {
      ++shape.repeats;
      continue;
    }
    if (direction != 0 && (way > 0) != (direction > 0)) ++shape.turns;
    direction = way;
  }
  return shape;
}

template <class Is>
bool every(const std::vector<int>& values, Is is) {
  return std::all_of(values.begin(), values.end(), is);
}
template <class Is>
bool some(const std::vector<int>& values, Is is) {
  return std::any_of(values.begin(), values.end(), is);
}

Judged known(Encoding encoding) { return {Judged::State::known, encoding}; }

/// Control changes of 7 bits, which say three kinds of steps as well.
Judged judgedSteps(const std::vector<int>& values, const Shape& shape) {
  const auto right = [](int v) { return v >= 1 && v <= kFastest; };
  const auto leftByComplement = [](int v) { return v >= 128 - kFastest && v <= 127; };
  const auto above64 = [](int v) { return v > 64 && v <= 64 + kFastest; };
  const auto below64 = [](int v) { return v < 64 && v >= 64 - kFastest; };
  const bool complement = every(values, [&](int v) { return right(v) || leftByComplement(v); });
  const bool sign = every(values, [&](int v) { return right(v) || above64(v); });
  const bool offset = every(values, [&](int v) { return above64(v) || below64(v); });
  // A knob that passes through these values sends each of them once; 64 itself is no step of an encoder, and neither is 0.
  const bool repeats = 2 * shape.repeats >= values.size() - 1 || (shape.repeats >= 2 && shape.widest > 2 * kFastest);
  const bool jumps = shape.widest > 2 * kFastest && shape.widest < 128;
  if (complement && (repeats || jumps) && some(values, leftByComplement)) return known(Encoding::twosComplement);
  if (sign && (repeats || jumps) && some(values, right) && some(values, above64)) return known(Encoding::signBit);
  if (offset && shape.repeats >= 2 && some(values, above64) && some(values, below64)) return known(Encoding::offset64);
  if (offset && repeats && every(values, below64)) return known(Encoding::offset64);
  if (repeats && (complement || sign || offset)) return {Judged::State::ambiguous, Encoding::absolute};
  return {Judged::State::noise, Encoding::absolute};
}

Judged judgedByte(const std::vector<int>& values, const Shape& shape) {
  const auto isAround = [](int way) { return std::abs(way) > 128; };
  std::size_t singles = 0;
  bool wraps = false;
  int widest = 0;
  for (std::size_t n = 1; n < values.size(); ++n) {
    int way = values[n] - values[n - 1];
    if (isAround(way)) {
      wraps = true;
      way += way > 0 ? -256 : 256;
    }
    widest = std::max(widest, std::abs(way));
    if (std::abs(way) == 1) ++singles;
  }
  if (widest > 48) return {Judged::State::noise, Encoding::absolute};  // buttons, or the lower half of a finer value
  if (wraps) return widest <= 8 ? known(Encoding::counter) : Judged{Judged::State::noise, Encoding::absolute};
  if (shape.highest - shape.lowest >= 72) return known(Encoding::absolute);
  if (singles == values.size() - 1 && singles >= kCounted) return known(Encoding::counter);
  return {Judged::State::tooFew, Encoding::absolute};
}

}  // namespace

Judged judged(ControlKind kind, const std::vector<int>& values) {
  if (kind == ControlKind::midiNote || kind == ControlKind::hidBit) return {Judged::State::button, Encoding::button};
  const int highest = highestValue(kind);
  if (values.size() >= 2 && every(values, [&](int v) { return v == 0 || v == highest; })) return {Judged::State::button, Encoding::button};
  if (values.size() < kFew) return {};
  const Shape shape = shapeOf(values);
  if (kind == ControlKind::hidByte) return judgedByte(values, shape);
  if (kind == ControlKind::midiControl) {
    const Judged steps = judgedSteps(values, shape);
    if (steps.state != Judged::State::noise) return steps;
  }
  const std::set<int> different(values.begin(), values.end());
  const bool isOneWay = shape.turns == 0, isFar = 5 * (shape.highest - shape.lowest) > highest;
  if (different.size() < kFew - 1 || !(isOneWay || isFar)) return {};
  return known(Encoding::absolute);
}

void Learner::take(const ControlEvent& event) {
  if (found_) return;
  std::vector<int>& values = values_[event.id];
  const int before = values.empty() ? 0 : values.back();
  if (values.size() < kMost) values.push_back(event.value);
  if (wanted_ == Target::Kind::action) return judgeAction(event, before);
  judge(event.id);
}

void Learner::judgeAction(const ControlEvent& event, int before) {
  // A byte of a report tells of many buttons at once; its bits tell of each.
  if (event.id.kind == ControlKind::hidByte || event.id.kind == ControlKind::midiControl14) return;
  const int highest = highestValue(event.id.kind);
  const bool isDown = event.id.kind == ControlKind::midiNote ? event.value > 0 : 2 * event.value > highest && 2 * before <= highest;
  if (!isDown) return;
  // One that jumps is a button; one that comes by steps is a knob, which is no button.
  const std::vector<int>& values = values_[event.id];
  if (values.size() > 2 && judged(event.id.kind, values).state == Judged::State::known) return;
  if (event.id.kind != ControlKind::midiNote && event.id.kind != ControlKind::hidBit && event.value != highest) return;
  found_ = Learned{event.id, Encoding::button};
}

void Learner::judge(const ControlId& id) {
  const Judged is = judged(id.kind, values_[id]);
  switch (is.state) {
    case Judged::State::button:
      if (needs_ == Needs::move) needs_ = Needs::knobInsteadOfButton;
      return;
    case Judged::State::ambiguous:
      needs_ = Needs::turnBack;
      return;
    case Judged::State::tooFew:
    case Judged::State::noise:
      if (needs_ != Needs::turnBack && id.kind != ControlKind::hidByte) needs_ = Needs::moveOn;
      return;
    case Judged::State::known:
      break;
  }
  if (id.kind == ControlKind::midiControl && is.encoding == Encoding::absolute) {
    // The two halves of a finer value: the pair is what moves.
    const int pair = id.number % 32;
    const auto upper = values_.find({id.device, ControlKind::midiControl, id.channel, pair});
    const ControlId fine{id.device, ControlKind::midiControl14, id.channel, pair};
    const auto both = values_.find(fine);
    if (id.number < 64 && both != values_.end() && upper != values_.end() && both->second.size() >= 3 && upper->second.size() >= 3) {
      found_ = Learned{fine, Encoding::absolute};
      return;
    }
  }
  if (id.kind == ControlKind::hidByte && !standsAlone(id, is.encoding)) {
    needs_ = Needs::moveOn;
    return;
  }
  found_ = Learned{id, is.encoding};
}

/// A value of 16 bits moves two bytes next to each other: the one that goes around is its lower half, and of no use alone.
bool Learner::standsAlone(const ControlId& byte, Encoding encoding) const {
  const auto wraps = [](const std::vector<int>& values) {
    for (std::size_t n = 1; n < values.size(); ++n)
      if (std::abs(values[n] - values[n - 1]) > 128) return true;
    return false;
  };
  // Two axes of a stick lie next to each other too, but go to and fro without going around.
  int way = 0;
  const std::vector<int>& values = values_.at(byte);
  for (std::size_t n = 1; n < values.size(); ++n) way += std::abs(values[n] - values[n - 1]);
  if (encoding == Encoding::absolute && way >= 600) return true;
  for (const int side : {-1, 1}) {
    ControlId next = byte;
    next.number += side;
    const auto beside = values_.find(next);
    if (beside == values_.end()) continue;
    if (encoding == Encoding::counter || !wraps(beside->second)) return false;
  }
  return true;
}

}  // namespace ew::controls
