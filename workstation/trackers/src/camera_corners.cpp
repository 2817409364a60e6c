#include "camera_corners.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ew/core/order_statistics.h"

namespace ew {
namespace {

constexpr double kProfileStep_px = 0.5;
constexpr double kLeastContrast = 4.0;  // light between black and white, below which noise decides where an edge is; of 255
constexpr double kFarthest_px = 7.0;    // that a side is looked for from where the detector says

/// An image, and the light its greys stand for.
struct LitImage {
  ImageView<const std::uint8_t> grey;
  const std::array<float, 256>& light;

  [[nodiscard]] bool has(const glm::dvec2& p_px) const {
    return p_px.x >= 0.0 && p_px.y >= 0.0 && p_px.x < grey.width - 1 && p_px.y < grey.height - 1;
  }
  /// Between the centres of four pixels of the image.
  [[nodiscard]] double at(const glm::dvec2& p_px) const {
    const int x = static_cast<int>(p_px.x), y = static_cast<int>(p_px.y);
    const auto fx = static_cast<float>(p_px.x - x), fy = static_cast<float>(p_px.y - y);
    const std::uint8_t* const above = grey.data + y * grey.stride + x;
    const std::uint8_t* const below = above + grey.stride;
    const float upper = light[above[0]] + fx * (light[above[1]] - light[above[0]]);
    const float lower = light[below[0]] + fx * (light[below[1]] - light[below[0]]);
    return static_cast<double>(upper + fy * (lower - upper));
  }
};

struct EdgePoint {
  double along_px = 0.0;  ///< across the side, from where it was looked for, outwards
  double spread_px = 0.0;
};

/// A profile across a side, from dark inside to light outside.
class EdgeProfile {
 public:
  /// False where it leaves the image.
  bool read(const LitImage& image, const glm::dvec2& middle, const glm::dvec2& outward, double half_px) {
    const int half = std::min(kMost, static_cast<int>(std::lround(half_px / kProfileStep_px)));
    count_ = 2 * half + 1;
    start_px_ = -half * kProfileStep_px;
    if (!image.has(middle + start_px_ * outward) || !image.has(middle - start_px_ * outward)) return false;
    for (int n = 0; n < count_; ++n) values_[static_cast<std::size_t>(n)] = image.at(middle + (start_px_ + n * kProfileStep_px) * outward);
    return true;
  }
  /// Where it rises most over a pixel.
  [[nodiscard]] std::optional<EdgePoint> steepest() const {
    constexpr int kSpan = 2;
    double most = kLeastContrast;
    int at = -1;
    for (int n = kSpan; n + kSpan < count_; ++n) {
      const double rise = value(n + kSpan) - value(n - kSpan);
      if (rise > most) {
        most = rise;
        at = n;
      }
    }
    if (at < 0) return {};
    return EdgePoint{start_px_ + at * kProfileStep_px, 0.0};
  }
  /// Where a sharp step between its ends would have to be for the same area under it.
  [[nodiscard]] std::optional<EdgePoint> halfWay() const {
    const double dark = 0.5 * (value(0) + value(1)), light = 0.5 * (value(count_ - 1) + value(count_ - 2));
    if (light - dark < kLeastContrast) return {};
    double missing = 0.0;  // of the light level, over the whole profile: trapezoids
    for (int n = 0; n < count_; ++n) missing += (n == 0 || n == count_ - 1 ? 0.5 : 1.0) * (light - value(n));
    EdgePoint found;
    found.along_px = start_px_ + missing * kProfileStep_px / (light - dark);
    if (std::abs(found.along_px) > -start_px_) return {};
    double moment = 0.0, weight = 0.0;
    for (int n = 0; n + 1 < count_; ++n) {
      const double rise = value(n + 1) - value(n), at = start_px_ + (n + 0.5) * kProfileStep_px - found.along_px;
      moment += rise * at * at;
      weight += rise;
    }
    found.spread_px = weight > 0.0 ? std::sqrt(std::max(0.0, moment / weight)) : 0.0;
    return found;
  }

