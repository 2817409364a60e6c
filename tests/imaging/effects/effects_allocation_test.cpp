#include <gtest/gtest.h>

#include "ew/imaging/adaptive_quality.h"
#include "ew/imaging/effects/edge_enhancement.h"
#include "ew/imaging/effects/gain.h"
#include "ew/imaging/effects/persistence.h"
#include "ew/imaging/latency.h"
#include "ew/imaging/m_mode.h"
#include "imaging/support/count_allocations.h"

namespace ew::effects_allocation_test {
namespace {

TEST(EffectsOnTheImage, AllocateNothingOnceTheirSizeIsKnown) {
  constexpr int kWidth = 200, kHeight = 150;
  const Spans spans(kHeight, {{20, 90}, {95, 180}});
  const std::vector<double> rows(kHeight, 0.4);
  const std::vector<std::uint8_t> beam(333, 77);
  GreyImage image(kWidth, kHeight, 90), sharp = image;
  std::vector<std::uint8_t> table;
  PersistenceMemory memory;
  MModeStrip strip;
  AdaptiveQuality quality;
  LatencyHistogram latency;
  const auto frame = [&](int n) {
    buildGainTable(1.0 + 0.01 * n, {1, 1, 2, 1, 1, 1, 1, 1}, {.dynamicRange_db = 50.0 + n, .map = GreyMap::soft}, rows, table);
    enhanceEdges(0.5, spans, viewOf(image), 0, kHeight, viewOf(sharp));
    beginPersistence(kWidth, kHeight, memory);
    persist(0.5, spans, 0, kHeight, viewOf(sharp), memory);
    applyGainTable(viewOf(sharp), spans, table);
    strip.configure(kWidth, kHeight, 2.0);
    strip.add(0.03 * n * n, beam);
    (void)quality.step({}, {}, 0.03 * n, 20.0);
    latency.add(20.0 * n);
  };
  frame(0);
  const std::size_t before = testing::allocationCount();
  for (int n = 1; n < 40; ++n) frame(n);
  EXPECT_EQ(testing::allocationCount(), before);
}

}  // namespace
}  // namespace ew::effects_allocation_test
