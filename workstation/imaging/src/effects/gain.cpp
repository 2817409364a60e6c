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

}  // namespace

double dgcAt(const std::array<double, kDgcSliders>& sliders, double position) { return curveAt(sliders, slopesOf(sliders), position); }

void buildGainTable(double gain, const std::array<double, kDgcSliders>& dgc, std::span<const double> rowPosition,
                    std::vector<std::uint8_t>& table) {
  Sliders sliders{};
  std::transform(dgc.begin(), dgc.end(), sliders.begin(), usableFactor);
  const Sliders slope = slopesOf(sliders);
  const double usableGain = usableFactor(gain);
  table.resize(256 * rowPosition.size());
  std::uint8_t* row = table.data();
  for (const double position : rowPosition) {
    const double factor = curveAt(sliders, slope, position);
    for (int v = 0; v < 256; ++v) {
      const double compensated = std::min(factor * static_cast<double>(v), 255.0);
      row[v] = static_cast<std::uint8_t>(static_cast<int>(std::min(usableGain * compensated, 255.0) + 0.5));
    }
    row += 256;
  }
}

void applyGainTable(ImageView<std::uint8_t> image, std::span<const std::uint8_t> table) {
  EW_EXPECTS(table.size() >= 256 * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* lookUp = table.data() + 256 * static_cast<std::size_t>(y);
    std::uint8_t* row = image.row(y);
    for (int x = 0; x < image.width; ++x) row[x] = lookUp[row[x]];
  }
}

void applyGainTable(ImageView<std::uint8_t> image, std::span<const std::vector<RowSpan>> spans, std::span<const std::uint8_t> table) {
  EW_EXPECTS(table.size() >= 256 * static_cast<std::size_t>(image.height));
  EW_EXPECTS(spans.size() == static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* lookUp = table.data() + 256 * static_cast<std::size_t>(y);
    std::uint8_t* row = image.row(y);
    for (const RowSpan& span : spans[static_cast<std::size_t>(y)])
      for (int x = span.begin; x < span.end; ++x) row[x] = lookUp[row[x]];
  }
}

}  // namespace ew
