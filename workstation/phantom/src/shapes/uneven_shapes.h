#pragma once

#include <cstdint>

#include "shapes/shape.h"

namespace ew::phantom {

// Shapes that are uneven as tissue is. All are made of noise hashed from a seed and the place, so they are the same on every machine.

/// The surface of a shape, moved in and out by smooth noise; inside and far outside as it was.
struct Roughness {
  double amplitude_mm = 0.5;  ///< at most this far; at most half of length_mm
  double length_mm = 10.0;    ///< size of bumps
  std::uint64_t seed = 1;
};
[[nodiscard]] ShapePtr makeRough(ShapePtr of, const Roughness& roughness);

/// Thin sheets one below the other between two depths below a surface, as fasciae: undulating, merging where they meet, with gaps.
struct Sheets {
  double fromDepth_mm = 0.0;
  double toDepth_mm = 10.0;
  double spacing_mm = 2.5;  ///< mean of a log-normal distribution with a spread of half of it
  double thickness_mm = 0.5;
  double undulation_mm = 0.6;  ///< root mean square
  double length_mm = 15.0;     ///< of undulations
  double missing = 0.2;        ///< about this share of every sheet
  std::uint64_t seed = 1;
};
[[nodiscard]] ShapePtr makeSheets(ShapePtr below, const Sheets& sheets);

/// The walls between lobules, as septa of fat, between two depths below a surface: the faces of a Voronoi diagram. Lobules lie along
/// the surface of a body that stands upright.
struct Septa {
  double fromDepth_mm = 0.0;
  double toDepth_mm = 10.0;
  glm::dvec3 lobule_mm{12.0, 5.0, 12.0};  ///< around the body, in depth, along z
  double thickness_mm = 0.5;
  std::uint64_t seed = 1;
};
[[nodiscard]] ShapePtr makeSepta(ShapePtr below, const Septa& septa);

/// Rounded patches that fill about this share of space, to be cut with something: gas in a bowel.
struct Patches {
  glm::dvec3 size_mm{8.0};
  double share = 0.5;
  std::uint64_t seed = 1;
};
[[nodiscard]] ShapePtr makePatches(const Patches& patches);

}  // namespace ew::phantom
