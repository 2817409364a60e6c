#include "ew/imaging/bands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <new>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace ew::bands_test {
namespace {

TEST(Bands, HandOutEveryRowOnceWhateverTheNumberOfThreads) {
  for (const int threads : {1, 2, 3, 8}) {
    Bands bands(threads);
    EXPECT_EQ(bands.threads(), threads);
    for (const int rows : {0, 1, 7, 8, 9, 64, 65, 768, 1001}) {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(rows));
      bands.run(rows, [&](int firstRow, int rowCount, int) {
        for (int y = firstRow; y < firstRow + rowCount; ++y) ++visits.at(static_cast<std::size_t>(y));
      });
      for (const auto& count : visits) ASSERT_EQ(count, 1) << threads << " threads, " << rows << " rows";
    }
  }
}

TEST(Bands, NeverUseASlotTwiceAtATime) {
  constexpr int kThreads = 4;
  Bands bands(kThreads);
  std::vector<std::atomic<int>> inUse(kThreads);
  std::atomic<int> clashes = 0;
  for (int frame = 0; frame < 200; ++frame)
    bands.run(256, [&](int, int, int slot) {
      if (slot < 0 || slot >= kThreads || inUse[static_cast<std::size_t>(slot)]++ != 0) ++clashes;
      if (slot >= 0 && slot < kThreads) --inUse[static_cast<std::size_t>(slot)];
    });
  EXPECT_EQ(clashes, 0);
}

TEST(Bands, HandOutEveryItemOnceAndFewOfThemToSeveralThreads) {
  for (const int threads : {1, 2, 3}) {
    Bands bands(threads);
    for (const int items : {0, 1, 2, 3, 9}) {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(items));
      std::vector<std::atomic<int>> inUse(static_cast<std::size_t>(threads));
      std::atomic<int> clashes = 0;
      bands.runEach(items, [&](int item, int slot) {
        if (inUse.at(static_cast<std::size_t>(slot))++ != 0) ++clashes;
        ++visits.at(static_cast<std::size_t>(item));
        --inUse.at(static_cast<std::size_t>(slot));
      });
      for (const auto& count : visits) ASSERT_EQ(count, 1) << threads << " threads, " << items << " items";
      EXPECT_EQ(clashes, 0);
    }
  }
}

TEST(Bands, HandOutItemsInTheirOrderOnOneThread) {
  std::vector<int> order;
  Bands(1).runEach(4, [&](int item, int) { order.push_back(item); });
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3}));
}

/// In plain memory, so that the thread sanitizer (preset tsan) sees a hand-over that is none.
TEST(Bands, LeaveWhatItemsAndRowsWroteToWhoeverAsksNext) {
  constexpr int kItems = 97;
  for (const int threads : {1, 2, 3}) {
    Bands bands(threads);
    std::vector<int> written(kItems), bySlot(static_cast<std::size_t>(threads));
    for (int frame = 1; frame <= 40; ++frame) {
      bands.runEach(kItems, [&](int item, int slot) {
        written[static_cast<std::size_t>(item)] += item;
        ++bySlot[static_cast<std::size_t>(slot)];
      });
      // Others read what one wrote.
      bands.run(kItems, [&](int first, int count, int slot) {
        for (int item = first; item < first + count; ++item)
          bySlot[static_cast<std::size_t>(slot)] += written[static_cast<std::size_t>(item)];
      });
    }
    EXPECT_EQ(std::accumulate(bySlot.begin(), bySlot.end(), 0), 40 * kItems + (40 * 41 / 2) * (kItems * (kItems - 1) / 2)) << threads;
  }
}

/// In plain memory, as above.
TEST(Bands, StayReadyForOneStepAfterAnotherOfAFrame) {
  constexpr int kItems = 41, kSteps = 9, kFrames = 60;
  for (const int threads : {1, 2, 3}) {
    Bands bands(threads);
    std::vector<int> from(kItems, 1), to(kItems);
    std::vector<std::atomic<int>> inUse(static_cast<std::size_t>(threads));
    std::atomic<int> clashes = 0;
    int serial = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
      const auto caller = std::this_thread::get_id();
      bands.together([&] {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        for (int step = 0; step < kSteps; ++step) {
          bands.runEach(kItems, [&](int item, int slot) {
            if (inUse.at(static_cast<std::size_t>(slot))++ != 0) ++clashes;
            // What others wrote a step before.
            to[static_cast<std::size_t>(item)] = (from[static_cast<std::size_t>((item + 1) % kItems)] + item) % 1000;
            --inUse.at(static_cast<std::size_t>(slot));
          });
          std::swap(from, to);
          serial += from[0];
        }
      });
      // Also without staying.
      bands.run(kItems, [&](int first, int count, int) {
        for (int item = first; item < first + count; ++item) to[static_cast<std::size_t>(item)] = from[static_cast<std::size_t>(item)] ^ 1;
      });
      std::swap(from, to);
    }
    std::vector<int> expectedFrom(kItems, 1), expectedTo(kItems);
    int expectedSerial = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
      for (int step = 0; step < kSteps; ++step) {
        for (int item = 0; item < kItems; ++item)
          expectedTo[static_cast<std::size_t>(item)] = (expectedFrom[static_cast<std::size_t>((item + 1) % kItems)] + item) % 1000;
        std::swap(expectedFrom, expectedTo);
        expectedSerial += expectedFrom[0];
      }
      for (int& number : expectedFrom) number ^= 1;
    }
    EXPECT_EQ(from, expectedFrom) << threads;
    EXPECT_EQ(serial, expectedSerial) << threads;
    EXPECT_EQ(clashes, 0) << threads;
  }
}

