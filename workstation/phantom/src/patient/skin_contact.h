#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/core/frames.h"
#include "ew/imaging/probe.h"
#include "shapes/shape.h"

namespace ew::phantom {

/// Unit outward normal of the skin near a point, over a patch of +-`patch_mm`: fine creases do not turn a probe.
[[nodiscard]] glm::dvec3 skinNormal(const Shape& skin, const glm::dvec3& p_mm, double patch_mm);

/// The point of the skin that is reached from `near_mm` straight along the normals, within 0.001 mm; empty when it is more than
/// kFarthestFromSkin_mm away or the search does not settle.
inline constexpr double kFarthestFromSkin_mm = 80.0;
[[nodiscard]] std::optional<glm::dvec3> skinPointNear(const Shape& skin, const glm::dvec3& near_mm);

/// How far a probe whose face's centre lies on the skin must be drawn back along its central beam until no part of the face is inside the
/// body: 0 for a face that touches with its centre, mm >= 0. Empty when it would have to go back further than `most_mm`.
[[nodiscard]] std::optional<double> drawnBack_mm(const Shape& skin, const Probe& probe,
                                                 const Transform<frame::World, frame::Probe>& probeToWorld, double most_mm);

/// How far each of `count` points of the face is from the skin along the central beam, mm, at most `most_mm`; 0 for a point at or inside
/// the skin.
[[nodiscard]] std::vector<double> gapsToSkin_mm(const Shape& skin, const Probe& probe,
                                                const Transform<frame::World, frame::Probe>& probeToWorld, int count, double most_mm);

}  // namespace ew::phantom
