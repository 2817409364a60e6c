#include "ew/assessment/compass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "ew/core/contract.h"
#include "measures/compass_words.h"

namespace ew {
namespace {

constexpr double kRegion_mm = 25.0;       // nearer than this the probe stands in the region and is turned first
constexpr double kCoarse_deg = 15.0;      // further out than this an angle is brought near before anything is refined
constexpr double kTurnRound_deg = 150.0;  // of rotation; the marker points the wrong way
constexpr double kStillFound = 1.0;       // of the tolerance: a found plane is left beyond it ...
constexpr double kFound = 0.75;           // ... and found within this
constexpr double kRelease = 0.2;          // of what the tolerance leaves a movement: then the next one may come
constexpr double kAboutRight_deg = 5.0;   // the same while angles are brought near
constexpr double kAboutThere_mm = 8.0;    // ... and while sliding to the region

/// What is left to do, each in its own measure.
struct Left {
  glm::dvec3 slide_mm{0.0};  ///< along the tangent plane at the contact; its length is the way over the skin
  glm::dvec3 across{0.0};    ///< unit normal of the target plane, carried to the contact; a slide along the plane leaves it where it is
  double rotate_deg = 0.0;
  double tilt_deg = 0.0;
  double rock_deg = 0.0;
  double press_mm = 0.0;
};

/// What the tolerance leaves to each.
struct Units {
  double slide_mm = 1.0;
  double rotate_deg = 1.0;
  double tip_deg = 1.0;
};

/// Two directions across the skin that a patient's words name: along the body, and around it.
struct SkinAxes {
  glm::dvec3 along, around;
};

SkinAxes axesAt(const glm::dvec3& outward) {
  glm::dvec3 along(0.0, 0.0, 1.0);
  along -= glm::dot(along, outward) * outward;
  // On top of the head there is no way to the head: then front and back are along.
  if (glm::length(along) < 0.2) along = glm::dvec3(0.0, 1.0, 0.0) - outward.y * outward;
  along = glm::normalize(along);
  return {along, glm::cross(along, outward)};
}

PatientSide sideOf(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  if (size.z >= size.x && size.z >= size.y) return direction.z > 0.0 ? PatientSide::head : PatientSide::feet;
  if (size.x >= size.y) return direction.x > 0.0 ? PatientSide::left : PatientSide::right;
  return direction.y > 0.0 ? PatientSide::back : PatientSide::front;
}

/// Whether a contact lies on the other side of the body.
bool isOpposite(const Skin::Contact& a, const Skin::Contact& b) { return glm::dot(a.outward, b.outward) < 0.0; }

/// The way over the skin to a contact: along the chord's tangent, as long as an arc whose ends have these normals. To the other side of
/// the body the chord's tangent says next to nothing of how far it is around, so that is what the arc leaves once the way along the body is
/// gone.
glm::dvec3 wayTo(const Skin::Contact& target, const Skin::Contact& now) {
  const glm::dvec3 chord = target.point_mm - now.point_mm;
  const double chord_mm = glm::length(chord);
  if (chord_mm < 1e-9) return glm::dvec3(0.0);
  const double half_rad = std::asin(std::clamp(0.5 * glm::length(target.outward - now.outward), 0.0, 1.0));
  const double way_mm = half_rad < 1e-6 ? chord_mm : chord_mm * half_rad / std::sin(half_rad);
  const glm::dvec3 tangent = chord - glm::dot(chord, now.outward) * now.outward;
  if (!isOpposite(target, now) && glm::length(tangent) > 0.05 * chord_mm) return way_mm * glm::normalize(tangent);
  const SkinAxes axes = axesAt(now.outward);
  const double along_mm = glm::dot(chord, axes.along);
  const double around_mm = std::sqrt(std::max(0.0, way_mm * way_mm - along_mm * along_mm));
  return along_mm * axes.along + std::copysign(around_mm, glm::dot(chord, axes.around)) * axes.around;
}

Left leftTo(const CompassTarget& target, const Hold& now) {
  Left left;
  left.slide_mm = wayTo(target.hold.contact, now.contact);
  const glm::dmat3 here(uprightPoseOf(now).probeToWorld.matrix);
  const glm::dmat4 carriedTarget = uprightPoseOf(movedTo(target.hold, now.contact)).probeToWorld.matrix;
  const glm::dvec3 asked(carriedTarget[0]);
  left.across = glm::dvec3(carriedTarget[2]);
  // The angle about the beam that takes the probe's lateral axis there: x turned by r lies at x cos r - z sin r.
  left.rotate_deg = glm::degrees(std::atan2(-glm::dot(asked, here[2]), glm::dot(asked, here[0])));
  left.tilt_deg = glm::degrees(target.hold.tilt_rad - now.tilt_rad);
  left.rock_deg = glm::degrees(target.hold.rock_rad - now.rock_rad);
  left.press_mm = target.hold.press_mm - now.press_mm;
  return left;
}

/// A tip moves a deep point of interest out of the plane much sooner than the angle itself is out of tolerance.
Units unitsOf(const CompassTarget& target) {
  const double depth_mm = std::max(1.0, std::abs(target.plane.interest_mm.y));
  const double lateral_mm = std::max(1.0, std::abs(target.plane.interest_mm.x));
  const auto limited = [&](double arm_mm) {
    return std::min(target.tolerance.angle_deg, glm::degrees(std::atan2(target.tolerance.position_mm, arm_mm)));
  };
  return {target.tolerance.position_mm, limited(lateral_mm), limited(depth_mm)};
}

/// How much a slide matters, mm: out of the plane in full, along it as far as the target's place in the image counts.
double weightOf(const glm::dvec3& slide_mm, const glm::dvec3& across) {
  const double out_mm = glm::dot(slide_mm, across);
  return std::max(std::abs(out_mm), glm::length(slide_mm - out_mm * across) / kInImageFactor);
}

double wholeOf(double amount) { return std::max(1.0, std::round(std::abs(amount))); }

CompassAdvice told(CompassAdvice advice) {
  advice.text = assessment::sentenceOf(advice);
  return advice;
}

/// One of the patient's two directions across the skin: the one that more is left of, unless the other is being slid along. Near the
/// target the one that brings the plane nearer.
CompassAdvice slideBy(const Left& left, const Hold& target, const Hold& now, const std::optional<CompassAdvice>& before, bool isFar,
                      double release_mm) {
  const SkinAxes axes = axesAt(now.contact.outward);
  const double along_mm = glm::dot(left.slide_mm, axes.along);
  const double around_mm = glm::dot(left.slide_mm, axes.around);
  const auto matters = [&](double amount_mm, const glm::dvec3& way) {
    return isFar ? std::abs(amount_mm) : weightOf(amount_mm * way, left.across);
  };
  bool isAlong = matters(along_mm, axes.along) > matters(around_mm, axes.around);
  if (before && before->movement == HandMovement::slide) {
    const bool wasAlong = std::abs(glm::dot(before->along, axes.along)) > std::abs(glm::dot(before->along, axes.around));
    if ((wasAlong ? matters(along_mm, axes.along) : matters(around_mm, axes.around)) > release_mm) isAlong = wasAlong;
  }
  double amount_mm = isAlong ? along_mm : around_mm;
  // On the far side both ways around are about as long, and which is shorter changes with every tremor: the way goes on as it began.
  const bool wentAround = before && before->movement == HandMovement::slide &&
                          std::abs(glm::dot(before->along, axes.around)) > std::abs(glm::dot(before->along, axes.along));
  if (!isAlong && wentAround && isOpposite(target.contact, now.contact))
    amount_mm = std::copysign(amount_mm, glm::dot(before->along, axes.around));
  CompassAdvice advice;
  advice.movement = HandMovement::slide;
  advice.along = (amount_mm < 0.0 ? -1.0 : 1.0) * (isAlong ? axes.along : axes.around);
  advice.towards = sideOf(advice.along);
  advice.amount = wholeOf(amount_mm);
  return told(advice);
}

CompassAdvice rotateBy(const Left& left, const std::optional<CompassAdvice>& before) {
  CompassAdvice advice;
  double rotate_deg = left.rotate_deg;
  // At half a turn the shorter way changes with every tremor; a turn goes on the way it began.
  const bool turning = before && (before->movement == HandMovement::rotate || before->movement == HandMovement::turnRound);
  if (turning && before->amount * rotate_deg < 0.0 && std::abs(rotate_deg) > kTurnRound_deg)
    rotate_deg += rotate_deg < 0.0 ? 360.0 : -360.0;
  advice.movement = std::abs(rotate_deg) > kTurnRound_deg ? HandMovement::turnRound : HandMovement::rotate;
  advice.amount = std::copysign(wholeOf(rotate_deg), rotate_deg);
  return told(advice);
}

/// Tips name where the beam goes: a tilt tips it towards the upright probe's +z as turned by rotation, a rock towards its -x.
CompassAdvice tipBy(HandMovement movement, double by_deg, const Hold& now) {
  const glm::dmat3 upright(uprightPoseOf(now).probeToWorld.matrix);
  const double sign = by_deg < 0.0 ? -1.0 : 1.0;
  CompassAdvice advice;
  advice.movement = movement;
  advice.towards = sideOf(sign * (movement == HandMovement::tilt ? upright[2] : -upright[0]));
  advice.amount = wholeOf(by_deg);
  advice.signedAmount = sign * advice.amount;
  return told(advice);
}

CompassAdvice pressBy(double by_mm) {
  CompassAdvice advice;
  advice.movement = HandMovement::press;
  advice.amount = std::copysign(wholeOf(by_mm), by_mm);
  return told(advice);
}

/// The movements with what is left of each in units of the tolerance.
struct Candidate {
  HandMovement movement;
  double share;
};

bool isSame(HandMovement a, HandMovement b) {
  const auto plain = [](HandMovement m) { return m == HandMovement::turnRound ? HandMovement::rotate : m; };
  return plain(a) == plain(b);
}

/// What a teacher would have done first, or what is farthest out once everything is about right.
HandMovement chosen(const Left& left, const Units& units, const std::optional<CompassAdvice>& before) {
  const auto goesOn = [&](HandMovement movement) { return before && isSame(before->movement, movement); };
  const auto isFarOut = [&](HandMovement movement, double left_deg) {
    return std::abs(left_deg) > (goesOn(movement) ? kAboutRight_deg : kCoarse_deg);
  };
  if (glm::length(left.slide_mm) > (goesOn(HandMovement::slide) ? kAboutThere_mm : kRegion_mm)) return HandMovement::slide;
  if (isFarOut(HandMovement::rotate, left.rotate_deg)) return HandMovement::rotate;
  if (isFarOut(HandMovement::tilt, left.tilt_deg)) return HandMovement::tilt;
  if (isFarOut(HandMovement::rock, left.rock_deg)) return HandMovement::rock;

  const std::array<Candidate, 5> candidates = {{
      {HandMovement::slide, weightOf(left.slide_mm, left.across) / units.slide_mm},
      {HandMovement::rotate, std::abs(left.rotate_deg) / units.rotate_deg},
      {HandMovement::tilt, std::abs(left.tilt_deg) / units.tip_deg},
      // A rock turns the image within its plane, which is found all the same; half as urgent.
      {HandMovement::rock, 0.5 * std::abs(left.rock_deg) / units.tip_deg},
      {HandMovement::press, std::abs(left.press_mm) / (2.0 * units.slide_mm)},
  }};
  for (const Candidate& each : candidates)
    if (goesOn(each.movement) && each.share > kRelease) return each.movement;
  return std::max_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.share < b.share; })->movement;
}

}  // namespace

