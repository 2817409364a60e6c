#pragma once

namespace ew {

extern "C" {
/// How often the thread is marked. One for the whole program: plugins carry core inside, and marks of their own would say nothing of the
/// window's thread. A program that opens plugins exports the symbol (EW_EXPORT_THREAD_MARK in cmake/EwTargets.cmake).
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
inline thread_local int ewResponsiveMarks = 0;
}

/// Marks the thread that makes it, as long as it lives, as one on which people see every pause: a window's. Whatever may wait for a disk,
/// or parse what can be long, expects not to run there (EW_EXPECTS(!isResponsiveThread())); such work belongs into a job. Marks nest. Made
/// and destroyed on one thread.
class ResponsiveThread {
 public:
  ResponsiveThread() { ++ewResponsiveMarks; }
  ~ResponsiveThread() { --ewResponsiveMarks; }
  ResponsiveThread(const ResponsiveThread&) = delete;
  ResponsiveThread& operator=(const ResponsiveThread&) = delete;
};

/// Whether the thread that asks is marked.
[[nodiscard]] inline bool isResponsiveThread() { return ewResponsiveMarks > 0; }

}  // namespace ew
