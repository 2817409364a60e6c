#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "ew/core/frames.h"
#include "ew/core/pose.h"

namespace ew {

/// The surface a probe slides on. Reading is safe from several threads at once.
class Skin {
 public:
  struct Contact {
    glm::dvec3 point_mm{0.0};  ///< on the surface, world
    glm::dvec3 outward{0.0};   ///< unit normal, smoothed over about the size of a probe's face
    bool operator==(const Contact&) const = default;
  };
  virtual ~Skin();
  /// First hit of the ray (`direction` need not be a unit vector), or empty.
  [[nodiscard]] virtual std::optional<Contact> hit(const glm::dvec3& from_mm, const glm::dvec3& direction) const = 0;
  /// The point of the surface nearest to p.
  [[nodiscard]] virtual Contact nearest(const glm::dvec3& p_mm) const = 0;
};

/// How a hand holds the probe: where it touches the skin, and three angles against the skin's normal there.
/// rotation turns about the beam axis (the normal); rock tips the fan within its own plane; tilt (fanning) tips the plane itself.
/// With B = (lateral, into the body, elevational) at the contact, the axes of the probe are B * Ry(rotation) * Rx(tilt) * Rz(rock).
struct Hold {
  Skin::Contact contact;
  /// World direction the marker points to before rotation, projected onto the skin (at first the patient's right). Not zero.
  glm::dvec3 lateralHint{-1.0, 0.0, 0.0};
  double rotation_rad = 0.0;
  double rock_rad = 0.0;
  double tilt_rad = 0.0;
  /// How far the face's foremost point is pressed in from the contact, against the normal: skin gives way, so that the sides of a curved
  /// face touch as well. 0..kMaxPress_mm.
  double press_mm = 0.0;
  bool operator==(const Hold&) const = default;
};

inline constexpr double kMaxPress_mm = 20.0;               ///< a firm hand on a soft belly
inline constexpr double kMaxTip_rad = 1.2217304763960306;  ///< 70 degrees: further and the face has left the skin

/// The pose of a hold: y of the probe looks into the body, its origin lies press_mm below the contact. Rock and tilt together never tip the
/// beam further from the normal than kMaxTip_rad: what is asked beyond is scaled back. A hint along the normal says nothing; then the
/// marker points around the body to the patient's right as seen from the front (normal x superior), on top of the head to the patient's
/// right. A press outside of 0..kMaxPress_mm is brought to the nearer end. Expects a unit normal and finite numbers.
[[nodiscard]] Pose poseOf(const Hold& hold);

/// poseOf without rock and tilt: x and z span the skin's tangent plane as a rotated probe sees it.
[[nodiscard]] Pose uprightPoseOf(const Hold& hold);

/// Slides the contact over the surface along the probe's lateral (x) and elevational (z) axes, as a path of that length on the skin.
/// Angles and press are kept; the hint is carried along the path without twisting, so that a probe sliding around the flank goes on
/// where it was heading, rather than turning round where the first hint meets the normal. Edges are crossed in both directions; where
/// the surface ends the probe stays at its rim. At most 2000 mm in one call; longer ways are cut.
[[nodiscard]] Hold slid(const Hold& hold, const Skin& skin, double alongLateral_mm, double alongElevational_mm);

/// Puts the contact elsewhere, keeping angles and press; the hint turns as little as the two normals allow (about the body's long axis when
/// they are opposite).
[[nodiscard]] Hold movedTo(const Hold& hold, const Skin::Contact& contact);

/// Turned further by these angles; rotation is kept in [-pi, pi], rock and tilt within kMaxTip_rad as in poseOf.
[[nodiscard]] Hold turned(const Hold& hold, double byRotation_rad, double byRock_rad, double byTilt_rad);

/// The hold that reproduces a pose as well as a probe on the skin can: the contact whose normal passes through the pose's origin, pressed
/// in as far as that origin lies below the skin (0 when it lies above, at most kMaxPress_mm), the pose's axes as far as kMaxTip_rad
/// allows. The hint is the patient's right, or posterior where the skin faces right or left. Expects a pose that is ok and
/// that checkRigid accepts.
[[nodiscard]] Hold holdFor(const Pose& pose, const Skin& skin);

}  // namespace ew
