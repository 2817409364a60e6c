#pragma once

#include <array>

namespace ew {

/// How the volume is sampled; each step up costs time (see `echoweave bench slicing`).
enum class Quality { weave, linear };

inline constexpr int kDgcSliders = 8;

/// The console. Defaults are neutral: an effect at its neutral setting is not run.
struct Knobs {
  double gain = 1.0;                                            ///< factor of Eq. 3, >= 0; 1 is neutral
  std::array<double, kDgcSliders> dgc{1, 1, 1, 1, 1, 1, 1, 1};  ///< factors of Eq. 4, near to far, >= 0; 1 is neutral
  double depth_mm = 0.0;                                        ///< 0: the probe's default depth
  double focus_mm = 0.0;                                        ///< depth of the focus mark; 0: half of the depth
  double zoom = 1.0;                                            ///< display magnification about the middle of the image, 1..8
  Quality quality = Quality::linear;
  bool markerLeft = true;  ///< display only: the marked side (+x of the probe) at the left of the picture, as in general imaging
  bool operator==(const Knobs&) const = default;
};

}  // namespace ew
