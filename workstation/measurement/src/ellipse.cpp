#include "ew/measurement/ellipse.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "ew/core/contract.h"
#include "ew/core/guarded.h"

namespace ew::measurement {
namespace {

constexpr std::size_t kFewestPoints = 5;
constexpr double kThinnest = 1e-3;  // short axis over long axis: below this the points lie on a line
constexpr int kMostSteps = 100;

using Parameters = Eigen::Matrix<double, 5, 1>;  // centre x, y; M: xx, xy, yy
using ByParameters = Eigen::Matrix<double, 2, 5>;

Eigen::Matrix2d shapeOf(const Parameters& p) {
  Eigen::Matrix2d M;
  M << p[2], p[3], p[3], p[4];
  return M;
}

/// Half of the axes: eigenvalues of M. b <= a.
struct Axes {
  double a, b, mean, halfDifference, offDiagonal, root;
};
Axes axesOf(const Parameters& p) {
  const double mean = 0.5 * (p[2] + p[4]), d = 0.5 * (p[2] - p[4]), root = std::hypot(d, p[3]);
  return {mean + root, mean - root, mean, d, p[3], root};
}

bool isEllipse(const Parameters& p) {
  const Axes axes = axesOf(p);
  return p.allFinite() && axes.a > 0.0 && axes.b > kThinnest * axes.a;
}

Parameters parametersOf(const Ellipse& e) {
  const double c = std::cos(e.angle_rad), s = std::sin(e.angle_rad), a = e.semiMajor_mm, b = e.semiMinor_mm;
  return (Parameters() << e.centre_mm.x, e.centre_mm.y, a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c).finished();
}

Ellipse ellipseOf(const Parameters& p) {
  const Axes axes = axesOf(p);
  double angle_rad = axes.root > 0.0 ? 0.5 * std::atan2(axes.offDiagonal, axes.halfDifference) : 0.0;
  if (angle_rad < 0.0) angle_rad += std::numbers::pi;
  if (angle_rad >= std::numbers::pi) angle_rad = 0.0;
  return {{p[0], p[1]}, axes.a, axes.b, angle_rad};
}

/// The nearest point of x^2/a^2 + y^2/b^2 = 1 to one of the first quadrant. D. Eberly, "Distance from a Point to an Ellipse, an Ellipsoid,
/// or a Hyperellipsoid" (2013): the root of a function that is convex and falls, found by bisection, which cannot miss it.
Eigen::Vector2d nearestInQuadrant(double a, double b, const Eigen::Vector2d& y) {
  if (y[1] <= 0.0) {
    const double numerator = a * y[0], denominator = a * a - b * b;
    if (numerator < denominator) {
      const double x = numerator / denominator;
      return {a * x, b * std::sqrt(std::max(0.0, 1.0 - x * x))};
    }
    return {a, 0.0};
  }
  if (y[0] <= 0.0) return {0.0, b};
  const double z0 = y[0] / a, z1 = y[1] / b, ratio = (a / b) * (a / b);
  double low = z1 - 1.0, high = z0 * z0 + z1 * z1 < 1.0 ? 0.0 : std::hypot(ratio * z0, z1) - 1.0;
  double s = 0.5 * (low + high);
  for (int n = 0; n < 200 && s != low && s != high; ++n) {
    const double n0 = ratio * z0 / (s + ratio), n1 = z1 / (s + 1.0);
    const double excess = n0 * n0 + n1 * n1 - 1.0;
    if (excess == 0.0) break;
    (excess > 0.0 ? low : high) = s;
    s = 0.5 * (low + high);
  }
  return {ratio * y[0] / (s + ratio), y[1] / (s + 1.0)};
}

/// Where on the ellipse a point belongs: (cos t, sin t) of the nearest place.
Eigen::Vector2d nearestParameter(const Parameters& p, const glm::dvec2& point) {
  const Ellipse e = ellipseOf(p);
  const double c = std::cos(e.angle_rad), s = std::sin(e.angle_rad);
  const Eigen::Vector2d d(point.x - p[0], point.y - p[1]);
  const Eigen::Vector2d local(c * d[0] + s * d[1], -s * d[0] + c * d[1]);
  const Eigen::Vector2d near = nearestInQuadrant(e.semiMajor_mm, e.semiMinor_mm, local.cwiseAbs());
  const Eigen::Vector2d signedNear(std::copysign(near[0], local[0]), std::copysign(near[1], local[1]));
  const Eigen::Vector2d place(c * signedNear[0] - s * signedNear[1], s * signedNear[0] + c * signedNear[1]);
  return shapeOf(p).inverse() * place;
}

/// One point beside the ellipse.
struct Foot {
  Eigen::Vector2d place;      // on the ellipse, from the centre: M (cos, sin)
  Eigen::Vector2d along;      // its derivative by t
  Eigen::Vector2d residual;   // the point less the place
  Eigen::Vector2d normal;     // outwards, of length one
  ByParameters byParameters;  // of the place, at fixed t
  ByParameters alongByParameters;
};
ByParameters byParametersAt(double cosT, double sinT, double ofCentre) {
  ByParameters J;
  J << ofCentre, 0.0, cosT, sinT, 0.0,  //
      0.0, ofCentre, 0.0, cosT, sinT;
  return J;
}
Foot footOf(const Parameters& p, const glm::dvec2& point) {
  const Eigen::Vector2d u = nearestParameter(p, point).normalized();
  const Eigen::Matrix2d M = shapeOf(p);
  Foot foot;
  foot.place = M * u;
  foot.along = M * Eigen::Vector2d(-u[1], u[0]);
  foot.residual = Eigen::Vector2d(point.x - p[0], point.y - p[1]) - foot.place;
  foot.normal = (M.inverse() * u).normalized();
  foot.byParameters = byParametersAt(u[0], u[1], 1.0);
  foot.alongByParameters = byParametersAt(-u[1], u[0], 0.0);
  return foot;
}

double costOf(const Parameters& p, std::span<const glm::dvec2> points) {
  double cost = 0.0;
  for (const glm::dvec2& point : points) cost += footOf(p, point).residual.squaredNorm();
  return cost;
}

struct Refined {
  Parameters parameters;
  int steps = 0;
  bool isConverged = false;
};

/// The Gauss-Newton step on the distances along the normals.
Parameters stepFrom(const Parameters& p, std::span<const glm::dvec2> points, double damping) {
  Eigen::Matrix<double, 5, 5> H = Eigen::Matrix<double, 5, 5>::Zero();
  Parameters g = Parameters::Zero();
  for (const glm::dvec2& point : points) {
    const Foot foot = footOf(p, point);
    const Parameters row = foot.byParameters.transpose() * foot.normal;
    H += row * row.transpose();
    g += row * foot.normal.dot(foot.residual);
  }
  const double scale = H.trace() / 5.0;
  H.diagonal().array() += damping * scale;
  return H.ldlt().solve(g);
}

/// Steps are damped until the cost falls. Close to the minimum the cost is flat to its last digit while the steps still shrink by the same
/// factor each: there they are taken as they come, until they no longer do.
Refined refine(Parameters p, std::span<const glm::dvec2> points) {
  constexpr double kClose = 1e-6, kEnough = 1e-13;  // of the long axis
  Refined found{p};
  double cost = costOf(p, points), damping = 0.0, before = 0.0;
  for (; found.steps < kMostSteps && !found.isConverged; ++found.steps) {
    const Parameters step = stepFrom(p, points, damping), next = p + step;
    const double size = step.norm() / axesOf(p).a;
    if (step.allFinite() && size <= kClose && damping == 0.0 && isEllipse(next)) {
      found.isConverged = size <= kEnough || (before > 0.0 && size >= 0.9 * before);
      if (before == 0.0 || size < before) p = next;
      before = size;
      continue;
    }
    before = 0.0;
    const double nextCost = step.allFinite() && isEllipse(next) ? costOf(next, points) : 2.0 * cost + 1.0;
    if (nextCost <= cost) {
      p = next;
      cost = nextCost;
      damping = damping < 1e-5 ? 0.0 : 0.1 * damping;
    } else {
      damping = damping == 0.0 ? 1e-4 : 10.0 * damping;
      if (damping > 1e8) break;
    }
  }
  found.parameters = p;
  return found;
}

/// Derivatives of the parameters by each point, at the minimum of F = 1/2 sum |x_i - e(t_i)|^2 over parameters and all t_i: the equations
/// dF = 0 hold when a point moves, so that d(parameters, t) = H^-1 d(gradient). The t_i are eliminated, each by itself.
std::vector<Eigen::Matrix<double, 5, 2>> parametersByPoint(const Parameters& p, std::span<const glm::dvec2> points) {
  Eigen::Matrix<double, 5, 5> S = Eigen::Matrix<double, 5, 5>::Zero();
  std::vector<Eigen::Matrix<double, 5, 2>> right;
  for (const glm::dvec2& point : points) {
    const Foot foot = footOf(p, point);
    const double byT = foot.along.squaredNorm() + foot.residual.dot(foot.place);  // d2e/dt2 = -place
    const Parameters mixed = foot.byParameters.transpose() * foot.along - foot.alongByParameters.transpose() * foot.residual;
    S += foot.byParameters.transpose() * foot.byParameters - mixed * mixed.transpose() / byT;
    right.emplace_back(foot.byParameters.transpose() - mixed * foot.along.transpose() / byT);
  }
  const auto solver = S.ldlt();
  for (auto& each : right) each = solver.solve(each).eval();
  return right;
}

/// Derivatives of long axis, short axis, circumference and area by the parameters.
Eigen::Matrix<double, 4, 5> figuresByParameters(const Parameters& p) {
  const Axes axes = axesOf(p);
  Parameters ofMean = Parameters::Zero(), ofRoot = Parameters::Zero();
  ofMean[2] = ofMean[4] = 0.5;
  if (axes.root > 1e-9 * axes.a) {  // of a circle the axes have no direction, and their difference no derivative
    ofRoot[2] = 0.5 * axes.halfDifference / axes.root;
    ofRoot[3] = axes.offDiagonal / axes.root;
    ofRoot[4] = -ofRoot[2];
  }
  const auto slopes = ellipseCircumferenceSlopes(axes.a, axes.b);
  Eigen::Matrix<double, 4, 5> J;
  J.row(0) = 2.0 * (ofMean + ofRoot).transpose();
  J.row(1) = 2.0 * (ofMean - ofRoot).transpose();
  J.row(2) = (slopes[0] + slopes[1]) * ofMean.transpose() + (slopes[0] - slopes[1]) * ofRoot.transpose();
  J.row(3) << 0.0, 0.0, p[4], -2.0 * p[3], p[2];
  J.row(3) *= std::numbers::pi;
  return J;
}

Error noEllipse() {
  return {ErrorCode::badField, say<"No ellipse goes through these points; put them around the outline, not along a line.">(), {}};
}

/// OpenCV works in float: points are brought around zero and to the size of one.
Result<Parameters> directFit(std::span<const glm::dvec2> points) {
  glm::dvec2 centre(0.0);
  for (const glm::dvec2& point : points) centre += point / static_cast<double>(points.size());
  double size = 0.0;
  for (const glm::dvec2& point : points) size = std::max(size, glm::length(point - centre));
  if (!(size > 0.0) || !std::isfinite(size)) return passOn(noEllipse());
  std::vector<cv::Point2f> scaled;
  for (const glm::dvec2& point : points) {
    const glm::dvec2 at = (point - centre) / size;
    scaled.emplace_back(static_cast<float>(at.x), static_cast<float>(at.y));
  }
  return guarded(
      [&]() -> Result<Parameters> {
        const cv::RotatedRect box = cv::fitEllipseDirect(scaled);
        const double w = 0.5 * static_cast<double>(box.size.width), h = 0.5 * static_cast<double>(box.size.height);
        double angle_rad = static_cast<double>(box.angle) * std::numbers::pi / 180.0;
        if (w < h) angle_rad += 0.5 * std::numbers::pi;
        const glm::dvec2 middle = centre + size * glm::dvec2(box.center.x, box.center.y);
        const Parameters p = parametersOf({middle, size * std::max(w, h), size * std::min(w, h), angle_rad});
        if (!isEllipse(p)) return passOn(noEllipse());
        return p;
      },
      [](const Thrown&) { return noEllipse(); });
}

/// Spread of the points across over along their main direction: 0 on a line.
double thickness(std::span<const glm::dvec2> points) {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  for (const glm::dvec2& point : points) centre += Eigen::Vector2d(point.x, point.y) / static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const glm::dvec2& point : points) {
    const Eigen::Vector2d d = Eigen::Vector2d(point.x, point.y) - centre;
    scatter += d * d.transpose();
  }
  const Eigen::Vector2d spread = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvalues();
  return spread[1] > 0.0 ? std::sqrt(std::max(0.0, spread[0]) / spread[1]) : 0.0;
}

}  // namespace

