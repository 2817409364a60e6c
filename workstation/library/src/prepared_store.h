#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "ew/core/progress.h"
#include "ew/core/volume.h"

namespace ew {

/// What a step of a preparation made. A part without voxels is one that the step does not make.
struct Prepared {
  Volume volume;  ///< with coverage
  Volume labels;  ///< a label per voxel in its `echo`
};

/// 32 hexadecimal digits of everything that shapes a result, one after the other. Parts do not run into one another.
class ContentHash {
 public:
  ContentHash& add(std::string_view text);
  ContentHash& add(double number);
  ContentHash& add(std::uint64_t number);
  [[nodiscard]] std::string text() const;

 private:
  std::string collected_;
};

/// One result in the cache: files of one name, and beside them `NAME.json`, which is written last and carries the hashes of what the others
/// hold. So a half-written result is none, and a damaged one is noticed.
class PreparedStore {
 public:
  PreparedStore() = default;
  PreparedStore(std::filesystem::path folder, std::string name) : folder_(std::move(folder)), name_(std::move(name)) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Whether a result was written to its end. Damage is only noticed by reading.
  [[nodiscard]] bool isThere() const;
  /// @error as readVolume; badHeader (damaged)
  [[nodiscard]] Result<Prepared> read(Progress& progress) const;
  /// @error notWritable, cancelled
  [[nodiscard]] Result<void> write(const Prepared& made, Progress& progress) const;
  [[nodiscard]] std::filesystem::path fileWithEnding(const std::string& ending) const { return folder_ / (name_ + ending); }

 private:
  std::filesystem::path folder_;
  std::string name_;
};

/// Keeps other programs from making the same thing at the same time. Held until destroyed, also when the program is killed.
class PreparationLock {
 public:
  /// Waits for whoever holds it. Where the file system knows no locks, or the file cannot be made, nothing is locked: two programs then do
  /// the same work, and write the same files.
  /// @error cancelled
  [[nodiscard]] static Result<PreparationLock> take(const std::filesystem::path& file, Progress& progress);
  ~PreparationLock();
  PreparationLock(PreparationLock&& other) noexcept : descriptor_(other.descriptor_) { other.descriptor_ = -1; }
  PreparationLock& operator=(PreparationLock&&) = delete;

 private:
  explicit PreparationLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace ew
