#include "fan_finder.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <utility>
#include <vector>

namespace ew::detail {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kStep_px = 2.0;       ///< between outline points that are measured
constexpr double kTolerance_px = 2.0;  ///< of a silhouette point to its line
constexpr double kSupport_px = 2.0;    ///< an edge this close bears the outline out
constexpr double kParallel_rad = 3.0 * kDegree;
constexpr double kSectorShare = 0.1;  ///< near over far radius below which a fan is a sector
constexpr double kLeastArea = 0.02;   ///< of the image
constexpr double kLeastFilled = 0.3;  ///< of an outline, by what is scan; wires in water fill a tenth
constexpr double kLeastSide = 0.15;   ///< of each side and of the far edge, by edges that bear it out; a side with less is a guess
constexpr double kMoves = 0.2;        ///< activity from which a pixel is one that moves
constexpr int kSamples = 600;         ///< lines drawn at random through two points

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }
glm::dvec2 down(double angle_rad) { return {std::sin(angle_rad), std::cos(angle_rad)}; }

/// What is scan (1) by one threshold, cleaned, and the map on which edges are measured.
struct Candidate {
  cv::Mat mask;
  cv::Mat evidence;
};

/// A straight line by a point and its angle from straight down.
struct Line {
  glm::dvec2 at{0.0};
  double angle_rad = 0.0;
  [[nodiscard]] double rightOf(glm::dvec2 p) const { return cross(p - at, down(angle_rad)); }
};

/// Outermost points of a mask, half a pixel outside the centres of its pixels.
struct Silhouette {
  std::vector<glm::dvec2> left, right, top, bottom;
  glm::dvec2 lower{0.0}, upper{0.0};  ///< corners of what holds them
};

enum Side { kNear, kRight, kFar, kLeft };

/// A place of the outline and where the edge is along its outward normal.
struct EdgePoint {
  glm::dvec2 at{0.0};
  glm::dvec2 normal{0.0};
  Side side = kNear;
  double offset_px = 0.0;
  bool seen = false;
  [[nodiscard]] glm::dvec2 edge() const { return at + offset_px * normal; }
};

cv::Mat matOf(const Image<float>& image) {
  cv::Mat mat(image.height, image.width, CV_32F);
  std::copy(image.pixels.begin(), image.pixels.end(), mat.ptr<float>());
  return mat;
}

cv::Mat disc(int size) {
  const int odd = std::max(3, size | 1);
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {odd, odd});
}

/// Small things gone, holes of speckle closed, and of the rest the largest piece, or all that are not small beside it.
cv::Mat cleaned(const cv::Mat& raw, bool largestAlone) {
  // A rim of nothing: what touches the image's edge is opened and closed there as anywhere.
  const int border = 24;
  cv::Mat mask;
  cv::copyMakeBorder(raw, mask, border, border, border, border, cv::BORDER_CONSTANT, cv::Scalar(0));
  const int scale = std::max(raw.cols, raw.rows);
  cv::morphologyEx(mask, mask, cv::MORPH_CLOSE, disc(scale / 150));
  cv::morphologyEx(mask, mask, cv::MORPH_OPEN, disc(scale / 90));
  mask = mask(cv::Rect(border, border, raw.cols, raw.rows)).clone();
  cv::Mat labels, facts, centres;
  const int count = cv::connectedComponentsWithStats(mask, labels, facts, centres, 8);
  int largest = 0;
  for (int n = 1; n < count; ++n) largest = std::max(largest, facts.at<int>(n, cv::CC_STAT_AREA));
  std::vector<std::uint8_t> keep(static_cast<std::size_t>(count), 0);
  for (int n = 1; n < count; ++n) {
    const int area = facts.at<int>(n, cv::CC_STAT_AREA);
    keep[static_cast<std::size_t>(n)] = largestAlone ? area == largest : area * 25 >= largest;
  }
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) mask.at<std::uint8_t>(y, x) = keep[static_cast<std::size_t>(labels.at<int>(y, x))];
  return mask;
}

