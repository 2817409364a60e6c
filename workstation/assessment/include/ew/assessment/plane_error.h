#pragma once

#include <glm/glm.hpp>

#include "ew/core/pose.h"
#include "ew/library/case_truth.h"

namespace ew {

/// A plane that a probe is to be brought to: where an expert holds the probe, and the point there that the image is taken for.
struct PlaneTarget {
  Transform<frame::World, frame::Probe> probeToWorld = {};  ///< the plane is z = 0 of the probe frame
  glm::dvec2 interest_mm{0.0, 40.0};                        ///< the point of interest, in that plane: lateral and axial
  bool operator==(const PlaneTarget&) const = default;
};

/// What counts as found. 5 mm and 10 degrees where nobody says otherwise: automatic estimation of fetal brain planes reached 2.97 mm and
/// 6.63 degrees (median; Di Vece et al., arXiv 2301.08317, 2023), observers of a facial axis differ by 10 to 15 degrees (Alomar et al.,
/// arXiv 2409.02826, 2024).
struct PlaneTolerance {
  double position_mm = 5.0;  ///< of PlaneError::distance_mm
  double angle_deg = 10.0;   ///< of PlaneError::angle_deg
  bool operator==(const PlaneTolerance&) const = default;
};

/// How many position tolerances the point of interest may lie elsewhere within the image: the plane is the same, but what it is taken
/// for has to be seen where one looks for it. Ours, for no source states one.
inline constexpr double kInImageFactor = 3.0;

/// How far a probe is from a target plane. A probe turned by 180 degrees about its beam sees the same plane from its other side; then
/// every figure but isMirrored is that of the target turned in the same way, so that it is told apart from being wrong.
struct PlaneError {
  bool isMirrored = false;        ///< the marker points the wrong way round: the turned target is the nearer one
  double angle_deg = 0.0;         ///< between the two planes' normals, 0..180 (beyond 90 only where both images are that far)
  double roll_deg = 0.0;          ///< within the plane, signed about the probe's z: left after the shortest turn of normal to normal
  double distance_mm = 0.0;       ///< of the point of interest from the probe's plane, >= 0
  double inImage_mm = 0.0;        ///< how far the point of interest, seen along the normal, lies from where the target's image has it
  double face_mm = 0.0;           ///< between the middles of both faces
  glm::dvec3 faceOffset_mm{0.0};  ///< from the probe's face to the target's; world: x to the patient's left, y to the back, z to the head
  // What the hand has yet to do: the target's axes are the probe's * Ry(rotate) * Rx(tilt) * Rz(rock), as in Hold.
  double rotate_deg = 0.0;  ///< about the beam; above 0 clockwise seen from above the probe
  double tilt_deg = 0.0;    ///< fanning; above 0 the beam tips towards the probe's +z
  double rock_deg = 0.0;    ///< in the plane; above 0 the beam tips towards the probe's -x
  bool operator==(const PlaneError&) const = default;
};

/// Of a rigid pose; its status is for the caller to look at.
/// Angle between normals and distance are what evaluations of plane finding state (as Di Vece et al. 2023); ours takes the distance of the
/// point of interest instead of the planes' middles, for the middle of a fan is seldom what one looks at.
[[nodiscard]] PlaneError planeError(const PlaneTarget& target, const Transform<frame::World, frame::Probe>& probeToWorld);

/// The worst of distance_mm / position, angle_deg / angle and inImage_mm / (kInImageFactor * position): up to 1 is within tolerance.
/// @param tolerance both above 0
[[nodiscard]] double shareOfTolerance(const PlaneError& error, const PlaneTolerance& tolerance);

/// Within tolerance, the marker on either side: whoever minds looks at isMirrored.
[[nodiscard]] bool isFound(const PlaneError& error, const PlaneTolerance& tolerance);

/// The target that a case expects. Its point of interest is the middle of the caliper points that `truth` has in this plane; without
/// any, the point of the beam axis at half of `depth_mm`.
/// @param depth_mm of the image, > 0
[[nodiscard]] PlaneTarget targetOf(const ReferencePlane& plane, const CaseTruth& truth, double depth_mm);
[[nodiscard]] PlaneTolerance toleranceOf(const ReferencePlane& plane);

}  // namespace ew
