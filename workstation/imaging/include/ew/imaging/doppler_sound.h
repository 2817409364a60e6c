#pragma once

#include <complex>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ew {

/// What is heard of a sample volume: Doppler shifts lie where ears are. Blood towards the probe is on the left, away from it on the right,
/// each up to the end of the scale, around which velocities go as they do in the spectrum.
/// Each side is a band of the complex signal, interpolated to the rate of the sound by a windowed sinc of 32 pulses; 16 pulses late.
class DopplerSound {
 public:
  /// @param prf_hz of the samples; @param baseline as SpectralDoppler::baseline; @param rate_hz of the sound. A change of any begins anew.
  void configure(double prf_hz, double baseline, double rate_hz = 48000.0);
  /// The next samples of the volume (FrameMaker::dopplerSamples). @return what is due of the sound, left and right; for samples of
  /// amplitude 1 each side is at most about 1. Valid until the next call.
  [[nodiscard]] std::span<const glm::vec2> add(std::span<const std::complex<float>> samples);
  void clear();
  [[nodiscard]] double rate_hz() const { return rate_hz_; }

 private:
  static constexpr int kReach = 16;    ///< pulses on both sides
  static constexpr int kPhases = 256;  ///< between two pulses

  double prf_hz_ = 0.0, baseline_ = 0.0, rate_hz_ = 48000.0;
  std::vector<std::complex<float>> towards_, away_;  ///< by phase, 2 kReach weights
  std::vector<std::complex<float>> waiting_;
  double next_ = 0.0;  ///< place of the next sound sample among those that wait
  std::vector<glm::vec2> sound_;
};

}  // namespace ew