Silhouette silhouetteOf(const cv::Mat& mask) {
  Silhouette found;
  found.lower = {mask.cols, mask.rows};
  std::vector<int> top(static_cast<std::size_t>(mask.cols), -1), bottom(static_cast<std::size_t>(mask.cols), -1);
  for (int y = 0; y < mask.rows; ++y) {
    int first = -1, last = -1;
    const std::uint8_t* const row = mask.ptr(y);
    for (int x = 0; x < mask.cols; ++x) {
      if (row[x] == 0) continue;
      if (first < 0) first = x;
      last = x;
      const auto column = static_cast<std::size_t>(x);
      if (top[column] < 0) top[column] = y;
      bottom[column] = y;
    }
    if (first < 0) continue;
    found.left.emplace_back(first - 0.5, y);
    found.right.emplace_back(last + 0.5, y);
    found.lower = glm::min(found.lower, glm::dvec2(first, y));
    found.upper = glm::max(found.upper, glm::dvec2(last, y));
  }
  for (std::size_t x = 0; x < top.size(); ++x) {
    if (top[x] < 0) continue;
    found.top.emplace_back(static_cast<double>(x), top[x] - 0.5);
    found.bottom.emplace_back(static_cast<double>(x), bottom[x] + 0.5);
  }
  return found;
}

/// The line through two of `points` that most of them lie on and few of `all` lie beyond. Dark parts of a scan draw points inwards, never
/// outwards, so that what lies beyond speaks against a line.
/// @param inward +1: inside is to the right of the line seen upright; -1: to the left
std::optional<Line> bestLine(const std::vector<glm::dvec2>& points, const std::vector<glm::dvec2>& all, double inward, double lowest_rad,
                             double highest_rad) {
  if (points.size() < 12) return std::nullopt;
  std::mt19937 random(20161);  // the same lines at every run
  std::optional<Line> best;
  double bestScore = 0.0;
  const auto at = [&] { return points[static_cast<std::size_t>(random() % points.size())]; };
  for (int n = 0; n < kSamples; ++n) {
    glm::dvec2 a = at(), b = at();
    if (a.y > b.y) std::swap(a, b);
    if (glm::distance(a, b) < 24.0) continue;
    const Line line{a, std::atan2(b.x - a.x, b.y - a.y)};
    const double angle = line.angle_rad;
    if (angle < lowest_rad || angle > highest_rad) continue;
    double score = 0.0;
    for (const glm::dvec2 p : points) score += std::abs(line.rightOf(p)) < kTolerance_px ? 1.0 : 0.0;
    for (const glm::dvec2 p : all) score -= inward * line.rightOf(p) < -2.0 * kTolerance_px ? 0.5 : 0.0;
    if (score > bestScore) {
      bestScore = score;
      best = line;
    }
  }
  return best;
}

std::optional<glm::dvec2> crossing(const Line& a, const Line& b) {
  const glm::dvec2 u = down(a.angle_rad), v = down(b.angle_rad);
  const double turn = cross(u, v);
  if (std::abs(turn) < 1e-6) return std::nullopt;
  return a.at + u * (cross(b.at - a.at, v) / turn);
}

/// The radius about `apex` that most points have and few lie beyond.
double bestRadius(const std::vector<glm::dvec2>& points, const FanOutline& fan, double outward) {
  std::vector<double> radii;
  for (const glm::dvec2 p : points) {
    const glm::dvec2 d = p - fan.apex_px;
    const double angle = std::atan2(d.x, d.y);
    if (angle > fan.left_rad && angle < fan.right_rad) radii.push_back(glm::length(d));
  }
  double best = radii.empty() ? 0.0 : radii.front(), bestScore = -1e9;
  for (const double radius : radii) {
    double score = 0.0;
    for (const double other : radii) {
      const double beyond = outward * (other - radius);
      score += std::abs(beyond) < kTolerance_px ? 1.0 : beyond > 2.0 * kTolerance_px ? -0.5 : 0.0;
    }
    if (score > bestScore) {
      bestScore = score;
      best = radius;
    }
  }
  return best;
}

