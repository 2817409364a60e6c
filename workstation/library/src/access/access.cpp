#include "ew/library/access.h"

#include <nlohmann/json.hpp>

#include "ew/core/json_fields.h"
#include "ew/io/private_file.h"
#include "ew/library/case_start.h"
#include "ew/library/instructor_log.h"
#include "ew/library/learning_progress.h"
#include "ew/library/lesson.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kAccessFile = "access.json";

Message needed(Permission permission) {
  switch (permission) {
    case Permission::seeAnswers:
      return say<"answers are not shown">();
    case Permission::editCases:
      return say<"cases are not edited">();
    case Permission::exportCases:
      return say<"cases are not handed on">();
    case Permission::seeOthersAttempts:
      return say<"other people's attempts are not shown">();
    case Permission::judge:
      return say<"attempts are not judged">();
    case Permission::changeLock:
      return say<"the lock is not changed">();
  }
  return {};
}

/// @error badHeader, badField, newerFormat, as readPrivateFile
Result<std::string> hashKeptIn(const fs::path& library) {
  const auto text = readPrivateFile(accessFile(library), 64u << 10);
  if (!text) return passOn(text.error());
  const auto document = parseJsonObject(*text, verbatim(kAccessFile));
  if (!document) return passOn(document.error());
  JsonReading reading(verbatim(kAccessFile));
  const JsonFields fields(*document, reading);
  const auto format = fields.whole("format", 1, 1'000'000);
  if (reading.good() && format > kAccessFormat)
    return failure(ErrorCode::newerFormat,
                   say<"%1 has format %2, and this program reads formats up to %3; open it with a newer EchoWeave.">(
                       std::string(kAccessFile), format, kAccessFormat));
  std::string hash = fields.text("passphrase");
  if (reading.problem()) return passOn(*reading.problem());
  return hash;
}

bool isThere(const fs::path& file) {
  std::error_code problem;
  const auto status = fs::symlink_status(file, problem);
  return status.type() != fs::file_type::not_found;  // also what cannot be looked at
}

}  // namespace

fs::path accessFile(const fs::path& library) { return library / kAccessFile; }

bool hasLock(const fs::path& library) { return isThere(accessFile(library)); }

AccessPolicy AccessPolicy::of(const fs::path& library) {
  AccessPolicy policy;
  policy.library_ = library;
  policy.hasLock_ = policy.isLocked_ = ew::hasLock(library);
  if (!policy.hasLock_) return policy;
  auto hash = hashKeptIn(library);
  if (hash)
    policy.hash_ = std::move(*hash);
  else
    policy.problem_ = std::move(hash.error());
  return policy;
}

Result<void> AccessPolicy::require(Permission permission) const {
  if (may(permission)) return {};
  return failure(ErrorCode::badUsage,
                 say<"This library is locked for trainees, so %1; an instructor unlocks it with the passphrase (in the window, or with "
                     "--unlock).">(needed(permission)),
                 {{"library", library_.string()}});
}

Result<void> AccessPolicy::unlock(const Passphrase& passphrase, const std::string& person) {
  if (!isLocked_) return {};
  if (problem_) {
    Error problem = *problem_;
    problem.message = say<"The lock of this library cannot be opened: %1 Whoever looks after this machine can take \"%2\" away.">(
        std::move(problem.message), accessFile(library_));
    return passOn(std::move(problem));
  }
  if (!fits(passphrase, hash_)) {
    static_cast<void>(logChange(library_, "wrong passphrase", {}, {}, {}, person));  // it stays locked either way
    return failure(ErrorCode::badUsage, say<"That is not the passphrase of this library; type it again.">());
  }
  // What is not written down does not happen.
  if (auto logged = logChange(library_, "unlocked", {}, "locked", "unlocked", person); !logged) return logged;
  isLocked_ = false;
  return {};
}

void AccessPolicy::lockAgain() {
  if (!hasLock_ || isLocked_) return;
  isLocked_ = true;
  static_cast<void>(logChange(library_, "locked", {}, "unlocked", "locked"));
}

Result<void> setLock(AccessPolicy& policy, const Passphrase& passphrase, const std::string& person, const PassphraseCost& cost) {
  if (auto may = policy.require(Permission::changeLock); !may) return may;
  const fs::path library = policy.library();
  if (hasLock(library) && !policy.hasLock()) {  // somebody else set one meanwhile
    policy = AccessPolicy::of(library);
    return policy.require(Permission::changeLock);
  }
  if (auto good = checkNewPassphrase(passphrase); !good) return good;
  const auto hash = hashOf(passphrase, cost);
  if (!hash) return passOn(hash.error());
  std::error_code ignored;
  fs::create_directories(library, ignored);  // writing says what is wrong when this did not help
  const std::string what = policy.hasLock() ? "passphrase changed" : "lock set";
  if (auto logged = logChange(library, what, {}, {}, {}, person); !logged) return logged;
  const json document = {{"format", kAccessFormat}, {"passphrase", *hash}, {"locked_by", accountName(person)}};
  if (auto written = writePrivateFile(accessFile(library), document.dump(1) + "\n"); !written) return written;
  policy = AccessPolicy::of(library);
  return {};
}

Result<void> removeLock(AccessPolicy& policy, const std::string& person) {
  if (auto may = policy.require(Permission::changeLock); !may) return may;
  if (!policy.hasLock()) return {};
  const fs::path library = policy.library();
  if (auto logged = logChange(library, "lock taken away", {}, {}, {}, person); !logged) return logged;
  std::error_code problem;
  fs::remove(accessFile(library), problem);
  if (problem)
    return failure(ErrorCode::notWritable, say<"The lock \"%1\" cannot be taken away (%2); check the folder's permissions.">(
                                               accessFile(library), verbatim(problem.message())));
  policy = AccessPolicy::of(library);
  return {};
}

Case shownCase(const Case& opened, const AccessPolicy& policy) {
  if (policy.may(Permission::seeAnswers) || opened.sealed) return opened;
  Case shown = opened;
  shown.title = titleForTrainees(opened);
  shown.findings.clear();
  shown.diagnosis.clear();
  shown.differential.clear();
  shown.targets.clear();
  shown.measurements.clear();
  shown.expertPose.reset();
  for (TissueAcoustics& tissue : shown.scene.tissues) tissue.name.clear();
  for (CaseExamination& each : shown.previousExaminations) each.otherFields = json::object();
  for (CaseLaboratory& each : shown.laboratory) each.otherFields = json::object();
  shown.otherFields = json::object();
  return withPresets(std::move(shown), shippedPresetsOf(opened));
}

Result<void> mayOpen(const Attempt& attempt, const std::string& person, const AccessPolicy& policy) {
  if (attempt.person.empty() || countsFor(attempt, person)) return {};
  return policy.require(Permission::seeOthersAttempts);
}

}  // namespace ew
