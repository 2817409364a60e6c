#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "ew/labelling/label_surfaces.h"

namespace ew::labelling::test {

/// The signed volume within a closed mesh.
inline double volumeOf(const SurfaceMesh& mesh) {
  double six = 0.0;
  for (const glm::ivec3& t : mesh.triangles) {
    const auto at = [&](int n) { return glm::dvec3(mesh.points_mm[static_cast<std::size_t>(t[n])]); };
    six += glm::dot(at(0), glm::cross(at(1), at(2)));
  }
  return six / 6.0;
}

/// Edges that are not used as often in one direction as in the other.
inline int openEdgesOf(const SurfaceMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;  // of an edge from its lower point to the higher one, less those the other way
  for (const glm::ivec3& t : mesh.triangles)
    for (int n = 0; n < 3; ++n) {
      const int a = t[n], b = t[(n + 1) % 3];
      uses[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  return static_cast<int>(std::count_if(uses.begin(), uses.end(), [](const auto& each) { return each.second != 0; }));
}

/// Finds pairs of triangles that share more than their common corners, without rounding. For points whose coordinates lie in [8, 64): as
/// floats they are whole multiples of 2^-20, and what is multiplied here stays within 128 bits.
class Crossings {
 public:
  explicit Crossings(const LabelSurfaces& surfaces) : triangles_(surfaces.triangles) {
    for (const glm::vec3& p : surfaces.points_mm) {
      Whole whole;
      for (int n = 0; n < 3; ++n) {
        const double scaled = std::ldexp(static_cast<double>(p[n]), 20);
        isExact_ = isExact_ && p[n] >= 8.0F && p[n] < 64.0F && scaled == std::floor(scaled);
        whole[static_cast<std::size_t>(n)] = static_cast<std::int64_t>(scaled);
      }
      points_.push_back(whole);
    }
  }

  [[nodiscard]] bool isExact() const { return isExact_; }

  [[nodiscard]] int count() const {
    std::map<std::array<int, 3>, std::vector<int>> inCell;
    std::set<std::pair<int, int>> crossing;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
      std::array<int, 3> low{}, high{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto at = [&](int n) { return cornerOf(t, n)[axis]; };
        low[axis] = static_cast<int>(std::min({at(0), at(1), at(2)}) >> 20);
        high[axis] = static_cast<int>(std::max({at(0), at(1), at(2)}) >> 20);
      }
      for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j)
          for (int i = low[0]; i <= high[0]; ++i) {
            for (const int other : inCell[{i, j, k}])
              if (meet(t, other) || meet(other, t)) crossing.insert(std::minmax(t, other));
            inCell[{i, j, k}].push_back(t);
          }
    }
    return static_cast<int>(crossing.size());
  }

 private:
  using Whole = std::array<std::int64_t, 3>;
  __extension__ typedef __int128 Wide;

  [[nodiscard]] int pointOf(int triangle, int n) const { return triangles_[static_cast<std::size_t>(triangle)][n]; }
  [[nodiscard]] const Whole& cornerOf(int triangle, int n) const { return points_[static_cast<std::size_t>(pointOf(triangle, n))]; }
  static int signOf(Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

  static std::array<Wide, 3> across(const Whole& a, const Whole& b, const Whole& c) {
    const auto d = [](const Whole& p, const Whole& q, std::size_t n) { return static_cast<Wide>(q[n] - p[n]); };
    return {d(a, b, 1) * d(a, c, 2) - d(a, b, 2) * d(a, c, 1), d(a, b, 2) * d(a, c, 0) - d(a, b, 0) * d(a, c, 2),
            d(a, b, 0) * d(a, c, 1) - d(a, b, 1) * d(a, c, 0)};
  }
  /// On which side of the plane of a, b, c the point p lies.
  static int sideOf(const Whole& a, const Whole& b, const Whole& c, const Whole& p) {
    const auto n = across(a, b, c);
    return signOf(n[0] * (p[0] - a[0]) + n[1] * (p[1] - a[1]) + n[2] * (p[2] - a[2]));
  }

  /// Whether an edge of one triangle meets another triangle anywhere but in common corners.
  [[nodiscard]] bool meet(int one, int other) const {
    for (int n = 0; n < 3; ++n)
      if (edgeMeets(pointOf(one, n), pointOf(one, (n + 1) % 3), other)) return true;
    return false;
  }

  [[nodiscard]] bool edgeMeets(int p, int q, int triangle) const {
    int common = -1, others = 0;
    for (int n = 0; n < 3; ++n) {
      const int corner = pointOf(triangle, n);
      if (corner != p && corner != q) continue;
      common = n;
      ++others;
    }
    if (others == 2) return false;  // an edge of both
    const Whole &a = cornerOf(triangle, 0), &b = cornerOf(triangle, 1), &c = cornerOf(triangle, 2);
    const Whole &from = points_[static_cast<std::size_t>(p)], &to = points_[static_cast<std::size_t>(q)];
    const int before = sideOf(a, b, c, from), after = sideOf(a, b, c, to);
    if (common >= 0) {
      const Whole& end = pointOf(triangle, common) == p ? to : from;
      return before == 0 && after == 0 && inCorner(triangle, common, end);
    }
    if (before == 0 && after == 0) return flatMeet(from, to, triangle);
    if (before == after) return false;
    const int first = sideOf(from, to, a, b), second = sideOf(from, to, b, c), third = sideOf(from, to, c, a);
    return !(std::min({first, second, third}) < 0 && std::max({first, second, third}) > 0);
  }

  /// The turn from a over b to c, seen along the axis that the plane of the triangle leans to most.
  [[nodiscard]] static int turn(std::size_t axis, const Whole& a, const Whole& b, const Whole& c) { return signOf(across(a, b, c)[axis]); }
  [[nodiscard]] std::size_t axisOf(int triangle) const {
    const auto n = across(cornerOf(triangle, 0), cornerOf(triangle, 1), cornerOf(triangle, 2));
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (n[axis] != 0) return axis;
    return 2;
  }

  /// In the triangle's plane: whether the way from its corner to `end` begins within it.
  [[nodiscard]] bool inCorner(int triangle, int corner, const Whole& end) const {
    const std::size_t axis = axisOf(triangle);
    const Whole &a = cornerOf(triangle, corner), &b = cornerOf(triangle, (corner + 1) % 3), &c = cornerOf(triangle, (corner + 2) % 3);
    const int way = turn(axis, a, b, c);
    return turn(axis, a, b, end) * way >= 0 && turn(axis, a, end, c) * way >= 0;
  }

  /// In the triangle's plane: whether no line of an edge has both apart, the segment's own included.
  [[nodiscard]] bool flatMeet(const Whole& from, const Whole& to, int triangle) const {
    const std::size_t axis = axisOf(triangle);
    const int way = turn(axis, cornerOf(triangle, 0), cornerOf(triangle, 1), cornerOf(triangle, 2));
    std::array<int, 3> sides{};
    for (int n = 0; n < 3; ++n) {
      const Whole &a = cornerOf(triangle, n), &b = cornerOf(triangle, (n + 1) % 3);
      if (turn(axis, a, b, from) * way < 0 && turn(axis, a, b, to) * way < 0) return false;
      sides[static_cast<std::size_t>(n)] = turn(axis, from, to, a);
    }
    return !(sides[0] == sides[1] && sides[1] == sides[2] && sides[0] != 0);
  }

  std::vector<glm::ivec3> triangles_;
  std::vector<Whole> points_;
  bool isExact_ = true;
};

}  // namespace ew::labelling::test
