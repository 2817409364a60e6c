#pragma once

namespace ew {

namespace detail {

/// One for the whole program: plugins carry core inside, and a mark of their own would say nothing of the window's thread.
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
inline thread_local int responsiveMarks = 0;

}  // namespace detail

/// Marks the thread that makes it, as long as it lives, as one on which people see every pause: a window's. Whatever may wait for a disk,
/// or parse what can be long, expects not to run there (EW_EXPECTS(!isResponsiveThread())); such work belongs into a job. Marks nest. Made
/// and destroyed on one thread.
class ResponsiveThread {
 public:
  ResponsiveThread() { ++detail::responsiveMarks; }
  ~ResponsiveThread() { --detail::responsiveMarks; }
  ResponsiveThread(const ResponsiveThread&) = delete;
  ResponsiveThread& operator=(const ResponsiveThread&) = delete;
};

/// Whether the thread that asks is marked.
[[nodiscard]] inline bool isResponsiveThread() { return detail::responsiveMarks > 0; }

}  // namespace ew
