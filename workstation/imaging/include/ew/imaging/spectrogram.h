#pragma once

#include <complex>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ew/imaging/m_mode.h"

namespace ew {

/// How Doppler samples become columns of a spectrum.
struct SpectrumSetting {
  double prf_hz = 4000.0;
  double baseline = 0.0;          ///< as SpectralDoppler::baseline
  bool invert = false;            ///< towards is below
  double black = 1.0;             ///< power of a bin that is black; > 0
  double dynamicRange_db = 40.0;  ///< from there to white
  bool operator==(const SpectrumSetting&) const = default;
};

/// Samples of a window: the power of two nearest to 16 ms of them, 32..512. A longer window tells velocities better apart and smears what
/// accelerates; 8 to 18 ms are usual (Aydin and Markus, Eur. J. Ultrasound 12, 2000).
[[nodiscard]] int spectrumWindow(double prf_hz);

/// Periodograms of a signal that goes on: Hann windows, one for each column of the strip, padded to twice their length.
/// Column n is the window whose middle lies n column times after half a window. Allocates in configure alone.
class Spectrogram {
 public:
  Spectrogram();
  ~Spectrogram();
  Spectrogram(const Spectrogram& other);
  Spectrogram& operator=(const Spectrogram& other);
  Spectrogram(Spectrogram&&) noexcept;
  Spectrogram& operator=(Spectrogram&&) noexcept;

  /// @param columns, rows of the strip, >= 0; @param sweep_s time across it. A change of any starts afresh, but for black and range, which
  /// the next columns have.
  void configure(const SpectrumSetting& setting, int columns, int rows, double sweep_s);
  /// The next samples. @param time_s of the first of them; where they do not go on from the last (half a sample), everything starts afresh
  void add(std::span<const std::complex<float>> samples, double time_s);
  void clear();

  [[nodiscard]] const MModeStrip& strip() const;
  [[nodiscard]] const SpectrumSetting& setting() const;
  [[nodiscard]] int window() const;
  /// Of a spectrum: 2 window(); bin n is at the Doppler shift (n / bins - 1/2) prf, towards the probe positive.
  [[nodiscard]] int bins() const;
  /// The newest columns that are kept, as many as the strip has, oldest first.
  [[nodiscard]] int columns() const;
  [[nodiscard]] double timeOf(int column) const;  ///< of its window's middle
  /// Power by bin; white noise of power 1 a sample has 1 in each on average.
  [[nodiscard]] std::span<const float> powers(int column) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew
