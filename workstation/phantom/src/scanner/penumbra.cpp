#include "scanner/penumbra.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scanner/beams.h"

namespace ew::phantom {
namespace {

constexpr int kRays = 21;
constexpr double kPedestal = 0.35;  // of a cosine: the width of a focus is kApodisedWidth then
constexpr double kEvery_mm = 0.7;   // along the lines; in between the difference to the line's own loss changes evenly

/// Distance between lines, which grows evenly with depth.
struct LineSpacing {
  double atFace_mm;
  double perMm;
};

class Rays {
 public:
  Rays(const ScannerSetup& setup, const std::vector<float>& lost_db, const std::vector<float>& reflection_db)
      : setup_(setup),
        lost_db_(lost_db),
        reflection_db_(reflection_db),
        lines_(static_cast<int>(setup.grid.lines.size())),
        last_(setup.steps - 1),
        spacing_{setup.grid.lineSpacing_mm(0.0), 0.0} {
    spacing_.perMm = (setup.grid.lineSpacing_mm(setup.fan.depth_mm) - spacing_.atFace_mm) / setup.fan.depth_mm;
  }

  /// Mean over the aperture of what one step of a line has left, dB.
  [[nodiscard]] double lostBy_db(int line, int step) const {
    const double depth_mm = step * setup_.step_mm, aperture_mm = std::min(setup_.probe.aperture_mm, depth_mm / kTransmitFNumber);
    double oneWay = 0.0, all = 0.0;
    for (int n = 0; n < kRays; ++n) {
      const double place = (n + 0.5) / kRays - 0.5, aside_mm = place * aperture_mm;
      if (!comesFromFace(line, aside_mm)) continue;
      const double weight = kPedestal + (1.0 - kPedestal) * std::cos(std::numbers::pi * place);
      oneWay += weight * std::pow(10.0, -0.025 * (alongRay_db(line, step, aside_mm) - lostAt(line, step)));
      all += weight;
    }
    return lostAt(line, step) - 40.0 * std::log10(std::max(oneWay / all, 1e-30));
  }

 private:
  [[nodiscard]] std::size_t indexOf(int line, int step) const {
    return static_cast<std::size_t>(line) * static_cast<std::size_t>(setup_.steps) + static_cast<std::size_t>(step);
  }
  [[nodiscard]] double lostAt(int line, int step) const { return static_cast<double>(lost_db_[indexOf(line, step)]); }
  [[nodiscard]] double reflectionAt(int line, int step) const { return static_cast<double>(reflection_db_[indexOf(line, step)]); }

  /// Where lines start closer together than the aperture is wide, it reaches beyond them.
  [[nodiscard]] bool comesFromFace(int line, double aside_mm) const {
    if ((lines_ - 1) * spacing_.atFace_mm < setup_.probe.aperture_mm) return true;
    const double at = line + aside_mm / spacing_.atFace_mm;
    return at > -0.5 && at < lines_ - 0.5;
  }

  /// Line by line, from the aperture to the place: on each the ray stays until it is nearer to the next.
  [[nodiscard]] double alongRay_db(int line, int step, double aside_mm) const {
    const int side = aside_mm < 0.0 ? -1 : 1, most = side < 0 ? line : lines_ - 1 - line;
    const double depth_mm = step * setup_.step_mm, offset_mm = std::abs(aside_mm);
    // offset (1 - d / depth) = c (atFace + perMm d)
    const auto crossing = [&](int away) {
      const double c = away - 0.5, d_mm = (offset_mm - c * spacing_.atFace_mm) / (offset_mm / depth_mm + c * spacing_.perMm);
      return std::clamp(static_cast<int>(std::lround(d_mm / setup_.step_mm)), 0, last_);
    };
    double sum_db = 0.0;
    int from = 0;
    for (int away = std::min(most, static_cast<int>(std::ceil(offset_mm / std::max(spacing_.atFace_mm, 1e-3)))); away > 0; --away) {
      const int to = std::min(crossing(away), step);
      if (to <= from) continue;
      const int own = line + side * away;
      sum_db += lostAt(own, to) - lostAt(own, from) + std::max(0.0, reflectionAt(own - side, to) - reflectionAt(own, to));
      from = to;
    }
    return sum_db + lostAt(line, step) - lostAt(line, from);
  }

  const ScannerSetup& setup_;
  const std::vector<float>& lost_db_;
  const std::vector<float>& reflection_db_;
  int lines_, last_;
  LineSpacing spacing_;
};

}  // namespace

void seenFromAperture(const ScannerSetup& setup, const std::vector<float>& lost_db, const std::vector<float>& reflection_db,
                      std::vector<float>& gain) {
  const Rays rays(setup, lost_db, reflection_db);
  const int lines = static_cast<int>(setup.grid.lines.size()), every = std::max(1, static_cast<int>(kEvery_mm / setup.step_mm));
  gain.resize(lost_db.size());
  for (int line = 0; line < lines; ++line) {
    const auto first = static_cast<std::size_t>(line) * static_cast<std::size_t>(setup.steps);
    double before_db = 0.0;
    for (int step = 0; step < setup.steps; step += every) {
      const int next = std::min(step + every, setup.steps - 1);
      const double after_db = rays.lostBy_db(line, next) - static_cast<double>(lost_db[first + static_cast<std::size_t>(next)]);
      for (int s = step; s <= next; ++s) {
        const double share = next > step ? static_cast<double>(s - step) / (next - step) : 1.0;
        const auto at = first + static_cast<std::size_t>(s);
        gain[at] = static_cast<float>(factorOf(static_cast<double>(lost_db[at]) + before_db + share * (after_db - before_db)));
      }
      before_db = after_db;
    }
  }
}

}  // namespace ew::phantom
