#pragma once

#include "ew/imaging/colour_doppler.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"

namespace ew::detail {

/// Of the polynomial that the wall filter takes out: as the setting asks, as far as the packet has samples for it.
[[nodiscard]] int filterOrderOf(const ColourDoppler& colour);
/// The probe with the lines that colour is scanned along.
[[nodiscard]] Probe colourProbeOf(const Probe& probe, const ColourDoppler& colour);
/// The knobs with lines of Doppler steered as asked, as far as this probe steers; lines that fan out are not.
[[nodiscard]] Knobs steeredKnobs(const Probe& probe, const Knobs& knobs, double steering_rad);
/// The knobs with the steering of the box's lines, as far as this probe steers.
/// @param knobs with colour, within limits
[[nodiscard]] Knobs colourKnobsOf(const Probe& probe, const Knobs& knobs);

}  // namespace ew::detail
