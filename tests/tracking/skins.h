#pragma once

#include <algorithm>
#include <cmath>

#include "ew/tracking/hand.h"

namespace ew::test {

/// z = 0, outwards +z.
class PlaneSkin final : public Skin {
 public:
  [[nodiscard]] std::optional<Contact> hit(const glm::dvec3& from, const glm::dvec3& direction) const override {
    if (direction.z == 0.0) return std::nullopt;
    const double t = -from.z / direction.z;
    if (t < 0.0) return std::nullopt;
    return Contact{from + t * direction, {0.0, 0.0, 1.0}};
  }
  [[nodiscard]] Contact nearest(const glm::dvec3& p) const override { return {{p.x, p.y, 0.0}, {0.0, 0.0, 1.0}}; }
};

/// z = 0 whose normals lean to either side, as normals smoothed over a bumpy surface do.
class LeaningSkin final : public Skin {
 public:
  [[nodiscard]] std::optional<Contact> hit(const glm::dvec3&, const glm::dvec3&) const override { return std::nullopt; }
  [[nodiscard]] Contact nearest(const glm::dvec3& p) const override {
    return {{p.x, p.y, 0.0}, glm::normalize(glm::dvec3(0.15 * std::sin(p.x / 15.0), 0.0, 1.0))};
  }
};

class SphereSkin final : public Skin {
 public:
  explicit SphereSkin(double radius_mm) : radius_mm_(radius_mm) {}
  [[nodiscard]] std::optional<Contact> hit(const glm::dvec3& from, const glm::dvec3& direction) const override {
    const glm::dvec3 d = glm::normalize(direction);
    const double b = glm::dot(from, d);
    const double root = b * b - glm::dot(from, from) + radius_mm_ * radius_mm_;
    if (root < 0.0 || -b - std::sqrt(root) < 0.0) return std::nullopt;
    return nearest(from + (-b - std::sqrt(root)) * d);
  }
  [[nodiscard]] Contact nearest(const glm::dvec3& p) const override {
    const double length = glm::length(p);
    const glm::dvec3 n = length > 0.0 ? p / length : glm::dvec3(0.0, -1.0, 0.0);
    return {radius_mm_ * n, n};
  }

 private:
  double radius_mm_;
};

/// Endless cylinder about z, like a trunk.
class CylinderSkin final : public Skin {
 public:
  explicit CylinderSkin(double radius_mm) : radius_mm_(radius_mm) {}
  [[nodiscard]] std::optional<Contact> hit(const glm::dvec3&, const glm::dvec3&) const override { return std::nullopt; }
  [[nodiscard]] Contact nearest(const glm::dvec3& p) const override {
    const double length = std::hypot(p.x, p.y);
    const glm::dvec3 n = length > 0.0 ? glm::dvec3(p.x / length, p.y / length, 0.0) : glm::dvec3(0.0, -1.0, 0.0);
    return {radius_mm_ * n + glm::dvec3(0.0, 0.0, p.z), n};
  }

 private:
  double radius_mm_;
};

/// A cube about the origin whose normals are those of its faces: nothing is smoothed at its edges and corners.
class CubeSkin final : public Skin {
 public:
  explicit CubeSkin(double half_mm) : half_mm_(half_mm) {}
  [[nodiscard]] std::optional<Contact> hit(const glm::dvec3&, const glm::dvec3&) const override { return std::nullopt; }
  [[nodiscard]] Contact nearest(const glm::dvec3& p) const override {
    glm::dvec3 at = glm::clamp(p, glm::dvec3(-half_mm_), glm::dvec3(half_mm_));
    int axis = 0;
    if (at == p) {  // inside: out through the nearest face
      for (int i = 1; i < 3; ++i)
        if (std::abs(p[i]) > std::abs(p[axis])) axis = i;
    } else {  // outside: the face it sticks out of most
      for (int i = 1; i < 3; ++i)
        if (std::abs(p[i] - at[i]) > std::abs(p[axis] - at[axis])) axis = i;
    }
    const double side = p[axis] < 0.0 ? -1.0 : 1.0;
    at[axis] = side * half_mm_;
    glm::dvec3 n(0.0);
    n[axis] = side;
    return {at, n};
  }
  [[nodiscard]] double distance_mm(const glm::dvec3& p) const {
    return std::abs(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - half_mm_);
  }

 private:
  double half_mm_;
};

/// A floor z = 0 (x > 0) that meets a wall x = 0 (z > 0): a concave corner.
class CornerSkin final : public Skin {
 public:
  [[nodiscard]] std::optional<Contact> hit(const glm::dvec3&, const glm::dvec3&) const override { return std::nullopt; }
  [[nodiscard]] Contact nearest(const glm::dvec3& p) const override {
    const glm::dvec3 floor(std::max(p.x, 0.0), p.y, 0.0);
    const glm::dvec3 wall(0.0, p.y, std::max(p.z, 0.0));
    if (glm::distance(p, floor) <= glm::distance(p, wall)) return {floor, {0.0, 0.0, 1.0}};
    return {wall, {1.0, 0.0, 0.0}};
  }
};

}  // namespace ew::test
