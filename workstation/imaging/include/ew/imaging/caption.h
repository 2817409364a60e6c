#pragma once

#include <string_view>

#include "ew/core/image.h"

namespace ew {

/// The words every exported scan image carries.
inline constexpr std::string_view kNotForDiagnosis = "simulation, not for diagnosis";

/// Smallest image these words can be read on.
inline constexpr int kCaptionMinWidth_px = 96;
inline constexpr int kCaptionMinHeight_px = 64;

/// Writes lower-case words (a-z, 0-9, comma, full stop, hyphen, blank) in small letters along the lower edge, centred, in a quiet grey with
/// a dark rim so that they can be read on any ground; on two or more lines when the image is narrow, larger on a large one. Nothing else
/// in the image changes.
void burnCaption(ImageView<std::uint8_t> image, std::string_view words);
void burnCaption(ImageView<Rgb> image, std::string_view words);

}  // namespace ew
