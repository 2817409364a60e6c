#pragma once

#include "ew/imaging/knobs.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Whether echoes are formed anew for each frame, from what is known of the tissue, rather than taken from recorded grey levels. Their
/// levels are decibels below full white, also below the recorded range; a recorded level of 0 is the end of what is known.
[[nodiscard]] bool formsEchoes(const Scene& scene);

/// What `automatic` stands for. A recorded volume went through a machine's gain and grey map once: it is shown as it is, and the paper's
/// factors act on it. Echoes formed anew are as they leave the transducer.
[[nodiscard]] GainLaw usualGainLaw(bool formsEchoes);
[[nodiscard]] GreyMap usualGreyMap(bool formsEchoes);

/// The level that the usual map shows as kMiddleGrey: a narrower range adds contrast about it, and blackens nothing that is brighter.
[[nodiscard]] double middleLevel(bool formsEchoes);

/// What acts: the knobs' own choice, or the usual one of the scene; never `automatic`.
[[nodiscard]] GainLaw resolvedGainLaw(const Knobs& knobs, const Scene& scene);
[[nodiscard]] GreyMap resolvedGreyMap(const Knobs& knobs, const Scene& scene);

}  // namespace ew
