#pragma once

#include <QImage>

#include "ew/imaging/display_image.h"

namespace ew {

/// An image as Qt draws it. Grey: the image's own pixels, valid as long as they are; with colours: a copy in which they lie over the
/// grey.
[[nodiscard]] QImage imageOf(const DisplayImage& image);
[[nodiscard]] QImage imageOf(ImageView<const std::uint8_t> grey);

/// The pixels of a Format_RGB888.
[[nodiscard]] RgbImage coloursOf(const QImage& image);

}  // namespace ew
