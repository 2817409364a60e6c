#include "ew/measurement/caliper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "cross.h"
#include "discs.h"
#include "ew/core/contract.h"
#include "ew/core/find_entry.h"
#include "ew/core/word_table.h"
#include "spreads.h"

namespace ew::measurement {
namespace {

using Points = std::span<const glm::dvec2>;
using Gradient = std::vector<glm::dvec2>;

constexpr std::size_t kMostPoints = 10000;  // every pair of an outline is looked at for its uncertainty

struct KindInfo {
  CaliperKind kind;
  std::string_view word;
  CaliperShape shape;
};
constexpr std::array kKinds{KindInfo{CaliperKind::distance, "distance", {1, 2, 2, false}},
                            KindInfo{CaliperKind::polyLine, "poly_line", {1, 2, kMostPoints, false}},
                            KindInfo{CaliperKind::ellipse, "ellipse", {1, 4, 4, false}},
                            KindInfo{CaliperKind::fittedEllipse, "fitted_ellipse", {1, 5, kMostPoints, false}},
                            KindInfo{CaliperKind::trace, "trace", {1, 3, kMostPoints, false}},
                            KindInfo{CaliperKind::angle, "angle", {1, 3, 4, false}},
                            KindInfo{CaliperKind::ratio, "ratio", {2, 2, 2, false}},
                            KindInfo{CaliperKind::ellipsoid, "ellipsoid", {3, 2, 2, false}},
                            KindInfo{CaliperKind::discs, "discs", {1, 5, kMostPoints, false}},
                            KindInfo{CaliperKind::biplane, "biplane", {2, 5, kMostPoints, false}},
                            KindInfo{CaliperKind::interval, "interval", {1, 2, 2, true}},
                            KindInfo{CaliperKind::slope, "slope", {1, 2, 2, true}},
                            KindInfo{CaliperKind::heartRate, "heart_rate", {1, 2, 2, true}},
                            KindInfo{CaliperKind::depthDistance, "depth_distance", {1, 2, 2, true}}};

constexpr WordTable<FigureKind, 11> kFigures{{{"length", FigureKind::length},
                                              {"circumference", FigureKind::circumference},
                                              {"area", FigureKind::area},
                                              {"long_axis", FigureKind::longAxis},
                                              {"short_axis", FigureKind::shortAxis},
                                              {"angle", FigureKind::angle},
                                              {"ratio", FigureKind::ratio},
                                              {"volume", FigureKind::volume},
                                              {"slope", FigureKind::slope},
                                              {"heart_rate", FigureKind::heartRate},
                                              {"duration", FigureKind::duration}}};

const KindInfo& infoOf(CaliperKind kind) {
  const auto found = std::find_if(kKinds.begin(), kKinds.end(), [&](const KindInfo& info) { return info.kind == kind; });
  EW_EXPECTS(found != kKinds.end());
  return *found;
}

Error cannot(Message why) { return {ErrorCode::badField, std::move(why), {}}; }

CaliperFigure made(FigureKind kind, double value, Unit unit, Gradient gradient) { return {kind, {value, 0.0, unit}, std::move(gradient)}; }

/// The length between two points, with its derivatives; nothing of no length.
std::optional<std::pair<double, std::array<glm::dvec2, 2>>> lengthOf(const glm::dvec2& a, const glm::dvec2& b) {
  const double length = glm::length(b - a);
  if (!(length > 0.0)) return std::nullopt;
  const glm::dvec2 u = (b - a) / length;
  return std::pair{length, std::array{-u, u}};
}

/// Length of a line from point to point; points that lie on each other have no direction and no derivative.
std::pair<double, Gradient> wayAlong(Points points, bool isClosed) {
  double length = 0.0;
  Gradient gradient(points.size(), glm::dvec2(0.0));
  for (std::size_t n = 0; n + (isClosed ? 0 : 1) < points.size(); ++n) {
    const std::size_t next = (n + 1) % points.size();
    if (const auto piece = lengthOf(points[n], points[next])) {
      length += piece->first;
      gradient[n] += piece->second[0];
      gradient[next] += piece->second[1];
    }
  }
  return {length, std::move(gradient)};
}

/// The area of a closed outline by the shoelace formula, about its first point so that far away nothing cancels.
std::pair<double, Gradient> areaWithin(Points points) {
  double twice = 0.0;
  for (std::size_t n = 1; n + 1 < points.size(); ++n) twice += cross(points[n] - points[0], points[n + 1] - points[0]);
  const double sign = twice < 0.0 ? -1.0 : 1.0;
  Gradient gradient(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) {
    const glm::dvec2 chord = points[(n + 1) % points.size()] - points[(n + points.size() - 1) % points.size()];
    gradient[n] = 0.5 * sign * glm::dvec2(chord.y, -chord.x);
  }
  return {0.5 * sign * twice, std::move(gradient)};
}

/// Whether two pieces of the closed outline cross each other. Only asked of outlines by hand: all pairs are looked at.
bool crossesItself(Points points) {
  constexpr std::size_t kMostLookedAt = 400;
  const std::size_t count = points.size();
  if (count > kMostLookedAt) return false;
  const auto side = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) { return cross(b - a, c - a); };
  for (std::size_t n = 0; n < count; ++n)
    for (std::size_t m = n + 2; m < count; ++m) {
      if (n == 0 && m + 1 == count) continue;
      const glm::dvec2 &a = points[n], &b = points[n + 1], &c = points[m], &d = points[(m + 1) % count];
      if (side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0) return true;
    }
  return false;
}

Result<Measured> measureDistance(Points points) {
  const auto length = lengthOf(points[0], points[1]);
  if (!length) return passOn(cannot(say<"Both points lie on each other; move one of them.">()));
  return Measured{{made(FigureKind::length, length->first, Unit::mm, {length->second[0], length->second[1]})}, {}, 0.0, {}};
}

Result<Measured> measurePolyLine(Points points) {
  auto [length, gradient] = wayAlong(points, false);
  return Measured{{made(FigureKind::length, length, Unit::mm, std::move(gradient))}, {}, 0.0, {}};
}

Result<Measured> measureEllipse(Points points) {
  const auto first = lengthOf(points[0], points[1]), second = lengthOf(points[2], points[3]);
  if (!first || !second) return passOn(cannot(say<"One axis of the ellipse has no length; move one of its ends.">()));
  const double a = 0.5 * first->first, b = 0.5 * second->first;
  const auto with = [&](double byA, double byB) {
    return Gradient{0.5 * byA * first->second[0], 0.5 * byA * first->second[1], 0.5 * byB * second->second[0],
                    0.5 * byB * second->second[1]};
  };
  const auto slopes = ellipseCircumferenceSlopes(a, b);
  const bool firstIsLong = a >= b;
  Measured measured;
  measured.figures = {made(FigureKind::circumference, ellipseCircumference_mm(a, b), Unit::mm, with(slopes[0], slopes[1])),
                      made(FigureKind::area, std::numbers::pi * a * b, Unit::mm2, with(std::numbers::pi * b, std::numbers::pi * a)),
                      made(FigureKind::longAxis, 2.0 * std::max(a, b), Unit::mm, firstIsLong ? with(2.0, 0.0) : with(0.0, 2.0)),
                      made(FigureKind::shortAxis, 2.0 * std::min(a, b), Unit::mm, firstIsLong ? with(0.0, 2.0) : with(2.0, 0.0))};
  const glm::dvec2 axis = points[1] - points[0];
  double angle_rad = std::atan2(axis.y, axis.x) + (firstIsLong ? 0.0 : 0.5 * std::numbers::pi);
  angle_rad -= std::numbers::pi * std::floor(angle_rad / std::numbers::pi);
  measured.ellipse = Ellipse{0.5 * (points[0] + points[1]), std::max(a, b), std::min(a, b), angle_rad < std::numbers::pi ? angle_rad : 0.0};
  return measured;
}

Result<Measured> measureFittedEllipse(Points points) {
  auto fit = fitEllipse(points);
  if (!fit) return passOn(fit.error());
  const double a = fit->ellipse.semiMajor_mm, b = fit->ellipse.semiMinor_mm;
  Measured measured;
  measured.figures = {made(FigureKind::circumference, ellipseCircumference_mm(a, b), Unit::mm, std::move(fit->circumferenceByPoint)),
                      made(FigureKind::area, std::numbers::pi * a * b, Unit::mm2, std::move(fit->areaByPoint)),
                      made(FigureKind::longAxis, 2.0 * a, Unit::mm, std::move(fit->majorByPoint)),
                      made(FigureKind::shortAxis, 2.0 * b, Unit::mm, std::move(fit->minorByPoint))};
  measured.ellipse = fit->ellipse;
  measured.residualRms_mm = fit->residualRms_mm;
  if (!fit->isConverged) measured.remarks.push_back(say<"The ellipse did not settle; more points around the outline would hold it.">());
  return measured;
}

Result<Measured> measureTrace(Points points) {
  auto [area, areaByPoint] = areaWithin(points);
  auto [length, lengthByPoint] = wayAlong(points, true);
  Measured measured;
  measured.figures = {made(FigureKind::area, area, Unit::mm2, std::move(areaByPoint)),
                      made(FigureKind::circumference, length, Unit::mm, std::move(lengthByPoint))};
  if (crossesItself(points)) measured.remarks.push_back(say<"The outline crosses itself, so its area is too small; trace it again.">());
  return measured;
}

Result<Measured> measureAngle(Points points) {
  const bool isOfTwoLines = points.size() == 4;
  const glm::dvec2 a = isOfTwoLines ? points[1] - points[0] : points[0] - points[1];
  const glm::dvec2 b = isOfTwoLines ? points[3] - points[2] : points[2] - points[1];
  const double aa = glm::dot(a, a), bb = glm::dot(b, b);
  if (!(aa > 0.0) || !(bb > 0.0)) return passOn(cannot(say<"One leg of the angle has no length; move one of its ends.">()));
  const double signed_rad = std::atan2(cross(a, b), glm::dot(a, b));
  const double sign = signed_rad < 0.0 ? -1.0 : 1.0, degrees = 180.0 / std::numbers::pi;
  // A leg's direction changes by the part of its end's move that stands square to it, over its length.
  const glm::dvec2 byA = sign * degrees * glm::dvec2(a.y, -a.x) / aa, byB = sign * degrees * glm::dvec2(-b.y, b.x) / bb;
  const Gradient gradient = isOfTwoLines ? Gradient{-byA, byA, -byB, byB} : Gradient{byA, -byA - byB, byB};
  return Measured{{made(FigureKind::angle, sign * signed_rad * degrees, Unit::degree, gradient)}, {}, 0.0, {}};
}

/// A product of powers of distances: that of each part.
Result<Measured> measureProduct(const Caliper& caliper, FigureKind kind, Unit unit, double factor, const std::vector<double>& powers) {
  double value = factor;
  std::vector<std::pair<double, std::array<glm::dvec2, 2>>> lengths;
  for (std::size_t n = 0; n < caliper.parts.size(); ++n) {
    const auto length = lengthOf(caliper.parts[n].points[0], caliper.parts[n].points[1]);
    if (!length) return passOn(cannot(say<"Distance %1 has no length; move one of its ends.">(n + 1)));
    value *= std::pow(length->first, powers[n]);
    lengths.push_back(*length);
  }
  Gradient gradient;
  for (std::size_t n = 0; n < lengths.size(); ++n)
    for (const glm::dvec2& slope : lengths[n].second) gradient.push_back(powers[n] * value / lengths[n].first * slope);
  return Measured{{made(kind, value, unit, std::move(gradient))}, {}, 0.0, {}};
}

Gradient scaled(Gradient gradient, double factor) {
  for (glm::dvec2& each : gradient) each *= factor;
  return gradient;
}

Result<Measured> measureDiscs(const Caliper& caliper) {
  constexpr double kMmCubed_ml = 1e-3;
  constexpr double kMostDifferent = 0.2;  // of two long axes of one chamber; beyond it one view is foreshortened (Lang et al. 2015)
  std::vector<DiscPlane> planes;
  for (const CaliperPart& part : caliper.parts) {
    if (!(glm::length(part.points[1] - part.points[0]) > 0.0))
      return passOn(cannot(say<"The long axis has no length; move one of its ends.">()));
    planes.push_back(discPlaneOf(part.points));
    const auto& widths = planes.back().widths_mm;
    if (std::all_of(widths.begin(), widths.end(), [](const ByPoints& width) { return width.value == 0.0; }))
      return passOn(cannot(say<"The outline does not lie along its long axis; draw the axis through it.">()));
  }
  ByPoints volume = planes.size() == 1 ? discVolume(planes[0]) : discVolume(planes[0], planes[1]);
  Measured measured;
  measured.figures.push_back(
      made(FigureKind::volume, volume.value * kMmCubed_ml, Unit::ml, scaled(std::move(volume.gradient), kMmCubed_ml)));
  const bool secondIsLonger = planes.size() == 2 && planes[1].length_mm.value > planes[0].length_mm.value;
  const ByPoints& length = planes[secondIsLonger ? 1 : 0].length_mm;
  Gradient byPoint(measured.figures[0].gradient.size(), glm::dvec2(0.0));
  std::copy(length.gradient.begin(), length.gradient.end(),
            byPoint.begin() + (secondIsLonger ? static_cast<std::ptrdiff_t>(caliper.parts[0].points.size()) : 0));
  measured.figures.push_back(made(FigureKind::longAxis, length.value, Unit::mm, std::move(byPoint)));
  if (planes.size() == 2) {
    const double other = planes[secondIsLonger ? 0 : 1].length_mm.value;
    if (length.value - other > kMostDifferent * length.value)
      measured.remarks.push_back(say<"The long axes of both planes differ by more than a fifth; one of them may be cut short.">());
  }
  return measured;
}

Result<Measured> measureInStrip(const Caliper& caliper) {
  const Points points = caliper.parts[0].points;
  const double time_s = points[1].x - points[0].x, change_mm = points[1].y - points[0].y;
  if (caliper.kind == CaliperKind::depthDistance) {
    if (change_mm == 0.0) return passOn(cannot(say<"Both points lie at the same depth; move one of them.">()));
    const double down = change_mm < 0.0 ? -1.0 : 1.0;
    return Measured{{made(FigureKind::length, std::abs(change_mm), Unit::mm, {{0.0, -down}, {0.0, down}})}, {}, 0.0, {}};
  }
  if (time_s == 0.0) return passOn(cannot(say<"Both points lie at the same moment; move one of them.">()));
  const double sign = time_s < 0.0 ? -1.0 : 1.0;
  Measured measured;
  if (caliper.kind == CaliperKind::slope) {
    const glm::dvec2 bySecond(-change_mm / (time_s * time_s), 1.0 / time_s);
    measured.figures.push_back(made(FigureKind::slope, change_mm / time_s, Unit::mmPerS, {-bySecond, bySecond}));
  } else if (caliper.kind == CaliperKind::heartRate) {
    const double rate = 60.0 * caliper.cycles / std::abs(time_s);
    const glm::dvec2 bySecond(-rate / time_s, 0.0);
    measured.figures.push_back(made(FigureKind::heartRate, rate, Unit::perMinute, {-bySecond, bySecond}));
  }
  measured.figures.push_back(made(FigureKind::duration, std::abs(time_s), Unit::s, {{-sign, 0.0}, {sign, 0.0}}));
  return measured;
}

Result<Measured> measureValue(const Caliper& caliper) {
  const Points points = caliper.parts[0].points;
  switch (caliper.kind) {
    case CaliperKind::distance:
      return measureDistance(points);
    case CaliperKind::polyLine:
      return measurePolyLine(points);
    case CaliperKind::ellipse:
      return measureEllipse(points);
    case CaliperKind::fittedEllipse:
      return measureFittedEllipse(points);
    case CaliperKind::trace:
      return measureTrace(points);
    case CaliperKind::angle:
      return measureAngle(points);
    case CaliperKind::ratio:
      return measureProduct(caliper, FigureKind::ratio, Unit::one, 1.0, {1.0, -1.0});
    case CaliperKind::ellipsoid:
      return measureProduct(caliper, FigureKind::volume, Unit::ml, 1e-3 * std::numbers::pi / 6.0, {1.0, 1.0, 1.0});
    case CaliperKind::discs:
    case CaliperKind::biplane:
      return measureDiscs(caliper);
    case CaliperKind::interval:
    case CaliperKind::slope:
    case CaliperKind::heartRate:
    case CaliperKind::depthDistance:
      return measureInStrip(caliper);
  }
  return passOn(cannot(say<"This kind of caliper is not known.">()));
}

/// @error badField
Result<void> checkShape(const Caliper& caliper) {
  const CaliperShape shape = shapeOf(caliper.kind);
  const std::string word(wordOf(caliper.kind));
  if (caliper.parts.size() != shape.parts)
    return failure(ErrorCode::badField,
                   say<"A caliper of the kind '%1' has %2 parts, this one has %3.">(word, shape.parts, caliper.parts.size()));
  for (const CaliperPart& part : caliper.parts) {
    if (part.points.size() < shape.fewest || part.points.size() > shape.most)
      return failure(ErrorCode::badField, say<"A caliper of the kind '%1' has %2 to %3 points in a part, this one has %4.">(
                                              word, shape.fewest, shape.most, part.points.size()));
    for (const glm::dvec2& point : part.points)
      if (!(std::abs(point.x) <= kFarthestPoint && std::abs(point.y) <= kFarthestPoint))
        return failure(ErrorCode::badField, say<"A point of a caliper lies nowhere; set it again.">());
  }
  if (caliper.cycles < 1 || caliper.cycles > kMostCycles)
    return failure(ErrorCode::badField, say<"A heart rate is measured over 1 to %1 cycles, not over %2.">(kMostCycles, caliper.cycles));
  return {};
}

bool isOutline(CaliperKind kind) { return kind == CaliperKind::trace || kind == CaliperKind::discs || kind == CaliperKind::biplane; }

}  // namespace

