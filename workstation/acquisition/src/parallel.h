#pragma once

#include <atomic>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "ew/core/progress.h"

namespace ew {

/// The threads to work with: `asked`, or all cores when it is 0.
[[nodiscard]] inline int workersFor(int asked) {
  if (asked > 0) return asked;
  const unsigned cores = std::thread::hardware_concurrency();
  return cores == 0 ? 1 : static_cast<int>(cores);
}

/// Calls work(task, worker, stopped) once for every task in [0, tasks), in up to `workers` threads of which the caller is one; worker is in
/// [0, workers). `stopped()` asks the progress and turns true for every worker as soon as one saw the wish to cancel.
/// `work` must not throw. Returns false when cancelled: then some tasks were not done.
template <class Work>
bool forEachTask(int tasks, int workers, Progress& progress, std::string_view what, const Work& work) {
  std::atomic<int> next{0};
  std::atomic<bool> cancelled{false};
  std::mutex reporting;
  int done = 0;
  const auto stopped = [&] {
    if (cancelled.load(std::memory_order_relaxed)) return true;
    if (!progress.cancelRequested()) return false;
    cancelled.store(true, std::memory_order_relaxed);
    return true;
  };
  const auto run = [&](int worker) {
    for (int task = next.fetch_add(1); task < tasks && !stopped(); task = next.fetch_add(1)) {
      work(task, worker, stopped);
      const std::lock_guard lock(reporting);
      progress.report(what, static_cast<double>(++done) / tasks);
    }
  };
  std::vector<std::thread> others;
  const int wanted = workers < tasks ? workers : tasks;
  try {
    others.reserve(static_cast<std::size_t>(wanted));
    for (int worker = 1; worker < wanted; ++worker) others.emplace_back(run, worker);
  } catch (const std::system_error&) {
    // No more threads to be had: those there are do the work, the voxels are the same.
  }
  run(0);
  for (std::thread& other : others) other.join();
  return !stopped();
}

}  // namespace ew
