#include "discs.h"

#include <algorithm>
#include <numbers>

#include "cross.h"
#include "ew/core/contract.h"

namespace ew::measurement {
namespace {

/// d cross(a, b) / da and / db.
glm::dvec2 crossByFirst(const glm::dvec2& b) { return {b.y, -b.x}; }
glm::dvec2 crossBySecond(const glm::dvec2& a) { return {-a.y, a.x}; }

/// Where an edge of the outline passes the middle line of a disc: how far from the axis, with its slopes.
struct Crossing {
  double across;
  std::size_t from, to;  // the edge's points
  glm::dvec2 byFrom, byTo, byStart, byEnd;
};

/// Axis from A to B, of length L along u. A disc's middle line lies at A + f (B - A) and is crossed by the edge P + t (Q - P):
/// t = (f L^2 - (P - A).(B - A)) / ((Q - P).(B - A)), and the crossing lies cross(B - A, P + t (Q - P) - A) / L from the axis.
Crossing crossingOf(std::span<const glm::dvec2> points, std::size_t from, std::size_t to, double fraction) {
  const glm::dvec2 A = points[0], d = points[1] - A, P = points[from], e = points[to] - P;
  const double L = glm::length(d), run = glm::dot(e, d), t = (fraction * L * L - glm::dot(P - A, d)) / run;
  const glm::dvec2 X = P + t * e - A;
  const double area = cross(d, X);
  Crossing made{area / L, from, to, {}, {}, {}, {}};
  // t by each point, from t run = f d.d - (P - A).d
  const glm::dvec2 tByP = (-d + t * d) / run, tByQ = -t * d / run;
  const glm::dvec2 tByD = (2.0 * fraction * d - (P - A) - t * e) / run, tByA = d / run;  // tByA: through P - A alone
  const double slide = cross(d, e);                                                      // of the area by t
  const glm::dvec2 byX = crossBySecond(d), byD = crossByFirst(X);
  made.byFrom = (byX * (1.0 - t) + slide * tByP) / L;
  made.byTo = (byX * t + slide * tByQ) / L;
  const glm::dvec2 whole = (byD + slide * tByD) / L - area / (L * L * L) * d;  // by d = B - A
  made.byEnd = whole;
  made.byStart = (-byX + slide * tByA) / L - whole;
  return made;
}

}  // namespace

DiscPlane discPlaneOf(std::span<const glm::dvec2> points) {
  EW_EXPECTS(points.size() >= 5);
  const glm::dvec2 A = points[0], d = points[1] - A;
  const double L = glm::length(d);
  DiscPlane plane;
  plane.length_mm.value = L;
  plane.length_mm.gradient.assign(points.size(), glm::dvec2(0.0));
  plane.length_mm.gradient[0] = -d / L;
  plane.length_mm.gradient[1] = d / L;
  const std::size_t count = points.size() - 2;
  for (int disc = 0; disc < kDiscs; ++disc) {
    const double fraction = (disc + 0.5) / kDiscs;
    std::vector<Crossing> crossings;
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t from = 2 + n, to = 2 + (n + 1) % count;
      const bool before = glm::dot(points[from] - A, d) < fraction * L * L, after = glm::dot(points[to] - A, d) < fraction * L * L;
      if (before != after) crossings.push_back(crossingOf(points, from, to, fraction));
    }
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.across < b.across; });
    ByPoints width{0.0, std::vector<glm::dvec2>(points.size(), glm::dvec2(0.0))};
    for (std::size_t n = 0; n < crossings.size(); ++n) {  // of an outline that folds, what lies inside
      const Crossing& each = crossings[n];
      const double sign = n % 2 == 0 ? -1.0 : 1.0;
      width.value += sign * each.across;
      width.gradient[each.from] += sign * each.byFrom;
      width.gradient[each.to] += sign * each.byTo;
      width.gradient[0] += sign * each.byStart;
      width.gradient[1] += sign * each.byEnd;
    }
    plane.widths_mm.push_back(std::move(width));
  }
  return plane;
}

ByPoints discVolume(const DiscPlane& plane) {
  const double share = 0.25 * std::numbers::pi / kDiscs;
  double squares = 0.0;
  for (const ByPoints& width : plane.widths_mm) squares += width.value * width.value;
  ByPoints volume{share * plane.length_mm.value * squares, std::vector<glm::dvec2>(plane.length_mm.gradient.size())};
  for (std::size_t n = 0; n < volume.gradient.size(); ++n) {
    volume.gradient[n] = share * squares * plane.length_mm.gradient[n];
    for (const ByPoints& width : plane.widths_mm)
      volume.gradient[n] += 2.0 * share * plane.length_mm.value * width.value * width.gradient[n];
  }
  return volume;
}

ByPoints discVolume(const DiscPlane& first, const DiscPlane& second) {
  const double share = 0.25 * std::numbers::pi / kDiscs;
  const bool firstIsLonger = first.length_mm.value >= second.length_mm.value;
  const double L = firstIsLonger ? first.length_mm.value : second.length_mm.value;
  double products = 0.0;
  for (std::size_t disc = 0; disc < first.widths_mm.size(); ++disc) products += first.widths_mm[disc].value * second.widths_mm[disc].value;
  ByPoints volume{share * L * products, {}};
  const auto append = [&](const DiscPlane& own, const DiscPlane& other, bool isLonger) {
    for (std::size_t n = 0; n < own.length_mm.gradient.size(); ++n) {
      glm::dvec2 slope = isLonger ? share * products * own.length_mm.gradient[n] : glm::dvec2(0.0);
      for (std::size_t disc = 0; disc < own.widths_mm.size(); ++disc)
        slope += share * L * other.widths_mm[disc].value * own.widths_mm[disc].gradient[n];
      volume.gradient.push_back(slope);
    }
  };
  append(first, second, firstIsLonger);
  append(second, first, !firstIsLonger);
  return volume;
}

}  // namespace ew::measurement
