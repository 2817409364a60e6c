#include "ew/imaging/bands.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

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

/// Whether something comes about within the next moments, asked all the time; whoever wakes from sleep comes later than that.
template <class Done>
bool comesSoon(const Done& isDone) {
  constexpr std::chrono::microseconds kSoon(50);
  constexpr int kAtATime = 16;
  for (const auto end = std::chrono::steady_clock::now() + kSoon; std::chrono::steady_clock::now() < end;)
    for (int n = 0; n < kAtATime; ++n) {
      if (isDone()) return true;
#if defined(__x86_64__)
      __builtin_ia32_pause();
#endif
    }
  return false;
}

/// What was thrown first on one of several threads, for the one that waits for them all.
class FirstThrown {
 public:
  template <class Work>
  void watch(const Work& work) {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
    }
  }
  /// Nobody is watched meanwhile.
  void throwOn() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

 private:
  std::mutex mutex_;
  std::exception_ptr thrown_;
};

/// Threads that stay ready for one job after another of a leader. Who waits longer than a moment sleeps.
class Crew {
 public:
  [[nodiscard]] bool isLedHere() const { return leader_.load(std::memory_order_relaxed) == std::this_thread::get_id(); }
  void begin(int slot) {
    EW_EXPECTS(open_ == kEnded);
    slot_ = slot;
    open_ = kClosed;
    leader_.store(std::this_thread::get_id(), std::memory_order_relaxed);
  }
  void end() {
    leader_.store({}, std::memory_order_relaxed);
    open_ = kEnded;
    open_.notify_all();
  }
  /// Of the leader. Who helps counts itself as inside before it looks whether the job is still open, and the leader looks who is inside
  /// after it closed the job: a helper that has not come yet is not waited for.
  void lead(int items, int takers, void* work, Job::Call call) {
    EW_EXPECTS(open_ == kClosed);  // an item runs nothing on the same bands
    job_.set(items, takers, work, call);
    number_ = std::max(number_ + 1, kFirst);  // it begins anew after four thousand million jobs
    open_ = number_;
    open_.notify_all();
    thrown_.watch([&] { job_.take(slot_); });
    open_ = kClosed;
    if (!comesSoon([&] { return inside_ == 0; }))
      for (int inside = inside_; inside != 0; inside = inside_) inside_.wait(inside);
    thrown_.throwOn();
  }
  void help(int slot) {
    std::uint32_t last = kClosed;
    for (std::uint32_t seen = open_; seen != kEnded; seen = open_) {
      const auto isSame = [&] { return seen == kClosed || seen == last; };
      if (isSame()) {
        if (!comesSoon([&] { return open_ != seen; })) open_.wait(seen);
        continue;
      }
      ++inside_;
      if (const std::uint32_t own = open_; own >= kFirst) {
        thrown_.watch([&] { job_.take(slot); });
        last = own;
      }
      if (--inside_ == 0) inside_.notify_all();
    }
  }

 private:
  static constexpr std::uint32_t kClosed = 0, kEnded = 1, kFirst = 2;
  Job job_;
  FirstThrown thrown_;
  int slot_ = 0;                                         ///< the leader's
  std::uint32_t number_ = kFirst;                        ///< of the last job
  alignas(64) std::atomic<std::uint32_t> open_{kEnded};  ///< the job's number, or none is open, or none will be
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
  FirstThrown thrown;
  const auto take = [&](int slot) { thrown.watch([&] { job.take(slot); }); };
  const int takers = std::min(threads_, items);
#ifdef __SANITIZE_THREAD__
  // oneTBB is built without the sanitizer, which would not see how a thread is handed its band.
  callOnThreads(takers, threads_, take);
#else
  arena_->arena.execute([&] {
    tbb::parallel_for(
        0, takers, [&](int) { take(tbb::this_task_arena::current_thread_index()); }, tbb::simple_partitioner());
  });
#endif
  thrown.throwOn();
}

void Bands::togetherErased(void* frame, Erased call) {
  if (!arena_ || arena_->crew.isLedHere()) return call(frame, 0, 0, 0);
  Crew& crew = arena_->crew;
  FirstThrown thrown;
  const auto lead = [&](int slot) {
    thrown.watch([&] { call(frame, 0, 0, slot); });
    crew.end();
  };
#ifdef __SANITIZE_THREAD__
  // Who helps stays until the frame ends, so that the caller, which is the first, is left one of the calls.
  crew.begin(0);
  callOnThreads(threads_, threads_, [&](int slot) {
    if (slot != 0 || !crew.isLedHere()) return crew.help(slot);
    lead(slot);
  });
#else
  arena_->arena.execute([&] {
    const auto slotHere = [] { return tbb::this_task_arena::current_thread_index(); };
    tbb::task_group helpers;
    crew.begin(slotHere());
    for (int n = 1; n < arena_->arena.max_concurrency(); ++n) helpers.run([&] { crew.help(slotHere()); });
    lead(slotHere());
    helpers.wait();
  });
#endif
  thrown.throwOn();
}

}  // namespace ew
