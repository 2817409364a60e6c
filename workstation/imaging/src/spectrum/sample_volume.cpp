#include "spectrum/sample_volume.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "colour/white_noise.h"
#include "effects/spread_bits.h"
#include "ew/core/contract.h"

namespace ew::detail {
namespace {

constexpr float kEdge = 2.6F;        // standard deviations that the region reaches: there a scatterer is 30 dB below the middle
constexpr double kStep_s = 1e-3;     // velocities are asked for as often
constexpr double kStirred_s = 4e-3;  // correlation of turbulence
constexpr double kLives_s = 0.2;     // on average, then another one is born anywhere: what the probe's own motion heaps up spreads again
constexpr double kNearby = 0.4;      // of a standard deviation
constexpr int kTries = 16;           // of a place where blood comes in

float evenOf(std::uint64_t bits) { return static_cast<float>(bits & 0xffffffU) * 0x1p-23F - 1.0F; }

}  // namespace

std::size_t SampleVolume::bytes() { return sizeof(SampleVolume) + kScatterers * sizeof(Scatterer); }

std::uint64_t SampleVolume::keyOf(std::size_t n) const {
  return spreadBits(seed_ + (n + 1) * 0x9e3779b97f4a7c15ULL + (std::uint64_t{scatterers_[n].born} << 40U));
}

void SampleVolume::renew(std::size_t n) {
  Scatterer& one = scatterers_[n];
  ++one.born;
  const auto turn = std::numbers::pi_v<float> * evenOf(keyOf(n));
  one.phase = {std::cos(turn), std::sin(turn)};
  one.stirred = {};
  one.isFresh = false;
}

void SampleVolume::renewAnywhere(std::size_t n) {
  renew(n);
  const std::uint64_t bits = spreadBits(keyOf(n) + 1), more = spreadBits(keyOf(n) + 2);
  scatterers_[n].at = {evenOf(bits), evenOf(bits >> 24U), evenOf(more)};
  scatterers_[n].isFresh = true;
}

void SampleVolume::renewWhereItComesIn(std::size_t n, const Flow& flow, std::size_t sample) {
  // Faces of the region by their areas.
  const glm::vec3 areas(half_mm_.y * half_mm_.z, half_mm_.x * half_mm_.z, half_mm_.x * half_mm_.y);
  const float all = areas.x + areas.y + areas.z;
  renew(n);
  for (int attempt = 0; attempt < kTries && fastest_mmPerS_ > 0.0; ++attempt) {
    const std::uint64_t bits = spreadBits(keyOf(n) + 8 + static_cast<std::uint64_t>(attempt)), more = spreadBits(bits + 1);
    const float which = 0.5F * (evenOf(more) + 1.0F) * all;
    const int axis = which < areas.x ? 0 : which < areas.x + areas.y ? 1 : 2;
    const float side = (more >> 30U & 1U) != 0 ? 1.0F : -1.0F;
    glm::vec3 at(side);
    at[(axis + 1) % 3] = evenOf(bits);
    at[(axis + 2) % 3] = evenOf(bits >> 24U);
    const MovingBlood blood = flow(sample, glm::dvec3(at * half_mm_));
    if (!blood.isThere) continue;
    const double inward = -static_cast<double>(side) * blood.velocity_mmPerS[axis];
    if (inward < 0.5 * (static_cast<double>(evenOf(more >> 36U)) + 1.0) * fastest_mmPerS_) continue;
    scatterers_[n].at = at;
    return;
  }
  renewAnywhere(n);
}

float SampleVolume::strengthAt(const glm::vec3& at_mm) const {
  const float across = at_mm.x / static_cast<float>(size_.lateralSigma_mm), aside = at_mm.z / static_cast<float>(size_.elevationalSigma_mm);
  const float beyond =
      std::max(std::abs(at_mm.y) - 0.5F * static_cast<float>(size_.length_mm), 0.0F) / static_cast<float>(size_.pulseSigma_mm);
  return std::exp(-0.5F * (across * across + aside * aside + beyond * beyond));
}

void SampleVolume::configure(const VolumeSize& size, std::uint64_t seed) {
  EW_EXPECTS(size.prf_hz > 0.0 && size.wavelength_mm > 0.0);
  if (size == size_ && seed == seed_ && !scatterers_.empty()) return;
  if (seed != seed_ || scatterers_.empty()) {
    seed_ = seed;
    steps_ = 0;
    scatterers_.assign(kScatterers, {});
    for (std::size_t n = 0; n < scatterers_.size(); ++n) {
      renewAnywhere(n);
      scatterers_[n].isFresh = false;
    }
  }
  size_ = size;
  half_mm_ = {kEdge * static_cast<float>(size.lateralSigma_mm),
              0.5F * static_cast<float>(size.length_mm) + kEdge * static_cast<float>(size.pulseSigma_mm),
              kEdge * static_cast<float>(size.elevationalSigma_mm)};
  // Mean of the strength squared over the region, whose axes are apart.
  const auto meanOf = [](double flat, double sigma, double half) {
    const double tail = 0.5 * std::sqrt(std::numbers::pi) * sigma * std::erf((half - flat) / sigma);
    return (flat + tail) / half;
  };
  const double mean = meanOf(0.0, size.lateralSigma_mm, static_cast<double>(half_mm_.x)) *
                      meanOf(0.5 * size.length_mm, size.pulseSigma_mm, static_cast<double>(half_mm_.y)) *
                      meanOf(0.0, size.elevationalSigma_mm, static_cast<double>(half_mm_.z));
  unit_ = static_cast<float>(1.0 / std::sqrt(mean * kScatterers));
}

void SampleVolume::add(const Flow& flow, std::span<std::complex<float>> samples) {
  EW_EXPECTS(!scatterers_.empty());
  const auto most = static_cast<std::size_t>(std::max(1.0, std::floor(kStep_s * size_.prf_hz)));
  const auto perTurn = static_cast<float>(4.0 * std::numbers::pi / (size_.wavelength_mm * size_.prf_hz));
  const auto nearby_mm = static_cast<float>(kNearby * std::min({size_.lateralSigma_mm, size_.elevationalSigma_mm, size_.pulseSigma_mm}));
  const NormalTable& normals = NormalTable::shared();
  for (std::size_t begin = 0; begin < samples.size(); begin += most) {
    const std::size_t count = std::min(most, samples.size() - begin);
    const auto time_s = static_cast<float>(static_cast<double>(count) / size_.prf_hz);
    const auto keeps = static_cast<float>(std::exp(-static_cast<double>(time_s) / kStirred_s)), comes = std::sqrt(1.0F - keeps * keeps);
    ++steps_;
    double fastest_mmPerS = 0.0;
    const auto dies = static_cast<float>(2.0 * static_cast<double>(time_s) / kLives_s - 1.0);
    for (std::size_t n = 0; n < scatterers_.size(); ++n) {
      Scatterer& one = scatterers_[n];
      const glm::vec3 at_mm = one.at * half_mm_;
      const MovingBlood blood = flow(begin, glm::dvec3(at_mm));
      fastest_mmPerS = std::max(fastest_mmPerS, glm::length(blood.velocity_mmPerS));
      glm::vec3 velocity(blood.velocity_mmPerS);
      const std::uint64_t bits = spreadBits(keyOf(n) ^ spreadBits(steps_));
      if (blood.turbulence_mmPerS > 0.0) {
        one.stirred = keeps * one.stirred + comes * glm::vec3(normals.at(bits), normals.at(bits >> 12U), normals.at(bits >> 24U));
        velocity += static_cast<float>(blood.turbulence_mmPerS) * one.stirred;
      }
      const bool ends = size_.broadens && evenOf(bits >> 36U) < dies;
      const glm::vec3 next_mm = at_mm + velocity * time_s;
      if (blood.isThere) {
        const float turn = -velocity.y * perTurn;
        const std::complex<float> step(std::cos(turn), std::sin(turn));
        // Strength is linear between places so near to one another that a Gaussian is.
        const float way_mm = size_.broadens ? glm::length(next_mm - at_mm) : 0.0F;
        const auto pieces = std::clamp(static_cast<std::size_t>(std::ceil(way_mm / nearby_mm)), std::size_t{1}, count);
        float now = one.isFresh ? 0.0F : unit_ * strengthAt(at_mm);
        for (std::size_t piece = 0, k = begin; piece < pieces; ++piece) {
          const std::size_t to = begin + (piece + 1) * count / pieces;
          const float share = static_cast<float>(to - begin) / static_cast<float>(count);
          const bool isLast = piece + 1 == pieces;
          const float then = isLast && ends ? 0.0F : unit_ * strengthAt(size_.broadens ? glm::mix(at_mm, next_mm, share) : at_mm);
          const float growth = (then - now) / static_cast<float>(std::max<std::size_t>(to - k, 1));
          for (; k < to; ++k) {
            samples[k] += now * one.phase;
            one.phase *= step;
            now += growth;
          }
          now = then;
        }
        one.phase /= std::abs(one.phase);
      }
      one.isFresh = false;
      if (!size_.broadens) continue;  // each stays for its place
      one.at = next_mm / half_mm_;
      if (ends)
        renewAnywhere(n);
      else if (std::abs(one.at.x) > 1.0F || std::abs(one.at.y) > 1.0F || std::abs(one.at.z) > 1.0F)
        renewWhereItComesIn(n, flow, begin);
    }
    fastest_mmPerS_ = fastest_mmPerS;
  }
}

}  // namespace ew::detail