float sample(const cv::Mat& map, glm::dvec2 p) {
  const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
  const auto fx = static_cast<float>(p.x - x), fy = static_cast<float>(p.y - y);
  const auto at = [&](int i, int j) { return i < 0 || j < 0 || i >= map.cols || j >= map.rows ? 0.0F : map.at<float>(j, i); };
  return (at(x, y) * (1.0F - fx) + at(x + 1, y) * fx) * (1.0F - fy) + (at(x, y + 1) * (1.0F - fx) + at(x + 1, y + 1) * fx) * fy;
}

/// The best step from a higher level inside to a lower one outside, of all steps along the normal.
void measureEdge(const cv::Mat& evidence, double reach_px, EdgePoint& point) {
  constexpr double step_px = 0.5;
  const int count = 2 * static_cast<int>(reach_px / step_px) + 1;
  const glm::dvec2 along(-point.normal.y, point.normal.x);
  std::vector<double> sums{0.0}, squares{0.0};
  for (int n = 0; n < count; ++n) {
    const glm::dvec2 p = point.at + (n * step_px - reach_px) * point.normal;
    double value = 0.0;
    for (const double aside : {-2.0, -1.0, 0.0, 1.0, 2.0}) value += 0.2 * static_cast<double>(sample(evidence, p + aside * along));
    sums.push_back(sums.back() + value);
    squares.push_back(squares.back() + value * value);
  }
  const auto spread = [&](int from, int to) {
    const double k = to - from, sum = sums[static_cast<std::size_t>(to)] - sums[static_cast<std::size_t>(from)];
    return squares[static_cast<std::size_t>(to)] - squares[static_cast<std::size_t>(from)] - sum * sum / k;
  };
  const double whole = spread(0, count);
  constexpr int fewest = 3;
  double best = whole;
  int split = 0;
  for (int n = fewest; n <= count - fewest; ++n) {
    const double inside = sums[static_cast<std::size_t>(n)] / n;
    const double outside = (sums.back() - sums[static_cast<std::size_t>(n)]) / (count - n);
    if (inside - outside < 0.25) continue;
    const double left = spread(0, n) + spread(n, count);
    if (left < best) {
      best = left;
      split = n;
    }
  }
  // Half of the profile's variation has to be the step.
  point.seen = split > 0 && best < 0.5 * whole;
  point.offset_px = (split - 0.5) * step_px - reach_px;
}

std::vector<EdgePoint> edgePoints(const FanOutline& outline, const cv::Mat& evidence, double reach_px) {
  std::vector<EdgePoint> points;
  const auto addLine = [&](glm::dvec2 from, glm::dvec2 to, Side side, glm::dvec2 outward) {
    const double length = glm::distance(from, to);
    for (double s = 4.0; s < length - 4.0; s += kStep_px) points.push_back({from + (to - from) * (s / length), outward, side, 0.0, false});
  };
  if (outline.shape == FanShape::linear) {
    for (std::size_t n = 0; n < 4; ++n) {
      const glm::dvec2 from = outline.corners_px[n], to = outline.corners_px[(n + 1) % 4];
      const glm::dvec2 d = (to - from) / std::max(1e-9, glm::distance(from, to));
      addLine(from, to, static_cast<Side>(n), {d.y, -d.x});
    }
  } else {
    const auto addArc = [&](double radius, Side side, double outward) {
      const double margin = 4.0 / std::max(radius, 4.0), angle = kStep_px / std::max(radius, 1.0);
      for (double a = outline.left_rad + margin; a < outline.right_rad - margin; a += angle)
        points.push_back({outline.apex_px + radius * down(a), outward * down(a), side, 0.0, false});
    };
    addArc(outline.near_px, kNear, -1.0);
    addArc(outline.far_px, kFar, 1.0);
    for (const bool left : {true, false}) {
      const double angle = left ? outline.left_rad : outline.right_rad;
      const glm::dvec2 u = down(angle), across(u.y, -u.x);
      addLine(outline.apex_px + outline.near_px * u, outline.apex_px + outline.far_px * u, left ? kLeft : kRight, left ? -across : across);
    }
  }
  for (EdgePoint& point : points) measureEdge(evidence, reach_px, point);
  return points;
}

