#include "ew/phantom/speckle.h"

#include <bit>
#include <cmath>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr int kReach = 2;
constexpr std::size_t kBorders = 2 * std::size_t{kReach};
constexpr std::array<std::int32_t, 5> kTaps{1, 4, 6, 4, 1};
// A scatterer's part is the number of bits set among 32, less 16: variance 8. The taps' squares sum to 70 in each direction.
constexpr double kMeanPower = 2.0 * 8.0 * 70.0 * 70.0 * 70.0;

std::int64_t floorOf(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  return static_cast<double>(whole) > value ? whole - 1 : whole;
}

}  // namespace

double valueNoise(std::uint64_t seed, const glm::dvec3& at) {
  const std::int64_t i = floorOf(at.x), j = floorOf(at.y), k = floorOf(at.z);
  const glm::dvec3 t = at - glm::dvec3(i, j, k);
  const glm::dvec3 ease = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  const std::uint64_t place = sumOfPlace(seed, i, j, k);
  const auto valueAt = [](std::uint64_t sum) { return static_cast<double>(hashOfSum(sum) >> 40) * (2.0 / 16777215.0) - 1.0; };
  const auto along = [&](std::uint64_t sum) {
    const double from = valueAt(sum);
    return from + ease.x * (valueAt(sum + kStepsOfPlace[0]) - from);
  };
  const double nearFrom = along(place), farFrom = along(place + kStepsOfPlace[2]);
  const double nearer = nearFrom + ease.y * (along(place + kStepsOfPlace[1]) - nearFrom);
  const double farther = farFrom + ease.y * (along(place + kStepsOfPlace[1] + kStepsOfPlace[2]) - farFrom);
  return nearer + ease.z * (farther - nearer);
}

void specklePower(std::uint64_t seed, const glm::ivec3& first, const glm::ivec3& size, SpeckleScratch& scratch, std::vector<float>& power) {
  EW_EXPECTS(size.x > 0 && size.y > 0 && size.z > 0);
  const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y), slices = static_cast<std::size_t>(size.z);
  const std::size_t wide = width + kBorders, tall = height + kBorders, plane = width * height;
  const std::size_t deep = slices + kBorders;
  scratch.row.resize(2 * wide);
  scratch.plane.resize(2 * width * tall);
  scratch.stack.resize(2 * plane * deep);
  power.resize(plane * slices);

  // Real and imaginary parts lie side by side, so that each pass is one loop over both.
  for (std::size_t z = 0; z < deep; ++z) {
    const std::int64_t k = first.z + static_cast<std::int64_t>(z) - kReach;
    for (std::size_t y = 0; y < tall; ++y) {
      for (std::size_t x = 0; x < wide; ++x) {
        const std::uint64_t hash =
            hashOfPlace(seed, first.x + static_cast<std::int64_t>(x) - kReach, first.y + static_cast<std::int64_t>(y) - kReach, k);
        scratch.row[2 * x] = std::popcount(static_cast<std::uint32_t>(hash)) - 16;
        scratch.row[2 * x + 1] = std::popcount(static_cast<std::uint32_t>(hash >> 32)) - 16;
      }
      std::int32_t* out = scratch.plane.data() + 2 * width * y;
      const std::int32_t* in = scratch.row.data();
      for (std::size_t x = 0; x < 2 * width; ++x)
        out[x] = kTaps[0] * (in[x] + in[x + 8]) + kTaps[1] * (in[x + 2] + in[x + 6]) + kTaps[2] * in[x + 4];
    }
    const std::size_t step = 2 * width;
    std::int32_t* out = scratch.stack.data() + 2 * plane * z;
    for (std::size_t y = 0; y < height; ++y, out += step) {
      const std::int32_t* in = scratch.plane.data() + step * y;
      for (std::size_t x = 0; x < step; ++x)
        out[x] = kTaps[0] * (in[x] + in[x + 4 * step]) + kTaps[1] * (in[x + step] + in[x + 3 * step]) + kTaps[2] * in[x + 2 * step];
    }
  }
  const std::size_t step = 2 * plane;
  for (std::size_t z = 0; z < slices; ++z) {
    const std::int32_t* in = scratch.stack.data() + step * z;
    float* out = power.data() + plane * z;
    for (std::size_t n = 0; n < plane; ++n) {
      std::int64_t parts[2];
      for (std::size_t part = 0; part < 2; ++part) {
        const std::int32_t* at = in + 2 * n + part;
        parts[part] = kTaps[0] * (at[0] + at[4 * step]) + kTaps[1] * (at[step] + at[3 * step]) + kTaps[2] * at[2 * step];
      }
      out[n] = static_cast<float>(static_cast<double>(parts[0] * parts[0] + parts[1] * parts[1]) / kMeanPower);
    }
  }
}

Decibel::Decibel() {
  // Rounded to 1/1024 dB, so that the last bit of a machine's logarithm does not reach the voxels.
  for (std::size_t n = 0; n < mantissa_.size(); ++n)
    mantissa_[n] = static_cast<float>(std::round(10240.0 * std::log10(1.0 + (static_cast<double>(n) + 0.5) / 2048.0)) / 1024.0);
}

float Decibel::of(float power) const {
  constexpr float kLeast = 1.0F / 1048576.0F;
  const auto bits = std::bit_cast<std::uint32_t>(power > kLeast ? power : kLeast);
  const int exponent = static_cast<int>(bits >> 23) - 127;
  return static_cast<float>(exponent) * 3.0103F + mantissa_[(bits >> 12) & 2047u];
}

}  // namespace ew
