#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "ew/core/message.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// Keeps other programs, and other threads, from doing the same at the same time. Held until destroyed; the system frees it with the
/// process, also when that is killed. Where the file system knows no locks nothing is locked: two programs then do the same work, and write
/// the same files.
class FileLock {
 public:
  enum class Kind { alone, shared };
  /// @param mode of a file that is not there yet, less what the umask takes
  /// @return nothing when somebody holds it in a way that excludes this one
  /// @error notWritable (the file of the lock cannot be made)
  [[nodiscard]] static Result<std::optional<FileLock>> tryTake(const std::filesystem::path& file, Kind kind = Kind::alone,
                                                               mode_t mode = 0666);
  /// The same for work of milliseconds: waits at most 3 s for whoever holds it.
  [[nodiscard]] static Result<std::optional<FileLock>> tryTakeSoon(const std::filesystem::path& file);
  /// Of a file that is there already, at once. @return nothing: it is not there, is a link, somebody holds it, or it cannot be locked here
  [[nodiscard]] static std::optional<FileLock> tryTakeExisting(const std::filesystem::path& file);
  /// Waits for whoever holds it.
  /// @param waiting what is reported meanwhile
  /// @error notWritable, cancelled
  [[nodiscard]] static Result<FileLock> take(const std::filesystem::path& file, const Message& waiting, Progress& progress,
                                             mode_t mode = 0666);
  /// Of a folder itself, so that nothing is left behind in it. Waits for whoever holds it; where it cannot be locked it is none.
  [[nodiscard]] static FileLock takeFolder(const std::filesystem::path& folder);
  /// Locks a file that is open until it is closed; waits for whoever holds it. @return false, with errno: it cannot be locked
  [[nodiscard]] static bool holdOpen(int descriptor);
  ~FileLock();
  FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileLock& operator=(FileLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace ew
