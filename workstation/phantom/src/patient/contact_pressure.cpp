#include "ew/phantom/contact_pressure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr double kSkinStiffness_mm = 6.0;  // how far beside the face the skin is drawn down with it
constexpr double kSoftness = 0.1;          // how gradually the skin leaves a curved face, as a share of the indentation
constexpr double kHousing_mm = 2.0;        // of the lens beyond the elements, on each side
constexpr double kThinnest = 0.2;          // what is left of the thickness of the most squeezed layer

double halfHeightOf(const Probe& probe) { return 0.5 * probe.elevationalAperture_mm + kHousing_mm; }

/// The radius of the curved face that touches; 0 for a straight one.
double faceRadiusOf(const Probe& probe) { return faceSagitta_mm(probe) > 0.0 ? probe.radius_mm : 0.0; }

double punchRadiusOf(const Probe& probe, double indentation_mm) {
  double halfWidth_mm = faceHalfWidth_mm(probe);
  if (const double radius_mm = faceRadiusOf(probe); radius_mm > 0.0)
    halfWidth_mm = std::min(halfWidth_mm, std::sqrt(2.0 * radius_mm * indentation_mm));
  return std::sqrt(std::max(halfWidth_mm, 0.5) * halfHeightOf(probe));
}

double squeezed(const Probe& probe, double indentation_mm) {
  return indentation_mm / (std::numbers::pi * punchRadiusOf(probe, indentation_mm));
}

}  // namespace

double deepestIndentation_mm(const Probe& probe) {
  double low = 0.0, high = 200.0;  // what is squeezed grows with the indentation
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (squeezed(probe, middle) < 1.0 - kThinnest ? low : high) = middle;
  }
  return low;
}

ContactPressure::ContactPressure(const Probe& probe, const Transform<frame::World, frame::Probe>& probeToWorld, double indentation_mm,
                                 std::vector<double> gaps_mm)
    : probeToWorld_(probeToWorld),
      worldToProbe_(inverse(probeToWorld)),
      indentation_mm_(indentation_mm),
      faceHalfWidth_mm_(faceHalfWidth_mm(probe)),
      faceHalfHeight_mm_(halfHeightOf(probe)),
      faceRadius_mm_(faceRadiusOf(probe)),
      punchRadius_mm_(punchRadiusOf(probe, indentation_mm)),
      gaps_mm_(std::move(gaps_mm)) {
  EW_EXPECTS(gaps_mm_.empty() || gaps_mm_.size() >= 2);
  EW_EXPECTS(indentation_mm >= 0.0 && indentation_mm <= deepestIndentation_mm(probe));
}

/// How far the face lies behind its foremost point at a place along it, as a negative y of the probe frame.
double ContactPressure::faceY_mm(double x_mm) const {
  const double inside_mm = std::min(std::abs(x_mm), faceHalfWidth_mm_);
  if (faceRadius_mm_ <= 0.0) return 0.0;
  return std::sqrt(std::max(0.0, faceRadius_mm_ * faceRadius_mm_ - inside_mm * inside_mm)) - faceRadius_mm_;
}

double ContactPressure::gap_mm(double x_mm) const {
  if (gaps_mm_.empty()) return -faceY_mm(x_mm);
  const double inside_mm = std::clamp(x_mm, -faceHalfWidth_mm_, faceHalfWidth_mm_);
  // Points of an arc are evenly spaced in angle.
  const double across = faceRadius_mm_ > 0.0 ? std::asin(std::clamp(inside_mm / faceRadius_mm_, -1.0, 1.0)) /
                                                   std::asin(std::min(1.0, faceHalfWidth_mm_ / faceRadius_mm_))
                                             : inside_mm / faceHalfWidth_mm_;
  const auto last = static_cast<std::ptrdiff_t>(gaps_mm_.size()) - 1;
  const double at = std::clamp(0.5 * (across + 1.0), 0.0, 1.0) * static_cast<double>(last);
  const auto n = std::min(static_cast<std::ptrdiff_t>(at), last - 1);
  const auto gap = [&](std::ptrdiff_t index) { return gaps_mm_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, last))]; };
  // Through the points without a kink (Catmull and Rom).
  const double t = at - static_cast<double>(n);
  const double a = gap(n - 1), b = gap(n), c = gap(n + 1), d = gap(n + 2);
  return std::max(0.0, b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a))));
}

double ContactPressure::push_mm(const glm::dvec3& rest_probe_mm) const {
  const double gap = gap_mm(rest_probe_mm.x);
  const double skinY_mm = faceY_mm(rest_probe_mm.x) - indentation_mm_ + gap;
  const double depth = std::max(rest_probe_mm.y - skinY_mm, 0.0);
  const double a = punchRadius_mm_;
  const double below = depth > 0.0 ? 2.0 / std::numbers::pi * (std::atan(a / depth) + a * depth / (a * a + depth * depth)) : 1.0;
  // How far the face stays away from the resting skin at this place, in indentations: 1 where it no longer touches.
  const glm::dvec2 beside_mm(rest_probe_mm.x, rest_probe_mm.z);
  const double spread = kSkinStiffness_mm / (kSkinStiffness_mm + depth);
  const glm::dvec2 beyond =
      glm::max(glm::abs(beside_mm) - glm::dvec2(faceHalfWidth_mm_, faceHalfHeight_mm_), glm::dvec2(0.0)) / kSkinStiffness_mm;
  const double away = (gap / indentation_mm_ + glm::dot(beyond, beyond)) * spread * spread;
  // max(1 - away, 0) with its corner rounded; 1 where nothing is away.
  const double touched = kSoftness * std::log1p(std::exp((1.0 - away) / kSoftness));
  static const double whole = kSoftness * std::log1p(std::exp(1.0 / kSoftness));
  return indentation_mm_ * below * touched / whole;
}

glm::dvec3 ContactPressure::moved(const glm::dvec3& rest_mm) const {
  if (indentation_mm_ <= 0.0) return rest_mm;
  const glm::dvec3 at = (worldToProbe_ * Point<frame::World>{rest_mm}).at;
  const double push = push_mm(at);
  return rest_mm + push * glm::dvec3(probeToWorld_.matrix[1]);
}

glm::dvec3 ContactPressure::rest(const glm::dvec3& moved_mm) const {
  if (indentation_mm_ <= 0.0) return moved_mm;
  const glm::dvec3 at = (worldToProbe_ * Point<frame::World>{moved_mm}).at;
  // Along the beam alone, and rising: found by halving with secant steps between.
  double low = at.y - indentation_mm_, high = at.y;  // the push is between 0 and the indentation
  const auto beyond = [&](double y) { return y + push_mm({at.x, y, at.z}) - at.y; };
  double atLow = beyond(low), atHigh = beyond(high);
  constexpr double kClose_mm = 1e-4;
  for (int step = 0; step < 60 && high - low > kClose_mm; ++step) {
    double middle = step % 3 == 2 ? 0.5 * (low + high) : low - atLow * (high - low) / (atHigh - atLow);
    if (!(middle > low && middle < high)) middle = 0.5 * (low + high);
    const double there = beyond(middle);
    if (std::abs(there) < kThinnest * kClose_mm) {
      low = high = middle;
    } else if (there < 0.0) {
      low = middle, atLow = there;
    } else {
      high = middle, atHigh = there;
    }
  }
  return moved_mm + (0.5 * (low + high) - at.y) * glm::dvec3(probeToWorld_.matrix[1]);
}

}  // namespace ew
