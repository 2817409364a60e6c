#include "ew/imaging/effects/beam_gain.h"

#include "effects/faint_level.h"
#include "ew/core/contract.h"
#include "ew/imaging/effects/gain.h"

namespace ew {

BeamGain makeBeamGain(const BeamGainSetting& setting, const BeamGrid& grid) {
  EW_EXPECTS(setting.recordedDynamicRange_db > 0.0 && setting.dynamicRange_db > 0.0);
  EW_EXPECTS(grid.samples >= 2);
  const double greyPerDb = 255.0 / setting.recordedDynamicRange_db;
  const double scale = setting.recordedDynamicRange_db / setting.dynamicRange_db;
  const double wider_db = setting.middleLevel / 255.0 * (setting.dynamicRange_db - setting.recordedDynamicRange_db);
  const auto rows = static_cast<std::size_t>(grid.samples);
  BeamGain gain{static_cast<float>(scale), std::vector<float>(rows), std::vector<float>(rows)};
  for (std::size_t row = 0; row < rows; ++row) {
    const double position = static_cast<double>(row) / static_cast<double>(rows - 1);
    const double lift = greyPerDb * (setting.gain_db + dgcAt(setting.tgc_db, position) + wider_db);
    gain.offset[row] = static_cast<float>(scale * lift);
    gain.lift[row] = static_cast<float>(std::max(0.0, lift));
  }
  return gain;
}

void openBlack(const BeamGain& gain, int firstRow, ImageView<float> echoes) {
  EW_EXPECTS(firstRow >= 0 && static_cast<std::size_t>(firstRow) + static_cast<std::size_t>(echoes.height) <= gain.lift.size());
  for (int y = 0; y < echoes.height; ++y) {
    const float lift = gain.lift[static_cast<std::size_t>(firstRow + y)];
    if (lift == 0.0F) continue;
    float* const row = echoes.row(y);
    for (int x = 0; x < echoes.width; ++x) row[x] = withBlackOpened(row[x], lift);
  }
}

void amplify(const BeamGain& gain, int firstRow, ImageView<float> echoes) {
  EW_EXPECTS(firstRow >= 0 && static_cast<std::size_t>(firstRow) + static_cast<std::size_t>(echoes.height) <= gain.offset.size());
  const float scale = gain.scale;
  for (int y = 0; y < echoes.height; ++y) {
    const float offset = gain.offset[static_cast<std::size_t>(firstRow + y)];
    float* const row = echoes.row(y);
    for (int x = 0; x < echoes.width; ++x) row[x] = scale * row[x] + offset;
  }
}

}  // namespace ew
