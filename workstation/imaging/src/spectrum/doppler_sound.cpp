#include "ew/imaging/doppler_sound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/contract.h"

namespace ew {
namespace {

using std::numbers::pi;

double sinc(double x) { return std::abs(x) < 1e-9 ? 1.0 : std::sin(pi * x) / (pi * x); }

/// Weight of a pulse that lies `pulses` before the sound sample, for shifts between two shares of the pulse rate: an even band, cut off
/// softly (Blackman), so that the other side is below -60 dB a little way off zero.
std::complex<float> weightOf(double pulses, double from, double to, double reach) {
  const double u = pulses / reach;
  if (std::abs(u) >= 1.0) return {};
  const double window = 0.42 + 0.5 * std::cos(pi * u) + 0.08 * std::cos(2.0 * pi * u), width = to - from;
  return std::complex<float>(std::polar(window * width * sinc(width * pulses), pi * (from + to) * pulses));
}

}  // namespace

void DopplerSound::configure(double prf_hz, double baseline, double rate_hz) {
  EW_EXPECTS(prf_hz > 0.0 && rate_hz > 0.0 && std::abs(baseline) < 1.0);
  if (prf_hz == prf_hz_ && baseline == baseline_ && rate_hz == rate_hz_ && !towards_.empty()) return;
  prf_hz_ = prf_hz;
  baseline_ = baseline;
  rate_hz_ = rate_hz;
  towards_.clear();
  away_.clear();
  for (int phase = 0; phase < kPhases; ++phase)
    for (int n = 0; n < 2 * kReach; ++n) {
      const double pulses = kReach - 1 - n + static_cast<double>(phase) / kPhases;
      towards_.push_back(weightOf(pulses, 0.0, 0.5 * (1.0 + baseline), kReach));
      away_.push_back(weightOf(pulses, -0.5 * (1.0 - baseline), 0.0, kReach));
    }
  clear();
}

void DopplerSound::clear() {
  waiting_.assign(2 * kReach - 1, {});
  next_ = 0.0;
}

std::span<const glm::vec2> DopplerSound::add(std::span<const std::complex<float>> samples) {
  EW_EXPECTS(!towards_.empty());
  waiting_.insert(waiting_.end(), samples.begin(), samples.end());
  sound_.clear();
  const double step = prf_hz_ / rate_hz_;
  constexpr std::size_t kTaps = std::size_t{2} * kReach;
  for (; next_ + static_cast<double>(kTaps) <= static_cast<double>(waiting_.size()); next_ += step) {
    const auto first = static_cast<std::size_t>(next_);
    const auto phase = std::min(static_cast<std::size_t>((next_ - static_cast<double>(first)) * kPhases), std::size_t{kPhases - 1});
    const std::complex<float>* left = towards_.data() + phase * kTaps;
    const std::complex<float>* right = away_.data() + phase * kTaps;
    std::complex<float> towards(0.0F), away(0.0F);
    for (std::size_t n = 0; n < kTaps; ++n) {
      towards += left[n] * waiting_[first + n];
      away += right[n] * waiting_[first + n];
    }
    sound_.emplace_back(towards.real(), away.real());
  }
  const auto done = static_cast<std::ptrdiff_t>(next_);
  waiting_.erase(waiting_.begin(), waiting_.begin() + done);
  next_ -= static_cast<double>(done);
  return sound_;
}

}  // namespace ew
