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

Result<std::optional<FileLock>> FileLock::tryTakeSoon(const fs::path& file) {
  constexpr int kTries = 100;
  for (int n = 1;; ++n) {
    auto taken = tryTake(file);
    if (!taken || *taken || n == kTries) return taken;
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
}

std::optional<FileLock> FileLock::tryTakeExisting(const fs::path& file) {
  FileLock lock(::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
  if (lock.descriptor_ < 0) return std::nullopt;
  while (::flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0)
    if (errno != EINTR) return std::nullopt;
  return lock;
}

Result<FileLock> FileLock::take(const fs::path& file, const Message& waiting, Progress& progress, mode_t mode) {
  while (true) {
    auto taken = tryTake(file, Kind::alone, mode);
    if (!taken) return passOn(taken.error());
    if (*taken) return std::move(**taken);
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Waiting for another program was cancelled.">());
    progress.report(waiting, 0.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

FileLock FileLock::takeFolder(const fs::path& folder) {
  FileLock lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (lock.descriptor_ >= 0) static_cast<void>(holdOpen(lock.descriptor_));
  return lock;
}

bool FileLock::holdOpen(int descriptor) {
  while (::flock(descriptor, LOCK_EX) != 0)
    if (errno != EINTR) return false;
  return true;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace ew
