#include "ew/imaging/effects/gain.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {

using Sliders = std::array<double, kDgcSliders>;

/// Slopes at the sliders per slider distance.
Sliders slopesOf(const Sliders& sliders) {
  Sliders slope{};
  for (std::size_t k = 1; k + 1 < sliders.size(); ++k) {
    const double before = sliders[k] - sliders[k - 1];
    const double after = sliders[k + 1] - sliders[k];
    slope[k] = before * after > 0.0 ? 0.5 * (before + after) : 0.0;
  }
  // Fritsch & Carlson, section 4: slopes inside the circle of radius three secants keep each interval monotone.
  for (std::size_t k = 0; k + 1 < sliders.size(); ++k) {
    const double secant = sliders[k + 1] - sliders[k];
    if (secant == 0.0) {
      slope[k] = slope[k + 1] = 0.0;
      continue;
    }
    const double length = std::hypot(slope[k] / secant, slope[k + 1] / secant);
    if (length > 3.0) {
      slope[k] *= 3.0 / length;
      slope[k + 1] *= 3.0 / length;
    }
  }
  return slope;
}

double curveAt(const Sliders& sliders, const Sliders& slope, double position) {
  const double t = position * kDgcSliders - 0.5;
  if (!(t > 0.0)) return sliders.front();
  if (t >= kDgcSliders - 1.0) return sliders.back();
  const auto k = static_cast<std::size_t>(t);
  const double s = t - static_cast<double>(k);
  const double r = 1.0 - s;
  const double value =
      (1.0 + 2.0 * s) * r * r * sliders[k] + s * r * r * slope[k] + s * s * (3.0 - 2.0 * s) * sliders[k + 1] - s * s * r * slope[k + 1];
  // In exact arithmetic the curve is inside; this keeps the last bit inside as well.
  const auto [low, high] = std::minmax(sliders[k], sliders[k + 1]);
  return std::clamp(value, low, high);
}

// NaN compares false. A thousand already makes every level above 0 white, and infinity times 0 is not a number.
double usableFactor(double factor) { return factor > 0.0 ? std::min(factor, 1e9) : 0.0; }

double usableRange_db(double range_db, double otherwise_db) { return std::clamp(range_db > 0.0 ? range_db : otherwise_db, 20.0, 120.0); }

/// 255 f(x) of shownLevel with its numbers worked out: f = first x + second x^2 + third x^3.
struct ToneCurve {
  double recordedOverShown = 1.0;
  double first = 1.0, second = 0.0, third = 0.0;

  explicit ToneCurve(const Tone& tone) {
    const double recorded_db = usableRange_db(tone.recordedDynamicRange_db, 60.0);
    recordedOverShown = recorded_db / usableRange_db(tone.dynamicRange_db, recorded_db);
    if (tone.map == GreyMap::soft) first = 2.0, second = -3.0, third = 2.0;
    if (tone.map == GreyMap::contrast) first = 0.0, second = 3.0, third = -2.0;
    if (tone.map == GreyMap::bright) first = 1.7, second = -0.7;
  }
  [[nodiscard]] bool isIdentity() const { return recordedOverShown == 1.0 && first == 1.0; }
  [[nodiscard]] double at(double level) const {
    const double x = std::max(1.0 - (255.0 - level) * (recordedOverShown / 255.0), 0.0);
    return 255.0 * x * (first + x * (second + x * third));
  }
};

/// Eq. 5 row by row, with `show` between its last MIN and the rounding.
template <class Show>
void fillGainTable(double gain, const Sliders& dgc, std::span<const double> rowPosition, const Show& show,
                   std::vector<std::uint8_t>& table) {
  Sliders sliders{};
  std::transform(dgc.begin(), dgc.end(), sliders.begin(), usableFactor);
  const Sliders slope = slopesOf(sliders);
  const double usableGain = usableFactor(gain);
  table.resize(256 * rowPosition.size());
  std::uint8_t* row = table.data();
  double factorBefore = -1.0;
  for (const double position : rowPosition) {
    const double factor = curveAt(sliders, slope, position);
    if (factor == factorBefore) {
      // Sliders in a line, and all rows above the face and below the bottom.
      std::copy(row - 256, row, row);
    } else {
      for (int v = 0; v < 256; ++v) {
        const double compensated = std::min(factor * static_cast<double>(v), 255.0);
        row[v] = static_cast<std::uint8_t>(static_cast<int>(show(std::min(usableGain * compensated, 255.0)) + 0.5));
      }
    }
    factorBefore = factor;
    row += 256;
  }
}

}  // namespace

double dgcAt(const std::array<double, kDgcSliders>& sliders, double position) { return curveAt(sliders, slopesOf(sliders), position); }

void buildGainTable(double gain, const std::array<double, kDgcSliders>& dgc, std::span<const double> rowPosition,
                    std::vector<std::uint8_t>& table) {
  fillGainTable(
      gain, dgc, rowPosition, [](double level) { return level; }, table);
}

double shownLevel(const Tone& tone, double level) {
  const double usable = level > 0.0 ? std::min(level, 255.0) : 0.0;
  const ToneCurve curve(tone);
  return curve.isIdentity() ? usable : curve.at(usable);
}

void buildGainTable(double gain, const std::array<double, kDgcSliders>& dgc, const Tone& tone, std::span<const double> rowPosition,
                    std::vector<std::uint8_t>& table) {
  const ToneCurve curve(tone);
  if (curve.isIdentity()) return buildGainTable(gain, dgc, rowPosition, table);
  fillGainTable(
      gain, dgc, rowPosition, [&curve](double level) { return curve.at(level); }, table);
}

}  // namespace ew