Spreads spreadsOf(const Caliper& caliper, const UncertaintyAt& at) {
  const bool isInStrip = shapeOf(caliper.kind).isInStrip;
  Spreads spreads;
  spreads.isOutline = isOutline(caliper.kind);
  for (const CaliperPart& part : caliper.parts) {
    for (const glm::dvec2& point : part.points) {
      const PointUncertainty u = at(part.image, point);
      const double beam_rad = isInStrip ? 0.0 : u.beam_rad, lateral_mm = isInStrip ? 0.0 : u.lateral_mm;
      const glm::dvec2 along(std::sin(beam_rad), std::cos(beam_rad)), across(std::cos(beam_rad), -std::sin(beam_rad));
      spreads.points.push_back(
          {point, u.pixel * u.pixel / 12.0, edgeDeviation_mm(u.axial_mm) * along, edgeDeviation_mm(lateral_mm) * across});
      spreads.meanWidth_mm += glm::dvec2(lateral_mm, u.axial_mm) / kFwhmOfSigma;
    }
    spreads.ends.push_back(spreads.points.size());
  }
  spreads.meanWidth_mm /= static_cast<double>(spreads.points.size());
  return spreads;
}

double covarianceWithin(const Gradient& a, const Gradient& b, const Spreads& spreads) {
  struct ByEcho {
    double axial, lateral;
  };
  const auto byEcho = [&](const Gradient& gradient) {
    std::vector<ByEcho> made;
    for (std::size_t n = 0; n < gradient.size(); ++n)
      made.push_back({glm::dot(gradient[n], spreads.points[n].axial), glm::dot(gradient[n], spreads.points[n].lateral)});
    return made;
  };
  const std::vector<ByEcho> ofA = byEcho(a), ofB = byEcho(b);
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n)
    sum += glm::dot(a[n] * b[n], spreads.points[n].pixelVariance) + ofA[n].axial * ofB[n].axial + ofA[n].lateral * ofB[n].lateral;
  if (!spreads.isOutline || !(spreads.meanWidth_mm.x > 0.0 && spreads.meanWidth_mm.y > 0.0)) return sum;
  constexpr double kFarthest_widths2 = 50.0;  // exp(-25): nothing
  std::size_t begin = 0;
  for (const std::size_t end : spreads.ends) {
    for (std::size_t n = begin; n < end; ++n)
      for (std::size_t m = n + 1; m < end; ++m) {
        const glm::dvec2 d = (spreads.points[n].place - spreads.points[m].place) / spreads.meanWidth_mm;
        const double dd = glm::dot(d, d);
        if (dd < kFarthest_widths2)
          sum += std::exp(-0.5 * dd) * (ofA[n].axial * ofB[m].axial + ofA[m].axial * ofB[n].axial + ofA[n].lateral * ofB[m].lateral +
                                        ofA[m].lateral * ofB[n].lateral);
      }
    begin = end;
  }
  return sum;
}

