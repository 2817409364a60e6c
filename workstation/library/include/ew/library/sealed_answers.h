#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/library/attempt.h"
#include "ew/library/bundle.h"
#include "ew/library/case.h"
#include "ew/library/instructor_key.h"

namespace ew {

// An examination is a case as its trainees may have it: what they may read stands in an ordinary case folder, and everything else, to the
// byte, in answers.sealed, which only the owner of a secret key can open. What may be read is a list of fields that are let through
// (trainee_view.cpp), so that a field nobody thought of stays behind. resources/docs/instructor/access.md has the list.

inline constexpr const char* kSealedName = "answers.sealed";
inline constexpr int kSealedFormat = 1;  ///< of answers.sealed; a larger one is refused with newerFormat

struct ExaminationOptions {
  std::vector<PublicKey> instructors;   ///< each of them can open the answers with their own key; at least one, at most 20
  std::string id = {};                  ///< of the examination; empty: a random one, for a case's own id often names its finding
  PreparationOptions preparation = {};  ///< of a case that comes as a recipe: its volume is made, and goes along instead
};

struct Examination {
  std::string id;            ///< of the case that trainees get
  std::string sealedSha256;  ///< of its answers.sealed: attempts refer to it, and say so which answers they are judged by
  std::size_t steps = 0;     ///< that trainees work on
  std::size_t leftOut = 0;   ///< experts' scans, and texts that come after the first question: trainees of an examination have none
  std::vector<Message> notes;
  BundleHeader bundle = {};  ///< of exportExamination
};

/// Makes the trainees' folder of a case, with its sealed answers. It appears complete or not at all.
/// @param folder new
/// @error as loadCase, loadCaseVolume and sumsOfCase; badUsage (no key, an id that cannot be one, no lesson with a question); badField (no
///        title for trainees, a step that scans another case, a mannequin of the case's own); unsupported (a case that is an examination
///        already, an image that is neither PNG nor JPEG); notWritable, cancelled
[[nodiscard]] Result<Examination> makeExamination(const std::filesystem::path& caseFolder, const std::filesystem::path& folder,
                                                  const ExaminationOptions& options, Progress& progress = noProgress());

/// The same into a bundle, which keeps nothing beside itself.
/// @param file as exportBundle has it @error as makeExamination and exportBundle
[[nodiscard]] Result<Examination> exportExamination(const std::filesystem::path& caseFolder, const std::filesystem::path& file,
                                                    const ExaminationOptions& options, Progress& progress = noProgress());

/// Which step of the examination is which of the case.
struct OriginalLesson {
  std::string id;
  std::map<std::string, std::string> steps;  ///< by the examination's step id
  bool operator==(const OriginalLesson&) const = default;
};

struct OpenExamination {
  std::filesystem::path folder;  ///< of the whole case again
  std::string caseId;            ///< its own
  std::string examinationId;
  std::string sealedSha256;
  std::map<std::string, OriginalLesson> lessons;  ///< by the examination's lesson id
};

/// Puts the whole case together again: every file as it was, to the byte.
/// @param folder new
/// @error notFound, notReadable, badHeader, newerFormat; badUsage (the key is another's: with the short names of those that fit); badField
/// (something was changed,
///        in answers.sealed or in what trainees may read, or they are of two revisions); notWritable, cancelled: then there is no folder
[[nodiscard]] Result<OpenExamination> openExamination(const std::filesystem::path& examinationFolder, const SecretKey& key,
                                                      const std::filesystem::path& folder, Progress& progress = noProgress());

/// An attempt at an examination as one at the case itself: its ids are the case's, so that it can be judged. Raw data stay as they are.
/// @error badField (it is an attempt at something else, at another revision of the answers, or names a step that there is not)
[[nodiscard]] Result<Attempt> asAttemptAtTheCase(const Attempt& attempt, const OpenExamination& opened);

/// Copies an attempt, with the files its steps name, as one at the case itself. The trainee's own stays as it is.
/// @param attempts a folder of attempts; the copy is ATTEMPTS/ID
/// @return the copy @error as AttemptFolder::open, asAttemptAtTheCase, AttemptFolder::begin; notWritable, cancelled
[[nodiscard]] Result<std::filesystem::path> takeExamined(const std::filesystem::path& attemptFolder, const OpenExamination& opened,
                                                         const std::filesystem::path& attempts, Progress& progress = noProgress());

/// "sealed_answers" of an attempt's otherFields: the SHA-256 of the answers it is to be judged by; empty: an attempt at no examination.
[[nodiscard]] std::string sealedAnswersOf(const Attempt& attempt);
/// Of a copy that takeExamined made: what the trainee tried. Else the case and lesson of the attempt itself.
struct TrialIdentity {
  std::string caseId, lessonId;
  bool operator==(const TrialIdentity&) const = default;
};
[[nodiscard]] TrialIdentity triedAs(const Attempt& attempt);
[[nodiscard]] Attempt withSealedAnswers(Attempt attempt, const std::string& sha256);

}  // namespace ew
