#include "own_grain.h"

#include <algorithm>
#include <cmath>

#include "echoes/echo_layout.h"
#include "ew/imaging/tissue_level.h"

namespace ew::detail {

OwnGrain ownGrainOf(const LiveEchoesEffect& effect, double recordedDynamicRange_db) {
  const LevelOptions usual;  // with which levels of recorded volumes are made
  OwnGrain grain;
  const double own = std::clamp(effect.ownGrain, 0.0, 1.0), live = std::sqrt(1.0 - own * own);
  grain.live = static_cast<float>(live);
  grain.own = static_cast<float>(own);
  grain.level = static_cast<float>(1.0 - live - own);
  const std::array<float, 256> shown = levelsShownAs(usual.shownWith);
  const double perDb = 255.0 / recordedDynamicRange_db;
  for (std::size_t n = 0; n < 256; ++n) {
    grain.ofGrey[n] = static_cast<float>(static_cast<double>(shown[n]) + perDb * (effect.gain_db - usual.gain_db));
    grain.ofLevel[n] = static_cast<float>(255.0 + perDb * ((static_cast<double>(n) / 255.0 - 1.0) * kLevelRange_db + effect.gain_db));
  }
  return grain;
}

void blendOwnGrain(const OwnGrain& grain, ImageView<const std::uint8_t> grey, ImageView<const std::uint8_t> level,
                   ImageView<float> echoes) {
  for (int s = 0; s < echoes.height; ++s) {
    float* row = echoes.row(s);
    for (int line = 0; line < echoes.width; ++line) {
      const std::uint8_t mean = level.row(line)[s];
      if (mean == 0) continue;
      const float live = std::max(row[line], 0.0F);  // the depth of a dark spot in the speckle is nobody's concern
      row[line] = grain.live * live + grain.own * grain.ofGrey[grey.row(line)[s]] + grain.level * grain.ofLevel[mean];
    }
  }
}

}  // namespace ew::detail
