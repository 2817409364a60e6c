#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "edge_profile.h"
#include "ew/core/contract.h"

namespace ew::measurement {
namespace {

/// Grey at a place between pixels, or nothing outside.
std::optional<double> greyAt(ImageView<const std::uint8_t> image, const glm::dvec2& p) {
  if (!(p.x >= 0.0 && p.y >= 0.0 && p.x <= image.width - 1 && p.y <= image.height - 1)) return std::nullopt;
  const int x = std::min(static_cast<int>(p.x), image.width - 2), y = std::min(static_cast<int>(p.y), image.height - 2);
  if (x < 0 || y < 0) return std::nullopt;
  const double u = p.x - x, v = p.y - y;
  const std::uint8_t *upper = image.row(y) + x, *lower = image.row(y + 1) + x;
  return (1.0 - v) * ((1.0 - u) * upper[0] + u * upper[1]) + v * ((1.0 - u) * lower[0] + u * lower[1]);
}

}  // namespace

std::vector<double> profileThrough(ImageView<const std::uint8_t> image, const ImageGeometry& geometry, const glm::dvec2& p,
                                   const glm::dvec2& along, int half, double step_mm, double across_mm) {
  const glm::dvec2 across(-along.y, along.x);
  const int lines = static_cast<int>(std::ceil(across_mm / step_mm));
  std::vector<double> profile;
  for (int n = -half; n <= half; ++n) {
    double sum = 0.0;
    int count = 0;
    for (int m = -lines; m <= lines; ++m)
      if (const auto grey =
              greyAt(image, geometry.toPixel(p + step_mm * (static_cast<double>(n) * along + static_cast<double>(m) * across)))) {
        sum += *grey;
        ++count;
      }
    profile.push_back(count > lines ? sum / count : std::nan(""));
  }
  return profile;
}

std::vector<double> slopesOf(const std::vector<double>& profile, double step_mm, double blur_mm) {
  const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * blur_mm / step_mm)));
  std::vector<double> weights;
  double moment = 0.0;
  for (int n = -reach; n <= reach; ++n) {
    const double x = n * step_mm, weight = x * std::exp(-0.5 * x * x / (blur_mm * blur_mm));
    weights.push_back(weight);
    moment += weight * x;  // so that a ramp keeps its slope
  }
  const int count = static_cast<int>(profile.size());
  std::vector<double> slopes(profile.size(), 0.0);
  for (int n = reach; n + reach < count; ++n) {
    double sum = 0.0;
    for (int m = -reach; m <= reach; ++m) sum += weights[static_cast<std::size_t>(m + reach)] * profile[static_cast<std::size_t>(n + m)];
    slopes[static_cast<std::size_t>(n)] = std::isnan(sum) ? 0.0 : sum / moment;
  }
  return slopes;
}

Snapped snapToEdge(ImageView<const std::uint8_t> image, const ImageGeometry& geometry, glm::dvec2 p_mm, glm::dvec2 direction,
                   const SnapOptions& options) {
  EW_EXPECTS(geometry.pixel_mm.x > 0.0 && geometry.pixel_mm.y > 0.0 && options.blur_mm > 0.0 && options.reach_mm > 0.0);
  Snapped snapped{false, p_mm, 0.0, 0.0, EdgeSide::any};
  const double length = glm::length(direction);
  if (!(length > 0.0)) return snapped;
  const glm::dvec2 along = direction / length;
  const double step_mm = 0.5 * std::min({geometry.pixel_mm.x, geometry.pixel_mm.y, options.blur_mm});
  const int reach = static_cast<int>(std::ceil(options.reach_mm / step_mm));
  const int half = reach + static_cast<int>(std::ceil(3.0 * options.blur_mm / step_mm)) + 1;
  const auto slopes = slopesOf(profileThrough(image, geometry, p_mm, along, half, step_mm, options.across_mm), step_mm, options.blur_mm);
  const auto height = [&](int n) {
    const double slope = slopes[static_cast<std::size_t>(n + half)];
    return options.side == EdgeSide::any ? std::abs(slope) : options.side == EdgeSide::darkToBright ? slope : -slope;
  };
  int best = -reach;
  for (int n = -reach; n <= reach; ++n)
    if (height(n) > height(best)) best = n;
  if (!(height(best) >= options.weakest)) return snapped;
  const double before = height(best - 1), here = height(best), after = height(best + 1), bend = before - 2.0 * here + after;
  const double shift = bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
  snapped.isFound = true;
  snapped.moved_mm = (best + shift) * step_mm;
  snapped.at_mm = p_mm + snapped.moved_mm * along;
  snapped.strength = here - 0.25 * (before - after) * shift;
  snapped.side = slopes[static_cast<std::size_t>(best + half)] > 0.0 ? EdgeSide::darkToBright : EdgeSide::brightToDark;
  return snapped;
}

}  // namespace ew::measurement
