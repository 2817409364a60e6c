#include "ew/imaging/bands.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

#include "ew/core/contract.h"
#include "ew/core/parallel.h"

namespace ew {
namespace {

// Bands a thread: rows near the middle of a fan are longer, and other programs take processors away, so that equal shares end late.
constexpr int kBandsPerThread = 4;
constexpr int kFewestRows = 8;  // below, starting a task costs more than its rows
constexpr int kMostShares = 32;

/// Items in a row that one thread begins with. A line of memory each.
struct alignas(64) Share {
  std::atomic<int> next{0};
  int end = 0;
};

}  // namespace

struct Bands::Arena {
  // Before other work (ew/core/parallel.h): somebody looks at the image.
  // More threads than processors would only wait for each other, and oneTBB says so on the terminal.
  explicit Arena(int threads) : arena(std::min(threads, tbb::info::default_concurrency()), 1, tbb::task_arena::priority::high) {}
  tbb::task_arena arena;
};

Bands::Bands(int threads) : threads_(threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {
  EW_EXPECTS(threads >= 0);
  if (threads_ > 1) arena_ = std::make_unique<Arena>(threads_);
}
Bands::~Bands() = default;
Bands::Bands(Bands&&) noexcept = default;
Bands& Bands::operator=(Bands&&) noexcept = default;

void Bands::runErased(int rows, void* work, Erased call) {
  if (rows <= 0) return;
  const int bands = std::min(kBandsPerThread * threads_, (rows + kFewestRows - 1) / kFewestRows);
  if (!arena_ || bands < 2) return call(work, 0, rows, 0);
  const auto rowOf = [&](int band) { return static_cast<int>(static_cast<long long>(rows) * band / bands); };
  runEach(bands, [&](int band, int slot) { call(work, rowOf(band), rowOf(band + 1) - rowOf(band), slot); });
}

void Bands::runEachErased(int items, void* work, Erased call) {
  if (!arena_ || items < 2) {
    for (int item = 0; item < items; ++item) call(work, item, 1, 0);
    return;
  }
  // A thread begins with a share of its own, the same from call to call, and goes on with those of others: nobody waits for a thread that
  // is still waking, or whose processor is taken away.
  const int takers = std::min(threads_, items), shareCount = std::min(takers, kMostShares);
  std::array<Share, kMostShares> shares;
  const auto firstOf = [&](int share) { return static_cast<int>(static_cast<long long>(items) * share / shareCount); };
  for (int n = 0; n < shareCount; ++n) {
    Share& share = shares[static_cast<std::size_t>(n)];
    share.next.store(firstOf(n), std::memory_order_relaxed);
    share.end = firstOf(n + 1);
  }
  const auto takeItems = [&](int slot) {
    for (int n = 0; n < shareCount; ++n) {
      Share& share = shares[static_cast<std::size_t>((slot + n) % shareCount)];
      for (int item = share.next++; item < share.end; item = share.next++) call(work, item, 1, slot);
    }
  };
#ifdef __SANITIZE_THREAD__
  // oneTBB is built without the sanitizer, which would not see how a thread is handed its band.
  callOnThreads(takers, threads_, takeItems);
#else
  arena_->arena.execute([&] {
    tbb::parallel_for(
        0, takers, [&](int) { takeItems(tbb::this_task_arena::current_thread_index()); }, tbb::simple_partitioner());
  });
#endif
}

}  // namespace ew
