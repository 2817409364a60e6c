#pragma once

#include <optional>

#include "ew/library/placing.h"
#include "ew/library/publishing.h"

namespace ew {

/// Whether an image of the case's first probe, from its start, meets the box of the volume; nothing when neither is known.
[[nodiscard]] std::optional<bool> startSeesVolume(const Case& opened);

/// Whether the start lies within the tolerance of the expert's pose or of a plane whose name gives the finding away.
[[nodiscard]] bool startGivesAway(const Case& opened);

/// @error as readVolume; unsupported (no skin); cancelled
[[nodiscard]] Result<Contact> contactOfCase(const Case& opened, const CheckSources& sources, Progress& progress);

inline constexpr int kFarthestFromSkin_mm = 25;  ///< that a probe's face may stand off or be pressed in

/// Whether a hand can get to a target.
enum class Reach { reached, outside, offSkin };
[[nodiscard]] Reach reachOf(const CaseTarget& target, const Case& opened, const CheckSources& sources);

}  // namespace ew
