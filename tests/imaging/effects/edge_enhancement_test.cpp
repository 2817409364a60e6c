#include "ew/imaging/effects/edge_enhancement.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace ew::edge_enhancement_test {
namespace {

Spans wholeSpans(int width, int height) { return Spans(static_cast<std::size_t>(height), {{0, width}}); }

template <class Value>
GreyImage imageOf(int width, int height, const Value& value) {
  GreyImage image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) viewOf(image).at(x, y) = static_cast<std::uint8_t>(value(x, y));
  return image;
}

GreyImage enhanced(double strength, const GreyImage& in, const Spans& spans, std::uint8_t around = 0) {
  GreyImage out(in.width, in.height, around);
  enhanceEdges(strength, spans, viewOf(in), 0, in.height, viewOf(out));
  return out;
}

TEST(EdgeEnhancement, LeavesConstantsAndRampsAsTheyAre) {
  for (const double strength : {0.0, 0.3, 1.0}) {
    for (const int grey : {0, 1, 77, 255}) {
      const GreyImage constant(150, 9, static_cast<std::uint8_t>(grey));
      EXPECT_EQ(enhanced(strength, constant, wholeSpans(150, 9)), constant);
    }
    const GreyImage ramp = imageOf(80, 20, [](int x, int y) { return 10 + x + 5 * y; });
    EXPECT_EQ(enhanced(strength, ramp, wholeSpans(80, 20)), ramp);
  }
}

TEST(EdgeEnhancement, OvershootsAStepByFiveAndByOneEighthOfItsHeight) {
  for (const bool upright : {true, false})
    for (const double strength : {0.25, 0.5, 1.0})
      for (const int height : {8, 40, 80}) {
        const auto step = [&](int x, int y) { return 100 + ((upright ? x : y) >= 20 ? height : 0); };
        const GreyImage out = enhanced(strength, imageOf(40, 40, step), wholeSpans(40, 40));
        const auto at = [&](int n) { return static_cast<double>(upright ? viewOf(out).at(n, 15) : viewOf(out).at(15, n)); };
        for (const auto& [from, to, share] : {std::tuple{19, 20, 5.0 / 8.0}, std::tuple{18, 21, 1.0 / 8.0}, std::tuple{17, 22, 0.0}}) {
          EXPECT_NEAR(at(from), 100.0 - share * strength * height, 0.6);
          EXPECT_NEAR(at(to), 100.0 + height + share * strength * height, 0.6);
        }
      }
}

/// Runs as of a convex fan: two beside the face, one below, narrower at the bottom; a hole and gaps of every size.
Spans anySpans(std::mt19937& random, int width, int height) {
  Spans spans(static_cast<std::size_t>(height));
  const bool ragged = random() % 3 == 0;
  int begin = static_cast<int>(random() % 9), end = width - static_cast<int>(random() % 9), hole = static_cast<int>(random() % 30);
  for (auto& row : spans) {
    if (ragged) begin = static_cast<int>(random() % 40);
    begin = std::clamp(begin + static_cast<int>(random() % 5) - 2, 0, width);
    end = std::clamp(end + static_cast<int>(random() % 5) - 2, 0, width);
    const int middle = (begin + end) / 2;
    if (hole > 0 && begin < middle - hole && middle + hole < end) {
      row = {{begin, middle - hole}, {middle + hole, end}};
    } else if (begin < end) {
      row = {{begin, end}};
    }
    hole -= static_cast<int>(random() % 5);
  }
  return spans;
}

TEST(EdgeEnhancement, IsItsFormulaWhereTheFanSurroundsAPixelAndTheSamePixelElsewhere) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 120; ++trial) {
    const int width = 1 + static_cast<int>(random() % 400), height = 1 + static_cast<int>(random() % 24);
    const Spans spans = anySpans(random, width, height);
    const double strength = (trial % 5) / 4.0;
    const GreyImage in = imageOf(width, height, [&](int, int) { return random() % 4 ? random() % 256 : 255 * (random() % 2); });
    const GreyImage out = enhanced(strength, in, spans, 99);
    GreyImage inside(width, height);
    for (int y = 0; y < height; ++y)
      for (const RowSpan& span : spans[static_cast<std::size_t>(y)])
        for (int x = span.begin; x < span.end; ++x) viewOf(inside).at(x, y) = 1;
    constexpr std::array kWeights = {1, 4, 6, 4, 1};
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const std::uint8_t v = viewOf(in).at(x, y), shown = viewOf(out).at(x, y);
        if (viewOf(inside).at(x, y) == 0) {
          ASSERT_EQ(shown, 99);
          continue;
        }
        bool surrounded = true;
        double mean = 0.0;
        for (int dy = -2; dy <= 2; ++dy)
          for (int dx = -2; dx <= 2; ++dx) {
            const int u = x + dx, w = y + dy;
            const bool within = u >= 0 && u < width && w >= 0 && w < height && viewOf(inside).at(u, w) == 1;
            surrounded = surrounded && within;
            if (within)
              mean += kWeights[static_cast<std::size_t>(dx + 2)] * kWeights[static_cast<std::size_t>(dy + 2)] * viewOf(in).at(u, w) / 256.0;
          }
        if (surrounded)
          ASSERT_NEAR(shown, std::clamp(v + 2.0 * strength * (v - mean), 0.0, 255.0), 0.6) << x << ", " << y << " trial " << trial;
        else
          ASSERT_EQ(shown, v) << x << ", " << y << " trial " << trial;
      }
  }
}

TEST(EdgeEnhancement, InBandsOfRowsGivesTheSameImage) {
  std::mt19937 random(8);
  const Spans spans = anySpans(random, 130, 31);
  const GreyImage in = imageOf(130, 31, [&](int, int) { return random() % 256; });
  GreyImage banded(130, 31);
  for (const auto& [first, rows] : {std::pair{12, 19}, std::pair{0, 1}, std::pair{1, 11}})
    enhanceEdges(0.7, spans, viewOf(in), first, rows, viewOf(banded));
  EXPECT_EQ(banded, enhanced(0.7, in, spans));
}

TEST(EdgeEnhancement, OfAStrengthThatIsNoneCopiesAndOfMoreThanOneIsThatOfOne) {
  std::mt19937 random(9);
  const GreyImage in = imageOf(70, 12, [&](int, int) { return random() % 256; });
  const Spans spans = wholeSpans(70, 12);
  for (const double none : {0.0, -3.0, std::numeric_limits<double>::quiet_NaN()}) EXPECT_EQ(enhanced(none, in, spans), in);
  EXPECT_EQ(enhanced(std::numeric_limits<double>::infinity(), in, spans), enhanced(1.0, in, spans));
}

}  // namespace
}  // namespace ew::edge_enhancement_test