/// Whether a second slot comes to the items of a job before this one is over. A busy machine may take its time.
class SecondSlot {
 public:
  bool comes(int slot) {
    seen_.at(static_cast<std::size_t>(slot)) = true;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < end) {
      if (std::count_if(seen_.begin(), seen_.end(), [](const auto& seen) { return seen.load(); }) > 1) return true;
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    return false;
  }

 private:
  std::array<std::atomic<bool>, 8> seen_{};
};

TEST(Bands, HaveOtherThreadsHelpInEveryStepOfAFrameAlsoAfterTheySlept) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "for want of a second processor";
  Bands bands(2);
  for (int frame = 0; frame < 5; ++frame)
    bands.together([&] {
      for (int step = 0; step < 4; ++step) {
        SecondSlot second;
        bands.runEach(2, [&](int, int slot) { EXPECT_TRUE(second.comes(slot)) << frame << ", " << step; });
        std::this_thread::sleep_for(std::chrono::milliseconds(step));  // longer than anybody stays awake
      }
    });
}

TEST(Bands, SeveralOwnersMayMakeFramesAtTheSameTime) {
  std::atomic<int> rows = 0;
  const auto makeFrames = [&] {
    Bands bands(8);  // more than there are processors
    for (int frame = 0; frame < 50; ++frame)
      bands.together([&] {
        for (int step = 0; step < 5; ++step) bands.run(64, [&](int, int count, int) { rows += count; });
      });
  };
  std::thread other(makeFrames);
  makeFrames();
  other.join();
  EXPECT_EQ(rows, 2 * 50 * 5 * 64);
}

TEST(Bands, StayReadyOnceForFramesWithinFrames) {
  Bands bands(2);
  std::atomic<int> steps = 0;
  bands.together([&] {
    bands.together([&] { bands.runEach(2, [&](int item, int) { steps += item == 0 ? 1 : 0; }); });
    bands.runEach(2, [&](int item, int) { steps += item == 0 ? 1 : 0; });
  });
  EXPECT_EQ(steps, 2);
}

TEST(Bands, ThrowOnWhatAnItemOrAFrameThrowsAndGoOn) {
  for (const int threads : {1, 2, 3}) {
    Bands bands(threads);
    for (int thrower = 0; thrower < 12; ++thrower) {
      const auto throwing = [&](int item, int) {
        if (item == thrower) throw std::bad_alloc();
      };
      EXPECT_THROW(bands.runEach(12, throwing), std::bad_alloc);
      int reached = 0;
      EXPECT_THROW(bands.together([&] {
        ++reached;
        bands.runEach(12, throwing);
        ++reached;
      }),
                   std::bad_alloc);
      EXPECT_EQ(reached, 1);
      EXPECT_THROW(bands.together([] { throw std::length_error("between two runs"); }), std::length_error);
      std::atomic<int> items = 0;
      bands.together([&] { bands.runEach(12, [&](int, int) { ++items; }); });
      EXPECT_EQ(items, 12) << threads;
    }
  }
}

TEST(Bands, ZeroThreadsMeansOnePerProcessor) { EXPECT_GE(Bands(0).threads(), 1); }

TEST(Bands, SeveralOwnersMayRunAtTheSameTimeInsideEachOther) {
  Bands outer(2), inner(2);
  std::atomic<int> rows = 0;
  outer.run(64, [&](int, int outerRows, int) {
    for (int n = 0; n < outerRows; ++n) inner.run(32, [&](int, int innerRows, int) { rows += innerRows; });
  });
  EXPECT_EQ(rows, 64 * 32);
}

}  // namespace
}  // namespace ew::bands_test