/// Tukey's biweight: (1 - (r / c)^2)^2 within c, c = 4.685 of the standard deviation as 1.4826 of the median says it.
double tukey(double residual, double scale) {
  const double share = residual / (4.685 * scale);
  return std::abs(share) < 1.0 ? (1.0 - share * share) * (1.0 - share * share) : 0.0;
}
double scaleOf(const std::vector<double>& residuals) {
  if (residuals.empty()) return 1.0;
  std::vector<double> sizes;
  for (const double r : residuals) sizes.push_back(std::abs(r));
  std::sort(sizes.begin(), sizes.end());
  return std::max(0.3, 1.4826 * sizes[sizes.size() / 2]);
}

std::optional<Line> fitLine(const std::vector<EdgePoint>& points, Side side, Line line) {
  std::vector<glm::dvec2> edges;
  for (const EdgePoint& point : points)
    if (point.seen && point.side == side) edges.push_back(point.edge());
  if (edges.size() < 8) return std::nullopt;
  for (int round = 0; round < 8; ++round) {
    std::vector<double> residuals;
    for (const glm::dvec2 p : edges) residuals.push_back(line.rightOf(p));
    const double scale = scaleOf(residuals);
    double weights = 0.0;
    glm::dvec2 middle(0.0);
    for (std::size_t n = 0; n < edges.size(); ++n) {
      const double w = tukey(residuals[n], scale);
      weights += w;
      middle += w * edges[n];
    }
    if (weights < 4.0) return std::nullopt;
    middle /= weights;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t n = 0; n < edges.size(); ++n) {
      const double w = tukey(residuals[n], scale);
      const glm::dvec2 d = edges[n] - middle;
      xx += w * d.x * d.x;
      xy += w * d.x * d.y;
      yy += w * d.y * d.y;
    }
    // The main axis of the weighted points, downwards.
    const double turn = 0.5 * std::atan2(2.0 * xy, xx - yy);
    glm::dvec2 along(std::cos(turn), std::sin(turn));
    if (glm::dot(along, down(line.angle_rad)) < 0.0) along = -along;
    line = {middle, std::atan2(along.x, along.y)};
  }
  return line;
}

Line lineOf(glm::dvec2 from, glm::dvec2 to) { return {from, std::atan2(to.x - from.x, to.y - from.y)}; }

bool refineLinear(FanOutline& outline, const std::vector<EdgePoint>& points) {
  std::array<Line, 4> lines;
  for (std::size_t n = 0; n < 4; ++n) {
    lines[n] = lineOf(outline.corners_px[n], outline.corners_px[(n + 1) % 4]);
    if (const auto fitted = fitLine(points, static_cast<Side>(n), lines[n])) lines[n] = *fitted;
  }
  FanOutline refined = outline;
  for (std::size_t n = 0; n < 4; ++n) {
    const auto corner = crossing(lines[(n + 3) % 4], lines[n]);
    if (!corner || glm::distance(*corner, outline.corners_px[n]) > 60.0) return false;
    refined.corners_px[n] = *corner;
  }
  outline = refined;
  return true;
}

/// Gauss-Newton on apex (x, y), both angles and both radii: distances of the edges from two lines through the apex and two circles about
/// it.
bool refineFan(FanOutline& fan, const std::vector<EdgePoint>& points) {
  using Vector = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  FanOutline now = fan;
  for (int round = 0; round < 15; ++round) {
    std::vector<double> residuals;
    std::vector<Vector> slopes;
    for (const EdgePoint& point : points) {
      if (!point.seen) continue;
      const glm::dvec2 d = point.edge() - now.apex_px;
      Vector slope = Vector::Zero();
      if (point.side == kLeft || point.side == kRight) {
        const double angle = point.side == kLeft ? now.left_rad : now.right_rad;
        residuals.push_back(cross(d, down(angle)));
        slope(0) = -std::cos(angle);
        slope(1) = std::sin(angle);
        slope(point.side == kLeft ? 2 : 3) = -glm::dot(d, down(angle));
      } else {
        const double length = std::max(1e-6, glm::length(d));
        residuals.push_back(length - (point.side == kNear ? now.near_px : now.far_px));
        slope(0) = -d.x / length;
        slope(1) = -d.y / length;
        slope(point.side == kNear ? 4 : 5) = -1.0;
      }
      slopes.push_back(slope);
    }
    if (slopes.size() < 30) return false;
    const double scale = scaleOf(residuals);
    Matrix normal = Matrix::Zero();
    Vector right = Vector::Zero();
    for (std::size_t n = 0; n < slopes.size(); ++n) {
      const double w = tukey(residuals[n], scale);
      normal += w * slopes[n] * slopes[n].transpose();
      right -= w * residuals[n] * slopes[n];
    }
    // What no point tells (the near arc of a phased array) stays as it is.
    for (int n = 0; n < 6; ++n) normal(n, n) += n == 2 || n == 3 ? 1.0 : 1e-2;
    const Vector step = normal.ldlt().solve(right);
    if (!step.allFinite()) return false;
    now.apex_px += glm::dvec2(step(0), step(1));
    now.left_rad += step(2);
    now.right_rad += step(3);
    now.near_px = std::max(0.0, now.near_px + step(4));
    now.far_px += step(5);
    if (step.norm() < 1e-6) break;
  }
  if (now.right_rad - now.left_rad < kParallel_rad || now.far_px <= now.near_px + 10.0 || now.right_rad - now.left_rad > 175.0 * kDegree)
    return false;
  fan = now;
  return true;
}

