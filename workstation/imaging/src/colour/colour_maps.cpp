#include <algorithm>
#include <array>
#include <cmath>

#include "ew/core/contract.h"
#include "ew/imaging/colour_doppler.h"

namespace ew {
namespace {

/// A hue from what is slow or faint to what is fast or strong.
using Ramp = std::array<glm::vec3, 5>;

// Brighter is faster; both sides are equally light at equal speed, so that neither direction looks faster than the other.
constexpr Ramp kTowards{{{60, 0, 0}, {150, 10, 0}, {220, 50, 0}, {255, 140, 30}, {255, 230, 130}}};
constexpr Ramp kAway{{{0, 10, 70}, {0, 40, 170}, {20, 90, 235}, {70, 170, 255}, {170, 240, 255}}};
constexpr Ramp kPower{{{70, 20, 0}, {150, 60, 0}, {220, 110, 10}, {250, 170, 60}, {255, 235, 160}}};
constexpr glm::vec3 kTurbulent{60, 230, 70};
constexpr double kCalmSpread = 0.18, kWildSpread = 0.5;  // of the Nyquist velocity; white noise has 0.45 by this estimator

glm::vec3 at(const Ramp& ramp, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (ramp.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), ramp.size() - 2);
  return glm::mix(ramp[low], ramp[low + 1], static_cast<float>(place - static_cast<double>(low)));
}

Rgb rounded(const glm::vec3& colour) { return Rgb(glm::clamp(colour, 0.0F, 255.0F) + 0.5F); }

}  // namespace

Rgb colourOf(const ColourDoppler& colour, double value, double spread) {
  if (colour.shows == ColourShows::power) return rounded(at(kPower, value));
  const bool isTowards = (value >= 0.0) != colour.invert;
  // Zero lies where the baseline was moved to, and each side has its whole ramp.
  glm::vec3 hue = at(isTowards ? kTowards : kAway, std::abs(value));
  if (colour.shows == ColourShows::variance)
    hue = glm::mix(hue, kTurbulent, static_cast<float>(std::clamp((spread - kCalmSpread) / (kWildSpread - kCalmSpread), 0.0, 0.85)));
  return rounded(hue);
}

RgbImage colourBar(const ColourDoppler& colour, int width, int height) {
  EW_EXPECTS(width >= 1 && height >= 1);
  RgbImage bar(width, height);
  const double baseline = colour.shows == ColourShows::velocity || colour.shows == ColourShows::variance ? colour.baseline : 0.0;
  for (int y = 0; y < height; ++y) {
    const double share = height > 1 ? 1.0 - static_cast<double>(y) / (height - 1) : 1.0;  // from the lowest to the highest
    double value = share;
    if (colour.shows != ColourShows::power) {
      const double velocity = 2.0 * share - 1.0 + baseline;
      value = velocity >= 0.0 ? velocity / (1.0 + baseline) : velocity / (1.0 - baseline);
    }
    for (int x = 0; x < width; ++x)
      viewOf(bar).at(x, y) = colourOf(colour, value, width > 1 ? 0.5 * static_cast<double>(x) / (width - 1) : 0.0);
  }
  return bar;
}

}  // namespace ew
