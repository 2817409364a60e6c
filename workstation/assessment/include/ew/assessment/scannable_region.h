#pragma once

#include <cstdint>
#include <optional>

#include "ew/core/volume.h"
#include "ew/tracking/hand.h"

namespace ew {

/// The skin that a case can be scanned from: where it lies in the box of the case's data, and the data go on below it.
struct ScannableRegion {
  Grid placedGrid;       ///< of the voxels, in the world
  double below_mm = 30;  ///< how deep below the skin there have to be data
  bool operator==(const ScannableRegion&) const = default;
};

[[nodiscard]] bool isScannable(const ScannableRegion& region, const Skin::Contact& contact);

/// How freely a random hand holds the probe.
struct RandomHold {
  double rotation_rad = 3.141592653589793;  ///< either way
  double tip_rad = 0.5235987755982988;      ///< rock and tilt, each either way
  double press_mm = 1.0;
};

/// A hold somewhere on the scannable skin, every piece of it about as likely as others of its size; the same for the same seed.
/// @return nothing when 20,000 tries met no such skin
[[nodiscard]] std::optional<Hold> randomHold(const ScannableRegion& region, const Skin& skin, std::uint64_t seed,
                                             const RandomHold& freely = {});

/// The same within `reach_mm` of a contact, its angles near those of `around`.
[[nodiscard]] std::optional<Hold> randomHoldNear(const ScannableRegion& region, const Skin& skin, const Hold& around, double reach_mm,
                                                 std::uint64_t seed, const RandomHold& freely);

}  // namespace ew
