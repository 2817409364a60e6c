#pragma once

#include <cmath>
#include <complex>
#include <numbers>

namespace ew::detail {

/// A spectral wall filter: two Butterworth high passes of second order, one behind the other, by the bilinear transform; -6 dB at the edge.
class HighPass {
 public:
  void configure(double edge_hz, double rate_hz) {
    const double turn = std::tan(std::numbers::pi * std::min(edge_hz / rate_hz, 0.49)), q = std::numbers::sqrt2;
    const double norm = 1.0 / (1.0 + q * turn + turn * turn);
    gain_ = static_cast<float>(norm);
    back1_ = static_cast<float>(2.0 * (turn * turn - 1.0) * norm);
    back2_ = static_cast<float>((1.0 - q * turn + turn * turn) * norm);
  }
  [[nodiscard]] std::complex<float> next(std::complex<float> sample) {
    for (Stage& stage : stages_) {
      const std::complex<float> out = gain_ * sample + stage.first;
      stage.first = -2.0F * gain_ * sample - back1_ * out + stage.second;
      stage.second = gain_ * sample - back2_ * out;
      sample = out;
    }
    return sample;
  }
  void clear() { stages_[0] = stages_[1] = {}; }

 private:
  struct Stage {
    std::complex<float> first{0.0F}, second{0.0F};
  };
  float gain_ = 1.0F, back1_ = 0.0F, back2_ = 0.0F;
  Stage stages_[2];
};

}  // namespace ew::detail
