#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "ew/core/image.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/knobs.h"

namespace ew {

/// Gain, TGC and dynamic range as a machine has them: in decibels, along the beams, before the image is made. Levels on a beam grid are
/// decibels already, so that a gain is an addition; noise that was added before rises with it, and a slider's depth is an arc in a sector.
/// The paper's factors on grey levels (Eq. 3-5) are in effects/gain.h; Knobs::gainLaw says which of the two acts.
struct BeamGainSetting {
  double gain_db = 0.0;
  std::array<double, kDgcSliders> tgc_db{};  ///< near to far; between them the curve of dgcAt (effects/gain.h)
  double recordedDynamicRange_db = 60.0;     ///< what 0..255 span, > 0
  double dynamicRange_db = 60.0;             ///< shown, > 0
  double middleLevel = kMiddleGrey;          ///< that stays when the range is another than recorded (resolved.h), 0..255
  bool operator==(const BeamGainSetting&) const = default;

  [[nodiscard]] bool isNeutral() const {
    return gain_db == 0.0 && dynamicRange_db == recordedDynamicRange_db &&
           std::all_of(tgc_db.begin(), tgc_db.end(), [](double slider_db) { return slider_db == 0.0; });
  }
  /// How far below recorded black a level comes into sight at most; negative when recorded levels go out of sight at every depth.
  [[nodiscard]] double largestLift_db() const {
    return gain_db + *std::max_element(tgc_db.begin(), tgc_db.end()) + middleLevel / 255.0 * (dynamicRange_db - recordedDynamicRange_db);
  }
};

/// The same worked out for each row (depth) of a beam grid: level' = scale * level + offset[row].
struct BeamGain {
  float scale = 1.0F;         ///< recorded over shown dynamic range
  std::vector<float> offset;  ///< scale * greyPerDb * (gain_db + TGC(depth)) + middleLevel (1 - scale)
  std::vector<float> lift;    ///< how many levels below 0 become 0, >= 0
};
[[nodiscard]] BeamGain makeBeamGain(const BeamGainSetting& setting, const BeamGrid& grid);

/// Levels of a recorded volume from here on are taken as they are; below, the less the nearer they lie to 0.
inline constexpr float kFaintLevel = 16.0F;

/// Outside stays outside. Level 0 of a recorded volume stands for everything below the recorded range, also for what was never recorded:
/// where it is, nothing is known that a gain or a wider range could bring to light. So before noise and gain it is put so far below black
/// that the gain brings it back to 0 and no further, and levels up to kFaintLevel (3.8 dB above black at 60 dB) are put between, in order:
///   level' = level - lift[row] (1 - level / kFaintLevel)^2, the bracket within 0..1.
/// Noise is then added to (almost) nothing there, as in a vessel without echoes, and does rise with the gain. Rows with lift 0 stay.
/// Not for echoes that are formed anew: their levels go on below 0.
/// @param firstRow the grid's row that echoes.row(0) is
void openBlack(const BeamGain& gain, int firstRow, ImageView<float> echoes);

/// level' = scale * level + offset[row]. Levels may leave 0..255: scan conversion clips, once.
void amplify(const BeamGain& gain, int firstRow, ImageView<float> echoes);

}  // namespace ew
