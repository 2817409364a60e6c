#include "camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace ew::bridge {
namespace {

constexpr double kSteepest_rad = glm::radians(85.0);
constexpr double kNearest_mm = 150.0;
constexpr double kFarthest_mm = 6000.0;
const double kHalfTangent = std::tan(0.5 * OrbitCamera::kOpening_rad);

}  // namespace

void OrbitCamera::setWindow(int width_px, int height_px) {
  width_px = std::max(1, width_px);
  height_px = std::max(1, height_px);
  if (width_px == width_px_ && height_px == height_px_) return;
  width_px_ = width_px;
  height_px_ = height_px;
  if (framed_) refit();
}

void OrbitCamera::look(CameraPreset preset, const Framing& framing) {
  elevation_rad_ = 0.0;
  switch (preset) {
    case CameraPreset::front:
      azimuth_rad_ = 0.0;
      break;
    case CameraPreset::back:
      azimuth_rad_ = glm::pi<double>();
      break;
    case CameraPreset::right:
      azimuth_rad_ = -glm::half_pi<double>();
      break;
    case CameraPreset::left:
      azimuth_rad_ = glm::half_pi<double>();
      break;
    case CameraPreset::top:
      azimuth_rad_ = 0.0;
      elevation_rad_ = kSteepest_rad;
      break;
    case CameraPreset::overview:
      azimuth_rad_ = glm::radians(-20.0);
      elevation_rad_ = glm::radians(27.0);
      break;
  }
  frame(framing);
}

void OrbitCamera::overlook(const glm::dvec3& planeNormal, const Framing& framing) {
  double best = -1.0;
  double bestAzimuth_rad = 0.0;
  double bestElevation_rad = 0.0;
  for (const double azimuth_deg : {-20.0, 20.0, -38.0, 38.0})
    for (const double elevation_deg : {27.0, 12.0}) {
      azimuth_rad_ = glm::radians(azimuth_deg);
      elevation_rad_ = glm::radians(elevation_deg);
      const double faced = std::abs(glm::dot(planeNormal, toViewer()));
      if (faced > best + 0.05) {  // a little more is not worth a view further round
        best = faced;
        bestAzimuth_rad = azimuth_rad_;
        bestElevation_rad = elevation_rad_;
      }
    }
  azimuth_rad_ = bestAzimuth_rad;
  elevation_rad_ = bestElevation_rad;
  frame(framing);
}

void OrbitCamera::frame(const Framing& framing) {
  framing_ = framing;
  framed_ = true;
  refit();
}

void OrbitCamera::refit() {
  focal_mm_ = framing_.focal_mm;
  const double aspect = static_cast<double>(width_px_) / height_px_;
  const double height_mm = std::max(framing_.height_mm, framing_.width_mm / aspect);
  distance_mm_ = std::clamp(0.5 * height_mm / kHalfTangent, kNearest_mm, kFarthest_mm);
}

void OrbitCamera::orbit(double right_rad, double up_rad) {
  azimuth_rad_ = std::remainder(azimuth_rad_ + right_rad, glm::two_pi<double>());
  elevation_rad_ = std::clamp(elevation_rad_ + up_rad, -kSteepest_rad, kSteepest_rad);
}

void OrbitCamera::pan(glm::dvec2 by_px, const Bounds& within) {
  framed_ = false;
  const double mm = mmPerPixelAt(focal_mm_);
  focal_mm_ = glm::clamp(focal_mm_ + mm * (by_px.y * up() - by_px.x * right()), within.lowest_mm, within.highest_mm);
}

void OrbitCamera::zoom(double factor) {
  if (!(factor > 0.0)) return;
  framed_ = false;
  distance_mm_ = std::clamp(distance_mm_ / factor, kNearest_mm, kFarthest_mm);
}

glm::dvec3 OrbitCamera::toViewer() const {
  const double flat = std::cos(elevation_rad_);
  return {std::sin(azimuth_rad_) * flat, -std::cos(azimuth_rad_) * flat, std::sin(elevation_rad_)};
}

glm::dvec3 OrbitCamera::right() const { return {std::cos(azimuth_rad_), std::sin(azimuth_rad_), 0.0}; }

glm::dvec3 OrbitCamera::up() const { return glm::cross(right(), forward()); }

Ray OrbitCamera::rayAt(glm::dvec2 at_px) const {
  const double perPixel = 2.0 * kHalfTangent / height_px_;
  const glm::dvec2 fromMiddle = (at_px - 0.5 * glm::dvec2(width_px_, height_px_)) * perPixel;
  return {eye_mm(), glm::normalize(forward() + fromMiddle.x * right() - fromMiddle.y * up())};
}

Sight OrbitCamera::sight() const { return {eye_mm(), forward(), right(), up(), {width_px_, height_px_}}; }

glm::dvec2 Sight::pixelOf(const glm::dvec3& p_world_mm) const {
  const glm::dvec3 fromEye = p_world_mm - eye_mm;
  return 0.5 * window_px + glm::dvec2(glm::dot(fromEye, right), -glm::dot(fromEye, up)) / mmPerPixelAt(p_world_mm);
}

double Sight::mmPerPixelAt(const glm::dvec3& p_world_mm) const {
  // A point behind the viewer has no pixel; the least depth keeps the answer finite and far outside the window.
  return 2.0 * kHalfTangent * std::max(1.0, glm::dot(p_world_mm - eye_mm, forward)) / window_px.y;
}

}  // namespace ew::bridge
