#pragma once

#include <optional>

#include "ew/assessment/plane_error.h"
#include "ew/core/message.h"
#include "ew/tracking/hand.h"

namespace ew {

/// A target plane as a hand on the skin reaches it.
struct CompassTarget {
  PlaneTarget plane;
  PlaneTolerance tolerance;
  Hold hold;               ///< of the plane, or the nearest that a probe on the skin can do
  PlaneError left;         ///< of that hold's pose from the plane
  bool reachable = false;  ///< that hold is within half of the tolerance
};

/// The hold of a target plane on a skin, worked out once.
/// @param plane rigid; @param tolerance both above 0
[[nodiscard]] CompassTarget compassTargetOf(const PlaneTarget& plane, const PlaneTolerance& tolerance, const Skin& skin);

/// The one thing to do next.
enum class HandMovement {
  stay,       ///< the plane is found
  slide,      ///< over the skin, along one of the patient's axes
  rotate,     ///< about the beam
  turnRound,  ///< the same by about 180 degrees: the marker points the wrong way
  tilt,       ///< fan: the plane itself tips
  rock,       ///< within the plane: heel and toe
  press,      ///< into the skin, or less of it
  none        ///< the plane cannot be reached from the skin
};

/// Directions of the patient, as far as the skin leaves them.
enum class PatientSide { left, right, head, feet, front, back };

struct CompassAdvice {
  HandMovement movement = HandMovement::stay;
  PatientSide towards = PatientSide::left;  ///< of slide, tilt and rock: where the probe, or the beam, goes
  double amount = 0.0;        ///< of slide and press mm, of the others degrees; whole; rotate: above 0 clockwise seen from above the probe;
                              ///< press: above 0 deeper; of the others above 0
  glm::dvec3 along{0.0};      ///< of slide: the unit tangent at the contact to slide along, world
  double signedAmount = 0.0;  ///< of tilt and rock: `amount` in the sense of Hold's angles
  Message text;               ///< a sentence for the hand
  bool operator==(const CompassAdvice&) const = default;
};

/// What to do next to come from `now` to the target, in the order a teacher takes: slide to the region, turn the probe about its beam, tip
/// it, then whatever is farthest out, each in units of what the tolerance leaves it. Contacts, rotation and tips are compared, not matrices
/// (decision 0054): the target's lateral axis is carried to where the probe stands, so that the advice stays the same while one slides over
/// curved skin. A movement goes on until little of it is left, and a found plane counts as found until it is left again, so that advice
/// does not chatter.
/// @param before what was advised last for this target; nothing at first
[[nodiscard]] CompassAdvice nextMovement(const CompassTarget& target, const Hold& now, const std::optional<CompassAdvice>& before = {});

}  // namespace ew
