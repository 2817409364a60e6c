#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/io/file_lock.h"

namespace ew {

/// A folder below `root` that one program has for itself, with a lock in it for as long as the program lives (0700): what lies in a folder
/// that nobody holds was left behind by one that ended without being asked. Without locks (some network file systems) what a program still
/// has may be offered to another; nothing is lost by it. Not for several threads at once.
class OwnFolder {
 public:
  /// Name of the file that is locked.
  static constexpr const char* kLock = "lock";

  /// @param root need not be there yet; nothing is made before make()
  explicit OwnFolder(std::filesystem::path root) : root_(std::move(root)) {}
  ~OwnFolder() { leave(); }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }  ///< empty: not made
  [[nodiscard]] bool isMade() const { return lock_.has_value(); }

  /// Makes it, when it is not there; the rest of the path is made as makePrivateFolder does. @return what stands in the way; empty: nothing
  [[nodiscard]] std::string make();
  /// It goes, with everything in it.
  void remove();
  /// It stays, as if the program had ended.
  void leave();

  /// Writes a note of what lies in the folder, whole or not at all; where it is not made there is nothing to write to. @error notWritable
  [[nodiscard]] Result<void> writeNote(const std::string& file, const nlohmann::json& note) const;

  /// What a program that is gone has left: its folder and the note in it.
  struct Left {
    std::filesystem::path folder;
    nlohmann::json note;  ///< an object
    std::filesystem::file_time_type written;
  };
  /// Those that have such a note, the latest first. One that cannot be read is not among them. @param file of the note, at most 8 MiB
  [[nodiscard]] std::vector<Left> leftWith(const std::string& file) const;
  /// Somebody has decided about what was left: these files go, and the folder when nothing else lies in it.
  static void discard(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

  /// Folders of programs that are gone, this one not among them.
  [[nodiscard]] std::vector<std::filesystem::path> left() const;
  /// The lock of a folder whose program is gone; nothing: it lives, somebody else has taken the folder, or there is none.
  [[nodiscard]] static std::optional<FileLock> lockOfAbandoned(const std::filesystem::path& folder);

 private:
  std::filesystem::path root_, folder_;
  std::optional<FileLock> lock_;
};

/// A time of a file on the clock that people read.
[[nodiscard]] std::chrono::system_clock::time_point systemTimeOf(std::filesystem::file_time_type time);

}  // namespace ew
