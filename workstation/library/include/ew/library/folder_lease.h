#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "ew/core/result.h"

namespace ew {

/// Who has a folder.
struct LeaseHolder {
  std::string user;
  std::string host;
  long long process = 0;
  std::chrono::sys_seconds since{};  ///< by the holder's clock
  bool operator==(const LeaseHolder&) const = default;
};

struct LeaseOptions {
  /// A lease that was not refreshed for so long, by the clock of whoever keeps the files, is nobody's any more.
  std::chrono::seconds staleAfter{120};
};

/// A folder that one window at a time edits, between programs and between workstations that share the folder over a network. Not a lock of
/// the system, which many network file systems keep on one machine only, but a file ".ew-lease-N" in the folder, which the holder
/// refreshes. N grows by one with every holder, and the file with the highest N counts; it is made by a link to a finished file, which
/// fails when there is one. So whoever takes over from a holder that has died, or that was suspended for minutes, does so once, however
/// slowly: who comes second finds the number taken. The last file stays behind, marked as free, to remember the number.
///
/// A program that was suspended and goes on after somebody else has taken over learns of it from refresh(): then it must not write any
/// more.
class FolderLease {
 public:
  /// @error notWritable (somebody has it: names who and since when; or the folder cannot be written)
  [[nodiscard]] static Result<FolderLease> take(const std::filesystem::path& folder, const LeaseOptions& options = {});
  /// Tells others that the holder is there; to be called every 30 s.
  /// @error notWritable (somebody else has taken over, and who; or the folder is gone)
  [[nodiscard]] Result<void> refresh();
  /// Who has the folder now; nothing when nobody has, or nobody that still lives.
  [[nodiscard]] static std::optional<LeaseHolder> holderOf(const std::filesystem::path& folder, const LeaseOptions& options = {});

  ~FolderLease();  ///< frees the folder
  FolderLease(FolderLease&& other) noexcept;
  FolderLease& operator=(FolderLease&& other) noexcept;

 private:
  FolderLease(std::filesystem::path folder, long long number) : folder_(std::move(folder)), number_(number) {}
  void free();

  std::filesystem::path folder_;
  long long number_ = 0;  // 0: it holds nothing
};

/// Whether a file of a case folder is a lease: it belongs to the folder, not to the case, and is not copied with it.
[[nodiscard]] bool isLeaseFile(const std::filesystem::path& name);

}  // namespace ew
