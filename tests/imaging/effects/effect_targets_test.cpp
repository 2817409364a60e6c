#include <gtest/gtest.h>

#include <random>
#include <string>

#include "ew/imaging/effects/edge_enhancement.h"
#include "ew/imaging/effects/gain.h"
#include "ew/imaging/effects/persistence.h"
#include "imaging/support/every_target.h"

namespace ew::effect_targets_test {
namespace {

GreyImage noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  GreyImage image(width, height);
  for (std::uint8_t& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random() % 3 ? random() : 255 * (random() % 2));
  return image;
}

/// Runs of every length up to 300, at every place within a vector.
Spans runsOfEveryLength(int width, int height) {
  Spans spans;
  for (int y = 0; y < height; ++y) spans.push_back({{y % 7, y % 7 + 1 + y % 300}, {y % 7 + 302, width - y % 70}});
  return spans;
}

constexpr int kWidth = 700, kHeight = 310;

TEST(EveryVectorUnit, LooksUpEdgesAndPersistenceToTheSamePixels) {
  const Spans spans = runsOfEveryLength(kWidth, kHeight);
  std::vector<std::uint8_t> table(256 * static_cast<std::size_t>(kHeight));
  std::mt19937 random(2);
  for (std::uint8_t& entry : table) entry = static_cast<std::uint8_t>(random());
  GreyImage looked, lookedWhole, sharp, persisted;
  std::vector<std::uint16_t> levels;
  int targets = 0;
  testing::onEveryTarget([&](const char* name) {
    GreyImage a = noise(kWidth, kHeight, 1), whole = a, b(kWidth, kHeight), c = a;
    applyGainTable(viewOf(a), spans, table);
    applyGainTable(viewOf(whole), Spans(kHeight, {{0, kWidth}}), table);
    const GreyImage in = noise(kWidth, kHeight, 1);
    enhanceEdges(0.83, Spans(kHeight, {{0, kWidth}}), viewOf(in), 0, kHeight / 2, viewOf(b));
    enhanceEdges(0.83, spans, viewOf(in), kHeight / 2, kHeight - kHeight / 2, viewOf(b));
    PersistenceMemory memory;
    for (unsigned frame = 0; frame < 30; ++frame) {
      c = noise(kWidth, kHeight, frame / 10);
      beginPersistence(kWidth, kHeight, memory);
      persist(0.83, spans, 0, kHeight, viewOf(c), memory);
    }
    if (targets++ == 0) {
      looked = a;
      lookedWhole = whole;
      sharp = b;
      persisted = c;
      levels = memory.levels;
    }
    EXPECT_EQ(a, looked) << name;
    EXPECT_EQ(whole, lookedWhole) << name;
    EXPECT_EQ(b, sharp) << name;
    EXPECT_EQ(c, persisted) << name;
    EXPECT_EQ(memory.levels, levels) << name;
  });
  EXPECT_GE(targets, 1);
}

}  // namespace
}  // namespace ew::effect_targets_test
