#include "ew/io/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

namespace ew {

namespace fs = std::filesystem;

Result<std::optional<FileLock>> FileLock::tryTake(const fs::path& file, Kind kind, mode_t mode) {
  FileLock lock(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, mode));
  if (lock.descriptor_ < 0)
    return failure(ErrorCode::notWritable,
                   say<"The folder '%1' cannot be written (%2); choose one you may write to.">(
                       file.parent_path().string(), verbatim(std::generic_category().message(errno))),
                   {{"file", file.parent_path().string()}});
  const int how = (kind == Kind::alone ? LOCK_EX : LOCK_SH) | LOCK_NB;
  if (::flock(lock.descriptor_, how) != 0 && (errno == EWOULDBLOCK || errno == EINTR)) return std::optional<FileLock>();
  return std::optional(std::move(lock));
}

Result<FileLock> FileLock::take(const fs::path& file, const Message& waiting, Progress& progress) {
  while (true) {
    auto taken = tryTake(file);
    if (!taken) return passOn(taken.error());
    if (*taken) return std::move(**taken);
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Waiting for another program was cancelled.">());
    progress.report(waiting, 0.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace ew
