#include "meant_size.h"

#include <algorithm>
#include <cmath>

#include "ew/acquisition/sweep_geometry.h"
#include "ew/core/contract.h"
#include "ew/core/figures.h"

namespace ew {
namespace {

// A probe of 50 MHz shows pixels of 0.01 mm, a probe that sees 40 cm deep in 128 lines pixels of 3 mm.
constexpr double kSmallestPixel_mm = 0.005;
constexpr double kLargestPixel_mm = 5.0;
constexpr double kFewestVoxels = 3.0;  // below, an image is a stamp of one or two
constexpr double kManyPixels = 100.0;  // an image that has them was not meant to become that
constexpr std::size_t kManyFrames = 10;
constexpr std::size_t kFewestMoved = 3;      // two may be anything
constexpr double kSamePlace_mm = 1e-6;       // poses that are all the same were written so
constexpr double kLargestGap_voxels = 50.0;  // of which a frame measures one or two

Message figure(double value) { return numeral(figureText(value, 3)); }

glm::dvec2 pixelSize_mm(const TrackedFrame& frame) {
  const glm::dmat4& matrix = frame.imageToWorld.matrix;
  return {glm::length(glm::dvec3(matrix[0])), glm::length(glm::dvec3(matrix[1]))};
}

/// How far the corner that moves most gets away from where it is in the first frame.
double movement_mm(std::span<const TrackedFrame> frames, const ClipRectangle& clipped) {
  double largest_mm = 0.0;
  for (const double x : {clipped.left, clipped.right})
    for (const double y : {clipped.top, clipped.bottom}) {
      const Point<frame::Image> corner_px{{x, y, 0.0}};
      const glm::dvec3 first_mm = (frames.front().imageToWorld * corner_px).at;
      for (const TrackedFrame& frame : frames)
        largest_mm = std::max(largest_mm, glm::distance(first_mm, (frame.imageToWorld * corner_px).at));
    }
  return largest_mm;
}

}  // namespace

Message questionAboutMovement(std::span<const TrackedFrame> frames, const ClipRectangle& clipped, double spacing_mm) {
  EW_EXPECTS(!frames.empty());
  if (frames.size() < kFewestMoved) return {};
  const glm::dvec2 used_px(clipped.right - clipped.left + 1.0, clipped.bottom - clipped.top + 1.0);
  const double moved_mm = movement_mm(frames, clipped);
  const bool isManyAndLarge = frames.size() >= kManyFrames && used_px.x >= kManyPixels && used_px.y >= kManyPixels;
  const bool isFlat = moved_mm > kSamePlace_mm && moved_mm < 0.5 * spacing_mm;
  if (isFlat || (isManyAndLarge && moved_mm < 2.0 * spacing_mm))
    return say<
        "Through all %1 frames the image moves by no more than %2 mm, which is less than two voxels: are the poses in metres? They count "
        "millimetres; correct them, or say that the probe was held still.">(frames.size(), figure(moved_mm));
  const glm::dvec2 used_mm = used_px * pixelSize_mm(frames.front());
  const double gap_mm = frameDistance_mm(frames);
  if (gap_mm <= kLargestGap_voxels * spacing_mm || gap_mm <= std::max(used_mm.x, used_mm.y)) return {};
  return say<
      "Neighbouring frames lie %1 mm apart, which is more than the image of %2 x %3 mm is large, so that next to nothing of the volume "
      "would be measured: are the poses in micrometres? They count millimetres; correct them, or say that so large a volume is meant.">(
      figure(gap_mm), figure(used_mm.x), figure(used_mm.y));
}

Message questionAboutSize(std::span<const TrackedFrame> frames, const ClipRectangle& clipped, double spacing_mm) {
  EW_EXPECTS(!frames.empty());
  const auto& pixels = frames.front().pixels;
  const glm::dvec2 pixel_mm = pixelSize_mm(frames.front());
  const glm::dvec2 image_mm = pixel_mm * glm::dvec2(pixels.width, pixels.height);
  if (std::min(pixel_mm.x, pixel_mm.y) < kSmallestPixel_mm)
    return say<
        "With this calibration a pixel is %1 x %2 mm and the whole image %3 x %4 mm: is the matrix in metres? Matrices count millimetres; "
        "correct it, or say that so small an image is meant.">(figure(pixel_mm.x), figure(pixel_mm.y), figure(image_mm.x),
                                                               figure(image_mm.y));
  if (std::max(pixel_mm.x, pixel_mm.y) > kLargestPixel_mm)
    return say<
        "With this calibration a pixel is %1 x %2 mm and the whole image %3 x %4 mm: is the matrix in micrometres? Matrices count "
        "millimetres; correct it, or say that so large an image is meant.">(figure(pixel_mm.x), figure(pixel_mm.y), figure(image_mm.x),
                                                                            figure(image_mm.y));
  const glm::dvec2 used_px(clipped.right - clipped.left + 1.0, clipped.bottom - clipped.top + 1.0);
  const glm::dvec2 voxels = used_px * pixel_mm / spacing_mm;
  if ((used_px.x >= kManyPixels && voxels.x < kFewestVoxels) || (used_px.y >= kManyPixels && voxels.y < kFewestVoxels))
    return say<
        "With voxels of %1 mm an image of %2 x %3 pixels would become %4 x %5 voxels; give a finer spacing, check the calibration for a "
        "wrong scale, or say that so few are meant.">(figure(spacing_mm), std::lround(used_px.x), std::lround(used_px.y),
                                                      std::max(1L, std::lround(voxels.x)), std::max(1L, std::lround(voxels.y)));
  return {};
}

}  // namespace ew
