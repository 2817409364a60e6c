#include "ew/widgets/qt_image.h"

#include <algorithm>

namespace ew {

QImage imageOf(ImageView<const std::uint8_t> grey) {
  return {grey.data, grey.width, grey.height, static_cast<int>(grey.stride), QImage::Format_Grayscale8};
}

QImage imageOf(const DisplayImage& image) {
  if (!image.hasColour()) return imageOf(image.grey);
  const RgbImage flat = composed(image);
  const auto* const bytes = reinterpret_cast<const uchar*>(flat.pixels.data());
  return QImage(bytes, flat.width, flat.height, 3 * flat.width, QImage::Format_RGB888).copy();
}

RgbImage coloursOf(const QImage& image) {
  RgbImage colours(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)  // Qt pads its lines
    std::copy_n(reinterpret_cast<const Rgb*>(image.constScanLine(y)), image.width(), viewOf(colours).row(y));
  return colours;
}

}  // namespace ew
