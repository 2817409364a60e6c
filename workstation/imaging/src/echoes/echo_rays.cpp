#include "echo_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

double apodisation(double place) { return 0.35 + 0.65 * std::cos(std::numbers::pi * std::clamp(place, -0.5, 0.5)); }

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
  endsWithFace_ = (lines_ - 1) * atFace_mm > 0.9 * probe.aperture_mm;
  rays_.assign(kRays, {});
  padding_ = 0;
  for (int n = 0; n < kRays; ++n) {
    Ray& ray = rays_[static_cast<std::size_t>(n)];
    const double q = (2 * n + 1 - kRays) * halfCell;
    double aside = 0.0;
    for (int s = 0; s < steps; ++s) {
      const double z_mm = s * step_mm, middle_mm = z_mm - 0.5 * step_mm;
      if (s > 0) aside += step_mm * spacing.slopeOf(q, middle_mm) / std::max(spacing.at(middle_mm), 1e-3);
      ray.line.push_back(static_cast<int>(std::lround(std::clamp<double>(aside, -lines_, lines_))));
      const double own = s > 0 ? shareWithin(outermost[static_cast<std::size_t>(s)], q, halfCell) : 1.0;
      const double place = spacing.slopeOf(q, z_mm) * z_mm / std::max(std::min(probe.aperture_mm, z_mm / kWidestFNumber), 1e-3);
      ray.weight.push_back(static_cast<float>(own * apodisation(place)));
      if (own > 0.0) ray.lastStep = s;
    }
    for (int s = 0; s <= ray.lastStep; ++s) {
      ray.before = std::max(ray.before, ray.line[static_cast<std::size_t>(s)]);
      ray.after = std::max(ray.after, -ray.line[static_cast<std::size_t>(s)]);
    }
    padding_ = std::max({padding_, ray.before, ray.after});
  }
  share_.assign(static_cast<std::size_t>(steps) * static_cast<std::size_t>(lines_), 0.0F);
  for (const Ray& ray : rays_)
    for (int s = 0; s <= ray.lastStep; ++s)
      for (int line = 0; line < lines_; ++line)
        if (comesFromFace(line - ray.line[static_cast<std::size_t>(s)]))
          share_[indexOf(s, line)] += ray.weight[static_cast<std::size_t>(s)];
  for (float& share : share_) share = 1.0F / share;
}

void EchoRays::begin(Scratch& scratch) const {
  const auto width = static_cast<std::size_t>(lines_ + 2 * padding_);
  scratch.left.assign(width * rays_.size(), 1.0F);
  if (endsWithFace_)
    for (std::size_t ray = 0; ray < rays_.size(); ++ray) {
      std::fill_n(scratch.left.data() + ray * width, padding_, 0.0F);
      std::fill_n(scratch.left.data() + (ray + 1) * width - padding_, padding_, 0.0F);
    }
  for (std::vector<float>& kept : scratch.kept) kept.resize(width);
  scratch.loss.resize(static_cast<std::size_t>(lines_));
  scratch.sum.resize(static_cast<std::size_t>(lines_) + 2);
}

const float* EchoRays::keep(const float* loss_log2, std::vector<float>& kept) const {
  float* first = kept.data() + padding_;
  keptOf(loss_log2, lines_, first);
  // Beyond the outermost lines it goes on as there.
  std::fill_n(kept.data(), padding_, first[0]);
  std::fill_n(first + lines_, padding_, first[lines_ - 1]);
  return first;
}

void EchoRays::pass(int step, const Step& met, float most, float weight, Scratch& scratch, float* gain) const {
  const float* onLine = keep(met.loss, scratch.kept[0]);
  std::array<const float*, 3> kept{onLine, onLine, onLine};
  const float* reflection = met.reflectionBefore;
  if (std::any_of(reflection, reflection + lines_, [&](float r) { return r != reflection[0]; }))
    for (const int side : {1, 2}) {
      for (int line = 0; line < lines_; ++line) {
        const int from = std::clamp(line + (side == 1 ? -1 : 1), 0, lines_ - 1);
        scratch.loss[static_cast<std::size_t>(line)] = met.loss[line] + std::max(0.0F, reflection[line] - reflection[from]);
      }
      kept[static_cast<std::size_t>(side)] = keep(scratch.loss.data(), scratch.kept[static_cast<std::size_t>(side)]);
    }
  float* sum = scratch.sum.data() + 1;
  std::fill_n(sum, lines_, 0.0F);
  float* left = scratch.left.data() + padding_;
  for (const Ray& ray : rays_) {
    if (step <= ray.lastStep) {
      const int aside = ray.line[static_cast<std::size_t>(step)], before = ray.line[static_cast<std::size_t>(std::max(step - 1, 0))];
      // Those that have left the fan do not come back.
      const int first = aside > 0 ? -ray.before : -aside, last = aside > 0 ? lines_ - aside : lines_ + ray.after;
      passRay(kept[aside > before ? 1 : aside < before ? 2 : 0] + first + aside, most, last - first, left + first);
      addWeighted(left - aside, ray.weight[static_cast<std::size_t>(step)], lines_, sum);
    }
    left += lines_ + 2 * padding_;
  }
  const float* share = share_.data() + indexOf(step, 0);
  for (int line = 0; line < lines_; ++line) sum[line] *= share[line];
  sum[-1] = sum[0];
  sum[lines_] = sum[lines_ - 1];
  addSquares(sum, weight, lines_, gain);
}

}  // namespace ew::detail
