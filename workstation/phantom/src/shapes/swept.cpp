// Solids swept along a line: round cones, tubes along a spline, lofts through cross-sections.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ew/core/contract.h"
#include "shapes/cone.h"

namespace ew::phantom {
namespace {

class ConeShape final : public Shape {
 public:
  explicit ConeShape(const RoundCone& c) : cone_(c) { bounds_ = boundsOfCone(c); }
  double distance_mm(const glm::dvec3& p_mm) const override { return cone_.distance_mm(p_mm); }

 private:
  Cone cone_;
};

class Tube final : public Shape {
 public:
  Tube(const std::vector<glm::dvec3>& points, const std::vector<double>& radii) {
    const auto count = static_cast<int>(points.size());
    const auto at = [&](int n) {
      const auto clamped = static_cast<std::size_t>(std::clamp(n, 0, count - 1));
      return glm::dvec4(points[clamped], radii[clamped]);
    };
    bounds_ = {points.front(), points.front()};
    line_.points_mm.push_back(at(0));
    for (int n = 0; n + 1 < count; ++n) {
      const glm::dvec4 before = at(n - 1), from = at(n), to = at(n + 1), after = at(n + 2);
      const auto spline = [&](double t) {
        return 0.5 * (2.0 * from + (to - before) * t + (2.0 * before - 5.0 * from + 4.0 * to - after) * (t * t) +
                      (3.0 * (from - to) + after - before) * (t * t * t));
      };
      Span span;
      glm::dvec4 last = from;
      for (int piece = 1; piece <= kPiecesPerSpan; ++piece) {
        glm::dvec4 next = spline(static_cast<double>(piece) / kPiecesPerSpan);
        next.w = std::clamp(next.w, std::min(from.w, to.w), std::max(from.w, to.w));  // no overshoot: a radius stays positive
        const RoundCone cone{glm::dvec3(last), glm::dvec3(next), last.w, next.w};
        const Bounds box = boundsOfCone(cone);
        if (piece == 1) span.box = box;
        span.box.lowest_mm = glm::min(span.box.lowest_mm, box.lowest_mm);
        span.box.highest_mm = glm::max(span.box.highest_mm, box.highest_mm);
        span.cones.emplace_back(cone);
        line_.points_mm.push_back(next);
        last = next;
      }
      if (n == 0) bounds_ = span.box;
      solids_ += static_cast<double>(span.cones.size());
      bounds_.lowest_mm = glm::min(bounds_.lowest_mm, span.box.lowest_mm);
      bounds_.highest_mm = glm::max(bounds_.highest_mm, span.box.highest_mm);
      spans_.push_back(std::move(span));
    }
  }
  double distance_mm(const glm::dvec3& p_mm) const override { return distanceUpTo_mm(p_mm, std::numeric_limits<double>::infinity()); }
  double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const override {
    // The span whose box is nearest first: with it most others are out of the question.
    std::size_t first = 0;
    double least2 = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < spans_.size() && least2 > 0.0; ++n) {
      const double here2 = squaredToBox_mm2(p_mm, spans_[n].box);
      if (here2 >= least2) continue;
      least2 = here2;
      first = n;
    }
    double nearest = most_mm;
    for (std::size_t n = 0; n < spans_.size(); ++n) {
      const Span& span = spans_[n == 0 ? first : n <= first ? n - 1 : n];
      const double atLeast2 = squaredToBox_mm2(p_mm, span.box);
      if (atLeast2 > 0.0 && (nearest <= 0.0 || atLeast2 > nearest * nearest)) continue;
      for (const Cone& cone : span.cones) nearest = std::min(nearest, cone.distance_mm(p_mm));
    }
    return nearest;
  }
  const CentreLine* centreLine() const override { return &line_; }

