#pragma once

#include <array>
#include <cstdint>

#include "ew/core/image.h"
#include "ew/imaging/scene.h"

namespace ew::detail {

/// How the grain of a recorded volume goes into live echoes: with w = own_grain, level L, live echo V and the volume's own grey G, all as
/// levels of the image,
///   L + sqrt(1 - w^2) (V - L) + w (G - L).
/// Both grains lie about the same level and know nothing of each other, so where they are as strong as each other the sum is as well,
/// whatever w; 0 is the live echo, 1 the slice. Where a volume has little grain of its own (averaged, interpolated), little is added.
struct OwnGrain {
  float live = 1.0F, own = 0.0F, level = 0.0F;  ///< weights, of the sum 1
  std::array<float, 256> ofGrey{};              ///< what a grey of the volume is as a level of the image
  std::array<float, 256> ofLevel{};             ///< the same of the maps' level
};

[[nodiscard]] OwnGrain ownGrainOf(const LiveEchoesEffect& effect, double recordedDynamicRange_db);

/// @param grey, level lines as rows; where the level is 0 nothing was recorded, and the echo stays as it is
/// @param echoes (lines x samples)
void blendOwnGrain(const OwnGrain& grain, ImageView<const std::uint8_t> grey, ImageView<const std::uint8_t> level, ImageView<float> echoes);

}  // namespace ew::detail
