#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/library/attempt.h"
#include "ew/library/case.h"
#include "ew/library/case_words.h"
#include "ew/library/lesson.h"
#include "ew/scanning/recording.h"
#include "logic/review_clock.h"

namespace ew::review {

enum class Who { trainee, expert };

/// A recorded scan that may be looked at, before it is read.
struct ScanChoice {
  Who who = Who::trainee;
  std::string title = {};                   ///< of the step, or the file's name
  std::filesystem::path file = {};          ///< of the recording
  std::filesystem::path attempt = {};       ///< folder; empty: it belongs to none
  std::string stepId = {};                  ///< of the lesson; empty: of none
  std::optional<StepOutcome> outcome = {};  ///< of that recording
  std::optional<WatchTask> watch = {};      ///< of an expert's scan: the part that is shown, and its marks
  std::string caseId = {};                  ///< of what is scanned, where the recording does not say
  bool operator==(const ScanChoice&) const = default;
};

/// The part of a recording that is reviewed, as it was read. Never changed afterwards.
struct ScanExcerpt {
  ScanChoice choice;
  ScanRecording recording;
  Part part;  ///< that is reviewed, on the recording's clock
  [[nodiscard]] std::vector<ExpertMark> marks() const { return choice.watch ? choice.watch->marks : std::vector<ExpertMark>{}; }
};

/// @error as readRecording, badField (a part without a frame)
[[nodiscard]] Result<ScanExcerpt> openScan(const ScanChoice& choice, Progress& progress = noProgress());

/// The expert's scans of a lesson, in the order of its steps.
/// @param home the case that holds it
[[nodiscard]] std::vector<ScanChoice> expertScansOf(const Case& home, const Lesson& lesson);
/// The one that a step is most likely compared with: the last before it in the lesson that scans the same case, else the first of the
/// same case, else the first. As many as there are: none.
[[nodiscard]] std::size_t usualExpertFor(const Lesson& lesson, const std::string& stepId, const std::vector<ScanChoice>& scans);
/// What an attempt has of a step: the outcome that counts. Empty: it was not recorded, or its file is gone.
[[nodiscard]] std::optional<ScanChoice> scanOfStep(const std::filesystem::path& folder, const Attempt& attempt, const LessonStep& step);

/// What a recording holds of a part: the frames within it and what happened meanwhile.
[[nodiscard]] ScanLog logOfPart(const ScanLog& log, const Part& part);

/// The same scan formed in another scene, as a lesson shows an expert's scan: poses and settings are the expert's, the physics of the image
/// those of the case that is scanned.
[[nodiscard]] ScanLog formedIn(const ScanLog& log, const Scene& scene);

/// A lesson and what was tried of it.
struct LessonAttempts {
  Case home;
  Lesson lesson;
  std::vector<std::pair<std::filesystem::path, Attempt>> attempts;  ///< the latest first
  CaseWords words = {};                                             ///< of `home`, in the reader's language; lesson and case are as written
};
/// What can be reviewed.
struct ScanShelf {
  std::vector<LessonAttempts> lessons;  ///< by the case's title, then as the author put them
  std::vector<Error> problems;          ///< of attempts and cases that cannot be read
  std::size_t strayAttempts = 0;        ///< of lessons that are in no case here
};
/// Lessons that somebody has tried, and those of the case at hand.
/// @param openCase folder of the case that is open; empty: none
/// @param language of whoever reads it, as wordsOf takes it; empty: as the lessons were written @error cancelled
[[nodiscard]] Result<ScanShelf> readShelf(const std::filesystem::path& library, const std::filesystem::path& openCase,
                                          Progress& progress = noProgress(), const std::string& language = {});

/// Where the case of a recording is: one of the cases at hand, else in the library. @error notFound (with what to do)
[[nodiscard]] Result<std::filesystem::path> caseOf(const ScanExcerpt& scan, const ScanShelf& shelf, const std::filesystem::path& library);

}  // namespace ew::review
