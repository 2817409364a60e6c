#include "ew/controls/binding.h"

#include <cmath>

namespace ew::controls {
namespace {

constexpr double kNear = 1.0 / 64.0;  ///< two steps of a knob of 7 bits: then it stands where the setting does

/// A counter's way around its range, the shorter one.
int around(int from, int to, int size) {
  const int way = ((to - from) % size + size) % size;
  return way > size / 2 ? way - size : way;
}

int stepsOf(Encoding encoding, int value) {
  switch (encoding) {
    case Encoding::twosComplement:
      return value < 64 ? value : value - 128;
    case Encoding::offset64:
      return value - 64;
    case Encoding::signBit:
      return value < 64 ? value : 64 - value;
    default:
      return 0;
  }
}

}  // namespace

int highestValue(ControlKind kind) {
  switch (kind) {
    case ControlKind::midiControl:
    case ControlKind::midiNote:
      return 127;
    case ControlKind::midiControl14:
    case ControlKind::midiParameter:
    case ControlKind::midiBend:
      return 16383;
    case ControlKind::hidByte:
      return 255;
    case ControlKind::hidBit:
      return 1;
  }
  return 1;
}

int highestNumber(ControlKind kind) {
  switch (kind) {
    case ControlKind::midiControl:
    case ControlKind::midiNote:
      return 127;
    case ControlKind::midiControl14:
      return 31;
    case ControlKind::midiParameter:
      return 16383;
    case ControlKind::midiBend:
      return 0;
    case ControlKind::hidByte:
      return 4095;
    case ControlKind::hidBit:
      return 8 * 4096 - 1;
  }
  return 0;
}

bool fits(Encoding encoding, ControlKind kind) {
  switch (encoding) {
    case Encoding::absolute:
      return kind != ControlKind::midiNote && kind != ControlKind::hidBit;
    case Encoding::twosComplement:
    case Encoding::offset64:
    case Encoding::signBit:
      return kind == ControlKind::midiControl;
    case Encoding::counter:
      return kind == ControlKind::hidByte;
    case Encoding::button:
      return true;
  }
  return false;
}

Motion Follower::toward(double knob, double present) {
  const bool leads = left_ && std::abs(*left_ - present) < 1e-9;  // nobody else has moved the setting since
  const bool passes = knob_ && (*knob_ - present) * (knob - present) <= 0.0;
  knob_ = knob;
  if (!leads && !passes && std::abs(knob - present) > kNear) {
    left_.reset();
    return {Motion::Kind::wait, knob};
  }
  left_ = knob;
  return {Motion::Kind::to, knob};
}

Motion Follower::take(const Binding& binding, int value, std::optional<double> present) {
  const int highest = highestValue(binding.control.kind);
  const std::optional<int> before = lastValue_;
  lastValue_ = value;
  const double side = binding.reversed ? -1.0 : 1.0;
  const auto by = [&](double steps) { return steps == 0.0 ? Motion{} : Motion{Motion::Kind::by, side * steps}; };
  switch (binding.encoding) {
    case Encoding::button: {
      const auto isDown = [&](int at) { return 2 * at > highest || (binding.control.kind == ControlKind::midiNote && at > 0); };
      return isDown(value) && !(before && isDown(*before)) ? Motion{Motion::Kind::press, 0.0} : Motion{};
    }
    case Encoding::counter:
      return before ? by(around(*before, value, highest + 1)) : Motion{};
    case Encoding::absolute: {
      const double knob = static_cast<double>(value) / highest;
      if (present) return toward(binding.reversed ? 1.0 - knob : knob, *present);
      return before ? by(static_cast<double>(value - *before) / highest * kStepsOfRange) : Motion{};
    }
    default:
      return by(stepsOf(binding.encoding, value));
  }
}

}  // namespace ew::controls