 private:
  [[nodiscard]] double value(int n) const { return values_[static_cast<std::size_t>(n)]; }
  static constexpr int kMost = 20;
  std::array<double, 2 * kMost + 1> values_{};
  int count_ = 0;
  double start_px_ = 0.0;
};

/// dot(normal, p) = distance
struct SideLine {
  glm::dvec2 normal{0.0};
  double distance = 0.0;
  double rms = 0.0;
  double points = 0.0;  ///< sum of weights
};

/// Total least squares with Tukey's weights. @param scale below which a point cannot be told from one on the line
std::optional<SideLine> lineThrough(const std::vector<glm::dvec2>& points, double scale) {
  std::vector<double> weights(points.size(), 1.0), off(points.size());
  SideLine line;
  for (int round = 0; round < 6; ++round) {
    double total = 0.0;
    glm::dvec2 middle(0.0);
    for (std::size_t n = 0; n < points.size(); ++n) {
      total += weights[n];
      middle += weights[n] * points[n];
    }
    if (total < 4.0) return {};
    middle /= total;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t n = 0; n < points.size(); ++n) {
      const glm::dvec2 d = points[n] - middle;
      xx += weights[n] * d.x * d.x;
      xy += weights[n] * d.x * d.y;
      yy += weights[n] * d.y * d.y;
    }
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);  // of the line
    line.normal = {-std::sin(angle), std::cos(angle)};
    line.distance = glm::dot(line.normal, middle);
    line.points = total;
    double squares = 0.0;
    for (std::size_t n = 0; n < points.size(); ++n) {
      off[n] = std::abs(glm::dot(line.normal, points[n]) - line.distance);
      squares += weights[n] * off[n] * off[n];
    }
    line.rms = std::sqrt(squares / total);
    const double reach = 4.685 * std::max(scale, 1.4826 * upperMedianOf(off));
    for (std::size_t n = 0; n < points.size(); ++n) {
      const double u = off[n] / reach;
      weights[n] = u < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
    }
  }
  return line;
}

std::optional<glm::dvec2> meeting(const SideLine& a, const SideLine& b) {
  const double across = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
  if (std::abs(across) < 0.05) return {};
  return glm::dvec2{a.distance * b.normal.y - b.distance * a.normal.y, b.distance * a.normal.x - a.distance * b.normal.x} / across;
}

struct MarkerSide {
  glm::dvec2 from{0.0}, along{0.0}, outward{0.0};
  double length_px = 0.0;
};
MarkerSide sideBetween(const glm::dvec2& a, const glm::dvec2& b) {
  MarkerSide side;
  side.length_px = glm::distance(a, b);
  side.from = a;
  side.along = (b - a) / side.length_px;
  side.outward = {side.along.y, -side.along.x};  // corners run clockwise in an image whose y goes down
  return side;
}

/// The side as the image roughly has it.
std::optional<MarkerSide> nearerSide(const LitImage& image, const MarkerSide& side, double cell_px) {
  std::vector<glm::dvec2> points;
  EdgeProfile profile;
  constexpr int kSamples = 14;
  for (int n = 0; n < kSamples; ++n) {
    const glm::dvec2 middle = side.from + (0.1 + 0.8 * n / (kSamples - 1)) * side.length_px * side.along;
    if (!profile.read(image, middle, side.outward, std::clamp(0.9 * cell_px, 2.5, kFarthest_px))) continue;
    if (const auto at = profile.steepest()) points.push_back(middle + at->along_px * side.outward);
  }
  if (points.size() < kSamples / 2) return {};
  const auto line = lineThrough(points, 0.35);
  if (!line || line->points < 0.35 * kSamples) return {};
  const auto onLine = [&](const glm::dvec2& p) { return p + (line->distance - glm::dot(line->normal, p)) * line->normal; };
  return sideBetween(onLine(side.from), onLine(side.from + side.length_px * side.along));
}

/// The lens turns no direction by more than a few degrees, so outwards in the image is outwards among the rays.
double outwardSign(const SideLine& line, const glm::dvec2& outward) { return glm::dot(line.normal, outward) > 0.0 ? 1.0 : -1.0; }

struct SideFit {
  SideLine line;  ///< of rays
  glm::dvec2 outward{0.0};
  double spread_px = 0.0;
};