CompassTarget compassTargetOf(const PlaneTarget& plane, const PlaneTolerance& tolerance, const Skin& skin) {
  EW_EXPECTS(tolerance.position_mm > 0.0 && tolerance.angle_deg > 0.0);
  CompassTarget target{plane, tolerance, {}, {}, false};
  Pose pose;
  pose.probeToWorld = plane.probeToWorld;
  target.hold = holdFor(pose, skin);
  target.left = planeError(plane, poseOf(target.hold).probeToWorld);
  target.reachable = shareOfTolerance(target.left, tolerance) <= 0.5 && !target.left.isMirrored;
  return target;
}

CompassAdvice nextMovement(const CompassTarget& target, const Hold& now, const std::optional<CompassAdvice>& before) {
  CompassAdvice advice;
  if (!target.reachable) {
    advice.movement = HandMovement::none;
    return told(advice);
  }
  const PlaneError error = planeError(target.plane, poseOf(now).probeToWorld);
  const bool wasThere = before && before->movement == HandMovement::stay;
  if (!error.isMirrored && shareOfTolerance(error, target.tolerance) <= (wasThere ? kStillFound : kFound)) return told(advice);
  const Left left = leftTo(target, now);
  const Units units = unitsOf(target);
  const HandMovement movement = chosen(left, units, before);
  switch (movement) {
    case HandMovement::slide: {
      const bool far = glm::length(left.slide_mm) > kRegion_mm;
      return slideBy(left, target.hold, now, before, far, far ? kAboutThere_mm : kRelease * units.slide_mm);
    }
    case HandMovement::rotate:
      return rotateBy(left, before);
    case HandMovement::tilt:
      return tipBy(movement, left.tilt_deg, now);
    case HandMovement::rock:
      return tipBy(movement, left.rock_deg, now);
    default:
      return pressBy(left.press_mm);
  }
}

}  // namespace ew
