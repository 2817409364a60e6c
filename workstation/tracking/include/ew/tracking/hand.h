#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "ew/core/frames.h"
#include "ew/core/pose.h"

namespace ew {

/// The surface a probe slides on.
class Skin {
 public:
  struct Contact {
    glm::dvec3 point_mm{0.0};  ///< on the surface, world
    glm::dvec3 outward{0.0};   ///< unit normal, smoothed over about the size of a probe's face
  };
  virtual ~Skin();
  /// First hit of the ray, or empty.
  [[nodiscard]] virtual std::optional<Contact> hit(const glm::dvec3& from_mm, const glm::dvec3& direction) const = 0;
  /// The point of the surface nearest to p.
  [[nodiscard]] virtual Contact nearest(const glm::dvec3& p_mm) const = 0;
};

/// How a hand holds the probe: where it touches the skin, and three angles against the skin's normal there.
/// rotation turns about the beam axis (the normal); rock tips the fan within its own plane; tilt (fanning) tips the plane itself.
struct Hold {
  Skin::Contact contact;
  glm::dvec3 lateralHint{-1.0, 0.0,
                         0.0};  ///< world direction the marker points to before rotation, projected onto the skin (patient's right)
  double rotation_rad = 0.0;
  double rock_rad = 0.0;
  double tilt_rad = 0.0;
};

inline constexpr double kMaxTip_rad = 1.2217304763960306;  ///< 70 degrees: further and the face has left the skin

/// The pose of a hold: y of the probe looks into the body.
[[nodiscard]] Pose poseOf(const Hold& hold);

/// Slides the contact by (right, down) mm as seen along the probe: over the surface, keeping contact, angles and hint.
[[nodiscard]] Hold slid(const Hold& hold, const Skin& skin, double alongLateral_mm, double alongElevational_mm);

/// Puts the contact elsewhere, keeping the angles.
[[nodiscard]] Hold movedTo(const Hold& hold, const Skin::Contact& contact);

[[nodiscard]] Hold turned(const Hold& hold, double rotation_rad, double rock_rad, double tilt_rad);

/// The hold that reproduces a pose as well as a probe on the skin can.
[[nodiscard]] Hold holdFor(const Pose& pose, const Skin& skin);

}  // namespace ew
