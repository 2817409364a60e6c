#include "ew/imaging/effects/gain.h"

#include <algorithm>

#include "effects/faint_level.h"
#include "effects/monotone_curve.h"

namespace ew {
namespace {

using Sliders = std::array<double, kDgcSliders>;

constexpr double kClinicalReject = 255.0 * (1.0 - 52.0 / 60.0);

/// The curve through the sliders; places are counted in sliders.
MonotoneCurve<kDgcSliders> curveThrough(const Sliders& sliders) {
  static constexpr Sliders kPlaces{0, 1, 2, 3, 4, 5, 6, 7};
  return {kPlaces, sliders, 0.0, 0.0};
}
double curveAt(const MonotoneCurve<kDgcSliders>& curve, double position) { return curve.at(position * kDgcSliders - 0.5); }

/// The clinical map of shownLevel, 0..255 both ways.
const MonotoneCurve<11>& clinicalCurve() {
  static const MonotoneCurve<11> curve({0, kClinicalReject, 80, 90, 100, 110, 120, 130, 150, 170, 255},
                                       {0, 0, 24, 32, 43, 55, 68, 85, 126, 183, 255}, 0.0, (255.0 - 183.0) / (255.0 - 170.0));
  return curve;
}

// NaN compares false. A thousand already makes every level above 0 white, and infinity times 0 is not a number.
double usableFactor(double factor) { return factor > 0.0 ? std::min(factor, 1e9) : 0.0; }

double usableRange_db(double range_db, double otherwise_db) { return std::clamp(range_db > 0.0 ? range_db : otherwise_db, 20.0, 120.0); }

/// 255 f(x) of shownLevel with its numbers worked out: f = first x + second x^2 + third x^3, or the clinical curve.
struct ToneCurve {
  double recordedOverShown = 1.0, middle = kMiddleGrey;
  double lift = 0.0;  ///< levels below 0 that a wider range makes 0
  double first = 1.0, second = 0.0, third = 0.0;
  const MonotoneCurve<11>* clinical = nullptr;

  explicit ToneCurve(const Tone& tone) {
    const double recorded_db = usableRange_db(tone.recordedDynamicRange_db, 60.0);
    const double shown_db = usableRange_db(tone.dynamicRange_db, recorded_db);
    recordedOverShown = recorded_db / shown_db;
    middle = std::clamp(tone.middleLevel, 0.0, 255.0);
    lift = std::max(0.0, middle * (shown_db / recorded_db - 1.0));
    if (tone.map == GreyMap::soft) first = 2.0, second = -3.0, third = 2.0;
    if (tone.map == GreyMap::contrast) first = 0.0, second = 3.0, third = -2.0;
    if (tone.map == GreyMap::bright) first = 1.7, second = -0.7;
    if (tone.map == GreyMap::clinical) clinical = &clinicalCurve();
  }
  [[nodiscard]] bool isIdentity() const { return recordedOverShown == 1.0 && first == 1.0 && clinical == nullptr; }
  [[nodiscard]] double at(double level) const {
    const double opened = lift > 0.0 ? withBlackOpened(level, lift) : level;
    const double x = std::clamp(opened * recordedOverShown + middle * (1.0 - recordedOverShown), 0.0, 255.0) / 255.0;
    if (clinical != nullptr) return clinical->at(255.0 * x);
    return 255.0 * x * (first + x * (second + x * third));
  }
};

/// Eq. 5 row by row, with `show` between its last MIN and the rounding.
template <class Show>
void fillGainTable(double gain, const Sliders& dgc, std::span<const double> rowPosition, const Show& show,
                   std::vector<std::uint8_t>& table) {
  Sliders sliders{};
  std::transform(dgc.begin(), dgc.end(), sliders.begin(), usableFactor);
  const auto curve = curveThrough(sliders);
  const double usableGain = usableFactor(gain);
  table.resize(256 * rowPosition.size());
  std::uint8_t* row = table.data();
  double factorBefore = -1.0;
  for (const double position : rowPosition) {
    const double factor = curveAt(curve, position);
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

double dgcAt(const std::array<double, kDgcSliders>& sliders, double position) { return curveAt(curveThrough(sliders), position); }

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