/// Of the outline borne out by edges, times the share of the mask inside; less for an outline around little of it or with a side
/// that nothing bears out.
double qualityOf(const FanOutline& outline, const Candidate& candidate) {
  const cv::Mat& mask = candidate.mask;
  const auto points = edgePoints(outline, candidate.evidence, 8.0);
  // The near edge is often still: it is the probe's own echo.
  constexpr std::array<double, 4> kWeights{0.5, 1.0, 1.0, 1.0};
  std::array<double, 4> seen{}, all{};
  for (const EdgePoint& point : points) {
    const auto side = static_cast<std::size_t>(point.side);
    all[side] += 1.0;
    seen[side] += point.seen && std::abs(point.offset_px) < kSupport_px ? 1.0 : 0.0;
  }
  double borne = 0.0, whole = 0.0, least = 1.0;
  for (std::size_t side = 0; side < 4; ++side) {
    borne += kWeights[side] * seen[side];
    whole += kWeights[side] * all[side];
    if (side > 0) least = std::min(least, seen[side] / std::max(all[side], 1.0));
  }
  const GreyImage inside = maskOf(outline, mask.cols, mask.rows);
  double both = 0.0, moving = 0.0, area = 0.0;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) {
      const bool in = viewOf(inside).row(y)[x] != 0, moves = mask.at<std::uint8_t>(y, x) != 0;
      both += in && moves ? 1.0 : 0.0;
      moving += moves ? 1.0 : 0.0;
      area += in ? 1.0 : 0.0;
    }
  if (whole < 1.0 || moving < 1.0 || area < kLeastArea * static_cast<double>(mask.total())) return 0.0;
  return borne / whole * (both / moving) * std::min(1.0, both / area / kLeastFilled) * std::min(1.0, least / kLeastSide);
}

std::optional<FanFit> refined(FanOutline outline, const Candidate& candidate) {
  for (const double reach_px : {14.0, 10.0, 7.0, 5.0, 5.0}) {
    const auto points = edgePoints(outline, candidate.evidence, reach_px);
    const bool moved = outline.shape == FanShape::linear ? refineLinear(outline, points) : refineFan(outline, points);
    if (!moved) break;
  }
  const auto bounds = outline.bounds_px();
  const glm::dvec2 size(candidate.mask.cols, candidate.mask.rows);
  if (glm::any(glm::lessThan(bounds[1], glm::dvec2(0.0))) || glm::any(glm::greaterThan(bounds[0], size))) return std::nullopt;
  return FanFit{outline, qualityOf(outline, candidate)};
}

