#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ew/core/result.h"

namespace ew::measurement {

/// An ellipse in the plane of the image.
struct Ellipse {
  glm::dvec2 centre_mm{0.0};
  double semiMajor_mm = 0.0;
  double semiMinor_mm = 0.0;  ///< <= semiMajor_mm
  double angle_rad = 0.0;     ///< of the long axis, from x towards y, in [0, pi)
  bool operator==(const Ellipse&) const = default;
};

/// 4 a E(e), to double precision, by the complete elliptic integral of the second kind. @param a, b semi-axes > 0, in any order
[[nodiscard]] double ellipseCircumference_mm(double a_mm, double b_mm);
/// Its derivatives by a and b.
[[nodiscard]] std::array<double, 2> ellipseCircumferenceSlopes(double a_mm, double b_mm);

/// Points on the ellipse at even steps of its parameter, for drawing. @param count >= 3
[[nodiscard]] std::vector<glm::dvec2> pointsOn(const Ellipse& ellipse, int count);

/// An ellipse through clicked points, and what a click is worth to it.
struct EllipseFit {
  Ellipse ellipse;
  double residualRms_mm = 0.0;  ///< distance of the points from the ellipse
  int iterations = 0;
  bool isConverged = false;  ///< false: the best one found within the iterations allowed
  // Derivatives by each point, mm and mm2 for each mm:
  std::vector<glm::dvec2> circumferenceByPoint;
  std::vector<glm::dvec2> areaByPoint;
  std::vector<glm::dvec2> majorByPoint;  ///< of the long axis (2 a); of a circle, whose axes have no direction, by the mean of both
  std::vector<glm::dvec2> minorByPoint;  ///< of the short axis (2 b)
};

/// The ellipse with the smallest sum of squared distances to the points. Starts from the direct least squares fit (Fitzgibbon, Pilu &
/// Fisher, IEEE PAMI 21(5), 1999, in the stable form of Halir & Flusser 1998: OpenCV's fitEllipseDirect), whose algebraic distance pulls
/// flat ellipses too small when clicks are rough, and goes on by damped Gauss-Newton steps on the true distances. The ellipse is written c
/// + M (cos t, sin t) with a symmetric M, so that a circle is no special case. Derivatives come from the implicit function theorem at the
/// minimum, with second derivatives, and so are exact where it converged.
/// @param points_mm at least 5
/// @error badField (points too few, on one line, or otherwise on no ellipse)
[[nodiscard]] Result<EllipseFit> fitEllipse(std::span<const glm::dvec2> points_mm);

}  // namespace ew::measurement
