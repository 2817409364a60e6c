#include "ew/imaging/tissue_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "effects/spread_bits.h"

namespace ew {
namespace {

/// A number -0.5..0.5 that looks random but is the same for the same cycle.
double unevenness(long long cycle) {
  const std::uint64_t bits = detail::spreadBits(static_cast<std::uint64_t>(cycle) + 0x9e3779b97f4a7c15ULL);
  return static_cast<double>(bits >> 11) * 0x1p-53 - 0.5;
}

double beginningOf_s(const BodyRhythm& rhythm, long long cycle) {
  return rhythm.period_s * (static_cast<double>(cycle) + rhythm.variation * unevenness(cycle));
}

double risen(double t) { return 0.5 - 0.5 * std::cos(std::numbers::pi * std::clamp(t, 0.0, 1.0)); }

double breathAt(const BodyRhythms::Breathing& breathing, double time_s) {
  const Cycle cycle = cycleAt(breathing.rhythm, time_s);
  const double moving_s = (1.0 - breathing.pause) * cycle.duration_s;
  if (cycle.since_s >= moving_s) return 0.0;
  const double s = std::sin(std::numbers::pi * cycle.since_s / moving_s);
  return breathing.tidal * s * s;
}

// After the R peak the pressure wave takes a tenth of a second to the abdominal aorta, which is widest a sixth of a second later and then
// narrows until the next beat; times rounded.
constexpr double kWaveArrives_s = 0.10;
constexpr double kWaveRises_s = 0.16;

double pulseAt(const BodyRhythm& rhythm, double time_s) {
  const Cycle cycle = cycleAt(rhythm, time_s);
  const double stretch = std::min(1.0, cycle.duration_s / 0.6);  // everything comes sooner in a fast heart
  const double arrives = kWaveArrives_s * stretch, widest = arrives + kWaveRises_s * stretch;
  if (cycle.since_s <= widest) return risen((cycle.since_s - arrives) / (widest - arrives));
  const double fall = (cycle.since_s - widest) / (cycle.duration_s - widest);
  return 1.0 - risen(std::sqrt(std::max(fall, 0.0)));  // the root lets it fall faster at first
}

}  // namespace

Cycle cycleAt(const BodyRhythm& rhythm, double time_s) {
  if (!(std::abs(time_s) < 1e9)) return {};
  auto cycle = static_cast<long long>(std::floor(time_s / rhythm.period_s));
  if (beginningOf_s(rhythm, cycle) > time_s) --cycle;
  if (beginningOf_s(rhythm, cycle + 1) <= time_s) ++cycle;
  const double begin = beginningOf_s(rhythm, cycle);
  return {time_s - begin, beginningOf_s(rhythm, cycle + 1) - begin};
}

BodyState bodyAt(const BodyRhythms& rhythms, double time_s) {
  BodyState body;
  if (rhythms.breathing) body.breath = breathAt(*rhythms.breathing, time_s);
  if (rhythms.pulse) body.pulse = pulseAt(*rhythms.pulse, time_s);
  if (rhythms.bowel) {
    const Cycle cycle = cycleAt(*rhythms.bowel, time_s);
    body.bowel = std::clamp(cycle.since_s / cycle.duration_s, 0.0, 1.0);
  }
  return body;
}

double amplitudeOf(TissueMotion::Kind kind, const BodyState& body) {
  const double phase_rad = 2.0 * std::numbers::pi * body.bowel;
  switch (kind) {
    case TissueMotion::Kind::breath:
      return body.breath;
    case TissueMotion::Kind::pulse:
      return body.pulse;
    case TissueMotion::Kind::bowelCosine:
      return std::cos(phase_rad) - 1.0;
    case TissueMotion::Kind::bowelSine:
      return std::sin(phase_rad);
  }
  return 0.0;
}

}  // namespace ew
