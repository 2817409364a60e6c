#include "ew/imaging/picture.h"

namespace ew {

RgbImage composed(const Picture& picture) {
  RgbImage result(picture.width(), picture.height());
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* const grey = picture.grey.row(y);
    Rgb* const out = viewOf(result).row(y);
    for (int x = 0; x < picture.width(); ++x) out[x] = Rgb(grey[x]);
    if (!picture.hasColour()) continue;
    const Rgba* const colour = picture.colour.row(y);
    for (int x = 0; x < picture.width(); ++x) out[x] = over(colour[x], out[x]);
  }
  return result;
}

}  // namespace ew
