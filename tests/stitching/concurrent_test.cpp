#include "chain/concurrent.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <vector>

namespace ew::stitching::beside_test {
namespace {

class Recorder final : public Progress {
 public:
  void report(const Message&, double fraction) override {
    const std::lock_guard lock(guard);
    fractions.push_back(fraction);
  }
  [[nodiscard]] bool cancelRequested() const override { return cancel; }
  std::mutex guard;
  std::vector<double> fractions;
  std::atomic<bool> cancel{false};
};

TEST(BesideEachOther, DoesEveryPieceOnceAndProgressNeverGoesBack) {
  for (const int atOnce : {1, 2, 5}) {
    Recorder progress;
    std::vector<std::atomic<int>> done(23);
    const auto all = runConcurrently(done.size(), atOnce, progress, [&](std::size_t n, Progress& own) -> Result<void> {
      own.report(verbatim("half"), 0.5);
      own.report(verbatim("back"), 0.2);
      ++done[n];
      return {};
    });
    EXPECT_TRUE(all);
    for (const auto& each : done) EXPECT_EQ(each, 1);
    EXPECT_TRUE(std::is_sorted(progress.fractions.begin(), progress.fractions.end()));
    EXPECT_LE(progress.fractions.back(), 1.0);
  }
}

TEST(BesideEachOther, SaysWhatFailedAndStopsTheRest) {
  for (const int atOnce : {1, 3}) {
    Recorder progress;
    std::atomic<int> begun{0};
    const auto all = runConcurrently(200, atOnce, progress, [&](std::size_t n, Progress& own) -> Result<void> {
      ++begun;
      if (n == 4) return failure(ErrorCode::badField, verbatim("the fourth"));
      if (own.cancelRequested()) return failure(ErrorCode::cancelled, verbatim("stopped"));
      return {};
    });
    ASSERT_FALSE(all);
    EXPECT_EQ(all.error().message, verbatim("the fourth"));
    EXPECT_LT(begun, 200);
  }
}

TEST(BesideEachOther, IsCancelledBetweenPieces) {
  Recorder progress;
  const auto all = runConcurrently(50, 2, progress, [&](std::size_t n, Progress&) -> Result<void> {
    if (n == 3) progress.cancel = true;
    return {};
  });
  ASSERT_FALSE(all);
  EXPECT_EQ(all.error().code, ErrorCode::cancelled);
}

TEST(BesideEachOther, OfNothingIsDone) {
  EXPECT_TRUE(
      runConcurrently(0, 4, noProgress(), [](std::size_t, Progress&) -> Result<void> { return failure(ErrorCode::badField, Message()); }));
}

}  // namespace
}  // namespace ew::stitching::beside_test
