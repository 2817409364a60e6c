#include "ew/imaging/doppler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/contract.h"

namespace ew {
namespace {

using std::numbers::pi;

constexpr int kFewestSamples = 2, kMostSamples = 64;
constexpr int kHighestOrder = 8;
constexpr double kSpreadStep = 0.01;  // between the spectra whose factors are kept
constexpr int kSpreads = 101;         // up to a spread of 1, where the spectrum has no direction left

/// Correlation after m periods of a Gaussian spectrum with this spread.
double correlationAfter(int m, double spread) {
  const double turned = pi * spread * m;
  return std::exp(-0.5 * turned * turned);
}

std::size_t triangle(int row, int column) { return static_cast<std::size_t>(row * (row + 1) / 2 + column); }

/// Lower factor of the covariance; what rounding leaves of a covariance of hardly full rank (a narrow spectrum) counts as none.
std::vector<float> choleskyOf(int samples, double spread) {
  std::vector<double> factor(triangle(samples, 0), 0.0);
  for (int row = 0; row < samples; ++row)
    for (int column = 0; column <= row; ++column) {
      double rest = correlationAfter(row - column, spread);
      for (int k = 0; k < column; ++k) rest -= factor[triangle(row, k)] * factor[triangle(column, k)];
      if (row == column)
        factor[triangle(row, row)] = rest > 1e-12 ? std::sqrt(rest) : 0.0;
      else
        factor[triangle(row, column)] = factor[triangle(column, column)] > 0.0 ? rest / factor[triangle(column, column)] : 0.0;
    }
  return {factor.begin(), factor.end()};
}

}  // namespace

double nyquist_mmPerS(double prf_hz, double carrier_hz, double speed_mPerS) {
  EW_EXPECTS(carrier_hz > 0.0);
  return 1000.0 * speed_mPerS * prf_hz / (4.0 * carrier_hz);
}

double aliased_mmPerS(double velocity_mmPerS, double nyquist_mmPerS) {
  EW_EXPECTS(nyquist_mmPerS > 0.0);
  const double turns = (velocity_mmPerS + nyquist_mmPerS) / (2.0 * nyquist_mmPerS);
  return (turns - std::floor(turns)) * 2.0 * nyquist_mmPerS - nyquist_mmPerS;
}

PacketSums sumsOf(std::span<const std::complex<float>> samples) {
  EW_EXPECTS(samples.size() >= 2);
  PacketSums sums;
  for (const auto& sample : samples) sums.r0 += static_cast<double>(std::norm(sample));
  for (std::size_t n = 0; n + 1 < samples.size(); ++n)
    sums.r1 += std::complex<double>(samples[n + 1]) * std::conj(std::complex<double>(samples[n]));
  sums.r0 /= static_cast<double>(samples.size());
  sums.r1 /= static_cast<double>(samples.size() - 1);
  return sums;
}

double meanVelocity(const PacketSums& sums) { return std::arg(sums.r1) / pi; }

double velocitySpread(const PacketSums& sums, double noisePower) {
  const double signal = sums.r0 - noisePower;
  if (!(signal > 0.0)) return 0.0;
  return std::sqrt(2.0 * std::max(0.0, 1.0 - std::abs(sums.r1) / signal)) / pi;
}

WallFilter::WallFilter(int samples, int order) : samples_(samples), order_(order) {
  EW_EXPECTS(samples >= kFewestSamples && samples <= kMostSamples && order >= -1 && order <= samples - 2 && order <= kHighestOrder);
  const auto count = static_cast<std::size_t>(samples);
  std::vector<std::vector<double>> rows;
  for (int power = 0; power <= order; ++power) {
    // The row before times x: powers of x themselves lie so near to one another that rounding would decide.
    std::vector<double> row(count, 1.0);
    for (int n = 0; n < samples && power > 0; ++n)
      row[static_cast<std::size_t>(n)] = rows.back()[static_cast<std::size_t>(n)] * (2.0 * n / (samples - 1.0) - 1.0);
    for (int pass = 0; pass < 2; ++pass)  // Gram and Schmidt, twice
      for (const auto& earlier : rows) {
        double product = 0.0;
        for (std::size_t n = 0; n < count; ++n) product += row[n] * earlier[n];
        for (std::size_t n = 0; n < count; ++n) row[n] -= product * earlier[n];
      }
    double length = 0.0;
    for (const double value : row) length += value * value;
    for (double& value : row) value /= std::sqrt(length);
    basis_.insert(basis_.end(), row.begin(), row.end());
    rows.push_back(std::move(row));
  }
}

void WallFilter::apply(std::span<std::complex<float>> packet) const {
  EW_EXPECTS(packet.size() == static_cast<std::size_t>(samples_));
  const float* row = basis_.data();
  for (int k = 0; k <= order_; ++k, row += samples_) {
    std::complex<float> product(0.0F);
    for (std::size_t n = 0; n < packet.size(); ++n) product += row[n] * packet[n];
    for (std::size_t n = 0; n < packet.size(); ++n) packet[n] -= row[n] * product;
  }
}

double WallFilter::response(double velocity) const {
  double taken = 0.0;
  const float* row = basis_.data();
  for (int k = 0; k <= order_; ++k, row += samples_) {
    std::complex<double> product(0.0);
    for (int n = 0; n < samples_; ++n) product += static_cast<double>(row[n]) * std::polar(1.0, pi * velocity * n);
    taken += std::norm(product);
  }
  return std::max(0.0, 1.0 - taken / samples_);
}

double WallFilter::edge(double down_db) const {
  if (order_ < 0) return 0.0;
  const double wanted = std::pow(10.0, -0.1 * down_db);
  constexpr double kStep = 1e-3;
  double below = 0.0;
  while (below < 1.0 && response(below + kStep) < wanted) below += kStep;
  if (below >= 1.0) return 1.0;
  double above = below + kStep;
  for (int n = 0; n < 30; ++n) {
    const double middle = 0.5 * (below + above);
    (response(middle) < wanted ? below : above) = middle;
  }
  return above;
}

double meanVelocityDeviation(int samples, double spread, double noiseToSignal) {
  EW_EXPECTS(samples >= kFewestSamples);
  const int pairs = samples - 1;
  const double rho1 = correlationAfter(1, spread), rho2 = correlationAfter(2, spread);
  double sum = 0.0;
  for (int m = -(pairs - 1); m <= pairs - 1; ++m) {
    const double rho = correlationAfter(m, spread);
    sum += rho * rho * (1.0 - std::abs(m) / static_cast<double>(pairs));
  }
  const double variance =
      ((1.0 - rho1 * rho1) * sum + noiseToSignal * noiseToSignal + 2.0 * noiseToSignal * (1.0 - rho2)) / (2.0 * pairs * rho1 * rho1);
  return std::sqrt(variance) / pi;
}

PacketSource::PacketSource(int samples) : samples_(samples) {
  EW_EXPECTS(samples >= kFewestSamples && samples <= kMostSamples);
  for (int n = 0; n < kSpreads; ++n) factors_.push_back(choleskyOf(samples, n * kSpreadStep));
}

std::span<const float> PacketSource::factorFor(double spread) const {
  EW_EXPECTS(spread >= 0.0);
  const auto nearest = static_cast<int>(std::lround(std::clamp(spread, 0.0, 1.0) / kSpreadStep));
  return factors_[static_cast<std::size_t>(nearest)];
}

void PacketSource::make(double velocity, double spread, std::span<const std::complex<float>> white,
                        std::span<std::complex<float>> packet) const {
  EW_EXPECTS(white.size() == static_cast<std::size_t>(samples_) && packet.size() == white.size());
  const float* factor = factorFor(spread).data();
  const std::complex<double> step = std::polar(1.0, pi * velocity);
  std::complex<double> turn(1.0, 0.0);
  for (std::size_t row = 0; row < packet.size(); ++row) {
    std::complex<float> sum(0.0F);
    for (std::size_t column = 0; column <= row; ++column) sum += *factor++ * white[column];
    packet[row] = sum * std::complex<float>(turn);
    turn *= step;
  }
}

}  // namespace ew
