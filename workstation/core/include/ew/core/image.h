#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ew/core/contract.h"

namespace ew {

/// A window onto pixels someone else owns: (width x height), row after row, `stride` elements from one row to the next.
template <class T>
struct ImageView {
  T* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;

  T* row(int y) const {
    EW_EXPECTS(y >= 0 && y < height);
    return data + y * stride;
  }
  T& at(int x, int y) const {
    EW_EXPECTS(x >= 0 && x < width);
    return row(y)[x];
  }
  operator ImageView<const T>() const { return {data, width, height, stride}; }
};

/// Pixels, row after row without padding. What a pixel measures in mm belongs to whoever made the image.
template <class T>
struct Image {
  int width = 0;
  int height = 0;
  std::vector<T> pixels;

  Image() = default;
  Image(int width_, int height_, T fill = T{})
      : width(width_), height(height_), pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), fill) {}
  bool operator==(const Image&) const = default;
};

template <class T>
ImageView<T> viewOf(Image<T>& image) {
  return {image.pixels.data(), image.width, image.height, image.width};
}
template <class T>
ImageView<const T> viewOf(const Image<T>& image) {
  return {image.pixels.data(), image.width, image.height, image.width};
}

template <class T>
Image<T> copyOf(ImageView<const T> image) {
  Image<T> copy(image.width, image.height);
  for (int y = 0; y < image.height; ++y) std::copy_n(image.row(y), image.width, viewOf(copy).row(y));
  return copy;
}

using GreyImage = Image<std::uint8_t>;
using Rgb = glm::u8vec3;
using RgbImage = Image<Rgb>;

/// A rectangle of pixels; x to the right, y down, from the upper left corner.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  bool operator==(const PixelRect&) const = default;
};

}  // namespace ew
