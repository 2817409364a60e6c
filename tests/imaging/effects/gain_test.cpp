#include "ew/imaging/effects/gain.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ew::gain_test {
namespace {

using Sliders = std::array<double, kDgcSliders>;

Sliders anySliders() {
  Sliders sliders{};
  for (double& slider : sliders) slider = *rc::gen::inRange(0, 400) / 100.0;
  return sliders;
}

TEST(DgcCurve, PassesThroughTheSlidersAndIsConstantBeyondThem) {
  const Sliders sliders{0.5, 1.5, 1.2, 0.2, 0.3, 2.0, 1.9, 0.7};
  for (std::size_t k = 0; k < sliders.size(); ++k) EXPECT_NEAR(dgcAt(sliders, (static_cast<double>(k) + 0.5) / 8.0), sliders[k], 1e-12);
  EXPECT_EQ(dgcAt(sliders, 0.0), 0.5);
  EXPECT_EQ(dgcAt(sliders, 0.05), 0.5);
  EXPECT_EQ(dgcAt(sliders, 1.0), 0.7);
}

TEST(DgcCurve, NeverLeavesTheRangeOfTwoNeighbouringSlidersAndIsMonotoneBetweenThem) {
  EXPECT_TRUE(rc::check("range", [] {
    const Sliders sliders = anySliders();
    for (std::size_t k = 0; k + 1 < sliders.size(); ++k) {
      const auto [low, high] = std::minmax(sliders[k], sliders[k + 1]);
      double before = sliders[k];
      for (int n = 0; n <= 50; ++n) {
        const double value = dgcAt(sliders, (static_cast<double>(k) + 0.5 + n / 50.0) / 8.0);
        RC_ASSERT(value >= low - 1e-12 && value <= high + 1e-12);
        RC_ASSERT((value - before) * (sliders[k + 1] - sliders[k]) >= -1e-12);
        before = value;
      }
    }
  }));
}

TEST(DgcCurve, HasNoCornersAtTheSliders) {
  const Sliders sliders{0.2, 0.9, 1.3, 2.0, 2.1, 1.0, 0.4, 0.3};
  const double h = 1e-6;
  for (int k = 0; k < kDgcSliders; ++k) {
    const double at = (k + 0.5) / 8.0;
    const double left = (dgcAt(sliders, at) - dgcAt(sliders, at - h)) / h;
    const double right = (dgcAt(sliders, at + h) - dgcAt(sliders, at)) / h;
    EXPECT_NEAR(left, right, 1e-3) << "slider " << k;
  }
}

TEST(GainTable, IsEquationFiveRoundedOnce) {
  EXPECT_TRUE(rc::check("Eq. 5", [] {
    const Sliders sliders = anySliders();
    const double gain = *rc::gen::inRange(0, 1000) / 100.0;
    const std::vector<double> rows = {0.0, 0.11, 0.5, 0.77, 1.0};
    std::vector<std::uint8_t> table;
    buildGainTable(gain, sliders, rows, table);
    RC_ASSERT(table.size() == 256U * 5U);
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (std::size_t v = 0; v < 256; ++v) {
        const double exact = std::min(gain * std::min(dgcAt(sliders, rows[row]) * static_cast<double>(v), 255.0), 255.0);
        RC_ASSERT(std::abs(table[256 * row + v] - exact) <= 0.5 + 1e-9);
        // Not with "v == 0 ||" inside: RC_ASSERT looks at both sides, and there is nothing before the first level.
        if (v > 0) RC_ASSERT(table[256 * row + v] >= table[256 * row + v - 1]);
      }
  }));
}

TEST(GainTable, OfNeutralFactorsChangesNothing) {
  const Sliders ones{1, 1, 1, 1, 1, 1, 1, 1};
  const std::vector<double> rows = {0.0, 0.3, 1.0};
  std::vector<std::uint8_t> table;
  buildGainTable(1.0, ones, rows, table);
  for (std::size_t n = 0; n < table.size(); ++n) ASSERT_EQ(table[n], n % 256);
}

TEST(GainTable, IsAppliedRowByRow) {
  std::vector<std::uint8_t> table(512);
  for (std::size_t v = 0; v < 256; ++v) {
    table[v] = static_cast<std::uint8_t>(v);
    table[256 + v] = static_cast<std::uint8_t>(255 - v);
  }
  GreyImage image(3, 2);
  image.pixels = {1, 2, 3, 4, 5, 6};
  applyGainTable(viewOf(image), Spans(2, {{0, 3}}), table);
  EXPECT_EQ(image.pixels, (std::vector<std::uint8_t>{1, 2, 3, 251, 250, 249}));
  const Spans spans = {{}, {{0, 1}, {2, 3}}};
  applyGainTable(viewOf(image), spans, table);
  EXPECT_EQ(image.pixels, (std::vector<std::uint8_t>{1, 2, 3, 4, 250, 6}));
}

}  // namespace
}  // namespace ew::gain_test