double ellipseCircumference_mm(double a_mm, double b_mm) {
  EW_EXPECTS(a_mm > 0.0 && b_mm > 0.0);
  const double a = std::max(a_mm, b_mm), b = std::min(a_mm, b_mm);
  return 4.0 * a * std::comp_ellint_2(std::sqrt((a - b) * (a + b)) / a);
}

std::array<double, 2> ellipseCircumferenceSlopes(double a_mm, double b_mm) {
  EW_EXPECTS(a_mm > 0.0 && b_mm > 0.0);
  const double a = std::max(a_mm, b_mm), b = std::min(a_mm, b_mm);
  const double kk = (a - b) * (a + b) / (a * a), k = std::sqrt(kk);
  const double E = std::comp_ellint_2(k);
  // dE/dk = (E - K) / k; near a circle the difference of E and K is taken from its series.
  const double perKk = kk < 1e-4 ? -0.25 * std::numbers::pi * (1.0 + kk * (3.0 / 8.0 + kk * (15.0 / 64.0 + kk * 175.0 / 1024.0)))
                                 : (E - std::comp_ellint_1(k)) / kk;
  const double byA = 4.0 * (E + perKk * (b / a) * (b / a));
  const double byB = (4.0 * a * E - a * byA) / b;  // of degree one: P = a dP/da + b dP/db
  return a_mm >= b_mm ? std::array{byA, byB} : std::array{byB, byA};
}

