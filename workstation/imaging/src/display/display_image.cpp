#include "ew/imaging/display_image.h"

namespace ew {

RgbImage composed(const DisplayImage& image) {
  RgbImage result(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y) {
    const std::uint8_t* const grey = image.grey.row(y);
    Rgb* const out = viewOf(result).row(y);
    for (int x = 0; x < image.width(); ++x) out[x] = Rgb(grey[x]);
    if (!image.hasColour()) continue;
    const Rgba* const colour = image.colour.row(y);
    for (int x = 0; x < image.width(); ++x) out[x] = over(colour[x], out[x]);
  }
  return result;
}

}  // namespace ew
