#include "ew/assessment/plane_error.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "ew/assessment/judging.h"
#include "ew/core/contract.h"

namespace ew {
namespace {

/// Of unit vectors; atan2 keeps its accuracy where acos loses half of the digits, at 0 and 180 degrees.
double angleBetween_rad(const glm::dvec3& a, const glm::dvec3& b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

/// Cosine of the angle of a rotation matrix.
double cosineOf(const glm::dmat3& rotation) { return 0.5 * (rotation[0].x + rotation[1].y + rotation[2].z - 1.0); }

/// Turned by 180 degrees about the beam: x and z change sign.
glm::dmat4 turnedRound(const glm::dmat4& probeToWorld) { return {-probeToWorld[0], probeToWorld[1], -probeToWorld[2], probeToWorld[3]}; }

/// Signed angle about z by which the target's x lies ahead of the probe's once its normal is brought to z the shortest way.
/// @param toTarget columns: the target's axes in the probe's frame
double rollOf_rad(const glm::dmat3& toTarget) {
  const glm::dvec3 normal = toTarget[2];
  if (normal.z < -1.0 + 1e-12) return 0.0;  // every way is as short
  const glm::dvec3 axis = glm::cross(normal, glm::dvec3(0.0, 0.0, 1.0));
  const glm::dvec3 x = toTarget[0];
  const glm::dvec3 brought = x * normal.z + glm::cross(axis, x) + axis * (glm::dot(axis, x) / (1.0 + normal.z));
  return std::atan2(brought.y, brought.x);
}

}  // namespace

PlaneError planeError(const PlaneTarget& target, const Transform<frame::World, frame::Probe>& probeToWorld) {
  const glm::dmat3 probe(probeToWorld.matrix);
  const glm::dmat3 asAsked = glm::transpose(probe) * glm::dmat3(target.probeToWorld.matrix);
  const glm::dmat3 otherWay = glm::transpose(probe) * glm::dmat3(turnedRound(target.probeToWorld.matrix));
  PlaneError error;
  // A tie stays unmirrored.
  error.isMirrored = cosineOf(otherWay) > cosineOf(asAsked) + 1e-12;
  const glm::dmat3 toTarget = error.isMirrored ? otherWay : asAsked;
  const glm::dvec2 interest_target(error.isMirrored ? -target.interest_mm.x : target.interest_mm.x, target.interest_mm.y);
  const glm::dvec3 interest_world = carried(target.probeToWorld, glm::dvec3(target.interest_mm.x, target.interest_mm.y, 0.0));
  const glm::dvec3 interest_probe = carried(rigidInverse(probeToWorld), interest_world);

  error.angle_deg = glm::degrees(angleBetween_rad({0.0, 0.0, 1.0}, toTarget[2]));
  error.roll_deg = glm::degrees(rollOf_rad(toTarget));
  error.distance_mm = std::abs(interest_probe.z);
  error.inImage_mm = glm::length(glm::dvec2(interest_probe) - interest_target);
  error.faceOffset_mm = glm::dvec3(target.probeToWorld.matrix[3] - probeToWorld.matrix[3]);
  error.face_mm = glm::length(error.faceOffset_mm);
  // Entries of Ry(rotate) Rx(tilt) Rz(rock) that hold one angle each, as in holdFor.
  error.tilt_deg = glm::degrees(std::asin(std::clamp(-toTarget[2].y, -1.0, 1.0)));
  if (std::abs(toTarget[2].y) < 1.0 - 1e-12) {
    error.rotate_deg = glm::degrees(std::atan2(toTarget[2].x, toTarget[2].z));
    error.rock_deg = glm::degrees(std::atan2(toTarget[0].y, toTarget[1].y));
  } else {
    error.rotate_deg = glm::degrees(std::atan2(-toTarget[0].z, toTarget[0].x));
  }
  return error;
}

double shareOfTolerance(const PlaneError& error, const PlaneTolerance& tolerance) {
  EW_EXPECTS(tolerance.position_mm > 0.0 && tolerance.angle_deg > 0.0);
  return std::max({shareOfTolerance(error.distance_mm, 0.0, tolerance.position_mm),
                   shareOfTolerance(error.angle_deg, 0.0, tolerance.angle_deg),
                   shareOfTolerance(error.inImage_mm, 0.0, kInImageFactor * tolerance.position_mm)});
}

bool isFound(const PlaneError& error, const PlaneTolerance& tolerance) { return shareOfTolerance(error, tolerance) <= 1.0; }

PlaneTarget targetOf(const ReferencePlane& plane, const CaseTruth& truth, double depth_mm) {
  EW_EXPECTS(depth_mm > 0.0);
  glm::dvec2 sum_mm(0.0);
  int points = 0;
  const auto worldToProbe = rigidInverse(plane.probeToWorld);
  for (const ReferenceMeasurement& each : truth.measurements) {
    if (each.plane != plane.name) continue;
    for (const glm::dvec3& p_mm : each.points_mm) {
      sum_mm += glm::dvec2(carried(worldToProbe, p_mm));
      ++points;
    }
  }
  PlaneTarget target{plane.probeToWorld, {0.0, 0.5 * depth_mm}};
  if (points > 0) target.interest_mm = sum_mm / static_cast<double>(points);
  return target;
}

PlaneTolerance toleranceOf(const ReferencePlane& plane) { return {plane.positionTolerance_mm, plane.angleTolerance_deg}; }

}  // namespace ew
