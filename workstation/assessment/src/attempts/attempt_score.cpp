#include "ew/assessment/attempt_score.h"

#include "attempts/series_files.h"
#include "ew/core/data_file.h"
#include "ew/core/find_entry.h"
#include "ew/core/json_fields.h"
#include "ew/core/message_json.h"
#include "ew/io/json_files.h"
#include "ew/library/lesson.h"
#include "ew/library/timestamp.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kLargestScore_bytes = 16u << 20;
constexpr std::size_t kMostOfAScore = 10'000;
constexpr double kFarthestValue = 1e300;

Message readSentence(const JsonFields& fields, std::string_view key) {
  try {
    if (const json* found = fields.find(key)) return found->get<Message>();
  } catch (const std::exception&) {
    fields.refuse(key, say<"a sentence">());
  }
  return {};
}

StepScore readStepScore(const JsonFields& fields) {
  StepScore step;
  step.stepId = fields.text("step", {}, 1, 100);
  step.title = fields.text("title", std::string(), 0);
  step.kind = fields.text("kind", std::string(), 0, 40);
  step.result() = readStepResult(fields, kMostOfAScore);
  step.task = fields.number("task", 0.0, 1.0);
  step.passLevel = fields.number("pass_level", 0.0, 1.0);
  step.weight = fields.number("weight", 0.0, 1e6);
  step.isJudgedAnew = fields.flag("judged_anew", false);
  if (fields.has("valid_share")) step.validShare = fields.number("valid_share", 0.0, 1.0);
  for (const JsonFields& each : fields.objects("metrics", 0, kMostOfAScore))
    step.metrics.push_back({each.text("id", {}, 1, 100), static_cast<int>(each.whole("version", 1, 1'000'000)),
                            each.number("value", -kFarthestValue, kFarthestValue)});
  return step;
}

json jsonOf(const StepScore& step) {
  json made = {{"step", step.stepId}, {"title", step.title},          {"kind", step.kind},
               {"task", step.task},   {"pass_level", step.passLevel}, {"weight", step.weight}};
  writeStepResult(step, made);
  if (step.validShare) made["valid_share"] = *step.validShare;
  if (step.isJudgedAnew) made["judged_anew"] = true;
  for (const MetricValue& each : step.metrics)
    made["metrics"].push_back({{"id", each.id}, {"version", each.version}, {"value", each.value}});
  return made;
}

fs::path scoresFolder(const fs::path& attemptFolder) { return attemptFolder / "scores"; }

Result<AttemptScore> readScore(const assessment::SeriesFile& from) {
  const auto document = readJsonFile(from.file, verbatim(from.file.filename().string()), kLargestScore_bytes);
  if (!document) return passOn(document.error());
  auto score = scoreFromJson(*document);
  if (score) score->number = from.number;
  return score;
}

}  // namespace

const StepScore* AttemptScore::of(const std::string& stepId) const { return entryWith(steps, &StepScore::stepId, stepId); }

Result<AttemptScore> scoreFromJson(const json& document) {
  JsonReading reading(say<"the score">());
  const JsonFields fields(document, reading);
  requireFormat(fields, kScoreFormat);
  AttemptScore score;
  score.attemptId = fields.text("attempt", {}, 1, 100);
  score.caseId = fields.text("case", {}, 1, 100);
  score.lessonId = fields.text("lesson", {}, 1, 100);
  score.key = fields.text("key", {}, 1, 100);
  score.program = fields.text("program", std::string(), 0);
  score.scoring = static_cast<int>(fields.whole("scoring", 1, 1'000'000));
  score.planRevision = static_cast<int>(fields.whole("plan", 0, 1'000'000));
  score.expertAttempt = fields.text("expert", std::string(), 0, 100);
  score.madeAt = readTimestamp(fields, "made_at", true).value_or(std::chrono::sys_seconds{});
  score.score = fields.number("score", 0.0, 1.0);
  score.passed = fields.flag("passed", false);
  if (fields.has("outcomes")) score.outcomes = static_cast<std::size_t>(fields.whole("outcomes", 0, 1'000'000));
  score.wasFinished = fields.flag("finished", false);
  for (const JsonFields& each : fields.objects("steps", 0, kMostOfAScore)) score.steps.push_back(readStepScore(each));
  for (const JsonFields& each : fields.objects("notes", 0, kMostOfAScore)) score.notes.push_back(readSentence(each, "text"));
  if (reading.problem()) return passOn(*reading.problem());
  return score;
}

json jsonOf(const AttemptScore& score) {
  json made = {{"format", kScoreFormat},   {"attempt", score.attemptId}, {"case", score.caseId},
               {"lesson", score.lessonId}, {"key", score.key},           {"program", score.program},
               {"scoring", score.scoring}, {"plan", score.planRevision}, {"made_at", timestampText(score.madeAt)},
               {"score", score.score},     {"passed", score.passed},     {"steps", json::array()}};
  if (score.outcomes) made["outcomes"] = *score.outcomes;
  if (score.wasFinished) made["finished"] = true;
  if (!score.expertAttempt.empty()) made["expert"] = score.expertAttempt;
  for (const StepScore& each : score.steps) made["steps"].push_back(jsonOf(each));
  for (const Message& each : score.notes) made["notes"].push_back({{"text", each}});
  return made;
}

std::vector<AttemptScore> scoresOf(const fs::path& attemptFolder) {
  std::vector<AttemptScore> scores;
  for (const auto& each : assessment::numberedFiles(scoresFolder(attemptFolder)))
    if (auto score = readScore(each)) scores.push_back(std::move(*score));
  return scores;
}

std::optional<AttemptScore> latestScore(const fs::path& attemptFolder) {
  const auto files = assessment::numberedFiles(scoresFolder(attemptFolder));
  for (auto each = files.rbegin(); each != files.rend(); ++each)
    if (auto score = readScore(*each)) return std::move(*score);
  return std::nullopt;
}

Result<AttemptScore> keepScore(const fs::path& attemptFolder, AttemptScore score) {
  const auto added = assessment::addNumbered(scoresFolder(attemptFolder), jsonOf(score).dump(1) + "\n");
  if (!added) return passOn(added.error());
  score.number = added->number;
  return score;
}

}  // namespace ew
