#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/attempt_result.h"
#include "ew/library/case.h"
#include "ew/records/record_store_settings.h"
#include "ew/records/statement_outbox.h"
#include "ew/records/xapi.h"
#include "run/command.h"

namespace ew::cli {

/// What the commands of `records` can be given.
struct RecordsArguments {
  std::vector<std::string> attempts;
  std::string library, outbox, settings;
  std::string language = "en";
  bool names = false;
  bool dryRun = false;
  // send
  int rounds = 8;
  double timeout_s = 60.0;
  bool retriesRefused = false;
  // settings
  std::optional<std::string> endpoint, user, homePage, activityBase, certificates;
  std::string login, secretFrom;
  bool allowsHttp = false, forbidsHttp = false, asks = false, forgets = false, noKeyring = false;
  // launch
  std::string url;
  std::string person;           ///< what the learner is called in their attempts; empty: as the launch calls them
  std::string window;           ///< program of the window; empty: the one beside this program
  bool isWantedByHand = false;  ///< the learner is not asked

  [[nodiscard]] std::filesystem::path libraryPlace() const { return library.empty() ? libraryFolder() : std::filesystem::path(library); }
  [[nodiscard]] std::filesystem::path outboxPlace() const {
    return outbox.empty() ? recordOutboxFolder(libraryPlace()) : std::filesystem::path(outbox);
  }
  [[nodiscard]] Result<std::filesystem::path> settingsPlace() const {
    return settings.empty() ? recordSettingsFolder() : Result<std::filesystem::path>(settings);
  }
  [[nodiscard]] SecretOptions secrets() const { return {!noKeyring, 60.0}; }
};

/// What was taken, sent or set stays, whatever happens next.
inline void staysDone(Run& run) {
  run.isPublished = true;
  run.stopped = {};
}

/// --settings and --no-keyring.
void addSettingsPlace(CLI::App& app, RecordsArguments& arguments);
/// What the library knows of an attempt's lesson, as a trainee may read it; without it statements name steps by their ids.
void addLessonTo(XapiOptions& options, const Attempt& attempt, AttemptResults& results, const std::string& language);
/// Whether a score has to be made before an attempt is told: there is none by its plan, or one of an earlier way of scoring.
[[nodiscard]] bool needsScore(const AttemptResult& result, const AssessmentPlan& plan);
/// What is told of an attempt: what an instructor sees. Where the lesson has a plan and the attempt no score by it, it is scored now; what
/// keeps it from that is remarked, and it is told as its lesson judged it. @param keeps the score, beside the attempt
/// @error cancelled; as readPlan, for nobody knows then what counts
[[nodiscard]] Result<AttemptResult> resultToTell(const std::filesystem::path& folder, const Attempt& attempt, AttemptResults& results,
                                                 const std::filesystem::path& library, bool keeps, Run& run);
/// `records launch`.
void addRecordLaunch(CLI::App& group, Selection& selection, const std::shared_ptr<RecordsArguments>& arguments);
/// `records settings`.
void addRecordSettings(CLI::App& group, Selection& selection, const std::shared_ptr<RecordsArguments>& arguments);

}  // namespace ew::cli
