// Ridges and furrows along lines on a surface: ribs, lips, a navel.
#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"
#include "shapes/shape.h"

namespace ew::phantom {
namespace {

constexpr int kPiecesPerSpan = 6;
// A ridge is felt in the skin and not at the spine: full down to the first depth, gone at the second, on both sides of the surface.
constexpr double kFullDepth_mm = 15.0;
constexpr double kReach_mm = 30.0;
constexpr int kStepsToSurface = 12;
constexpr double kStep_mm = 0.5;

/// Next to the surface of `of`, by steps of its distance along its gradient.
glm::dvec3 onSurface(const Shape& of, glm::dvec3 p_mm) {
  for (int n = 0; n < kStepsToSurface; ++n) {
    const double distance = of.distance_mm(p_mm);
    if (std::abs(distance) < 0.01) break;
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0.0);
      step[axis] = kStep_mm;
      gradient[axis] = of.distance_mm(p_mm + step) - of.distance_mm(p_mm - step);
    }
    const double length = glm::length(gradient);
    if (!(length > 0.0)) break;
    p_mm -= distance * gradient / length;
  }
  return p_mm;
}

/// Place and share of the height, both along the spline.
std::vector<glm::dvec4> splineThrough(const std::vector<glm::dvec4>& points) {
  std::vector<glm::dvec4> line{points.front()};
  const auto count = static_cast<int>(points.size());
  const auto at = [&](int n) { return points[static_cast<std::size_t>(std::clamp(n, 0, count - 1))]; };
  for (int n = 0; n + 1 < count; ++n) {
    const glm::dvec4 before = at(n - 1), from = at(n), to = at(n + 1), after = at(n + 2);
    for (int piece = 1; piece <= kPiecesPerSpan; ++piece) {
      const double t = static_cast<double>(piece) / kPiecesPerSpan;
      line.push_back(0.5 * (2.0 * from + (to - before) * t + (2.0 * before - 5.0 * from + 4.0 * to - after) * (t * t) +
                            (3.0 * (from - to) + after - before) * (t * t * t)));
      line.back().w = std::clamp(line.back().w, std::min(from.w, to.w), std::max(from.w, to.w));
    }
  }
  return line;
}

/// The nearest place of some lines.
struct Nearest {
  double squared_mm2;
  double share = 0.0;  ///< of the height, there
};

class Line {
 public:
  Line(const Shape& of, const std::vector<glm::dvec4>& points) {
    std::vector<glm::dvec4> lying;
    for (const glm::dvec4& point : points) lying.emplace_back(onSurface(of, glm::dvec3(point)), point.w);
    points_ = splineThrough(lying);
    box_ = {glm::dvec3(points_.front()), glm::dvec3(points_.front())};
    for (const glm::dvec4& point : points_) {
      box_.lowest_mm = glm::min(box_.lowest_mm, glm::dvec3(point));
      box_.highest_mm = glm::max(box_.highest_mm, glm::dvec3(point));
    }
  }
  /// Keeps this line's nearest place when it is nearer than the one found so far.
  void approach(const glm::dvec3& p_mm, Nearest& nearest) const {
    const glm::dvec3 off = glm::max(glm::max(box_.lowest_mm - p_mm, p_mm - box_.highest_mm), glm::dvec3(0.0));
    if (glm::dot(off, off) >= nearest.squared_mm2) return;
    const auto keep = [&](const glm::dvec3& across, double share) {
      const double squared = glm::dot(across, across);
      if (squared < nearest.squared_mm2) nearest = {squared, share};
    };
    if (points_.size() == 1) return keep(p_mm - glm::dvec3(points_.front()), points_.front().w);
    for (std::size_t n = 0; n + 1 < points_.size(); ++n) {
      const glm::dvec4 step = points_[n + 1] - points_[n];
      const glm::dvec3 along(step), from = p_mm - glm::dvec3(points_[n]);
      const double length2 = glm::dot(along, along);
      const double t = length2 > 0.0 ? std::clamp(glm::dot(from, along) / length2, 0.0, 1.0) : 0.0;
      keep(from - t * along, points_[n].w + t * step.w);
    }
  }
  [[nodiscard]] std::size_t pieces() const { return points_.size(); }

 private:
  std::vector<glm::dvec4> points_;
  Bounds box_;
};

class Relief final : public Shape {
 public:
  Relief(ShapePtr of, const std::vector<ReliefLine>& lines) : of_(std::move(of)) {
    countPart(*of_);
    double highest = 0.0;
    for (const ReliefLine& each : lines) {
      Ridge ridge{each.halfWidth_mm, each.height_mm, {}};
      for (const auto& points : each.lines) {
        ridge.lines.emplace_back(*of_, points);
        solids_ += static_cast<double>(ridge.lines.back().pieces());
      }
      highest += std::max(0.0, each.height_mm);
      ridges_.push_back(std::move(ridge));
    }
    bounds_ = {of_->bounds().lowest_mm - highest, of_->bounds().highest_mm + highest};
  }
  double distance_mm(const glm::dvec3& p_mm) const override {
    const double d = of_->distance_mm(p_mm);
    const double depth = std::abs(d);
    if (depth >= kReach_mm) return d;
    double raised = 0.0;
    for (const Ridge& ridge : ridges_) {
      // Along the surface: what the point lies off it does not count.
      const double width2 = ridge.halfWidth_mm * ridge.halfWidth_mm, farthest2 = width2 + d * d;
      Nearest nearest{farthest2};
      for (const Line& line : ridge.lines) line.approach(p_mm, nearest);
      if (nearest.squared_mm2 >= farthest2) continue;
      const double off = 1.0 - std::max(0.0, nearest.squared_mm2 - d * d) / width2;
      raised += ridge.height_mm * nearest.share * off * off;
    }
    const double faded = std::clamp((depth - kFullDepth_mm) / (kReach_mm - kFullDepth_mm), 0.0, 1.0);
    return d - raised * (1.0 - faded * faded * (3.0 - 2.0 * faded));
  }

 private:
  struct Ridge {
    double halfWidth_mm;
    double height_mm;
    std::vector<Line> lines;
  };
  ShapePtr of_;
  std::vector<Ridge> ridges_;
};

}  // namespace

ShapePtr makeRelief(ShapePtr of, const std::vector<ReliefLine>& lines) {
  EW_EXPECTS(of);
  for (const ReliefLine& each : lines) {
    EW_EXPECTS(each.halfWidth_mm > 0.0);
    for ([[maybe_unused]] const auto& points : each.lines) EW_EXPECTS(!points.empty());
  }
  return std::make_shared<Relief>(std::move(of), lines);
}

}  // namespace ew::phantom
