#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "ew/core/image.h"

/// Pairs of two-dimensional images with a displacement known exactly: both are drawn from one continuous pattern.
namespace ew::test {

/// Speckle-like: smooth noise of a fine grain under patches of different brightness, everywhere defined.
class Pattern {
 public:
  /// @param grain_mm   distance of the noise's random values
  /// @param structure  grey levels by which patches differ
  Pattern(unsigned seed, double grain_mm, double speckle, double structure)
      : grain_mm_(grain_mm), speckle_(speckle), structure_(structure) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    fine_.resize(kSide * kSide);
    coarse_.resize(kSide * kSide);
    for (double& v : fine_) v = normal(random);
    for (double& v : coarse_) v = normal(random);
  }
  [[nodiscard]] double at(glm::dvec2 p_mm) const {
    const double patches = std::tanh(2.0 * noise(coarse_, p_mm / 9.0));
    return 120.0 + structure_ * patches + speckle_ * noise(fine_, p_mm / grain_mm_);
  }

 private:
  static constexpr int kSide = 256;  // values repeat after so many
  static double noise(const std::vector<double>& values, glm::dvec2 p) {
    const glm::dvec2 cell = glm::floor(p);
    const auto weights = [](double t) {
      const double s = 1.0 - t;
      return glm::dvec4(s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0, (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0,
                        t * t * t / 6.0);
    };
    const glm::dvec4 wx = weights(p.x - cell.x), wy = weights(p.y - cell.y);
    double sum = 0.0;
    for (int b = 0; b < 4; ++b) {
      for (int a = 0; a < 4; ++a) {
        const int x = (static_cast<int>(cell.x) + a + 64 * kSide) % kSide, y = (static_cast<int>(cell.y) + b + 64 * kSide) % kSide;
        sum += wx[a] * wy[b] * values[static_cast<std::size_t>(y * kSide + x)];
      }
    }
    return 2.0 * sum;
  }
  double grain_mm_, speckle_, structure_;
  std::vector<double> fine_, coarse_;
};

using Motion = std::function<glm::dvec2(glm::dvec2)>;

struct Pair2d {
  GreyImage fixed;
  GreyImage moving;
};

inline std::uint8_t grey(double value) { return static_cast<std::uint8_t>(std::lround(std::fmin(255.0, std::fmax(1.0, value)))); }

/// fixed(x) = pattern(x + u(x)), moving(y) = change(other(y)): u is the truth, exactly. `other` is the pattern, or one that shares its
/// structure.
inline Pair2d pairOf(
    int side, double pixel_mm, const Pattern& pattern, const Pattern& other, const Motion& u,
    const std::function<double(double, glm::dvec2)>& change = [](double v, glm::dvec2) { return v; }) {
  Pair2d pair{GreyImage(side, side), GreyImage(side, side)};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 p{x * pixel_mm, y * pixel_mm};
      const std::size_t n = static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
      pair.fixed.pixels[n] = grey(pattern.at(p + u(p)));
      pair.moving.pixels[n] = grey(change(other.at(p), p));
    }
  }
  return pair;
}

/// A swirl and a squeeze that fade towards nothing in particular: smooth, of the given peak.
inline Motion warp(double peak_mm, double extent_mm) {
  return [=](glm::dvec2 p) {
    const double k = 2.0 * 3.141592653589793 / extent_mm;
    return peak_mm * glm::dvec2(0.8 * std::sin(k * p.y + 0.4) * std::cos(0.5 * k * p.x),
                                0.6 * std::cos(k * p.x - 0.3) * std::sin(0.7 * k * p.y + 1.0));
  };
}

/// Mean error over pixels whose mate lies in the moving image.
inline double meanError_mm(const std::vector<glm::vec2>& found, int side, double pixel_mm, const Motion& u) {
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 p{x * pixel_mm, y * pixel_mm}, truth = u(p), mate = p + truth;
      if (mate.x < 0.0 || mate.y < 0.0 || mate.x > (side - 1) * pixel_mm || mate.y > (side - 1) * pixel_mm) continue;
      const glm::vec2 here = found[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)];
      sum += glm::length(glm::dvec2(here) - truth);
      ++count;
    }
  }
  return sum / count;
}

}  // namespace ew::test