double covarianceBetween(const Gradient& a, const Spreads& ofA, const Gradient& b, const Spreads& ofB) {
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n)
    for (std::size_t m = 0; m < b.size(); ++m) {
      const Spread &one = ofA.points[n], &other = ofB.points[m];
      if (one.place != other.place) continue;
      sum += glm::dot(a[n] * b[m], one.pixelVariance) + glm::dot(a[n], one.axial) * glm::dot(b[m], other.axial) +
             glm::dot(a[n], one.lateral) * glm::dot(b[m], other.lateral);
    }
  return sum;
}

std::string_view wordOf(CaliperKind kind) { return infoOf(kind).word; }

std::optional<CaliperKind> caliperKindOf(std::string_view word) {
  for (const KindInfo& info : kKinds)
    if (info.word == word) return info.kind;
  return std::nullopt;
}

CaliperShape shapeOf(CaliperKind kind) { return infoOf(kind).shape; }

std::string_view wordOf(FigureKind kind) { return wordIn(kFigures, kind); }

Figure figureOf(const CaliperFigure& figure) {
  return {std::string(wordOf(figure.kind)), figure.quantity.value, std::string(symbolOf(figure.quantity.unit)),
          figure.quantity.uncertainty};
}

const CaliperFigure* Measured::figure(FigureKind kind) const { return entryWith(figures, &CaliperFigure::kind, kind); }

Result<Measured> measure(const Caliper& caliper, const UncertaintyAt& at) {
  if (auto checked = checkShape(caliper); !checked) return passOn(checked.error());
  auto measured = measureValue(caliper);
  if (!measured || !at) return measured;
  const Spreads spreads = spreadsOf(caliper, at);
  for (CaliperFigure& figure : measured->figures)
    figure.quantity.uncertainty = std::sqrt(std::max(0.0, covarianceWithin(figure.gradient, figure.gradient, spreads)));
  return measured;
}

}  // namespace ew::measurement