 private:
  static constexpr int kPiecesPerSpan = 8;
  struct Span {
    Bounds box;
    std::vector<Cone> cones;
  };
  std::vector<Span> spans_;
  CentreLine line_;
};

constexpr double kThinnest_mm = 0.01;
constexpr int kProfileCount = 6;
using Profile = std::array<double, kProfileCount>;  // x, y, half width, front, back, squareness

class Loft final : public Shape {
 public:
  Loft(const std::vector<LoftSection>& sections, double rounding) : rounding_(rounding) {
    for (const LoftSection& s : sections) {
      z_.push_back(s.z_mm);
      values_.push_back({s.centreX_mm, s.centreY_mm, s.halfWidth_mm, s.front_mm, s.back_mm, s.squareness});
    }
    slopes_.assign(values_.size(), Profile{});
    for (std::size_t c = 0; c < kProfileCount; ++c) setSlopes(c);
    bounds_ = {glm::dvec3(std::numeric_limits<double>::infinity()), glm::dvec3(-std::numeric_limits<double>::infinity())};
    for (std::size_t n = 0; n + 1 < z_.size(); ++n) {
      for (int piece = 0; piece <= kPiecesPerSection; ++piece) {
        const Profile v = profileAt(n, static_cast<double>(piece) / kPiecesPerSection).value;
        bounds_.lowest_mm = glm::min(bounds_.lowest_mm, {v[0] - v[2], v[1] - v[3], z_.front()});
        bounds_.highest_mm = glm::max(bounds_.highest_mm, {v[0] + v[2], v[1] + v[4], z_.back()});
      }
    }
  }
  double distance_mm(const glm::dvec3& p_mm) const override {
    const double z = std::clamp(p_mm.z, z_.front(), z_.back());
    auto upper = static_cast<std::size_t>(std::upper_bound(z_.begin(), z_.end(), z) - z_.begin());
    upper = std::clamp<std::size_t>(upper, 1, z_.size() - 1);
    const auto [value, slope] = profileAt(upper - 1, (z - z_[upper - 1]) / (z_[upper] - z_[upper - 1]));
    const bool inFront = p_mm.y < value[1];
    const double rx = value[2], ry = inFront ? value[3] : value[4];
    const double rxSlope = slope[2], rySlope = inFront ? slope[3] : slope[4];
    const double u = (p_mm.x - value[0]) / rx, v = (p_mm.y - value[1]) / ry;
    const double u2 = u * u, v2 = v * v;
    const double round = std::sqrt(u2 + v2);
    double side;
    if (round < 1e-9) {
      side = -std::min(rx, ry);
    } else {
      // The level is a mixture of the norms of order 2 and 4: convex, smooth, without pow.
      const double square = std::sqrt(std::sqrt(u2 * u2 + v2 * v2));
      const double s = value[5], cube = square * square * square;
      const double level = (1.0 - s) * round + s * square;
      const double du = (1.0 - s) * u / round + s * u2 * u / cube;
      const double dv = (1.0 - s) * v / round + s * v2 * v / cube;
      // The slope along z is taken where the ray from the section's centre meets the surface: taken at the point itself it grows with
      // the distance and the estimate collapses.
      const double dz =
          -du * (slope[0] + u / level * rxSlope) / rx - dv * (slope[1] + v / level * rySlope) / ry + slope[5] * (square - round) / level;
      side = (level - 1.0) / std::sqrt(du * du / (rx * rx) + dv * dv / (ry * ry) + dz * dz);
    }
    const double ends = std::max(z_.front() - p_mm.z, p_mm.z - z_.back());
    return smoothMax(side, ends, rounding_);
  }

 private:
  static constexpr int kPiecesPerSection = 16;
  struct ProfileAndSlope {
    Profile value{};
    Profile slope{};
  };
  [[nodiscard]] ProfileAndSlope profileAt(std::size_t n, double t) const {
    ProfileAndSlope found;
    const double step = z_[n + 1] - z_[n];
    for (std::size_t c = 0; c < kProfileCount; ++c) {
      const double a = values_[n][c], b = values_[n + 1][c];
      const double da = slopes_[n][c] * step, db = slopes_[n + 1][c] * step;
      const double c2 = 3.0 * (b - a) - 2.0 * da - db, c3 = 2.0 * (a - b) + da + db;
      found.value[c] = a + t * (da + t * (c2 + t * c3));
      found.slope[c] = (da + t * (2.0 * c2 + 3.0 * t * c3)) / step;
    }
    for (std::size_t c = 2; c < 5; ++c)
      found.value[c] = std::max(found.value[c], kThinnest_mm);  // a spline through wild sections may overshoot
    found.value[5] = std::clamp(found.value[5], 0.0, 1.0);
    return found;
  }

  // The cubic spline of continuous curvature (a jump in curvature shows as a band in the shading), upright at both ends so that the
  // distance goes on smoothly beyond them: a tridiagonal system for the slopes.
  void setSlopes(std::size_t c) {
    const std::size_t last = z_.size() - 1;
    std::vector<double> scale(z_.size(), 0.0);
    for (std::size_t n = 1; n < last; ++n) {
      const double below = 1.0 / (z_[n] - z_[n - 1]), above = 1.0 / (z_[n + 1] - z_[n]);
      const double right =
          3.0 * (below * below * (values_[n][c] - values_[n - 1][c]) + above * above * (values_[n + 1][c] - values_[n][c]));
      const double pivot = 2.0 * (below + above) - below * scale[n - 1];
      scale[n] = above / pivot;
      slopes_[n][c] = (right - below * slopes_[n - 1][c]) / pivot;
    }
    for (std::size_t n = last; n-- > 1;) slopes_[n][c] -= scale[n] * slopes_[n + 1][c];
  }

  std::vector<double> z_;
  std::vector<Profile> values_;
  std::vector<Profile> slopes_;
  double rounding_;
};

}  // namespace

ShapePtr makeRoundCone(const RoundCone& cone) {
  EW_EXPECTS(cone.fromRadius_mm > 0.0 && cone.toRadius_mm > 0.0);
  return std::make_shared<ConeShape>(cone);
}
ShapePtr makeTube(const std::vector<glm::dvec3>& points_mm, const std::vector<double>& radii_mm) {
  EW_EXPECTS(points_mm.size() >= 2 && points_mm.size() == radii_mm.size());
  return std::make_shared<Tube>(points_mm, radii_mm);
}
ShapePtr makeLoft(const std::vector<LoftSection>& sections, double capRounding_mm) {
  EW_EXPECTS(sections.size() >= 2 && capRounding_mm >= 0.0);
  return std::make_shared<Loft>(sections, capRounding_mm);
}

}  // namespace ew::phantom