std::optional<FanOutline> linearStart(const Silhouette& s, const Line& left, const Line& right) {
  const auto all = [&] {
    std::vector<glm::dvec2> points = s.left;
    for (const auto* more : {&s.right, &s.top, &s.bottom}) points.insert(points.end(), more->begin(), more->end());
    return points;
  }();
  // Across: turned by a quarter, so that "right of" is "above".
  const auto across = [&](const std::vector<glm::dvec2>& points, double inward) {
    std::vector<glm::dvec2> turned, rest;
    for (const glm::dvec2 p : points) turned.emplace_back(p.y, p.x);
    for (const glm::dvec2 p : all) rest.emplace_back(p.y, p.x);
    return bestLine(turned, rest, inward, -25.0 * kDegree, 25.0 * kDegree);
  };
  const auto top = across(s.top, 1.0), bottom = across(s.bottom, -1.0);
  if (!top || !bottom) return std::nullopt;
  const auto back = [](const Line& line) {
    const glm::dvec2 u = down(line.angle_rad);
    return lineOf({line.at.y, line.at.x}, {line.at.y + u.y, line.at.x + u.x});
  };
  const Line upper = back(*top), lower = back(*bottom);
  const auto ul = crossing(left, upper), ur = crossing(right, upper), lr = crossing(right, lower), ll = crossing(left, lower);
  if (!ul || !ur || !lr || !ll) return std::nullopt;
  if (ur->x < ul->x + 16.0 || lr->x < ll->x + 16.0 || ll->y < ul->y + 16.0 || lr->y < ur->y + 16.0) return std::nullopt;
  FanOutline outline;
  outline.corners_px = {*ul, *ur, *lr, *ll};
  return outline;
}

std::optional<FanOutline> fanStart(const Silhouette& s, const Line& left, const Line& right) {
  if (right.angle_rad - left.angle_rad < kParallel_rad) return std::nullopt;
  const auto apex = crossing(left, right);
  if (!apex) return std::nullopt;
  FanOutline fan;
  fan.shape = FanShape::convex;
  fan.apex_px = *apex;
  fan.left_rad = left.angle_rad;
  fan.right_rad = right.angle_rad;
  fan.far_px = bestRadius(s.bottom, fan, 1.0);
  fan.near_px = bestRadius(s.top, fan, -1.0);
  if (fan.far_px < fan.near_px + 16.0) return std::nullopt;
  return fan;
}

std::optional<FanFit> better(std::optional<FanFit> a, std::optional<FanFit> b) {
  if (!a) return b;
  return b && b->quality > a->quality ? b : a;
}

std::optional<FanFit> fitTo(const Candidate& candidate) {
  if (cv::countNonZero(candidate.mask) < kLeastArea * 0.5 * static_cast<double>(candidate.mask.total())) return std::nullopt;
  const Silhouette s = silhouetteOf(candidate.mask);
  const double middle = 0.5 * (s.lower.x + s.upper.x);
  std::vector<glm::dvec2> left = s.left, right = s.right, all;
  for (const auto* more : {&s.top, &s.bottom})
    for (const glm::dvec2 p : *more) (p.x < middle ? left : right).push_back(p);
  for (const auto* more : {&left, &right}) all.insert(all.end(), more->begin(), more->end());
  const auto leftLine = bestLine(left, all, 1.0, -85.0 * kDegree, 45.0 * kDegree);
  const auto rightLine = bestLine(right, all, -1.0, -45.0 * kDegree, 85.0 * kDegree);
  if (!leftLine || !rightLine) return std::nullopt;
  std::optional<FanFit> best;
  if (const auto start = fanStart(s, *leftLine, *rightLine)) best = refined(*start, candidate);
  if (const auto start = linearStart(s, *leftLine, *rightLine)) best = better(best, refined(*start, candidate));
  return best;
}

/// Of the sides and the far edge of an outline the share that edges bear out, where it is least, 0..1.
double leastEdgeSeen(const FanOutline& outline, const cv::Mat& evidence) {
  std::array<double, 4> seen{}, all{};
  for (const EdgePoint& point : edgePoints(outline, evidence, 8.0)) {
    const auto side = static_cast<std::size_t>(point.side);
    all[side] += 1.0;
    seen[side] += point.seen && std::abs(point.offset_px) < kSupport_px ? 1.0 : 0.0;
  }
  double least = 1.0;
  for (const Side side : {kRight, kFar, kLeft}) {
    const auto n = static_cast<std::size_t>(side);
    least = std::min(least, all[n] > 0.0 ? seen[n] / all[n] : 0.0);
  }
  return least;
}

