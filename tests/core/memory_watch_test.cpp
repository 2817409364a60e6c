#include "ew/core/memory_watch.h"

#include <gtest/gtest.h>

#include <vector>

namespace ew::memory_watch_test {
namespace {

constexpr std::size_t kBlock_bytes = 64U << 20;

TEST(PeakMemory, GrowsWithWhatWasTouched) {
  const double before_mib = peakMemory_mib();
  std::vector<char> block(kBlock_bytes, 1);
  EXPECT_GE(peakMemory_mib(), before_mib + 40.0) << static_cast<int>(block[block.size() / 2]);
}

TEST(MemoryWatch, TellsWhatWasTakenAndWhatIsStillHeld) {
  MemoryWatch watch;
  if (!watch.isKnown()) GTEST_SKIP() << "nobody says here what a process takes";
  { const std::vector<char> passing(kBlock_bytes, 1); }
  EXPECT_NEAR(watch.peak_mib(), 64.0, 8.0);
  EXPECT_LT(watch.held_mib(), 8.0);
  const std::vector<char> kept(kBlock_bytes / 2, 1);
  EXPECT_NEAR(watch.held_mib(), 32.0, 8.0) << static_cast<int>(kept[kept.size() / 2]);
  EXPECT_NEAR(watch.peak_mib(), 64.0, 8.0);
}

TEST(MemoryWatch, ForgetsForItselfAlone) {
  MemoryWatch watch;
  if (!watch.isKnown()) GTEST_SKIP() << "nobody says here what a process takes";
  { const std::vector<char> passing(kBlock_bytes, 1); }
  const double peak_mib = peakMemory_mib();
  ASSERT_TRUE(watch.forgetPeak());
  EXPECT_LT(watch.peak_mib(), 8.0);
  EXPECT_GE(peakMemory_mib(), peak_mib) << "of the process it stays";
}

}  // namespace
}  // namespace ew::memory_watch_test
