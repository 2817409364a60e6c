#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "ew/assessment/step_metrics.h"

namespace ew {
namespace {

constexpr int kDirections = 1024;

/// Evenly over the sphere (Fibonacci lattice).
glm::dvec3 directionOf(int n) {
  const double z = 1.0 - (2.0 * n + 1.0) / kDirections;
  const double around = n * std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(around), r * std::sin(around), z};
}

std::vector<glm::dvec3> outermost(std::span<const glm::dvec3> points) {
  std::set<std::size_t> found;
  for (int n = 0; n < kDirections; ++n) {
    const glm::dvec3 direction = directionOf(n);
    std::size_t best = 0;
    double farthest = glm::dot(points[0], direction);
    for (std::size_t p = 1; p < points.size(); ++p) {
      const double far = glm::dot(points[p], direction);
      if (!(far > farthest)) continue;
      best = p;
      farthest = far;
    }
    found.insert(best);
  }
  std::vector<glm::dvec3> corners;
  for (const std::size_t p : found) corners.push_back(points[p] - points[0]);
  return corners;
}

struct Facet {
  std::array<std::size_t, 3> corner;
  glm::dvec3 outward;  ///< unit
  double offset;
};

/// Grows the hull by one point after another: facets that see the point give way to those from the point to the rim of what it sees.
class Hull {
 public:
  explicit Hull(std::vector<glm::dvec3> points) : points_(std::move(points)) {}

  /// @return false: all points lie in one plane
  bool build() {
    if (!begin()) return false;
    for (std::size_t p = 0; p < points_.size(); ++p) add(p);
    return true;
  }
  [[nodiscard]] double volume() const {
    double sum = 0.0;
    for (const Facet& each : facets_)
      sum += glm::dot(points_[each.corner[0]] - inside_, glm::cross(points_[each.corner[1]] - inside_, points_[each.corner[2]] - inside_)) /
             6.0;
    return sum;
  }

 private:
  template <class Far>
  [[nodiscard]] std::size_t farthest(const Far& farOf) const {
    std::size_t best = 0;
    for (std::size_t p = 1; p < points_.size(); ++p)
      if (farOf(points_[p]) > farOf(points_[best])) best = p;
    return best;
  }

  bool begin() {
    if (points_.size() < 4) return false;
    const std::size_t a = farthest([&](const glm::dvec3& p) { return -p.x; });
    const std::size_t b = farthest([&](const glm::dvec3& p) { return glm::distance(p, points_[a]); });
    const double size = glm::distance(points_[a], points_[b]);
    near_ = 1e-9 * size;
    if (!(size > 0.0)) return false;
    const glm::dvec3 along = (points_[b] - points_[a]) / size;
    const std::size_t c = farthest([&](const glm::dvec3& p) { return glm::length(glm::cross(p - points_[a], along)); });
    const glm::dvec3 across = glm::cross(along, points_[c] - points_[a]);
    if (glm::length(across) <= near_) return false;
    const glm::dvec3 normal = glm::normalize(across);
    const std::size_t d = farthest([&](const glm::dvec3& p) { return std::abs(glm::dot(p - points_[a], normal)); });
    if (std::abs(glm::dot(points_[d] - points_[a], normal)) <= near_) return false;
    inside_ = 0.25 * (points_[a] + points_[b] + points_[c] + points_[d]);
    for (const auto& corner : {std::array{a, b, c}, std::array{a, b, d}, std::array{a, c, d}, std::array{b, c, d}})
      facets_.push_back(facet(corner));
    return true;
  }

  [[nodiscard]] Facet facet(std::array<std::size_t, 3> corner) const {
    glm::dvec3 normal = glm::cross(points_[corner[1]] - points_[corner[0]], points_[corner[2]] - points_[corner[0]]);
    if (glm::dot(normal, points_[corner[0]] - inside_) < 0.0) {
      std::swap(corner[1], corner[2]);
      normal = -normal;
    }
    const double length = glm::length(normal);
    if (length > 0.0) normal /= length;
    return {corner, normal, glm::dot(normal, points_[corner[0]])};
  }

  void add(std::size_t p) {
    std::set<std::pair<std::size_t, std::size_t>> rim;
    std::vector<Facet> kept;
    for (const Facet& each : facets_) {
      if (glm::dot(each.outward, points_[p]) - each.offset <= near_) {
        kept.push_back(each);
        continue;
      }
      for (std::size_t n = 0; n < 3; ++n) {
        const std::pair<std::size_t, std::size_t> edge(each.corner[n], each.corner[(n + 1) % 3]);
        if (rim.erase({edge.second, edge.first}) == 0) rim.insert(edge);  // an edge between two facets that go is no rim
      }
    }
    for (const auto& [from, to] : rim) kept.push_back(facet({from, to, p}));
    facets_ = std::move(kept);
  }

  std::vector<glm::dvec3> points_;
  std::vector<Facet> facets_;
  glm::dvec3 inside_{0.0};
  double near_ = 0.0;
};

}  // namespace

double hullVolume_mm3(std::span<const glm::dvec3> points_mm) {
  if (points_mm.size() < 4) return 0.0;
  Hull hull(outermost(points_mm));
  return hull.build() ? hull.volume() : 0.0;
}

}  // namespace ew
