#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace ew::test {

#ifdef __SANITIZE_ADDRESS__
/// The sanitizer for undefined behaviour opens a pipe to see whether an object can be read; without one it takes sound objects for broken.
/// Which of them it looks at differs from run to run.
inline constexpr bool kSanitizerOpensFiles = true;
#else
inline constexpr bool kSanitizerOpensFiles = false;
#endif

/// No file can be opened while this lives, as in a program that has all it may have. Opens nothing itself that stays; what is open goes on.
class NoMoreOpenFiles {
 public:
  NoMoreOpenFiles() {
    const int lowestFree = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (lowestFree < 0) return;
    ::close(lowestFree);
    if (::getrlimit(RLIMIT_NOFILE, &usual_) != 0) return;
    rlimit tight = usual_;
    tight.rlim_cur = static_cast<rlim_t>(lowestFree);  // a new file would get the lowest number that is free
    isTight_ = ::setrlimit(RLIMIT_NOFILE, &tight) == 0;
  }
  ~NoMoreOpenFiles() {
    if (isTight_) ::setrlimit(RLIMIT_NOFILE, &usual_);
  }
  NoMoreOpenFiles(const NoMoreOpenFiles&) = delete;
  NoMoreOpenFiles& operator=(const NoMoreOpenFiles&) = delete;
  [[nodiscard]] bool isTight() const { return isTight_; }

 private:
  rlimit usual_{};
  bool isTight_ = false;
};

}  // namespace ew::test
