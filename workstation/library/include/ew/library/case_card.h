#pragma once

namespace ew {

// A case that comes as a recipe has no image until it is prepared, and its card would be the only one without. So a case folder may hold
// one: what the case begins with, `kCardImageHeight_px` high, above a strip with the words every image carries.

inline constexpr const char* kCardName = "card.png";
inline constexpr int kCardImageWidth_px = 544;
inline constexpr int kCardImageHeight_px = 320;
inline constexpr int kCardStripHeight_px = 30;  ///< below the image; cards leave it out

}  // namespace ew
