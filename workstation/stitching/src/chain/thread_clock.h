#pragma once

#include <ctime>

namespace ew::stitching {

/// The processor time that the calling thread has worked since the clock was made. Unlike time on the wall it does not grow while other
/// programs, or other work of this one, have the processor. Asked by the thread that made it.
class ThreadClock {
 public:
  [[nodiscard]] double seconds() const { return now() - started_; }

 private:
  [[nodiscard]] static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double started_ = now();
};

}  // namespace ew::stitching
