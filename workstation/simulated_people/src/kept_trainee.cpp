#include <cstdio>

#include "ew/assessment/random_numbers.h"
#include "ew/assessment/step_work.h"
#include "ew/core/version.h"
#include "ew/library/lesson.h"
#include "ew/simulated_people/simulated_trainee.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using std::chrono::sys_seconds;

/// As idOfAttempt makes it, with an end that the seed decides.
std::string idOf(sys_seconds begun, std::uint64_t seed) {
  std::string id = idOfAttempt(begun);
  char end[16];
  std::snprintf(end, sizeof end, "%08x", static_cast<unsigned>(assessment::RandomNumbers(seed).bits() & 0xFFFFFFFFU));
  return id.substr(0, id.rfind('-') + 1) + end;
}

/// @param at when the step ended
Result<StepOutcome> judged(const LessonStep& step, const SimulatedStep& made, const TraineeCase& on, sys_seconds at,
                           const Progress& progress) {
  auto work = workOf(step, on.ground());
  if (!work) return passOn(work.error());
  for (std::size_t n = 0; n < made.log.frameCount(); ++n) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">());
    (*work)->see(made.log.frame(n));
  }
  StepOutcome outcome;
  outcome.stepId = step.id;
  outcome.seconds = made.seconds;
  outcome.hints = made.hints;
  outcome.answer = made.answer;
  outcome.at = at;
  outcome.result() = (*work)->judge(made.answer);
  conclude(step, step.passLevel, outcome);
  return outcome;
}

}  // namespace

std::string SimulatedPerson::name() const {
  const std::string digits = std::to_string(number);
  return std::string(wordOf(level)) + " " + (digits.size() < 2 ? "0" : "") + digits;
}

Result<fs::path> keepSimulatedAttempt(const Lesson& lesson, const TraineeCase& on, const std::vector<SimulatedStep>& steps,
                                      const SimulatedPerson& person, sys_seconds begun, const fs::path& root, Progress& progress) {
  Attempt attempt;
  attempt.id = idOf(begun, person.seed);
  attempt.startedAt = begun;
  attempt.caseId = on.teaching().opened.id;
  attempt.lessonId = lesson.id;
  attempt.lessonTitle = lesson.title;
  attempt.lessonContent = contentOf(lesson);
  attempt.person = person.name();
  attempt.program = kVersion;
  attempt.otherFields["simulated"] = {{"level", wordOf(person.level)}, {"seed", person.seed}};
  auto kept = AttemptFolder::begin(root, std::move(attempt));
  if (!kept) return passOn(kept.error());
  double elapsed_s = 0.0;
  for (std::size_t n = 0; n < steps.size(); ++n) {
    elapsed_s += steps[n].seconds;
    if (auto begunStep = kept->beginStep(steps[n].stepId); !begunStep) return passOn(begunStep.error());
    auto outcome = judged(lesson.steps[n], steps[n], on, begun + std::chrono::seconds(static_cast<long>(elapsed_s)), progress);
    if (!outcome) return passOn(outcome.error());
    if (steps[n].log.frameCount() > 0) {
      outcome->recording = kept->nameForFile(steps[n].stepId, ".seq.mha");
      ScanRecording recording;
      recording.caseId = on.teaching().opened.id;
      recording.title = lesson.steps[n].title;
      recording.log = steps[n].log;
      if (auto written = writeRecording(recording, kept->folder() / outcome->recording, progress); !written) return passOn(written.error());
    }
    if (auto ended = kept->endStep(*std::move(outcome)); !ended) return passOn(ended.error());
  }
  if (auto finished = kept->finish(begun + std::chrono::seconds(static_cast<long>(elapsed_s))); !finished) return passOn(finished.error());
  return kept->folder();
}

}  // namespace ew
