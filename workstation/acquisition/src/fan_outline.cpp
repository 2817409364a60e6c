#include "ew/acquisition/fan_outline.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Of the side from `above` to `below`, from straight down.
double slantOf(glm::dvec2 above, glm::dvec2 below) { return std::atan2(below.x - above.x, below.y - above.y); }

glm::dvec2 onArc(const FanOutline& fan, double radius_px, double angle_rad) {
  return fan.apex_px + radius_px * glm::dvec2(std::sin(angle_rad), std::cos(angle_rad));
}

void addLine(std::vector<glm::dvec2>& points, glm::dvec2 from, glm::dvec2 to, double step_px) {
  const int count = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / step_px)));
  for (int n = 0; n < count; ++n) points.push_back(from + (to - from) * (static_cast<double>(n) / count));
}

void addArc(std::vector<glm::dvec2>& points, const FanOutline& fan, double radius_px, double from_rad, double to_rad, double step_px) {
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(to_rad - from_rad) * radius_px / step_px)));
  for (int n = 0; n < count; ++n) points.push_back(onArc(fan, radius_px, from_rad + (to_rad - from_rad) * n / count));
}

}  // namespace

const char* FanOutline::word() const {
  if (shape != FanShape::linear) return wordIn(kFanShapeWords, shape);
  constexpr double straight_rad = 0.026;
  const double left = slantOf(corners_px[0], corners_px[3]), right = slantOf(corners_px[1], corners_px[2]);
  if (std::abs(left - right) > straight_rad) return "trapezoid";
  return std::abs(left + right) > 2.0 * straight_rad ? "parallelogram" : "rectangle";
}

bool FanOutline::contains(glm::dvec2 p_px) const {
  if (shape == FanShape::linear) {
    for (std::size_t n = 0; n < 4; ++n) {
      const glm::dvec2 a = corners_px[n], b = corners_px[(n + 1) % 4];
      if (cross(b - a, p_px - a) < 0.0) return false;
    }
    return true;
  }
  const glm::dvec2 d = p_px - apex_px;
  const double squared = glm::dot(d, d);
  if (squared < near_px * near_px || squared > far_px * far_px) return false;
  const double angle = std::atan2(d.x, d.y);
  return angle >= left_rad && angle <= right_rad;
}

double FanOutline::depth_px() const {
  if (shape != FanShape::linear) return far_px - near_px;
  return 0.5 * (corners_px[3].y - corners_px[0].y + corners_px[2].y - corners_px[1].y);
}

std::array<glm::dvec2, 2> FanOutline::bounds_px() const {
  std::vector<glm::dvec2> points;
  if (shape == FanShape::linear) {
    points.assign(corners_px.begin(), corners_px.end());
  } else {
    for (const double angle : {left_rad, right_rad})
      for (const double radius : {near_px, far_px}) points.push_back(onArc(*this, radius, angle));
    constexpr double quarter = 1.5707963267948966;
    for (const double angle : {-quarter, 0.0, quarter})
      if (angle > left_rad && angle < right_rad) points.push_back(onArc(*this, far_px, angle));
  }
  std::array<glm::dvec2, 2> bounds{points.front(), points.front()};
  for (const glm::dvec2 point : points) {
    bounds[0] = glm::min(bounds[0], point);
    bounds[1] = glm::max(bounds[1], point);
  }
  return bounds;
}

std::vector<glm::dvec2> FanOutline::points_px(double step_px) const {
  std::vector<glm::dvec2> points;
  if (shape == FanShape::linear) {
    for (std::size_t n = 0; n < 4; ++n) addLine(points, corners_px[n], corners_px[(n + 1) % 4], step_px);
    return points;
  }
  addArc(points, *this, near_px, left_rad, right_rad, step_px);
  addLine(points, onArc(*this, near_px, right_rad), onArc(*this, far_px, right_rad), step_px);
  addArc(points, *this, far_px, right_rad, left_rad, step_px);
  addLine(points, onArc(*this, far_px, left_rad), onArc(*this, near_px, left_rad), step_px);
  return points;
}

FanOutline FanOutline::movedBy(glm::dvec2 offset_px) const {
  FanOutline moved = *this;
  moved.apex_px += offset_px;
  for (glm::dvec2& corner : moved.corners_px) corner += offset_px;
  return moved;
}

Clip clipOf(const FanOutline& outline) {
  Clip clip;
  if (outline.shape == FanShape::linear) {
    const auto& c = outline.corners_px;
    const glm::dvec2 from(std::max(c[0].x, c[3].x), std::max(c[0].y, c[1].y)), to(std::min(c[1].x, c[2].x), std::min(c[2].y, c[3].y));
    clip.origin_px = glm::max(glm::ceil(from), glm::dvec2(0.0));
    clip.size_px = glm::max(glm::floor(to) - clip.origin_px + 1.0, glm::dvec2(1.0));
    return clip;
  }
  clip.fan = ClipFan{outline.apex_px, outline.left_rad, outline.right_rad, outline.near_px, outline.far_px};
  return clip;
}

GreyImage maskOf(const FanOutline& outline, int width_px, int height_px) {
  GreyImage mask(width_px, height_px);
  const auto bounds = outline.bounds_px();
  const int right = std::min(width_px - 1, static_cast<int>(std::floor(bounds[1].x)));
  const int bottom = std::min(height_px - 1, static_cast<int>(std::floor(bounds[1].y)));
  for (int y = std::max(0, static_cast<int>(std::ceil(bounds[0].y))); y <= bottom; ++y)
    for (int x = std::max(0, static_cast<int>(std::ceil(bounds[0].x))); x <= right; ++x)
      if (outline.contains(glm::dvec2(x, y))) viewOf(mask).row(y)[x] = 1;
  return mask;
}

}  // namespace ew
