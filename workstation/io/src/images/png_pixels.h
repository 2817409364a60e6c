#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "dicom/dicom_dataset.h"
#include "ew/core/result.h"

namespace ew::detail {

/// A PNG's stored numbers as 8 bit samples.
struct PngPixels {
  int width = 0;
  int height = 0;
  bool inColour = false;
  std::vector<std::uint8_t> samples;  ///< grey, or red, green, blue of each pixel; rows without padding
};

/// Echo levels are what is stored: 8 bits as they are, 16 bits linearly to 8 (65535 to 255). What the file says about how a screen should
/// show them (gAMA, sRGB, cHRM, iCCP) is not applied, and what is transparent lies on black.
/// @error badHeader (damaged), tooLarge (more than `mostPixels`, before memory is taken)
[[nodiscard]] Result<PngPixels> readPngPixels(Bytes png, const std::filesystem::path& file, std::uint64_t mostPixels);

/// How much wider than high the pixels of a PNG are by its pHYs; 1 where it says nothing that can be, or the file is no PNG.
[[nodiscard]] double pixelAspectOfPng(Bytes png);

/// ITU-R BT.601, as of other coloured images.
[[nodiscard]] std::uint8_t luminanceOf(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

}  // namespace ew::detail
