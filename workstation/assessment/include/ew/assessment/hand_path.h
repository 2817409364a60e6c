#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <vector>

#include "ew/core/pose.h"
#include "ew/imaging/probe.h"
#include "ew/tracking/hand.h"

namespace ew {

/// Position along a movement of least jerk: 10 t^3 - 15 t^4 + 6 t^5 (Flash and Hogan, J. Neurosci. 5(7), 1985).
/// @param share of the movement's time, 0..1; @return share of its way, 0..1
[[nodiscard]] inline double leastJerk(double share) { return share * share * share * (10.0 + share * (-15.0 + 6.0 * share)); }

/// The hold that shows a plane with the probe pressed on as firmly as in the window, where the plane itself may only touch the skin. Where
/// the probe leans, pressing moves the plane, so the contact is slid back.
/// @param plane rigid, ok
[[nodiscard]] Hold pressedOn(const Pose& plane, const Skin& skin, const Probe& probe);

/// The way of a hand from one hold to another: the contact along the skin below the straight line, the hint carried along without
/// twisting, the probe turning evenly against it, the press changing evenly.
class HandPath {
 public:
  /// @return nothing when no way on the skin leads straight from one to the other
  [[nodiscard]] static std::optional<HandPath> between(const Hold& from, const Hold& to, const Skin& skin);

  /// @param share of the way on the skin, 0..1; @param skin that of between()
  [[nodiscard]] Pose at(double share, const Skin& skin) const;
  /// Of the contact on the skin.
  [[nodiscard]] double length_mm() const { return length_mm_.back(); }
  /// How the probe turns against the skin below it, about its own axes: direction the axis, length the angle in radians, 0..pi.
  [[nodiscard]] glm::dvec3 turn_rad() const;

 private:
  std::vector<Hold> holds_;
  std::vector<double> length_mm_;
  std::array<double, 2> press_mm_{};
  std::array<glm::dquat, 2> turn_{};
};

/// Gaps of a face (gapsToSkin_mm) to sixteenths of a mm, which are written in a few digits: a recording is a fifth shorter, and gel fills
/// gaps fifty times as wide.
[[nodiscard]] std::vector<float> shortened(std::vector<float> gaps_mm);

}  // namespace ew