/// Whether `larger` holds all of `fan`, and beyond it pixels of which a good part moves.
bool goesOnIn(const FanOutline& fan, const FanOutline& larger, const cv::Mat& moving) {
  constexpr double kHeld = 0.97, kLeastMore = 0.03, kLeastMoving = 0.25;
  const GreyImage had = maskOf(fan, moving.cols, moving.rows), has = maskOf(larger, moving.cols, moving.rows);
  double before = 0.0, held = 0.0, beyond = 0.0, moves = 0.0;
  for (int y = 0; y < moving.rows; ++y)
    for (int x = 0; x < moving.cols; ++x) {
      const bool was = viewOf(had).at(x, y) != 0, is = viewOf(has).at(x, y) != 0;
      before += was ? 1.0 : 0.0;
      held += was && is ? 1.0 : 0.0;
      if (was || !is) continue;
      beyond += 1.0;
      moves += moving.at<std::uint8_t>(y, x) != 0 ? 1.0 : 0.0;
    }
  return held >= kHeld * before && beyond >= kLeastMore * before && moves >= kLeastMoving * beyond;
}

using Fits = std::vector<std::pair<FanFit, const Candidate*>>;

/// The best outline that holds `best` and moves beyond it, too: a layer or a beam without echoes, or one that stands still, parts what
/// moves and not the scan.
std::optional<FanFit> beyondWhatParts(const FanFit& best, const Fits& fits, const cv::Mat& moving) {
  constexpr double kNearlyAsGood = 0.8, kLeastSeen = 0.5;
  std::optional<FanFit> larger;
  for (const auto& [fit, candidate] : fits)
    if (fit.quality >= kNearlyAsGood * best.quality && leastEdgeSeen(fit.outline, candidate->evidence) >= kLeastSeen &&
        goesOnIn(best.outline, fit.outline, moving))
      larger = better(larger, fit);
  return larger;
}

cv::Mat rooted(const cv::Mat& map) {
  cv::Mat root;
  cv::sqrt(cv::max(map, 0.0), root);
  return root;
}

}  // namespace

float backgroundOf(const ScreenStatistics& statistics) {
  const Image<float> mean = statistics.mean(), deviation = statistics.deviation();
  std::vector<std::size_t> counts(256, 0);
  for (std::size_t n = 0; n < mean.pixels.size(); ++n)
    if (deviation.pixels[n] < 1.0F) ++counts[static_cast<std::size_t>(std::clamp(mean.pixels[n] + 0.5F, 0.0F, 255.0F))];
  return static_cast<float>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

std::optional<FanFit> findFan(const ScreenStatistics& statistics) {
  const cv::Mat mean = matOf(statistics.mean());
  const cv::Mat above = mean - cv::Scalar(static_cast<double>(backgroundOf(statistics)));
  const cv::Mat bright = (above > 6.0) / 255;
  std::vector<Candidate> candidates;
  const auto add = [&](const cv::Mat& raw, const cv::Mat& evidence) {
    for (const bool largestAlone : {true, false}) candidates.push_back({cleaned(raw, largestAlone), evidence});
  };
  if (statistics.frames() >= 3) {
    const cv::Mat activity = matOf(statistics.activity()), deviation = matOf(statistics.deviation());
    const cv::Mat moving = rooted(deviation);
    for (const double least : {0.05, 0.2, 0.5}) add((activity > least) / 255, moving);
    const cv::Mat either = cv::max((activity > 0.1) / 255, bright);
    add(either, rooted(cv::max(deviation, above)));
  }
  add(bright, rooted(above));
  std::optional<FanFit> best;
  Fits fits;
  for (const Candidate& candidate : candidates)
    if (const auto fit = fitTo(candidate)) {
      fits.emplace_back(*fit, &candidate);
      best = better(best, fit);
    }
  if (best && statistics.frames() >= 3)
    if (const auto larger = beyondWhatParts(*best, fits, (matOf(statistics.activity()) > kMoves) / 255)) best = larger;
  if (best && best->outline.shape != FanShape::linear)
    best->outline.shape = best->outline.near_px < kSectorShare * best->outline.far_px ? FanShape::sector : FanShape::convex;
  return best;
}

}  // namespace ew::detail
