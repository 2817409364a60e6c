#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ew/core/image.h"

/// Images as the two-dimensional registration compares them. Places are in mm from the outer corner of the first pixel, so that levels of
/// different pixels lie on each other: the centre of pixel i is at (i + 1/2) pixel.
namespace ew::registration {

/// Values with their validity, row after row.
struct PlanarImage {
  int width = 0;
  int height = 0;
  glm::dvec2 pixel_mm{1.0};
  std::vector<float> value;
  std::vector<float> weight;  ///< 0..1: how much of what shaped the value lay in the beam
};

/// Grey levels, and a weight of 1 wherever the beam was: 0 is outside where most of the 5 x 5 neighbours are 0 too (a dark vessel is not).
[[nodiscard]] PlanarImage planarImageOf(ImageView<const std::uint8_t> grey, glm::dvec2 pixel_mm);

/// Takes weight from shadows: what stays darker than its depth's median (local means, 2 mm) all the way down to the last row in the beam,
/// and at least 6 mm long. The beam runs along y, away from the first row. A shadow moves with the probe, not with the tissue.
void doubtShadows(PlanarImage& image);

/// Smoothed and sampled with pixels `times` as large (times >= 1), the weights' own smoothing divided out.
/// @param sigma_pixels of the Gaussian, in pixels of `image`
[[nodiscard]] PlanarImage shrunk(const PlanarImage& image, glm::dvec2 times, glm::dvec2 sigma_pixels);

/// Local mean taken out and divided by the local deviation, both within a Gaussian window: what gain and depth gain leave alone.
/// @param floor added to the deviation, in the image's grey levels: what is flatter than this is not blown up to look like tissue
void normaliseLocally(PlanarImage& image, double window_mm, float floor);

/// Gaussian by three running means (window >= 1 pixel), border renormalised by the caller's weights; in place.
void smoothWide(std::vector<float>& values, int width, int height, double sigmaX_pixels, double sigmaY_pixels);

}  // namespace ew::registration
