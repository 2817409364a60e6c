#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "ew/core/image.h"
#include "ew/imaging/display.h"
#include "ew/measurement/measurement_list.h"

namespace ew::measurement {

/// What a point is drawn to before it is set.
enum class SnapKind {
  none,
  point,       ///< the cross of another measurement
  edge,        ///< of echoes, along the line that is being drawn; of a first point along the beam
  horizontal,  ///< as deep as the point before; in a strip too
  vertical,    ///< below or above the point before; in a strip at the same moment
};

struct SnapTarget {
  SnapKind kind = SnapKind::none;
  glm::dvec2 at{0.0};  ///< of none: the place itself
  int number = 0;      ///< of the measurement whose cross it is
  bool operator==(const SnapTarget&) const = default;
};

/// What is looked for, and how near.
struct SnapSearch {
  int image = 0;
  double reach_mm = 2.0;
  glm::dvec2 scale{1.0};  ///< of differences of x and y, before they are distances: of a strip mm for each s
  int except = 0;         ///< the measurement whose own crosses are passed over: one of them is being moved
  double beam_rad = 0.0;  ///< direction of the beam there, from y towards x
};

/// What a place is drawn to: a cross within reach before all else, then the edge of echoes, then the level or the plumb line of the point
/// before. @param before the point that the line comes from; empty span: it is the first one @param image empty: edges are not looked for
[[nodiscard]] SnapTarget snapTarget(glm::dvec2 at, const Measurements& shown, std::span<const glm::dvec2> before, const SnapSearch& search,
                                    ImageView<const std::uint8_t> image = {}, const DisplayGeometry& geometry = {});

}  // namespace ew::measurement
