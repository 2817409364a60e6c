#include "echo_rays.h"

#include <algorithm>
#include <cmath>

#include "line_kernels.h"

namespace ew::detail {
namespace {

constexpr int kRays = 17;
constexpr double kWidestFNumber = 2.0;
constexpr double kSteepest = 1.5;  // slope against a line, where lines meet

/// Distance between neighbouring lines, which grows evenly with depth.
struct LineSpacing {
  double atFace_mm;
  double perMm;
  [[nodiscard]] double at(double depth_mm) const { return atFace_mm + perMm * depth_mm; }
  [[nodiscard]] bool isFan() const { return perMm > 1e-6; }
  /// From where lines meet.
  [[nodiscard]] double radius_mm(double depth_mm) const { return at(depth_mm) / perMm; }
  [[nodiscard]] double slopeOf(double ray, double depth_mm) const {
    if (!isFan()) return ray;
    const double radius = radius_mm(depth_mm), square = radius * radius - ray * ray;
    return std::clamp(square > 0.0 ? ray / std::sqrt(square) : std::copysign(kSteepest, ray), -kSteepest, kSteepest);
  }
  [[nodiscard]] double rayOf(double slope, double depth_mm) const {
    return isFan() ? radius_mm(depth_mm) * slope / std::sqrt(1.0 + slope * slope) : slope;
  }
};

/// How much of the cell around a ray is not farther than `most` from 0.
double shareWithin(double most, double ray, double halfCell) {
  return std::clamp((std::min(most, std::abs(ray) + halfCell) - (std::abs(ray) - halfCell)) / (2.0 * halfCell), 0.0, 1.0);
}

}  // namespace

void EchoRays::configure(const EchoLayout& layout, const Probe& probe, int steps, double step_mm) {
  lines_ = static_cast<int>(layout.grid.lines.size());
  const double depth_mm = (steps - 1) * step_mm, atFace_mm = layout.grid.lineSpacing_mm(0.0);
  const LineSpacing spacing{atFace_mm, (layout.grid.lineSpacing_mm(depth_mm) - atFace_mm) / depth_mm};
  std::vector<double> outermost(static_cast<std::size_t>(steps));  // ray, by step
  for (int s = 1; s < steps; ++s) {
    const double z_mm = s * step_mm;
    outermost[static_cast<std::size_t>(s)] = spacing.rayOf(0.5 * std::min(probe.aperture_mm / z_mm, 1.0 / kWidestFNumber), z_mm);
  }
  const double halfCell = *std::max_element(outermost.begin(), outermost.end()) / kRays;
  rays_.assign(kRays, {});
  padding_ = 0;
  for (int n = 0; n < kRays; ++n) {
    Ray& ray = rays_[static_cast<std::size_t>(n)];
    const double q = (2 * n + 1 - kRays) * halfCell;
    double aside = 0.0;
    for (int s = 0; s < steps; ++s) {
      const double middle_mm = (s - 0.5) * step_mm;
      if (s > 0) aside += step_mm * spacing.slopeOf(q, middle_mm) / std::max(spacing.at(middle_mm), 1e-3);
      ray.line.push_back(static_cast<int>(std::lround(std::clamp<double>(aside, -lines_, lines_))));
      double all = 0.0;
      for (int other = 0; other < kRays; ++other)
        all += shareWithin(outermost[static_cast<std::size_t>(s)], (2 * other + 1 - kRays) * halfCell, halfCell);
      const double own = shareWithin(outermost[static_cast<std::size_t>(s)], q, halfCell);
      ray.weight.push_back(static_cast<float>(s > 0 ? own / all : 1.0 / kRays));
      if (own > 0.0 || s == 0) ray.lastStep = s;
    }
    for (int s = 0; s <= ray.lastStep; ++s) {
      ray.before = std::max(ray.before, ray.line[static_cast<std::size_t>(s)]);
      ray.after = std::max(ray.after, -ray.line[static_cast<std::size_t>(s)]);
    }
    padding_ = std::max({padding_, ray.before, ray.after});
  }
}

void EchoRays::begin(Scratch& scratch) const {
  const auto width = static_cast<std::size_t>(lines_ + 2 * padding_);
  scratch.left.assign(width * rays_.size(), 1.0F);
  scratch.kept.resize(width);
  scratch.sum.resize(static_cast<std::size_t>(lines_) + 2);
}

void EchoRays::pass(int step, const float* loss_log2, float most, float weight, Scratch& scratch, float* gain) const {
  float* kept = scratch.kept.data() + padding_;
  keptOf(loss_log2, lines_, kept);
  // Beyond the outermost lines it goes on as there.
  std::fill_n(kept - padding_, padding_, kept[0]);
  std::fill_n(kept + lines_, padding_, kept[lines_ - 1]);
  float* sum = scratch.sum.data() + 1;
  std::fill_n(sum, lines_, 0.0F);
  float* left = scratch.left.data() + padding_;
  for (const Ray& ray : rays_) {
    if (step <= ray.lastStep) {
      const int aside = ray.line[static_cast<std::size_t>(step)];
      // Those that have left the fan do not come back.
      const int first = aside > 0 ? -ray.before : -aside, last = aside > 0 ? lines_ - aside : lines_ + ray.after;
      passRay(kept + first + aside, most, last - first, left + first);
      addWeighted(left - aside, ray.weight[static_cast<std::size_t>(step)], lines_, sum);
    }
    left += lines_ + 2 * padding_;
  }
  sum[-1] = sum[0];
  sum[lines_] = sum[lines_ - 1];
  addSquares(sum, weight, lines_, gain);
}

}  // namespace ew::detail
