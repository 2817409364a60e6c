#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "ew/core/figure.h"
#include "ew/core/message.h"
#include "ew/core/result.h"
#include "ew/measurement/ellipse.h"
#include "ew/measurement/quantity.h"

namespace ew::measurement {

/// What calipers measure. Points lie in the plane of the image: mm of the probe frame, x lateral, y depth. Those of kinds for the strip
/// lie in that of an M-mode: x in s on the scan's clock, y depth along the beam in mm.
enum class CaliperKind {
  distance,       ///< one part: two points
  polyLine,       ///< one part: two or more points, joined in their order
  ellipse,        ///< one part: the ends of one axis, then the ends of the other, whose length alone counts
  fittedEllipse,  ///< one part: five or more points on the outline
  trace,          ///< one part: three or more points, joined and closed
  angle,          ///< one part: a point, the vertex, a point; or four, two lines of two points
  ratio,          ///< two parts of two points: the first distance over the second
  ellipsoid,      ///< three parts of two points, of two images: pi / 6 times the product of three diameters
  discs,          ///< one part: the ends of the long axis, then three or more points of the closed outline (Simpson, one plane)
  biplane,        ///< two parts as of discs, of two planes at right angles
  interval,       ///< strip; one part: two points, of which the times count
  slope,          ///< strip; one part: two points
  heartRate,      ///< strip; one part: two points, `cycles` heart beats apart
  depthDistance,  ///< strip; one part: two points, of which the depths count
};
[[nodiscard]] std::string_view wordOf(CaliperKind kind);  ///< in files: "distance", "poly_line", "fitted_ellipse"
[[nodiscard]] std::optional<CaliperKind> caliperKindOf(std::string_view word);

inline constexpr double kFarthestPoint = 1e6;  ///< of a point's coordinates, either way
inline constexpr int kMostCycles = 20;

/// How many parts a caliper has, and how many points each.
struct CaliperShape {
  std::size_t parts = 1;
  std::size_t fewest = 2;
  std::size_t most = 2;
  bool isInStrip = false;
};
[[nodiscard]] CaliperShape shapeOf(CaliperKind kind);

/// Points in one image.
struct CaliperPart {
  int image = 0;  ///< of two or four on the screen, or of two that were kept
  std::vector<glm::dvec2> points;
  bool operator==(const CaliperPart&) const = default;
};

/// A measurement as it was drawn: a value, from which its results follow.
struct Caliper {
  CaliperKind kind = CaliperKind::distance;
  std::vector<CaliperPart> parts;
  int cycles = 1;  ///< of heartRate, 1 to kMostCycles
  bool operator==(const Caliper&) const = default;
};

/// How far the place of a point can be known.
struct PointUncertainty {
  glm::dvec2 pixel{0.0};    ///< size of a pixel, mm (strip: s and mm); a point lies anywhere within it: pixel / sqrt(12) on each axis
  double axial_mm = 0.0;    ///< resolution along the beam, full width at half maximum
  double lateral_mm = 0.0;  ///< width of the beam at that depth, full width at half maximum; a strip has none
  double beam_rad = 0.0;    ///< direction of the beam there, from y towards x: 0 straight down
  bool operator==(const PointUncertainty&) const = default;
};

inline constexpr double kFwhmOfSigma = 2.3548200450309493;  ///< full width at half maximum over standard deviation, of a Gaussian

/// From full width at half maximum to the standard deviation of an edge's place. A pulse of that width is about a Gaussian of width / 2.355
/// (sigma); the image of a sharp edge rises from 20 to 80 % within +-0.84 sigma of the edge, and a reader puts the caliper somewhere within
/// that rise: evenly over it, 0.84 / sqrt 3 = 0.49 sigma, rounded to a half.
inline constexpr double kEdgeShare = 0.5;
[[nodiscard]] inline double edgeDeviation_mm(double fullWidth_mm) { return kEdgeShare * fullWidth_mm / kFwhmOfSigma; }

/// @param image as of CaliperPart @param p point of the caliper
using UncertaintyAt = std::function<PointUncertainty(int image, const glm::dvec2& p)>;

enum class FigureKind { length, circumference, area, longAxis, shortAxis, angle, ratio, volume, slope, heartRate, duration };
[[nodiscard]] std::string_view wordOf(FigureKind kind);  ///< "length", "long_axis"

/// One result of a caliper.
struct CaliperFigure {
  FigureKind kind = FigureKind::length;
  Quantity quantity;
  std::vector<glm::dvec2> gradient;  ///< of its value by each point: all of the first part, then those of the next
};
/// By the words of its kind and unit: "long_axis", 41.2, "mm".
[[nodiscard]] Figure figureOf(const CaliperFigure& figure);

struct Measured {
  std::vector<CaliperFigure> figures;  ///< the one that the caliper is for comes first
  std::optional<Ellipse> ellipse;      ///< of the two kinds of ellipses: what is to be drawn
  double residualRms_mm = 0.0;         ///< of a fitted ellipse: distance of the points from it
  std::vector<Message> remarks;        ///< what a person should know about it

  /// Null when there is none of this kind.
  [[nodiscard]] const CaliperFigure* figure(FigureKind kind) const;
};

/// Measures, with the standard uncertainty of every result: gradient times covariance of the points times gradient.
/// Points that a person sets one by one are independent of each other. Those of an outline (trace, discs) are not, once they lie closer
/// than the resolution: errors of two of them are correlated by exp(-(dx^2 / lateral^2 + dy^2 / axial^2) / 2), with mean widths of
/// resolution as standard deviations, so that a thousand points along an edge know no more of its place than the echoes do.
/// @param at empty: uncertainties are 0, not known
/// @error badField: parts or points too few or too many, not finite, or where nothing can be measured (an angle with a leg of no length)
[[nodiscard]] Result<Measured> measure(const Caliper& caliper, const UncertaintyAt& at = {});

}  // namespace ew::measurement
