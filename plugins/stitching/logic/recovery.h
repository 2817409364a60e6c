#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/io/file_lock.h"

namespace ew::stitching {

/// Where the windows of one person keep unsaved work: each has a place of its own in `folder` (unsaved-N.json, with a lock that lives as
/// long as the window), so that no window writes over, offers or removes what another one is at work on. What a window leaves that ended
/// without being asked stays until somebody decides about it.
class RecoveryPlace {
 public:
  /// Takes the first place that no window has and in which nothing was left. Where nothing can be locked (a medium without locks, a folder
  /// that cannot be written) the place is as good as none, and what is kept there may be offered too early.
  explicit RecoveryPlace(std::filesystem::path folder);

  /// The number of the place: what else must not be shared with another window is called after it.
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] std::filesystem::path file() const { return fileOf(number_); }

  /// Numbers of places in which windows that are gone left something, the latest first.
  [[nodiscard]] std::vector<int> left() const;
  [[nodiscard]] std::filesystem::path fileOf(int number) const;
  /// Somebody decided: what was left there goes.
  void forget(int number) const;

 private:
  [[nodiscard]] std::filesystem::path lockOf(int number) const;

  std::filesystem::path folder_;
  int number_ = 1;
  std::optional<FileLock> lock_;  ///< its file stays: were it removed, two windows could hold two files of one name
};

}  // namespace ew::stitching
