#pragma once

#include <glm/glm.hpp>
#include <utility>
#include <vector>

namespace ew {

struct Probe;
struct Knobs;

/// A sample volume on one line and its part of the console: the spectrum of what moves in it, over time.
struct SpectralDoppler {
  double line = 0.0;              ///< across the face: -1 at its -x end .. +1
  double depth_mm = 0.0;          ///< of the sample volume's middle; 0: half of the image's
  double gate_mm = 2.0;           ///< its length along the line, 0.5..20
  double steering_rad = 0.0;      ///< linear probes: of the line, towards +x, at most kMostColourSteering_rad and the probe's largest
  double angle_rad = 0.0;         ///< between the line and the way blood is said to go, towards +x of the image from it, -80..80 degrees
  double carrier_hz = 0.0;        ///< sent, 1e6..2e7; 0: two thirds of the image's own
  double prf_hz = 4000.0;         ///< pulses a second, 100..52000; no more than the depth lets come back, unless `highPrf`
  bool highPrf = false;           ///< pulses are sent before the last echo is back: then other depths answer as well
  double baseline = 0.0;          ///< share of the range that is moved from away to towards, -0.9..0.9
  double wallFilter_hz = 100.0;   ///< Doppler shifts below are taken out, 20..1600
  double gain_db = 0.0;           ///< -30..30
  double dynamicRange_db = 40.0;  ///< from black to white, 20..80
  bool invert = false;            ///< towards is below the baseline
  bool broadens = true;           ///< blood crosses beam and pulse in a time, which widens its line (intrinsic broadening)
  bool operator==(const SpectralDoppler&) const = default;
};
inline constexpr double kMostDopplerAngle_rad = 1.3962634015954636;  // 80 degrees
/// Beyond, an error of the angle outweighs the measurement; vascular laboratories do not go there.
inline constexpr double kTrustedDopplerAngle_rad = 1.0471975511965976;  // 60 degrees

/// A sample volume as it comes out of settings, probe and depth: what acts.
struct SpectralGate {
  glm::dvec2 face_mm{0.0};         ///< where its line leaves the face
  glm::dvec2 middle_mm{0.0};       ///< of the volume, in the image plane
  glm::dvec2 direction{0.0, 1.0};  ///< of the line
  glm::dvec2 flow{0.0, 1.0};       ///< the way blood is said to go or to come, of length 1
  double depth_mm = 0.0, length_mm = 0.0;
  double carrier_hz = 0.0, prf_hz = 0.0;
  std::vector<double> alsoAt_mm = {};  ///< depths on the line that answer as well (high PRF)
  double nyquist_mmPerS = 0.0;         ///< along the line
  double corrected = 1.0;              ///< velocities along the flow over those along the line: 1 / cos of the angle
  /// What is shown, corrected, from the lowest to the highest; towards the probe is positive.
  std::pair<double, double> shown_mmPerS{0.0, 0.0};
  double filtered_mmPerS = 0.0;  ///< slower is taken out, corrected
};
/// @param knobs with spectral (Knobs::spectral); brought within limits
[[nodiscard]] SpectralGate spectralGateOf(const Probe& probe, const Knobs& knobs);
/// The knobs with the sample volume at a point of the image plane, as far as the fan goes.
[[nodiscard]] Knobs withSpectralGateAt(const Probe& probe, const Knobs& knobs, const glm::dvec2& p_mm);
/// What an error of the angle does to a corrected velocity, as a share of it: tan(angle) times the error.
[[nodiscard]] double angleUncertainty(double angle_rad, double error_rad);

}  // namespace ew
