#include "camera_truth/truth_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace ew::camera_truth {
namespace {

double between(std::mt19937_64& random, double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }

glm::dvec3 direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  for (;;) {
    const glm::dvec3 d(normal(random), normal(random), normal(random));
    if (glm::length(d) > 0.1) return glm::normalize(d);
  }
}

glm::dmat4 turnAbout(const glm::dvec3& axis, double angle_rad) { return glm::rotate(glm::dmat4(1.0), angle_rad, axis); }

bool isInside(const CameraModel& model, const MarkerBody& body, const glm::dmat4& bodyToCamera) {
  for (const Marker& marker : body.markers)
    for (const auto& corner : marker.corners_mm) {
      const glm::dvec3 p = glm::dvec3(bodyToCamera * glm::dvec4(corner, 1.0));
      if (p.z < 100.0) return false;
      const glm::dvec2 at = pixelOf(model, p);
      if (at.x < 12 || at.y < 12 || at.x > model.width - 12 || at.y > model.height - 12) return false;
    }
  return true;
}

glm::dvec3 placeSeenAt(const CameraModel& model, const glm::dvec2& at_px, double away_mm) {
  return away_mm * glm::dvec3(rayThrough(model, at_px), 1.0);
}

}  // namespace

CameraModel webcam(int width, int height) {
  CameraModel model = assumedCamera(width, height, 68.0 * std::numbers::pi / 180.0);
  model.fy *= 1.002;
  model.cx += 0.006 * width;
  model.cy -= 0.008 * height;
  model.distortion = {-0.11, 0.06, 0.0006, -0.0009, -0.012};
  return model;
}

TruthMotion::TruthMotion(const CameraModel& model, const std::vector<MarkerBody>& bodies, const MotionOptions& options, std::uint64_t seed)
    : options_(options) {
  std::mt19937_64 random(seed);
  for (int attempt = 0; attempt < 400; ++attempt) {
    const bool probeLeft = between(random, 0, 1) < 0.5;
    const auto px = [&](bool left, double low, double high) {
      return glm::dvec2((left ? between(random, 0.12, 0.45) : between(random, 0.55, 0.88)) * model.width,
                        between(random, low, high) * model.height);
    };
    // The axis of the probe points down or towards the camera's lower edge, the board stands or lies behind.
    glm::dmat4 turn = turnAbout({0, 1, 0}, between(random, -std::numbers::pi, std::numbers::pi));
    if (options.straightOn)
      turn = turnAbout(direction(random), between(random, 0.0, 0.25)) *
             turnAbout({0, 1, 0}, 0.5 * std::numbers::pi * std::floor(between(random, 0.0, 4.0)));
    else
      turn = turnAbout(direction(random), between(random, 0.0, options.tipped_rad)) * turn;
    probe_ = turn;
    const glm::dvec3 place = placeSeenAt(model, px(probeLeft, 0.2, 0.75), between(random, options.near_mm, options.far_mm));
    if (options.straightOn) {
      // Straight on means along the ray to it.
      const glm::dvec3 ray = glm::normalize(place), axis = glm::cross(glm::dvec3(0, 0, 1), ray);
      if (glm::length(axis) > 1e-6) probe_ = turnAbout(glm::normalize(axis), std::asin(std::min(1.0, glm::length(axis)))) * turn;
    }
    probe_[3] = glm::dvec4(place, 1.0);
    board_ = turnAbout(direction(random), between(random, 0.15, 0.7));
    board_[3] = glm::dvec4(placeSeenAt(model, px(!probeLeft, 0.35, 0.65), between(random, options.near_mm + 80.0, options.far_mm)), 1.0);
    if (isInside(model, bodies[0], probe_) && (bodies.size() < 2 || isInside(model, bodies[1], board_))) break;
  }
  way_ = direction(random);
  axis_ = direction(random);
  phase_ = between(random, 0.0, 2.0 * std::numbers::pi);
  turnPhase_ = between(random, 0.0, 2.0 * std::numbers::pi);
}

std::vector<glm::dmat4> TruthMotion::at(double time_s) const {
  const double beat = 2.0 * std::numbers::pi * options_.rate_hz * time_s;
  glm::dmat4 probe = probe_ * turnAbout(axis_, options_.turns_rad * (std::sin(0.8 * beat + turnPhase_) - std::sin(turnPhase_)));
  probe[3] = probe_[3] + glm::dvec4(options_.moves_mm * (std::sin(beat + phase_) - std::sin(phase_)) * way_, 0.0);
  return {probe, board_};
}

TruthError errorOf(const glm::dmat4& found, const glm::dmat4& truth, const glm::dvec3& at_body) {
  const glm::dmat3 turn = glm::transpose(glm::dmat3(truth)) * glm::dmat3(found);
  const glm::dvec3 axis{turn[1][2] - turn[2][1], turn[2][0] - turn[0][2], turn[0][1] - turn[1][0]};
  return {glm::length(glm::dvec3((found - truth) * glm::dvec4(at_body, 1.0))),
          std::atan2(glm::length(axis), turn[0][0] + turn[1][1] + turn[2][2] - 1.0)};
}

double percentile(std::vector<double> values, double part) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at =
      static_cast<std::ptrdiff_t>(std::clamp(part * static_cast<double>(values.size()), 0.0, static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace ew::camera_truth
