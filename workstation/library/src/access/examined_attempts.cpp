#include <nlohmann/json.hpp>

#include "ew/io/private_file.h"
#include "ew/library/checksums.h"
#include "ew/library/sealed_answers.h"
#include "files/file_pieces.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kAttemptField = "sealed_answers";
constexpr const char* kExaminedField = "examined_as";

/// A file that an outcome names, when it is one: an attempt comes from a trainee, and may name anything.
bool isOwnFile(const fs::path& folder, const std::string& name) {
  std::error_code problem;
  return !problemOfPath(name) && fs::symlink_status(folder / name, problem).type() == fs::file_type::regular;
}

Result<void> copyNamed(const fs::path& from, const fs::path& to, const std::string& name, ByteCount& count) {
  std::error_code ignored;
  if (name.empty() || !isOwnFile(from, name) || fs::exists(to / name, ignored)) return {};
  const auto copied = copyInPieces(from / name, to / name, count);
  return copied ? Result<void>() : passOn(copied.error());
}

}  // namespace

std::string sealedAnswersOf(const Attempt& attempt) {
  if (!attempt.otherFields.is_object() || !attempt.otherFields.contains(kAttemptField)) return {};
  const json& value = attempt.otherFields[kAttemptField];
  return value.is_string() ? value.get<std::string>() : std::string();
}

TrialIdentity triedAs(const Attempt& attempt) {
  const auto text = [](const json& fields, const char* name) {
    const auto found = fields.find(name);
    return found != fields.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  const auto examined = attempt.otherFields.is_object() ? attempt.otherFields.find(kExaminedField) : attempt.otherFields.end();
  TrialIdentity tried;
  if (examined != attempt.otherFields.end() && examined->is_object()) tried = {text(*examined, "case"), text(*examined, "lesson")};
  return tried.caseId.empty() || tried.lessonId.empty() ? TrialIdentity{attempt.caseId, attempt.lessonId} : tried;
}

Attempt withSealedAnswers(Attempt attempt, const std::string& sha256) {
  attempt.otherFields[kAttemptField] = sha256;
  return attempt;
}

Result<Attempt> asAttemptAtTheCase(const Attempt& attempt, const OpenExamination& opened) {
  const auto refuse = [&](Message sentence) { return failure(ErrorCode::badField, std::move(sentence), {{"attempt", attempt.id}}); };
  if (attempt.caseId != opened.examinationId)
    return refuse(say<"The attempt '%1' is at '%2' and not at the examination '%3'; judge it with its own.">(attempt.id, attempt.caseId,
                                                                                                             opened.examinationId));
  if (sealedAnswersOf(attempt) != opened.sealedSha256)
    return refuse(
        say<"The attempt '%1' was made with other sealed answers than these; judge it with the bundle that its trainee had.">(attempt.id));
  const auto lesson = opened.lessons.find(attempt.lessonId);
  if (lesson == opened.lessons.end())
    return refuse(say<"The attempt '%1' is at the lesson '%2', which the examination does not have.">(attempt.id, attempt.lessonId));
  Attempt made = attempt;
  made.otherFields.erase(kAttemptField);
  made.otherFields[kExaminedField] = {{"case", attempt.caseId}, {"lesson", attempt.lessonId}, {kAttemptField, opened.sealedSha256}};
  made.caseId = opened.caseId;
  made.lessonId = lesson->second.id;
  const auto rename = [&](std::string& step) {
    const auto original = lesson->second.steps.find(step);
    if (original == lesson->second.steps.end()) return false;
    step = original->second;
    return true;
  };
  for (StepOutcome& outcome : made.outcomes)
    if (const std::string id = outcome.stepId; !rename(outcome.stepId))
      return refuse(say<"The attempt '%1' names the step '%2', which the examination does not have.">(attempt.id, id));
  if (!made.runningStep.empty() && !rename(made.runningStep))
    return refuse(say<"The attempt '%1' names the step '%2', which the examination does not have.">(attempt.id, attempt.runningStep));
  return made;
}

Result<fs::path> takeExamined(const fs::path& attemptFolder, const OpenExamination& opened, const fs::path& attempts, Progress& progress) {
  const auto kept = AttemptFolder::open(attemptFolder);
  if (!kept) return passOn(kept.error());
  const auto made = asAttemptAtTheCase(kept->attempt(), opened);
  if (!made) return passOn(made.error());
  std::error_code ignored;
  if (fs::exists(attempts / made->id, ignored))
    return failure(ErrorCode::notWritable, say<"The attempt '%1' is there twice; give each folder once.">(made->id),
                   {{"attempt", made->id}});
  const auto copy = AttemptFolder::begin(attempts, *made);
  if (!copy) return passOn(copy.error());
  ByteCount count(say<"Copying the attempts">(), 0, progress);
  for (const StepOutcome& outcome : made->outcomes) {
    if (auto copied = copyNamed(attemptFolder, copy->folder(), outcome.recording, count); !copied) return passOn(copied.error());
    for (const std::string& image : outcome.images)
      if (auto copied = copyNamed(attemptFolder, copy->folder(), image, count); !copied) return passOn(copied.error());
  }
  if (auto closed = closeToOthers(copy->folder()); !closed) return passOn(closed.error());
  return copy->folder();
}

}  // namespace ew
