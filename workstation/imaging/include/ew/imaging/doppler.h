#pragma once

#include <complex>
#include <span>
#include <vector>

namespace ew {

/// Velocities along the beam between minus and plus this are told apart: c PRF / (4 f0); mm/s.
/// Beyond, they come back from the other side.
[[nodiscard]] double nyquist_mmPerS(double prf_hz, double carrier_hz, double speed_mPerS = 1540.0);
/// What is shown of a velocity: itself within +-nyquist, and around from there. Positive nyquist itself shows as negative.
[[nodiscard]] double aliased_mmPerS(double velocity_mmPerS, double nyquist_mmPerS);

/// Of a packet of slow-time samples of one place: R(0) and R(1), each divided by the number of its own terms, so that a pure tone of any
/// length has |r1| = r0. Averages over neighbours and frames are averages of these, never of angles.
/// Source: Kasai et al., IEEE Trans. Sonics Ultrason. 32, 1985. Ours differs: that division.
struct PacketSums {
  double r0 = 0.0;
  std::complex<double> r1{0.0, 0.0};
};
/// @param samples complex, at least two
[[nodiscard]] PacketSums sumsOf(std::span<const std::complex<float>> samples);

/// Mean velocity along the beam, towards the probe positive, in units of the Nyquist velocity: -1..1.
[[nodiscard]] double meanVelocity(const PacketSums& sums);
/// Standard deviation of velocity in units of the Nyquist velocity, by 2 / pi^2 (1 - |r1| / (r0 - noise)); 0 where noise leaves nothing.
/// White noise adds to r0 alone, so that without taking it off 10 dB of signal to noise read as 0.18.
[[nodiscard]] double velocitySpread(const PacketSums& sums, double noisePower = 0.0);

/// Takes slow echoes out of a packet: what a polynomial of an order fits best, sample by sample, is left out of it.
/// As a filter it has no start to settle and keeps all samples; its edge is that of the regression filters of colour scanners.
class WallFilter {
 public:
  /// @param samples of a packet, 2..64; @param order of the polynomial, -1 (nothing is taken out) .. 8 and samples - 2
  WallFilter(int samples, int order);
  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] int order() const { return order_; }
  /// In place.
  void apply(std::span<std::complex<float>> packet) const;
  /// Power that is left of a tone: 1 - 1/N sum |B_k|^2. @param velocity in units of the Nyquist velocity
  [[nodiscard]] double response(double velocity) const;
  /// Where the response comes up to this many dB below 1, in units of the Nyquist velocity; 0 for order -1, 1 where it never does.
  [[nodiscard]] double edge(double down_db = 3.0) const;
  /// Of white noise, the share of its power that is left.
  [[nodiscard]] double noiseShare() const { return 1.0 - (order_ + 1.0) / samples_; }

 private:
  int samples_, order_;
  std::vector<float> basis_;  ///< (order + 1) orthonormal rows of as many samples
};

/// Standard deviation of meanVelocity for a packet without filter, in units of the Nyquist velocity, when speckle does not fade:
///   var(phase) = [(1 - rho1^2) sum over |m| < M of rho_m^2 (1 - |m|/M) + q^2 + 2 q (1 - rho2)] / (2 M rho1^2),
/// with M = samples - 1 pairs, rho_m = exp(-(pi spread m)^2 / 2) and q noiseToSignal.
/// @param spread of the spectrum, a Gaussian, in units of the Nyquist velocity; @param noiseToSignal power
/// Source: the perturbation formula of weather radar (Doviak and Zrnic, Doppler Radar and Weather Observations), without its term for pairs
/// that share a sample. With short packets of narrow spectra at 10 dB it is too small by up to 2.3 times, for fading leaves some packets
/// with far less signal than the mean.
[[nodiscard]] double meanVelocityDeviation(int samples, double spread, double noiseToSignal);

/// Makes packets with the statistics of blood, without a scatterer in them: complex normal samples whose covariance is that of a Gaussian
/// spectrum, so that speckle fades as it does.
class PacketSource {
 public:
  /// @param samples of a packet, 2..64
  explicit PacketSource(int samples);
  /// A packet of mean power 1, of a spectrum around `velocity` with the standard deviation `spread`, both in units of the Nyquist velocity;
  /// spread >= 0, above 1 it counts as 1.
  /// @param white `samples` complex normal numbers of power 1 @param packet as many, written
  void make(double velocity, double spread, std::span<const std::complex<float>> white, std::span<std::complex<float>> packet) const;
  [[nodiscard]] int samples() const { return samples_; }

 private:
  [[nodiscard]] std::span<const float> factorFor(double spread) const;

  int samples_;
  std::vector<std::vector<float>> factors_;  ///< by spread: lower triangles of the covariance's Cholesky factor
};

}  // namespace ew
