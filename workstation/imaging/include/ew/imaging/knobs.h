#pragma once

#include <array>
#include <optional>

#include "ew/imaging/colour_doppler.h"
#include "ew/imaging/spectral_doppler.h"

namespace ew {

/// How the volume is sampled; each step up costs time (see `echoweave bench slicing`).
enum class Quality { weave, linear, cubic };

/// How the focus acts (`Scene::focus` says whether it does).
enum class FocusMethod {
  rowStretch,     ///< the paper's: rows out of focus are undersampled and stretched back
  lateralKernel,  ///< every depth is blurred by the width its beam has there
};

/// How gain and TGC act. The values of the law that does not act are kept and do nothing.
enum class GainLaw {
  automatic,  ///< what suits the scene (resolved.h): decibels for echoes formed anew, the paper's for a recorded volume
  decibel,    ///< a machine's: `gain_db` and `tgc_db` along the beams, before the image is made (effects/beam_gain.h)
  paper,      ///< Eq. 3-5: `gain` and `dgc` are factors on grey levels, by rows of the image (effects/gain.h)
};

/// How grey levels are shown after the dynamic range; see effects/gain.h for the curves, resolved.h for what suits a scene.
enum class GreyMap { linear, soft, contrast, bright, clinical, automatic };

/// What the scan view shows.
enum class DisplayMode {
  bMode,
  mMode,
  both,
  spectrum,  ///< the image, and the spectrum of a sample volume over time, where blood is known (FrameParts::flow)
};

inline constexpr int kDgcSliders = 8;
inline constexpr int kMostFoci = 4;
inline constexpr int kMostCompoundAngles = 5;

/// The grey that stays when the dynamic range is turned: parenchyma, as machines show it (the liver sweep's: 39 to 48).
inline constexpr double kMiddleGrey = 45.0;

/// The console. Defaults are neutral: an effect at its neutral setting is not run.
struct Knobs {
  double gain = 1.0;                                            ///< factor of Eq. 3, >= 0; 1 is neutral
  std::array<double, kDgcSliders> dgc{1, 1, 1, 1, 1, 1, 1, 1};  ///< factors of Eq. 4, near to far, >= 0; 1 is neutral
  GainLaw gainLaw = GainLaw::automatic;
  double gain_db = 0.0;                             ///< -30..30; 0 is neutral
  std::array<double, kDgcSliders> tgc_db{};         ///< near to far, -20..20; 0 is neutral
  double depth_mm = 0.0;                            ///< 0: the probe's default depth
  double focus_mm = 0.0;                            ///< depth of the focus mark; 0: half of the depth
  std::array<double, kMostFoci - 1> moreFoci_mm{};  ///< further foci, 0: not used
  FocusMethod focusMethod = FocusMethod::lateralKernel;
  double carrier_hz = 0.0;  ///< one of the probe's frequencies; 0: the probe's own
  bool harmonic = false;    ///< echoes formed anew: half of the carrier is sent, its second harmonic received (echoes/echo_beams.h)
  int compoundAngles = 1;   ///< echoes formed anew, linear and convex probes: directions whose images are averaged, odd, 1 (neutral)..5
  double dynamicRange_db = 0.0;  ///< shown about kMiddleGrey, 20..120; 0: the range the volume was recorded with
  GreyMap greyMap = GreyMap::automatic;
  double edgeEnhancement = 0.0;  ///< 0 (neutral)..1
  double persistence = 0.0;      ///< share of the last image that stays, 0 (neutral)..0.95
  int elevationPlanes = 5;       ///< planes the slice thickness is averaged over, odd, 3..9; acts when the scene has a slice thickness
  double steering_rad = 0.0;     ///< linear probes: towards +x, within the probe's largest
  bool trapezoid = false;        ///< linear probes: lines fan out to the probe's trapezoid angle; then steering does not act
  double zoom = 1.0;             ///< display magnification about the middle of the image, 1..8
  Quality quality = Quality::linear;
  DisplayMode mode = DisplayMode::bMode;
  double mLine = 0.0;                                      ///< which beam M-mode follows: -1 at the face's -x end .. +1
  double mSweep_s = 4.0;                                   ///< time across the strip of the M-mode or the spectrum, 1..16
  std::optional<SpectralDoppler> spectral = std::nullopt;  ///< of DisplayMode::spectrum; none: as it is at first
  std::optional<ColourDoppler> colour = std::nullopt;      ///< where blood is known (FrameParts::flow)
  bool markerLeft = true;   ///< display only: the marked side (+x of the probe) at the left of the image, as in general imaging
  bool upsideDown = false;  ///< display only: the face at the bottom
  bool operator==(const Knobs&) const = default;
};

/// The nearest setting that every step can work with: each number brought into its range (those of settings_json.h), one that is not a
/// number to the default, an even count of planes to the next odd one.
[[nodiscard]] Knobs limited(const Knobs& knobs);

}  // namespace ew
