#pragma once

#include <filesystem>

#include "ew/core/image.h"
#include "ew/core/result.h"

namespace ew {

/// Writes an 8 bit image as .png, or as a two-dimensional .mha whose spacing is pixel_mm; complete or not at all.
/// @error notWritable, unsupported (ending)
[[nodiscard]] Result<void> writeImage(ImageView<const std::uint8_t> image, double pixel_mm, const std::filesystem::path& file);
/// The same in colour: .mha with three channels.
[[nodiscard]] Result<void> writeImage(ImageView<const Rgb> image, double pixel_mm, const std::filesystem::path& file);

/// @error notFound, notReadable, badHeader
[[nodiscard]] Result<GreyImage> readImage(const std::filesystem::path& file);

}  // namespace ew
