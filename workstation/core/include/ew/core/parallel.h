#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <type_traits>

#include "ew/core/progress.h"

namespace ew {

/// The threads to work with: `asked`, or one per processor when it is 0 or less; at most 256.
[[nodiscard]] inline int threadCount(int asked) {
  if (asked <= 0) asked = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return std::min(asked, 256);
}

/// Calls `call` so many times on up to `workers` threads, of which the caller is one; returns when all have ended. The other threads are
/// oneTBB's, shared with whatever else runs in the program: no more work at once than there are processors, and between two calls a thread
/// may go to work of higher priority (images that somebody looks at). `call` must not throw.
/// @param call call(worker) with worker in [0, workers), no two calls at once with the same
void callOnThreads(int calls, int workers, const std::function<void(int worker)>& call);

/// Calls `work` once for every task in [0, tasks), in no fixed order, on up to threadCount(threads) threads of which the caller is one.
/// @param work work(task), or work(task, worker, stopped) with worker in [0, threadCount(threads)); `stopped()` asks the progress and turns
///             true for every worker as soon as one saw the wish to cancel. Between tasks it is asked anyway.
/// What `work` throws stops the others and is thrown again by the caller's thread once all have ended.
/// @return false when cancelled: then some tasks were not done
template <class Work>
bool forEachTask(int tasks, int threads, Progress& progress, const Message& what, const Work& work) {
  std::atomic<int> next{0};
  std::atomic<bool> cancelled{false};
  std::mutex guard;  // of what follows
  int done = 0;
  std::exception_ptr failed;
  const auto stopped = [&] {
    if (cancelled.load(std::memory_order_relaxed)) return true;
    if (!progress.cancelRequested()) return false;
    cancelled.store(true, std::memory_order_relaxed);
    return true;
  };
  // Tasks in their order, whichever call comes first.
  callOnThreads(tasks, std::min(threadCount(threads), tasks), [&](int worker) {
    const int task = next++;
    try {
      if (stopped()) return;
      if constexpr (std::is_invocable_v<const Work&, int>) {
        work(task);
      } else {
        work(task, worker, stopped);
      }
      const std::lock_guard lock(guard);
      progress.report(what, static_cast<double>(++done) / tasks);
    } catch (...) {
      const std::lock_guard lock(guard);
      if (!failed) failed = std::current_exception();
      cancelled = true;
    }
  });
  if (failed) std::rethrow_exception(failed);
  return !stopped();
}

}  // namespace ew
