#include <algorithm>
#include <cmath>

#include "colour/colour_lines.h"
#include "ew/core/contract.h"
#include "ew/imaging/display.h"
#include "ew/imaging/doppler.h"
#include "ew/imaging/spectral_doppler.h"
#include "flow/echo_powers.h"
#include "plan/planning.h"
#include "probes/fan_shape.h"
#include "probes/sound.h"
#include "spectrum/gate_line.h"

namespace ew {

namespace detail {

Knobs gateKnobsOf(const Probe& probe, const Knobs& knobs) { return steeredKnobs(probe, knobs, knobs.spectral->steering_rad); }

}  // namespace detail

SpectralGate spectralGateOf(const Probe& probe, const Knobs& asked) {
  EW_EXPECTS(asked.spectral.has_value());
  const Knobs knobs = limited(asked);
  const SpectralDoppler& spectral = *knobs.spectral;
  const double depth_mm = resolvedDepth_mm(probe, knobs);
  SpectralGate gate;
  gate.length_mm = std::min(spectral.gate_mm, depth_mm);
  const double middle_mm = spectral.depth_mm > 0.0 ? spectral.depth_mm : 0.5 * depth_mm;
  gate.depth_mm = std::clamp(middle_mm, 0.5 * gate.length_mm, depth_mm - 0.5 * gate.length_mm);
  const detail::FanShape::Line line = detail::fanShapeOf(probe, detail::gateKnobsOf(probe, knobs)).lineAt(spectral.line);
  gate.face_mm = line.origin_mm;
  gate.direction = line.direction;
  gate.middle_mm = line.origin_mm + gate.depth_mm * line.direction;
  const double sine = std::sin(spectral.angle_rad), cosine = std::cos(spectral.angle_rad);
  gate.flow = {cosine * line.direction.x + sine * line.direction.y, cosine * line.direction.y - sine * line.direction.x};
  gate.carrier_hz =
      spectral.carrier_hz > 0.0 ? spectral.carrier_hz : detail::kCarrierShare * detail::withCarrierOf(probe, knobs).carrier_hz;
  const double deepest_mm = gate.depth_mm + 0.5 * gate.length_mm, back_hz = 0.5 * detail::kSpeedOfSound_mmPerS / deepest_mm;
  gate.prf_hz = spectral.highPrf ? spectral.prf_hz : std::min(spectral.prf_hz, back_hz);
  const double apart_mm = 0.5 * detail::kSpeedOfSound_mmPerS / gate.prf_hz;
  if (gate.prf_hz > back_hz) {
    for (double at_mm = std::fmod(gate.depth_mm, apart_mm); at_mm < depth_mm; at_mm += apart_mm)
      if (at_mm > 0.5 * gate.length_mm && std::abs(at_mm - gate.depth_mm) > 0.5 * apart_mm) gate.alsoAt_mm.push_back(at_mm);
  }
  gate.nyquist_mmPerS = nyquist_mmPerS(gate.prf_hz, gate.carrier_hz);
  gate.corrected = 1.0 / cosine;
  gate.shown_mmPerS = {(-1.0 + spectral.baseline) * gate.nyquist_mmPerS * gate.corrected,
                       (1.0 + spectral.baseline) * gate.nyquist_mmPerS * gate.corrected};
  gate.filtered_mmPerS = 0.5 * spectral.wallFilter_hz * detail::kSpeedOfSound_mmPerS / gate.carrier_hz * gate.corrected;
  return gate;
}

Knobs withSpectralGateAt(const Probe& probe, const Knobs& knobs, const glm::dvec2& p_mm) {
  EW_EXPECTS(knobs.spectral.has_value());
  Knobs moved = limited(knobs);
  const detail::FanShape::Place place = detail::fanShapeOf(probe, detail::gateKnobsOf(probe, moved)).placeOf(p_mm);
  const double half_mm = 0.5 * moved.spectral->gate_mm;
  moved.spectral->line = std::clamp(place.across, -1.0, 1.0);
  moved.spectral->depth_mm = std::clamp(place.depth_mm, half_mm, std::max(half_mm, resolvedDepth_mm(probe, moved) - half_mm));
  return moved;
}

double angleUncertainty(double angle_rad, double error_rad) { return std::tan(std::abs(angle_rad)) * std::abs(error_rad); }

}  // namespace ew
