#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "shapes/shape.h"

namespace ew::phantom {

/// The convex hull of two balls. Where one ball holds the other it is the larger ball.
class Cone {
 public:
  explicit Cone(const RoundCone& c) : from_(c.from_mm), axis_(c.to_mm - c.from_mm), radius_(c.fromRadius_mm), toRadius_(c.toRadius_mm) {
    squared_ = glm::dot(axis_, axis_);
    const double shrink = radius_ - toRadius_;
    slant_ = squared_ - shrink * shrink;
    if (slant_ <= 0.0) {
      if (toRadius_ > radius_) {
        from_ = c.to_mm;
        radius_ = toRadius_;
      }
      return;
    }
    const double length = std::sqrt(squared_);
    axis_ /= length;
    length_ = length;
    sine_ = shrink / length;
    cosine_ = std::sqrt(std::max(0.0, 1.0 - sine_ * sine_));
  }
  [[nodiscard]] double distance_mm(const glm::dvec3& p_mm) const {
    const glm::dvec3 offset = p_mm - from_;
    const double offset2 = glm::dot(offset, offset);
    if (slant_ <= 0.0) return std::sqrt(offset2) - radius_;
    const double along = glm::dot(offset, axis_);
    const double across = std::sqrt(std::max(0.0, offset2 - along * along));
    // In the half plane (along, across) the surface is two arcs and the line tangent to both; `foot` is measured along that line.
    const double foot = along * cosine_ - across * sine_;
    if (foot <= 0.0) return std::sqrt(offset2) - radius_;
    if (foot >= length_ * cosine_) return std::sqrt((along - length_) * (along - length_) + across * across) - toRadius_;
    return along * sine_ + across * cosine_ - radius_;
  }

 private:
  glm::dvec3 from_;
  glm::dvec3 axis_;
  double radius_;
  double toRadius_;
  double squared_ = 0.0;
  double slant_ = 0.0;
  double length_ = 0.0;
  double sine_ = 0.0;
  double cosine_ = 1.0;
};

/// The square of distanceToBox_mm, without a root.
[[nodiscard]] inline double squaredToBox_mm2(const glm::dvec3& p_mm, const Bounds& box) {
  const glm::dvec3 outside = glm::max(glm::max(box.lowest_mm - p_mm, p_mm - box.highest_mm), glm::dvec3(0.0));
  return glm::dot(outside, outside);
}

inline Bounds boundsOfCone(const RoundCone& c) {
  return {glm::min(c.from_mm - c.fromRadius_mm, c.to_mm - c.toRadius_mm), glm::max(c.from_mm + c.fromRadius_mm, c.to_mm + c.toRadius_mm)};
}

}  // namespace ew::phantom
