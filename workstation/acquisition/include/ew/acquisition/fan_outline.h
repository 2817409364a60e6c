#pragma once

#include <array>
#include <glm/glm.hpp>

#include "ew/acquisition/reconstruct.h"
#include "ew/core/image.h"
#include "ew/core/word_table.h"

namespace ew {

/// Which part of a screen a scan fills.
enum class FanShape {
  linear,  ///< four straight sides: rectangle, steered parallelogram, trapezoid
  convex,  ///< two straight sides of one apex, near and far arc about it
  sector   ///< the same with the apex at the face (near radius below a tenth of the far one): phased arrays
};
inline constexpr WordTable<FanShape, 3> kFanShapeWords{
    {{"linear", FanShape::linear}, {"convex", FanShape::convex}, {"sector", FanShape::sector}}};

/// The outline of a scan, in pixels of the image it lies in; pixel centres at integers, y down.
struct FanOutline {
  FanShape shape = FanShape::linear;
  std::array<glm::dvec2, 4> corners_px{};  ///< linear: upper left, upper right, lower right, lower left
  glm::dvec2 apex_px{0.0};                 ///< convex and sector, and the four below
  double left_rad = 0.0;                   ///< atan2(x, y) from the downward axis: usually below 0
  double right_rad = 0.0;                  ///< above left_rad
  double near_px = 0.0;
  double far_px = 0.0;

  /// "rectangle", "parallelogram" or "trapezoid" for linear, by angles of its sides (1.5 degrees); else the word of the shape.
  [[nodiscard]] const char* word() const;
  [[nodiscard]] bool contains(glm::dvec2 p_px) const;
  /// Along the beams: far - near radius, or the mean height of the upright sides.
  [[nodiscard]] double depth_px() const;
  /// Upper left and lower right corner of the smallest rectangle that holds it.
  [[nodiscard]] std::array<glm::dvec2, 2> bounds_px() const;
  /// Points along it, at most `step_px` apart, clockwise from the upper left corner: to draw it.
  [[nodiscard]] std::vector<glm::dvec2> points_px(double step_px = 2.0) const;
  [[nodiscard]] FanOutline movedBy(glm::dvec2 offset_px) const;
  bool operator==(const FanOutline&) const = default;
};

/// The part of a frame that a reconstruction takes: the fan for convex and sector; for linear the upright rectangle inside its sides.
[[nodiscard]] Clip clipOf(const FanOutline& outline);

/// 1 for each pixel whose centre lies inside.
[[nodiscard]] GreyImage maskOf(const FanOutline& outline, int width_px, int height_px);

}  // namespace ew
