#include "fan_shape.h"

#include <algorithm>
#include <cmath>

namespace ew::detail {

namespace {

/// The line through a point of a steered sector touches a circle about the apex: the angle at which it is seen from the point, and how far
/// along the line that is.
struct Tangent {
  double angle_rad;
  double along_mm;
};
Tangent tangentFrom(double fromApex_mm, double touched_mm) {
  const double at_mm = std::max(fromApex_mm, std::abs(touched_mm));
  return {at_mm > 0.0 ? std::asin(touched_mm / at_mm) : 0.0, std::sqrt(at_mm * at_mm - touched_mm * touched_mm)};
}

}  // namespace

FanShape fanShapeOf(const Probe& probe, const Knobs& knobs, double look_rad) {
  FanShape fan;
  if (isSector(probe.kind)) {
    fan.kind = FanShape::Kind::sector;
    fan.apexToFace_mm = probe.radius_mm;
    fan.halfAngle_rad = probe.halfAngle_rad;
    fan.steering_rad = look_rad;
    return fan;
  }
  fan.halfWidth_mm = 0.5 * probe.width_mm;
  if (knobs.trapezoid && probe.trapezoidHalfAngle_rad > 0.0) {
    fan.kind = FanShape::Kind::trapezoid;
    fan.halfAngle_rad = probe.trapezoidHalfAngle_rad;
    fan.apexToFace_mm = fan.halfWidth_mm / std::tan(fan.halfAngle_rad);
  } else if (std::isfinite(knobs.steering_rad)) {
    fan.steering_rad = std::clamp(knobs.steering_rad, -probe.maxSteering_rad, probe.maxSteering_rad) + look_rad;
  }
  return fan;
}

FanShape::Line FanShape::lineAt(double across) const {
  switch (kind) {
    case Kind::parallel:
      return {{across * halfWidth_mm, 0.0}, {std::sin(steering_rad), std::cos(steering_rad)}};
    case Kind::trapezoid: {
      const double x_mm = across * halfWidth_mm;
      const double fromApex_mm = std::hypot(x_mm, apexToFace_mm);
      return {{x_mm, 0.0}, {x_mm / fromApex_mm, apexToFace_mm / fromApex_mm}};
    }
    case Kind::sector:
      break;
  }
  const glm::dvec2 outward(std::sin(across * halfAngle_rad), std::cos(across * halfAngle_rad));
  Line line{{apexToFace_mm * outward.x, apexToFace_mm * (outward.y - 1.0)}, outward};
  if (steering_rad != 0.0) {
    const double angle = across * halfAngle_rad + steering_rad;
    line.direction = {std::sin(angle), std::cos(angle)};
  }
  return line;
}

glm::dvec2 FanShape::directionThrough(const glm::dvec2& p_mm) const {
  if (kind == Kind::parallel) return {std::sin(steering_rad), std::cos(steering_rad)};
  if (kind == Kind::sector && steering_rad != 0.0) {
    const double y_mm = p_mm.y + apexToFace_mm;
    const double angle = std::atan2(p_mm.x, y_mm) + tangentFrom(std::hypot(p_mm.x, y_mm), apexToFace_mm * std::sin(steering_rad)).angle_rad;
    return {std::sin(angle), std::cos(angle)};
  }
  return glm::normalize(glm::dvec2(p_mm.x, std::max(p_mm.y + apexToFace_mm, 1e-9)));
}

FanShape::Place FanShape::placeOf(const glm::dvec2& p_mm) const {
  switch (kind) {
    case Kind::parallel:
      return {(p_mm.x - p_mm.y * std::tan(steering_rad)) / halfWidth_mm, p_mm.y / std::cos(steering_rad)};
    case Kind::trapezoid: {
      // Behind the apex every point is far in front of the face's depth 0: the sign of y already says that it is outside.
      const double fromApex_mm = std::max(p_mm.y + apexToFace_mm, 1e-9);
      const double onFace_mm = p_mm.x * apexToFace_mm / fromApex_mm;
      return {onFace_mm / halfWidth_mm, p_mm.y * std::sqrt(onFace_mm * onFace_mm + apexToFace_mm * apexToFace_mm) / apexToFace_mm};
    }
    case Kind::sector:
      break;
  }
  const double y_mm = p_mm.y + apexToFace_mm, fromApex_mm = std::sqrt(p_mm.x * p_mm.x + y_mm * y_mm);
  if (steering_rad == 0.0) return {std::atan2(p_mm.x, y_mm) / halfAngle_rad, fromApex_mm - apexToFace_mm};
  const Tangent tangent = tangentFrom(fromApex_mm, apexToFace_mm * std::sin(steering_rad));
  return {(std::atan2(p_mm.x, y_mm) + tangent.angle_rad - steering_rad) / halfAngle_rad,
          tangent.along_mm - apexToFace_mm * std::cos(steering_rad)};
}

double FanShape::wavefrontLead_mm() const {
  switch (kind) {
    case Kind::parallel:
      return halfWidth_mm * std::sin(steering_rad);
    case Kind::sector:
      return apexToFace_mm * halfAngle_rad * std::sin(steering_rad);  // involutes of the circle that the lines touch
    case Kind::trapezoid:
      break;
  }
  return 0.0;
}

FanShape::Box FanShape::box(double depth_mm) const {
  switch (kind) {
    case Kind::parallel:
      return {halfWidth_mm + depth_mm * std::abs(std::sin(steering_rad)), 0.0, depth_mm * std::cos(steering_rad)};
    case Kind::trapezoid:
      return {halfWidth_mm + depth_mm * std::sin(halfAngle_rad), 0.0, depth_mm};
    case Kind::sector:
      break;
  }
  // The ends of the face lie behind its foremost point.
  return {(apexToFace_mm + depth_mm) * std::sin(halfAngle_rad), apexToFace_mm * (std::cos(halfAngle_rad) - 1.0), depth_mm};
}

FanShape::Row FanShape::rowAt(double y_mm, double depth_mm) const {
  switch (kind) {
    case Kind::parallel: {
      if (y_mm < 0.0 || y_mm > depth_mm * std::cos(steering_rad)) return {};
      const double shift_mm = y_mm * std::tan(steering_rad);
      return {shift_mm - halfWidth_mm, shift_mm + halfWidth_mm, 0.0};
    }
    case Kind::trapezoid: {
      if (y_mm < 0.0 || y_mm > depth_mm) return {};
      // A line at the angle t ends at y = depth cos t, so a row below the outer lines' ends holds those with cos t >= y / depth.
      const double slope = std::min(std::tan(halfAngle_rad), std::sqrt(depth_mm * depth_mm - y_mm * y_mm) / std::max(y_mm, 1e-300));
      const double half_mm = (y_mm + apexToFace_mm) * slope;
      return {-half_mm, half_mm, 0.0};
    }
    case Kind::sector:
      break;
  }
  const double fromApex_mm = y_mm + apexToFace_mm;
  const double far_mm = apexToFace_mm + depth_mm;
  if (fromApex_mm < 0.0 || fromApex_mm > far_mm) return {};
  const double half_mm = std::min(fromApex_mm * std::tan(halfAngle_rad), std::sqrt(far_mm * far_mm - fromApex_mm * fromApex_mm));
  const double gap_mm = fromApex_mm < apexToFace_mm ? std::sqrt(apexToFace_mm * apexToFace_mm - fromApex_mm * fromApex_mm) : 0.0;
  if (gap_mm > half_mm) return {};
  return {-half_mm, half_mm, gap_mm};
}

}  // namespace ew::detail
