#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace ew {

/// A thread that does one thing after another. Whoever owns it makes it the last member, so that it ends first: what it was given and has
/// not begun is dropped then. Tasks throw nothing.
class Worker {
 public:
  Worker();
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void add(std::function<void()> task);
  /// Of those that were added, with the one at work.
  [[nodiscard]] std::size_t waiting() const;

 private:
  void run();
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  bool isAtWork_ = false;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace ew
