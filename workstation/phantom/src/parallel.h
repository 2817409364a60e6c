#pragma once

#include <algorithm>
#include <atomic>
#include <string_view>
#include <thread>
#include <vector>

#include "ew/core/progress.h"

namespace ew::phantom {

/// Threads to use for a request; 0 or less asks for one per processor.
inline int threadCount(int asked) {
  return asked > 0 ? std::min(asked, 256) : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

/// Runs work(n) for n in [0, count), each once, in no fixed order. A piece of work should take well under 100 ms: cancellation is asked
/// between pieces. Returns false when cancelled. Only the calling thread reports progress.
template <class Work>
bool parallelFor(int count, int threads, Progress& progress, std::string_view what, const Work& work) {
  std::atomic<int> next{0};
  std::atomic<bool> cancelled{false};
  const auto run = [&](bool reports) {
    for (int n = next++; n < count; n = next++) {
      if (cancelled.load(std::memory_order_relaxed) || progress.cancelRequested()) {
        cancelled = true;
        return;
      }
      work(n);
      if (reports) progress.report(what, static_cast<double>(std::min(next.load(), count)) / count);
    }
  };
  std::vector<std::jthread> others;
  const int helpers = std::min(threadCount(threads), count) - 1;
  for (int n = 0; n < helpers; ++n) others.emplace_back(run, false);
  run(true);
  others.clear();
  return !cancelled;
}

}  // namespace ew::phantom
