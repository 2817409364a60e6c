#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/library/placing.h"
#include "ew/library/probe_side.h"
#include "ew/sdk/overlays.h"

namespace ew::case_authoring {

using FilePlace = Transform<frame::World, frame::File>;
using HandlesPose = Transform<frame::World, sdk::BodyHandles::Frame>;

/// Which of the six faces the beams of `axes` enter squarely, within 2 degrees; nothing when they are oblique to all.
[[nodiscard]] std::optional<std::size_t> faceOf(const Grid& own, const SweepAxes& axes);
/// The face on which the probe was, as far as it can be guessed: near to the skin, looking inwards, and best along `beam`, the direction in
/// which the case's probe looks at its start. Without one probes are taken to look in from the front.
[[nodiscard]] std::size_t likelyFace(const Grid& own, const FilePlace& fileToWorld, const Skin& skin,
                                     const std::optional<glm::dvec3>& beam);

/// The shape of voxels whose grid says where they lay once. @param own where they lie in the volume's file
[[nodiscard]] PlacingShape shapeOf(const Volume& voxels, const Grid& own, const SweepAxes& axes);

/// Handles on a placed volume: x lateral, y along the beams, z across both; in the volume's middle.
[[nodiscard]] sdk::BodyHandles handlesOf(const Grid& own, const SweepAxes& axes, const FilePlace& fileToWorld);
/// The placement after handles that stood at `before` have come to stand at `now`. The same when they have not moved.
[[nodiscard]] FilePlace movedWith(const FilePlace& fileToWorld, const HandlesPose& before, const HandlesPose& now);

/// Turned about the beam through the volume's middle.
[[nodiscard]] FilePlace turnedAboutBeam(const Grid& own, const SweepAxes& axes, const FilePlace& fileToWorld, double angle_rad);
/// The near face flush on the skin at a point of it, the beams straight in; the marker points where it pointed, as far as that can be.
[[nodiscard]] FilePlace putOnSkin(const PlacingShape& shape, const FilePlace& fileToWorld, const Skin& skin, const Point<frame::World>& at);

/// A point of the near face, and how it lies against the skin.
struct FaceMark {
  enum class Kind { touching, above, below };
  Point<frame::World> at;
  Kind kind = Kind::touching;
};
/// At most `most` of them, spread over the face; within kGel_mm counts as touching.
[[nodiscard]] std::vector<FaceMark> faceMarksOf(const PlacingShape& shape, const FilePlace& fileToWorld, const Skin& skin,
                                                std::size_t most);
/// The corners of the near side of the box, in order around it.
[[nodiscard]] std::array<Point<frame::World>, 4> nearSideOf(const Grid& own, const SweepAxes& axes, const FilePlace& fileToWorld);

/// What there is to say of a contact.
enum class ContactVerdict { good, standsOff, liesBelow, tipped, outside };
[[nodiscard]] ContactVerdict verdictOf(const Contact& contact);

}  // namespace ew::case_authoring
