#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/figure.h"
#include "ew/core/message.h"
#include "ew/core/result.h"
#include "ew/library/step_answer.h"

namespace ew {

class JsonFields;
struct Lesson;

inline constexpr int kAttemptFormat = 1;  ///< `format` of attempt.json; a larger one is refused with newerFormat

enum class StepVerdict {
  passed,
  failed,
  skipped,  ///< left without trying: counts as not passed
  handedIn  ///< of an examination: kept, and judged afterwards by who can open its answers; counts as not passed until then
};
/// What a verdict is called wherever people read it, in window, reports and tables: "passed", "not passed", "skipped", "handed in".
[[nodiscard]] Message verdictWord(StepVerdict verdict);
/// The same of a whole lesson.
[[nodiscard]] Message passedWord(bool passed);

/// What is said after a step.
struct AttemptRemark {
  bool good = false;  ///< what was done well; false: what was missed
  Message text;
  bool operator==(const AttemptRemark&) const = default;
};

/// What a trainee's work was worth, of a step of a lesson or of an exercise. Whatever knows more of it is one of these, too.
struct StepResult {
  double score = 0.0;  ///< 0 to 1
  StepVerdict verdict = StepVerdict::failed;
  std::vector<Figure> figures;  ///< that it was judged by
  std::vector<AttemptRemark> remarks;
  bool operator==(const StepResult&) const = default;

  [[nodiscard]] bool passed() const { return verdict == StepVerdict::passed; }
  /// This part of whatever knows more.
  [[nodiscard]] StepResult& result() { return *this; }
};
/// Of its fields "score", "verdict", "figures" and "remarks". @param most figures, and most remarks
[[nodiscard]] StepResult readStepResult(const JsonFields& fields, std::size_t most);
void writeStepResult(const StepResult& result, nlohmann::json& into);

/// How a step of an attempt ended.
struct StepOutcome : StepResult {
  std::string stepId;
  double seconds = 0.0;             ///< spent on the step, pauses left out
  int hints = 0;                    ///< that were asked for
  StepAnswer answer;                ///< what was entered, by the step's kind
  nlohmann::json otherAnswer;       ///< as it was read, where it is none of these or says more: kept as it is; null: `answer` says it all
  std::string recording;            ///< of the scan during the step, relative to the attempt's folder; empty: none was made
  std::vector<std::string> images;  ///< relative to the attempt's folder
  std::chrono::sys_seconds at{};    ///< when it ended
  nlohmann::json otherFields = nlohmann::json::object();
  bool operator==(const StepOutcome&) const = default;

  /// All that is known of what was entered, as attempt.json has it; null: nothing was.
  [[nodiscard]] nlohmann::json answerJson() const;
};

/// One trainee's way through one lesson: raw data first, so that scores can be worked out again.
struct Attempt {
  std::string id;      ///< as idOfAttempt makes it: by time, unique
  std::string caseId;  ///< of the case that holds the lesson
  std::string lessonId;
  std::string lessonTitle;    ///< as it was shown
  std::string lessonContent;  ///< ContentKey of the lesson's JSON when it was begun or last gone on with: whether it has changed since
  std::string person;         ///< who tried, as they call themselves; may be empty
  std::string program;        ///< version that judged
  std::string launch;         ///< of the learning management system's launch that began it (launchOfEnvironment); empty: nobody launched it
  std::optional<double>
      masteryScore;  ///< 0 to 1, that this system asks for (masteryScoreOfEnvironment); empty: none, or nobody launched it
  std::chrono::sys_seconds startedAt{};
  std::optional<std::chrono::sys_seconds> finishedAt;  ///< empty: stopped in the middle, and may be gone on with
  std::string runningStep;                             ///< begun and not ended yet; after a crash this is the step that was lost
  std::vector<StepOutcome> outcomes;                   ///< in the order they ended; of a step that was repeated all are kept
  nlohmann::json otherFields = nlohmann::json::object();
  bool operator==(const Attempt&) const = default;

