#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "ew/core/result.h"
#include "ew/library/attempt.h"
#include "ew/library/case.h"
#include "ew/library/passphrase.h"

namespace ew {

// Who may do what on one account that instructors and trainees share: the only place that decides it, below the window, the command line
// and the plugins' door. An instructor locks a library with a passphrase; from then on the program shows trainees what trainees may see.
//
// What a lock does not do: whoever can read the account's files with another program can read them. What must stay secret from trainees at
// the same account travels sealed (sealed_answers.h); other people's attempts are safe in an account of their own (attempt.h).

enum class Permission {
  seeAnswers,         ///< findings, targets, right answers: in details, lists, files that are shown or exported
  editCases,          ///< make, change, publish cases; the Author workspace
  exportCases,        ///< hand on a case with everything in it
  seeOthersAttempts,  ///< attempts and progress of anybody but oneself
  judge,              ///< score, rate, report; the Review workspace
  changeLock          ///< set, change or take away the lock
};

inline constexpr int kAccessFormat = 1;  ///< of access.json; a larger one leaves the library locked

/// LIBRARY/access.json, mode 0600: {"format": 1, "passphrase": the Argon2id hash, "locked_by"}.
[[nodiscard]] std::filesystem::path accessFile(const std::filesystem::path& library);

/// What may be done with a library now. A copy has a state of its own.
class AccessPolicy {
 public:
  /// A policy without a lock: everything may be done.
  AccessPolicy() = default;
  /// As the library's access.json says. What cannot be read or understood locks: a damaged file opens no door.
  [[nodiscard]] static AccessPolicy of(const std::filesystem::path& library);

  /// There is a lock, whether it is open now or not.
  [[nodiscard]] bool hasLock() const { return hasLock_; }
  [[nodiscard]] bool isLocked() const { return isLocked_; }
  [[nodiscard]] bool may(Permission) const { return !isLocked_; }
  /// @error badUsage, with what to do, while it is locked
  [[nodiscard]] Result<void> require(Permission permission) const;

  /// Opens it for as long as this policy lives. Written into the instructors' log, as is a wrong passphrase.
  /// @param person whom the window greets; empty on the command line
  /// @error badUsage (another passphrase), notReadable (access.json is not what the program wrote)
  [[nodiscard]] Result<void> unlock(const Passphrase& passphrase, const std::string& person = {});
  /// Closes it again; nothing without a lock.
  void lockAgain();

  [[nodiscard]] const std::filesystem::path& library() const { return library_; }

 private:
  std::filesystem::path library_;
  std::string hash_;
  std::optional<Error> problem_;
  bool hasLock_ = false;
  bool isLocked_ = false;
};

/// Sets the lock, or changes its passphrase. @param policy of the library; locked when this returns
/// @error as AccessPolicy::require (a lock is there and closed), checkNewPassphrase; notWritable: then everything is as before
[[nodiscard]] Result<void> setLock(AccessPolicy& policy, const Passphrase& passphrase, const std::string& person = {},
                                   const PassphraseCost& cost = {});
/// @error as AccessPolicy::require; notWritable
[[nodiscard]] Result<void> removeLock(AccessPolicy& policy, const std::string& person = {});

/// Whether a library has a lock; whoever changes it between two looks is noticed: a policy that was made before knows nothing of it.
[[nodiscard]] bool hasLock(const std::filesystem::path& library);

/// What may be shown of a case: the case itself, or, while the library is locked, what its trainees may read before they examine. Of a
/// sealed case it is the case, for it holds nothing else.
[[nodiscard]] Case shownCase(const Case& opened, const AccessPolicy& policy);

/// Whether somebody may open or read an attempt: their own (as countsFor has it), or anybody's who may see others'.
/// @error badUsage with what to do
[[nodiscard]] Result<void> mayOpen(const Attempt& attempt, const std::string& person, const AccessPolicy& policy);

}  // namespace ew
