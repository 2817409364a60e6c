#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "ew/core/image.h"
#include "ew/trackers/camera_model.h"
#include "ew/trackers/camera_tracking.h"

namespace ew {

/// A marker's four corners as measured in an image.
struct MarkerCorners {
  std::array<glm::dvec2, 4> rays{};  ///< (X/Z, Y/Z), the lens taken back
  /// Where they go when every side moves outwards by its own edge's spread: black that ran or light that bled moves a side in proportion.
  std::array<glm::dvec2, 4> perBleed{};
  std::array<glm::dvec2, 4> corners_px{};
  double spread_px = 0.0;                 ///< standard deviation of a corner, from how straight the sides are; 0: not known
  std::array<glm::dvec2, 4> across{};     ///< unit normals of the sides in the image
  std::array<double, 4> edgeSpread_px{};  ///< standard deviation of each side's edge across it: what blurs it
};

/// Corners from the four sides of a black square on white: points of each side where the light has risen half way between black and
/// white, found by the area under the profile across it (no bias from any symmetric blur, nor from noise); through their rays a line by
/// Tukey's weights; corners where lines meet, so that a round printed corner and a hand over a part of a side do no harm.
/// @param about the corners to within about half a cell, clockwise as seen in the image
/// @param cells modules along a side with the black border, 6 for 4 x 4 bits
/// @param light what a grey level stands for, 0..255: blur adds light, so the middle of an edge is to be looked for in light
/// Empty where a side is not seen over at least half its length, or is no line between dark and light.
[[nodiscard]] std::optional<MarkerCorners> cornersByEdges(ImageView<const std::uint8_t> grey, const CameraModel& model,
                                                          const std::array<glm::dvec2, 4>& about, int cells,
                                                          const std::array<float, 256>& light);

/// Light of grey levels that encode it to the power of 1 / gamma.
[[nodiscard]] std::array<float, 256> lightOfGreys(double gamma);

/// Corners as they are given.
[[nodiscard]] MarkerCorners cornersAsGiven(const CameraModel& model, const std::array<glm::dvec2, 4>& corners_px);

}  // namespace ew