std::vector<glm::dvec2> pointsOn(const Ellipse& ellipse, int count) {
  EW_EXPECTS(count >= 3);
  const double c = std::cos(ellipse.angle_rad), s = std::sin(ellipse.angle_rad);
  std::vector<glm::dvec2> points;
  for (int n = 0; n < count; ++n) {
    const double t = 2.0 * std::numbers::pi * n / count, x = ellipse.semiMajor_mm * std::cos(t), y = ellipse.semiMinor_mm * std::sin(t);
    points.push_back(ellipse.centre_mm + glm::dvec2(c * x - s * y, s * x + c * y));
  }
  return points;
}

Result<EllipseFit> fitEllipse(std::span<const glm::dvec2> points_mm) {
  if (points_mm.size() < kFewestPoints)
    return failure(ErrorCode::badField, say<"An ellipse needs at least %1 points; there are %2.">(kFewestPoints, points_mm.size()));
  if (!(thickness(points_mm) > kThinnest)) return passOn(noEllipse());
  const auto start = directFit(points_mm);
  if (!start) return passOn(start.error());
  const Refined refined = refine(*start, points_mm);
  if (!isEllipse(refined.parameters)) return passOn(noEllipse());

  EllipseFit fit;
  fit.ellipse = ellipseOf(refined.parameters);
  fit.iterations = refined.steps;
  fit.isConverged = refined.isConverged;
  fit.residualRms_mm = std::sqrt(costOf(refined.parameters, points_mm) / static_cast<double>(points_mm.size()));
  const auto figures = figuresByParameters(refined.parameters);
  for (const auto& each : parametersByPoint(refined.parameters, points_mm)) {
    const Eigen::Matrix<double, 4, 2> byPoint = figures * each;
    fit.majorByPoint.emplace_back(byPoint(0, 0), byPoint(0, 1));
    fit.minorByPoint.emplace_back(byPoint(1, 0), byPoint(1, 1));
    fit.circumferenceByPoint.emplace_back(byPoint(2, 0), byPoint(2, 1));
    fit.areaByPoint.emplace_back(byPoint(3, 0), byPoint(3, 1));
  }
  return fit;
}

}  // namespace ew::measurement
