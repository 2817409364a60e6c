#pragma once

namespace ew {

/// While it lives, the calling thread does work that nobody waits for: it gives way to others (nice), and what it calls by callOnThreads or
/// forEachTask (ew/core/parallel.h) runs on threads of its own, as low in priority as it is. The shared ones belong to everybody and give
/// way to nobody. The thread keeps its priority afterwards: only a privileged program may raise it again.
class QuietWork {
 public:
  /// @param nice 0 (as others) to 19 (only what is left over); a thread that is lower already stays so
  explicit QuietWork(int nice);
  ~QuietWork();
  QuietWork(const QuietWork&) = delete;
  QuietWork& operator=(const QuietWork&) = delete;

 private:
  bool wasShared_;
};

}  // namespace ew
