#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "ew/core/image.h"

namespace ew {

using Rgba = glm::u8vec4;  ///< straight alpha: 0 shows what lies below, 255 hides it

/// What a frame shows: grey levels, and over them colours where its plan makes some. Views of pixels that belong to someone else.
struct DisplayImage {
  ImageView<const std::uint8_t> grey;
  ImageView<const Rgba> colour = {};  ///< as large as `grey`; width 0: the frame has no colours

  [[nodiscard]] int width() const { return grey.width; }
  [[nodiscard]] int height() const { return grey.height; }
  [[nodiscard]] bool isEmpty() const { return grey.width == 0; }
  [[nodiscard]] bool hasColour() const { return colour.width > 0; }
};

/// One pixel of a colour over one of another, rounded to the nearest level.
[[nodiscard]] inline Rgb over(const Rgba& colour, const Rgb& below) {
  const glm::uvec3 sum = glm::uvec3(below) * (255U - colour.a) + glm::uvec3(colour) * static_cast<unsigned>(colour.a);
  return Rgb((sum + 127U) / 255U);
}

/// The colours of an image laid over its grey levels, rounded to the nearest level.
[[nodiscard]] RgbImage composed(const DisplayImage& image);

}  // namespace ew
