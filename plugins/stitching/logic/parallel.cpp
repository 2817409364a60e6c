#include "logic/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace ew::stitching {

bool forEachIndex(std::size_t count, int threads, const char* what, Progress& progress, const std::function<void(std::size_t)>& body) {
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t workers = std::min(std::max<std::size_t>(count, 1), threads > 0 ? static_cast<std::size_t>(threads) : cores);
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> finished{0};
  std::atomic<bool> stop{false};
  std::mutex failureGuard;
  std::exception_ptr failed;

  const auto work = [&](bool reports) {
    for (std::size_t index = next++; index < count && !stop; index = next++) {
      if (progress.cancelRequested()) {
        stop = true;
        return;
      }
      try {
        body(index);
      } catch (...) {
        const std::lock_guard lock(failureGuard);
        if (!failed) failed = std::current_exception();
        stop = true;
        return;
      }
      ++finished;
      if (reports) progress.report(what, static_cast<double>(finished) / static_cast<double>(count));
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < workers; ++i) helpers.emplace_back(work, false);
    work(true);
  }
  if (failed) std::rethrow_exception(failed);
  return finished == count;
}

}  // namespace ew::stitching
