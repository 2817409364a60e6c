#pragma once

#include <sys/resource.h>

#include <csignal>

namespace ew::test {

/// No file grows beyond so many bytes while this lives: what a full medium, or one's share of it, does to whoever writes. A write that
/// passes the limit is done in part.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &usual_);
    rlimit tight = usual_;
    tight.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &tight);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &usual_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit usual_{};
  void (*handler_)(int);
};

}  // namespace ew::test
