#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "ew/acquisition/reconstruct.h"

namespace ew::sweeps {

/// Frames that own their pixels, and the views of them that reconstruct() takes.
struct Sweep {
  std::deque<GreyImage> images;
  std::vector<TrackedFrame> frames;

  void add(GreyImage image, const glm::dmat4& imageToWorld) {
    images.push_back(std::move(image));
    frames.push_back({viewOf(std::as_const(images.back())), {imageToWorld}});
  }
};

/// An image whose pixel (x, y) is value(x, y).
inline GreyImage imageOf(int width, int height, const std::function<int(int, int)>& value) {
  GreyImage image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) viewOf(image).at(x, y) = static_cast<std::uint8_t>(value(x, y));
  return image;
}

/// Image to world: the columns are mm per pixel along x, y and the normal, and the first pixel.
inline glm::dmat4 matrixOf(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& origin) {
  return {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(origin, 1.0)};
}

/// Parallel frames in the x-y plane, `step` apart along z, one pixel to the mm.
inline Sweep stack(int width, int height, int count, double step_mm, const std::function<int(int, int, int)>& value) {
  Sweep sweep;
  for (int n = 0; n < count; ++n)
    sweep.add(imageOf(width, height, [&](int x, int y) { return value(x, y, n); }),
              matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, n * step_mm}));
  return sweep;
}

}  // namespace ew::sweeps
