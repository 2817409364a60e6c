#include "ew/imaging/bands.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
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

/// Work that is handed out item by item.
class Job {
 public:
  using Call = void (*)(void* work, int item, int count, int slot);
  /// Nobody takes items meanwhile.
  void set(int items, int takers, void* work, Call call) {
    work_ = work;
    call_ = call;
    shareCount_ = std::min({items, takers, kMostShares});
    const auto firstOf = [&](int share) { return static_cast<int>(static_cast<long long>(items) * share / shareCount_); };
    for (int n = 0; n < shareCount_; ++n) {
      Share& share = shares_[static_cast<std::size_t>(n)];
      share.next.store(firstOf(n), std::memory_order_relaxed);
      share.end = firstOf(n + 1);
    }
  }
  /// A thread begins with a share of its own, the same from call to call, and goes on with those of others: nobody waits for a thread that
  /// is still waking, or whose processor is taken away.
  void take(int slot) {
    for (int n = 0; n < shareCount_; ++n) {
      Share& share = shares_[static_cast<std::size_t>((slot + n) % shareCount_)];
      for (int item = share.next++; item < share.end; item = share.next++) call_(work_, item, 1, slot);
    }
  }

 private:
  void* work_ = nullptr;
  Call call_ = nullptr;
  int shareCount_ = 0;
  std::array<Share, kMostShares> shares_;
};

/// Waits a little, and longer the longer it lasts.
void waitALittle(int already) {
  constexpr int kSpins = 2000;  // some ten microseconds
  if (already > kSpins) return std::this_thread::yield();
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Threads that stay ready for one job after another of a leader.
class Crew {
 public:
  [[nodiscard]] bool isLedHere() const { return leader_.load(std::memory_order_relaxed) == std::this_thread::get_id(); }
  void begin(int slot) {
    slot_ = slot;
    ended_ = false;
    leader_.store(std::this_thread::get_id(), std::memory_order_relaxed);
  }
  void end() {
    leader_.store({}, std::memory_order_relaxed);
    ended_ = true;
  }
  /// Of the leader. Who helps counts itself as inside before it looks whether the job is still open, and the leader looks who is inside
  /// after it closed the job: a helper that has not come yet is not waited for.
  void lead(int items, int takers, void* work, Job::Call call) {
    job_.set(items, takers, work, call);
    open_ = ++number_;
    job_.take(slot_);
    open_ = kClosed;
    for (int n = 0; inside_ != 0; ++n) waitALittle(n);
  }
  void help(int slot) {
    std::uint64_t last = kClosed;
    for (int idle = 0; !ended_; ++idle) {
      if (const std::uint64_t seen = open_; seen == kClosed || seen == last) {
        waitALittle(idle);
        continue;
      }
      ++inside_;
      if (const std::uint64_t own = open_; own != kClosed) {
        job_.take(slot);
        last = own;
      }
      --inside_;
      idle = 0;
    }
  }

 private:
  static constexpr std::uint64_t kClosed = 0;
  Job job_;
  int slot_ = 0;              ///< the leader's
  std::uint64_t number_ = 0;  ///< of jobs so far
  alignas(64) std::atomic<std::uint64_t> open_{kClosed};
  std::atomic<bool> ended_{true};
  alignas(64) std::atomic<int> inside_{0};
  std::atomic<std::thread::id> leader_{};
};

}  // namespace

struct Bands::Arena {
  // Before other work (ew/core/parallel.h): somebody looks at the image.
  // More threads than processors would only wait for each other, and oneTBB says so on the terminal.
  explicit Arena(int threads) : arena(std::min(threads, tbb::info::default_concurrency()), 1, tbb::task_arena::priority::high) {}
  tbb::task_arena arena;
  Crew crew;
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
  if (arena_->crew.isLedHere()) return arena_->crew.lead(items, threads_, work, call);
  Job job;
  job.set(items, threads_, work, call);
  const int takers = std::min(threads_, items);
#ifdef __SANITIZE_THREAD__
  // oneTBB is built without the sanitizer, which would not see how a thread is handed its band.
  callOnThreads(takers, threads_, [&](int slot) { job.take(slot); });
#else
  arena_->arena.execute([&] {
    tbb::parallel_for(
        0, takers, [&](int) { job.take(tbb::this_task_arena::current_thread_index()); }, tbb::simple_partitioner());
  });
#endif
}

void Bands::togetherErased(void* frame, Erased call) {
  if (!arena_) return call(frame, 0, 0, 0);
  Crew& crew = arena_->crew;
#ifdef __SANITIZE_THREAD__
  // Who helps stays until the frame ends, so that the caller, which is the first, is left one of the calls.
  crew.begin(0);
  callOnThreads(threads_, threads_, [&](int slot) {
    if (slot != 0 || !crew.isLedHere()) return crew.help(slot);
    call(frame, 0, 0, slot);
    crew.end();
  });
#else
  arena_->arena.execute([&] {
    const auto slotHere = [] { return tbb::this_task_arena::current_thread_index(); };
    tbb::task_group helpers;
    crew.begin(slotHere());
    for (int n = 1; n < arena_->arena.max_concurrency(); ++n) helpers.run([&] { crew.help(slotHere()); });
    call(frame, 0, 0, slotHere());
    crew.end();
    helpers.wait();
  });
#endif
}

}  // namespace ew
