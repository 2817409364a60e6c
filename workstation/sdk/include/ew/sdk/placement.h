#pragma once

#include <glm/glm.hpp>

#include "ew/core/frames.h"

namespace ew::sdk {

/// A rigid placement as people edit it: where the file's origin goes, and how it is turned.
/// The matrix is T(at) * Rz * Ry * Rx: turned about the fixed world axes, first x (patient left), then y (posterior), then z (superior).
struct Placement {
  glm::dvec3 at_mm{0.0};
  glm::dvec3 rotation_deg{0.0};  ///< about x, y, z
  bool operator==(const Placement&) const = default;
};

/// Exact at multiples of 90 degrees: 90 gives zeros and ones, not 6e-17.
[[nodiscard]] Transform<frame::World, frame::File> transformOf(const Placement& placement);
/// The same of a volume in another frame than the world: a moving one in the fixed one.
template <class To, class From>
[[nodiscard]] Transform<To, From> transformOf(const Placement& placement) {
  return renamed<To, From>(transformOf(placement));
}

/// The placement of a rigid matrix: x and z in (-180, 180], y in [-90, 90]. When y is +-90 degrees, x and z turn about the same axis; then
/// x is 0 and z carries the whole turn. transformOf(placementOf(t)) equals t within 1e-12.
[[nodiscard]] Placement placementOf(const Transform<frame::World, frame::File>& rigid);
template <class To, class From>
[[nodiscard]] Placement placementOf(const Transform<To, From>& rigid) {
  return placementOf(renamed<frame::World, frame::File>(rigid));
}

}  // namespace ew::sdk
