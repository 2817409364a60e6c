#pragma once

#include <optional>

#include "refine.h"

namespace ew::registration {

/// What speaks against a pose that descending from a start found, though the images agree there and halves of them too.
/// Loose: moved by 10 mm along what holds it least (turned, by as much at the rim of the overlap), the images agree nearly as well. Layers
/// and tubes let it slide, a ball lets it turn; where it then lies is where the start was. Rival: another shift at the same turn agrees as
/// well and lies hardly further from the start than twice as far: structure repeats.
/// @param found where descending ended, and the evidence there at the level of agreement
/// @param doubt nothing when the pose stands
/// @return false when cancelled
[[nodiscard]] bool doubtsAbout(const PairLevels& pair, const Transform<frame::Moving, frame::Fixed>& start,
                               const Transform<frame::Moving, frame::Fixed>& found, const Evidence& evidence, int threads,
                               Progress& progress, std::optional<Remark>& doubt);

}  // namespace ew::registration