std::optional<SideFit> measuredSide(const LitImage& image, const CameraModel& model, const MarkerSide& side, double cell_px) {
  const int samples = std::clamp(static_cast<int>(0.6 * side.length_px), 12, 28);
  const double margin = std::clamp(2.5 / side.length_px, 0.06, 0.2);  // where the blurred corner begins
  std::vector<glm::dvec2> rays;
  double spread = 0.0;
  EdgeProfile profile;
  for (int n = 0; n < samples; ++n) {
    glm::dvec2 middle = side.from + (margin + (1.0 - 2.0 * margin) * n / (samples - 1)) * side.length_px * side.along;
    std::optional<EdgePoint> at;
    // Ends alike on both sides of the edge cut off alike from a blurred one; so the profile is centred on what was found.
    for (int round = 0; round < 3; ++round) {
      if (!profile.read(image, middle, side.outward, std::clamp(0.55 * cell_px, 1.5, 4.0))) {
        at.reset();
        break;
      }
      at = profile.halfWay();
      if (!at) break;
      middle += at->along_px * side.outward;
      if (std::abs(at->along_px) < 0.06) break;
    }
    if (!at || std::abs(at->along_px) > 0.25) continue;
    rays.push_back(rayThrough(model, middle));
    spread += at->spread_px;
  }
  if (static_cast<int>(rays.size()) * 2 < samples) return {};
  const auto line = lineThrough(rays, 0.05 / model.fx);
  if (!line || line->points < 0.4 * samples) return {};
  return SideFit{*line, side.outward, spread / static_cast<double>(rays.size())};
}

}  // namespace

std::optional<MarkerCorners> cornersByEdges(ImageView<const std::uint8_t> grey, const CameraModel& model,
                                            const std::array<glm::dvec2, 4>& about, int cells, const std::array<float, 256>& light) {
  const LitImage image{grey, light};
  std::array<MarkerSide, 4> sides;
  for (std::size_t n = 0; n < 4; ++n) {
    sides[n] = sideBetween(about[n], about[(n + 1) % 4]);
    if (!(sides[n].length_px > 4.0)) return {};
  }
  // A profile across a side runs along its neighbours.
  const auto cellAcross_px = [&](std::size_t n) { return std::min(sides[(n + 1) % 4].length_px, sides[(n + 3) % 4].length_px) / cells; };
  std::array<SideFit, 4> measured;
  MarkerCorners found;
  for (std::size_t n = 0; n < 4; ++n) {
    const auto nearer = nearerSide(image, sides[n], cellAcross_px(n));
    if (!nearer) return {};
    const auto side = measuredSide(image, model, *nearer, cellAcross_px(n));
    if (!side) return {};
    measured[n] = *side;
    found.across[n] = side->outward;
    found.edgeSpread_px[n] = side->spread_px;
  }
  const double focal = 0.5 * (model.fx + model.fy);
  double variance = 0.0;
  for (std::size_t n = 0; n < 4; ++n) {
    const auto corner = meeting(measured[(n + 3) % 4].line, measured[n].line);
    if (!corner) return {};
    found.rays[n] = *corner;
    // Lines move along their outward normals; where they meet moves in proportion.
    SideLine before = measured[(n + 3) % 4].line, after = measured[n].line;
    before.distance += outwardSign(before, found.across[(n + 3) % 4]) * found.edgeSpread_px[(n + 3) % 4] / focal;
    after.distance += outwardSign(after, found.across[n]) * found.edgeSpread_px[n] / focal;
    found.perBleed[n] = meeting(before, after).value_or(*corner) - *corner;
    found.corners_px[n] = pixelOf(model, glm::dvec3(*corner, 1.0));
    if (glm::distance(found.corners_px[n], about[n]) > kFarthest_px + 4.0) return {};
    // At its end a line is twice as uncertain as in its middle; two of them make a corner.
    variance += 0.25 * 2.0 * 4.0 * std::pow(focal * measured[n].line.rms, 2) / measured[n].line.points;
  }
  found.spread_px = std::sqrt(variance);
  return found;
}

std::array<float, 256> lightOfGreys(double gamma) {
  std::array<float, 256> light{};
  for (std::size_t n = 0; n < light.size(); ++n) light[n] = static_cast<float>(255.0 * std::pow(static_cast<double>(n) / 255.0, gamma));
  return light;
}

MarkerCorners cornersAsGiven(const CameraModel& model, const std::array<glm::dvec2, 4>& corners_px) {
  MarkerCorners given;
  given.corners_px = corners_px;
  for (std::size_t n = 0; n < 4; ++n) given.rays[n] = rayThrough(model, corners_px[n]);
  return given;
}

}  // namespace ew
