#include "ew/tracking/rate_hand.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"

namespace ew {

namespace {

constexpr double kLongestStep_s = 0.25, kPart_s = 0.01;
/// Springing back: as quick as the spring of a controller, so that a tick's jump of a coarse axis is no jump of the probe.
constexpr double kSpring_s = 0.06;

constexpr std::size_t indexOf(HandMotion motion) { return static_cast<std::size_t>(motion); }

using PerMotion = std::array<double, kHandMotions>;

Hold heldBy(const Hold& hold, const Skin& skin, const PerMotion& by) {
  const double lateral = by[indexOf(HandMotion::slideLateral)], elevational = by[indexOf(HandMotion::slideElevational)];
  Hold next = hold;
  // Half of the way before the rotation and half after it: what is left of the order of two motions at once is of third order.
  const bool slides = lateral != 0.0 || elevational != 0.0;
  if (slides) next = slid(next, skin, 0.5 * lateral, 0.5 * elevational);
  next = turned(next, by[indexOf(HandMotion::rotation)], by[indexOf(HandMotion::rock)], by[indexOf(HandMotion::tilt)]);
  if (slides) next = slid(next, skin, 0.5 * lateral, 0.5 * elevational);
  next.press_mm = std::clamp(next.press_mm + by[indexOf(HandMotion::press)], 0.0, kMaxPress_mm);
  return next;
}

RateHandOptions optionsOf(RateMode mode, const std::array<RateAxis, kHandMotions>& rates, const std::array<double, kHandMotions>& reach) {
  RateHandOptions options;
  options.mode = mode;
  options.axes = rates;
  if (mode == RateMode::springBack)
    for (std::size_t n = 0; n < kHandMotions; ++n) options.axes[n].full = reach[n];
  return options;
}

constexpr PerMotion kReach{40.0, 40.0, 12.0, 0.8, 0.5, 0.5};

}  // namespace

// Seen from in front of the patient, with the probe as it is held at first: what is pushed to the right goes to the right, as keys do.
RateHandOptions spaceMouseOptions(RateMode mode) {
  return optionsOf(mode,
                   {RateAxis{.axis = 0, .reversed = true, .full = 80.0}, RateAxis{.axis = 2, .reversed = true, .full = 80.0},
                    RateAxis{.axis = 1, .reversed = true, .full = 15.0}, RateAxis{.axis = 4, .reversed = true, .full = 1.2},
                    RateAxis{.axis = 5, .reversed = true, .full = 0.7}, RateAxis{.axis = 3, .reversed = true, .full = 0.7}},
                   kReach);
}

RateHandOptions gameControllerOptions(RateMode mode) {
  return optionsOf(
      mode,
      {RateAxis{.axis = 0, .reversed = true, .full = 80.0}, RateAxis{.axis = 1, .full = 80.0}, RateAxis{.axis = 4, .full = 12.0},
       RateAxis{.axis = 5, .full = 1.0}, RateAxis{.axis = 2, .full = 0.7}, RateAxis{.axis = 3, .reversed = true, .full = 0.7}},
      kReach);
}

double shapedAxis(double axis, double deadZone, double curve) {
  EW_EXPECTS(deadZone >= 0.0 && deadZone < 1.0 && curve > 0.0);
  if (!std::isfinite(axis)) return 0.0;
  const double size = std::min(std::abs(axis), 1.0);
  if (size <= deadZone) return 0.0;
  return std::copysign(std::pow((size - deadZone) / (1.0 - deadZone), curve), axis);
}

RateHand::Motions RateHand::motionsOf(std::span<const double> axes) const {
  Motions motions{};
  for (std::size_t n = 0; n < kHandMotions; ++n) {
    const RateAxis& from = options_.axes[n];
    if (from.axis < 0 || static_cast<std::size_t>(from.axis) >= axes.size()) continue;
    const double shaped = shapedAxis(axes[static_cast<std::size_t>(from.axis)], options_.deadZone, options_.curve);
    motions[n] = (from.reversed ? -1.0 : 1.0) * from.full * shaped;
  }
  return motions;
}

Hold RateHand::drivenBy(const Hold& hold, const Skin& skin, const Motions& rates, double dt_s) const {
  const int parts = static_cast<int>(std::ceil(dt_s / kPart_s));
  Motions each{};
  for (std::size_t n = 0; n < kHandMotions; ++n) each[n] = rates[n] * dt_s / parts;
  Hold next = hold;
  for (int part = 0; part < parts; ++part) next = heldBy(next, skin, each);
  return next;
}

Hold RateHand::sprungBy(const Hold& hold, const Skin& skin, const Motions& reach, double dt_s) {
  if (!base_ || !given_ || !(hold == *given_)) {
    base_ = hold;
    away_ = {};
  }
  const double share = 1.0 - std::exp(-dt_s / kSpring_s);
  for (std::size_t n = 0; n < kHandMotions; ++n) {
    away_[n] += share * (reach[n] - away_[n]);
    // Hundredths of a millimetre or of a degree: it is where it was.
    if (reach[n] == 0.0 && std::abs(away_[n]) < 2e-4) away_[n] = 0.0;
  }
  given_ = away_ == Motions{} ? *base_ : heldBy(*base_, skin, away_);
  return *given_;
}

Hold RateHand::step(const Hold& hold, const Skin& skin, std::span<const double> axes, double dt_s) {
  EW_EXPECTS(dt_s >= 0.0);
  const double step_s = std::min(dt_s, kLongestStep_s);
  const Motions motions = motionsOf(axes);
  if (options_.mode == RateMode::springBack) return sprungBy(hold, skin, motions, step_s);
  if (motions == Motions{} || step_s <= 0.0) return hold;
  return drivenBy(hold, skin, motions, step_s);
}

bool RateHand::isAtRest(std::span<const double> axes) const { return motionsOf(axes) == Motions{} && away_ == Motions{}; }

void RateHand::setOptions(const RateHandOptions& options) {
  options_ = options;
  base_.reset();
  given_.reset();
  away_ = {};
}

}  // namespace ew
