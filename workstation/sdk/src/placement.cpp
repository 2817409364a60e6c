#include "ew/sdk/placement.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace ew::sdk {
namespace {

constexpr double kDegreesPerRadian = 180.0 / glm::pi<double>();

/// Sine and cosine of an angle in degrees; whole quarter turns are taken out first, so that they are exact.
struct Turn {
  double sine;
  double cosine;
};
Turn turnOf(double angle_deg) {
  const double quarters = std::round(angle_deg / 90.0);
  const double rest_rad = (angle_deg - 90.0 * quarters) / kDegreesPerRadian;
  const double s = std::sin(rest_rad);
  const double c = std::cos(rest_rad);
  switch (static_cast<int>(std::fmod(std::fmod(quarters, 4.0) + 4.0, 4.0))) {
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    case 3:
      return {-c, s};
    default:
      return {s, c};
  }
}

double degrees(double sine, double cosine) {
  const double angle = std::atan2(sine, cosine) * kDegreesPerRadian;
  return angle <= -180.0 ? 180.0 : angle + 0.0;  // no -180 beside 180, no -0
}

}  // namespace

Transform<frame::World, frame::File> transformOf(const Placement& placement) {
  const Turn x = turnOf(placement.rotation_deg.x);
  const Turn y = turnOf(placement.rotation_deg.y);
  const Turn z = turnOf(placement.rotation_deg.z);
  glm::dmat4 m(1.0);
  m[0] = {z.cosine * y.cosine, z.sine * y.cosine, -y.sine, 0.0};
  m[1] = {z.cosine * y.sine * x.sine - z.sine * x.cosine, z.sine * y.sine * x.sine + z.cosine * x.cosine, y.cosine * x.sine, 0.0};
  m[2] = {z.cosine * y.sine * x.cosine + z.sine * x.sine, z.sine * y.sine * x.cosine - z.cosine * x.sine, y.cosine * x.cosine, 0.0};
  m[3] = glm::dvec4(placement.at_mm, 1.0);
  return {m};
}

Placement placementOf(const Transform<frame::World, frame::File>& fileToWorld) {
  const glm::dmat4& rigid = fileToWorld.matrix;
  Placement placement;
  placement.at_mm = glm::dvec3(rigid[3]);
  // asin(-m20) loses half its digits near 90 degrees; the length of the rest of the first column does not.
  const double cosineY = std::hypot(rigid[0][0], rigid[0][1]);
  placement.rotation_deg.y = degrees(-rigid[0][2], cosineY);
  constexpr double gimbal = 1e-12;
  if (cosineY > gimbal) {
    placement.rotation_deg.x = degrees(rigid[1][2], rigid[2][2]);
    placement.rotation_deg.z = degrees(rigid[0][1], rigid[0][0]);
  } else {
    placement.rotation_deg.x = 0.0;
    placement.rotation_deg.z = degrees(-rigid[1][0], rigid[1][1]);
  }
  return placement;
}

}  // namespace ew::sdk
