#include "ew/imaging/doppler_sound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace ew::doppler_sound_test {
namespace {

using std::numbers::pi;

/// Sound of a tone, without its beginning.
std::vector<glm::vec2> soundOf(double shift_hz, double prf_hz, double baseline = 0.0) {
  DopplerSound sound;
  sound.configure(prf_hz, baseline);
  std::vector<std::complex<float>> tone;
  for (int n = 0; n < static_cast<int>(prf_hz); ++n) tone.emplace_back(std::polar(1.0, 2.0 * pi * shift_hz * n / prf_hz));
  std::vector<glm::vec2> all;
  // In pieces, as frames bring them.
  for (std::size_t begin = 0; begin < tone.size(); begin += 137) {
    const auto piece = sound.add(std::span(tone).subspan(begin, std::min<std::size_t>(137, tone.size() - begin)));
    all.insert(all.end(), piece.begin(), piece.end());
  }
  EXPECT_NEAR(static_cast<double>(all.size()), 48000.0, 48000.0 * 40.0 / prf_hz);
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 10));
  return all;
}

struct Level {
  double left = 0.0, right = 0.0;      ///< root mean squares
  double atLeft = 0.0, atRight = 0.0;  ///< amplitudes of the tone that is asked for
};
Level levelOf(const std::vector<glm::vec2>& sound, double hz) {
  Level level;
  std::complex<double> left, right;
  for (std::size_t n = 0; n < sound.size(); ++n) {
    const glm::dvec2 at(sound[n]);
    level.left += at.x * at.x;
    level.right += at.y * at.y;
    const auto turn = std::polar(2.0 / static_cast<double>(sound.size()), -2.0 * pi * hz * static_cast<double>(n) / 48000.0);
    left += at.x * turn;
    right += at.y * turn;
  }
  const auto count = static_cast<double>(sound.size());
  return {std::sqrt(level.left / count), std::sqrt(level.right / count), std::abs(left), std::abs(right)};
}

TEST(DopplerSound, HasEachDirectionOnItsSide) {
  for (const double prf_hz : {2000.0, 8000.0})
    for (const double share : {0.08, 0.25, 0.4}) {
      const double hz = share * prf_hz;
      const Level towards = levelOf(soundOf(hz, prf_hz), hz), away = levelOf(soundOf(-hz, prf_hz), hz);
      EXPECT_NEAR(towards.atLeft, 1.0, 0.03) << hz;
      EXPECT_NEAR(towards.left, std::sqrt(0.5), 0.03) << hz;  // the tone and nothing else
      EXPECT_LT(towards.right, 0.02) << hz;
      EXPECT_NEAR(away.atRight, 1.0, 0.03) << hz;
      EXPECT_LT(away.left, 0.02) << hz;
    }
}

TEST(DopplerSound, GoesAroundAtTheScaleUnlessTheBaselineIsMoved) {
  constexpr double kPrf_hz = 4000.0, kShift_hz = 2600.0;
  const Level around = levelOf(soundOf(kShift_hz, kPrf_hz), kPrf_hz - kShift_hz);
  EXPECT_NEAR(around.atRight, 1.0, 0.05);  // heard as 1400 Hz away from the probe
  EXPECT_LT(around.left, 0.05);
  const Level moved = levelOf(soundOf(kShift_hz, kPrf_hz, 0.6), kShift_hz);
  EXPECT_NEAR(moved.atLeft, 1.0, 0.05);
}

}  // namespace
}  // namespace ew::doppler_sound_test
