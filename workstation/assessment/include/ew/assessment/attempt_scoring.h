#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/assessment_plan.h"
#include "ew/assessment/attempt_score.h"
#include "ew/assessment/case_ground.h"
#include "ew/core/progress.h"
#include "ew/library/attempt.h"
#include "ew/library/case_words.h"
#include "ew/scanning/recording.h"

namespace ew {

/// Everything that the attempts of a lesson are scored against. Reading is safe from several threads.
struct LessonGround {
  std::string caseId;  ///< that holds the lesson
  Lesson lesson;
  AssessmentPlan plan;
  std::map<std::string, std::shared_ptr<const CaseGround>> cases;           ///< by id: those that its steps scan
  std::map<std::string, std::shared_ptr<const ScanRecording>> expertScans;  ///< by step: of the expert's attempt
  std::map<std::string, ScanState> expertImages;  ///< by step: that the expert stored, or has nearest to the plane
  std::string key;                                ///< ContentKey of all of it
  std::vector<Message> notes;                     ///< what could not be found

  /// The case that a step scans; null where it is not there.
  [[nodiscard]] std::shared_ptr<const CaseGround> caseOf(const LessonStep& step) const;
};

/// Reads a lesson with its cases and its plan: that of the revision whose content the attempt names, where it is still there.
/// @param lessonContent of the attempt (Attempt::lessonContent); empty: the lesson as it is now
/// @error notFound (case, lesson), as loadCase, loadCaseTruth, loadCaseLabels, readPlan; cancelled
[[nodiscard]] Result<std::shared_ptr<const LessonGround>> lessonGroundOf(const std::string& caseId, const std::string& lessonId,
                                                                         const std::string& lessonContent,
                                                                         const std::filesystem::path& library,
                                                                         Progress& progress = noProgress());

/// Judges every step of an attempt anew from its recordings and answers, and works out its metrics. The same for the same data, whenever,
/// wherever and on however many threads it is done.
/// @param folder of the attempt
/// @error cancelled, tooLarge. A recording that cannot be read is no error: the step keeps the verdict it had, and a note says so
[[nodiscard]] Result<AttemptScore> scoreAttempt(const std::filesystem::path& folder, const Attempt& attempt, const LessonGround& ground,
                                                Progress& progress = noProgress());

struct AssessOptions {
  int threads = 0;     ///< 0: one per processor; no score depends on it
  bool again = false;  ///< also those whose score is up to date: a new one is kept only where it differs
};

struct AttemptAssessment {
  std::filesystem::path folder;
  Attempt attempt;
  std::optional<AttemptScore> score;  ///< the one that counts now
  bool wasUpToDate = false;           ///< nothing that goes into it has changed since it was scored
  std::optional<Error> problem;       ///< why there is no score
};

/// Scores attempts of any lessons and keeps a new score where something that goes into it has changed; scores that are up to date are read.
/// Stopped at any moment, what was scored stays, and the next call goes on after it. Memory, however many attempts there are: those of one
/// batch, the recordings of as many as there are threads, and the labels of the cases.
/// @param folders of attempts
/// @param take gets one assessment for each folder, in their order, on the caller's thread; when cancelled, those not reached have the
///             problem `cancelled`
void assess(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& library, const AssessOptions& options,
            Progress& progress, const std::function<void(AttemptAssessment)>& take);

/// The same, all of them together.
[[nodiscard]] std::vector<AttemptAssessment> assess(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& library,
                                                    const AssessOptions& options = {}, Progress& progress = noProgress());

}  // namespace ew