  /// The outcome that counts: the latest of the step; null while there is none.
  [[nodiscard]] const StepOutcome* outcomeOf(const std::string& stepId) const;
};

/// "20261126-093000-1f4a91c7": sorts by time, of those made now to the millisecond; a random end keeps two workstations on one folder
/// apart.
[[nodiscard]] std::string idOfAttempt(std::chrono::sys_seconds now);

/// A launch by a learning management system is told to the window in this variable of its environment, and by the window to the attempts
/// that it begins.
inline constexpr const char* kLaunchVariable = "ECHOWEAVE_LAUNCH";
/// The launch that started this window: letters, digits, '-' and '.', at most 100 of them. Empty: none did, or it says something else.
[[nodiscard]] std::string launchOfEnvironment();
/// The mastery score of the launch is told in the same way: a number from 0 to 1, absent where the system asks for none.
inline constexpr const char* kMasteryVariable = "ECHOWEAVE_MASTERY_SCORE";
/// Empty: nothing launched this window, it was told none, or no number from 0 to 1.
[[nodiscard]] std::optional<double> masteryScoreOfEnvironment();

/// An attempt's JSON. @error badField, newerFormat (with both format numbers)
[[nodiscard]] Result<Attempt> attemptFromJson(const nlohmann::json& document);
/// attemptFromJson(jsonOf(a)) == a.
[[nodiscard]] nlohmann::json jsonOf(const Attempt& attempt);

/// An attempt on disk: ROOT/ID/attempt.json and the files that it names. attempt.json is written whole or not at all whenever a step begins
/// or ends; files of a step lie there before they are named. So a crash at any moment loses at most the step that was running, and
/// `runningStep` says which. Folders are 0700 and files 0600 whatever the umask: another account reads nothing of it.
class AttemptFolder {
 public:
  /// Makes the folder. @param root need not be there yet. @error notWritable
  [[nodiscard]] static Result<AttemptFolder> begin(const std::filesystem::path& root, Attempt attempt);
  /// @error notFound, badHeader, badField, newerFormat
  [[nodiscard]] static Result<AttemptFolder> open(const std::filesystem::path& folder);

  [[nodiscard]] const Attempt& attempt() const { return attempt_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// All of these save; when that fails, nothing has changed. @error notWritable
  [[nodiscard]] Result<void> beginStep(const std::string& stepId);
  /// @param outcome names files that lie in the folder already @param finishedAt given: the lesson has no step left, and the attempt is
  /// finished with this one
  [[nodiscard]] Result<void> endStep(StepOutcome outcome, std::optional<std::chrono::sys_seconds> finishedAt = {});
  /// The step that runs is given up, as if it had not begun.
  [[nodiscard]] Result<void> leaveStep();
  [[nodiscard]] Result<void> finish(std::chrono::sys_seconds now);
  /// The attempt goes on at the lesson as it is now: what it is judged by, from its first step on.
  [[nodiscard]] Result<void> goOnAt(const Lesson& lesson);

  /// A name for a file of a step that is not there yet: "step-03-find-the-kidney.seq.mha". @param ending with its dot
  [[nodiscard]] std::string nameForFile(const std::string& stepId, const std::string& ending) const;

 private:
  AttemptFolder(std::filesystem::path folder, Attempt attempt) : folder_(std::move(folder)), attempt_(std::move(attempt)) {}
  [[nodiscard]] Result<void> keep(Attempt next);

  std::filesystem::path folder_;
  Attempt attempt_;
};

struct AttemptList {
  std::vector<std::pair<std::filesystem::path, Attempt>> attempts;  ///< folder and content, the latest first
  std::vector<Error> problems;                                      ///< of folders that cannot be read, each with its name
};
/// A folder that is not there holds no attempts.
[[nodiscard]] AttemptList listAttempts(const std::filesystem::path& root);

}  // namespace ew
