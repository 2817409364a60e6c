#pragma once

#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"

namespace ew::detail {

/// The knobs with the steering of the sample volume's line. @param knobs with spectral, within limits
[[nodiscard]] Knobs gateKnobsOf(const Probe& probe, const Knobs& knobs);

}  // namespace ew::detail
