#include "ew/library/attempt.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "ew/core/json_fields.h"
#include "ew/core/message_json.h"
#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/io/json_files.h"
#include "ew/io/private_file.h"
#include "ew/io/safe_file.h"
#include "ew/library/lesson.h"
#include "ew/library/timestamp.h"
#include "files/json_rest.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using std::chrono::sys_seconds;

constexpr const char* kAttemptFile = "attempt.json";
constexpr std::size_t kLargestAttempt_bytes = 64u << 20;
constexpr std::size_t kMostOutcomes = 10'000, kMostRemarks = 1000;
constexpr std::size_t kLongestPerson = 20'000, kLongestFileName = 240, kLongestLaunch = 100;

constexpr WordTable<StepVerdict, 4> kVerdicts = {{{"passed", StepVerdict::passed},
                                                  {"failed", StepVerdict::failed},
                                                  {"skipped", StepVerdict::skipped},
                                                  {"handed_in", StepVerdict::handedIn}}};
constexpr std::array<std::string_view, 14> kAttemptFields = {"format",  "id",       "case",       "lesson",       "lesson_title",
                                                             "person",  "program",  "started_at", "finished_at",  "lesson_content",
                                                             "running", "outcomes", "launch",     "mastery_score"};
constexpr std::array<std::string_view, 11> kOutcomeFields = {"step",    "verdict",   "score",    "seconds", "hints", "figures",
                                                             "remarks", "recording", "pictures", "answer",  "at"};

/// A file of the attempt's own folder.
std::string ownFile(const JsonFields& fields, std::string_view key, const std::string& name) {
  if (name.find_first_of("/\\") != std::string::npos || name == ".." || name == ".")
    fields.refuse(key, say<"a file of the attempt's folder">());
  return name;
}

StepOutcome readOutcome(const JsonFields& fields) {
  StepOutcome outcome;
  outcome.stepId = fields.text("step", {}, 1, 100);
  outcome.result() = readStepResult(fields, kMostRemarks);
  outcome.seconds = fields.number("seconds", 0.0, 1e8);
  outcome.hints = static_cast<int>(fields.whole("hints", 0, 1000, 0));
  if (const json* answer = fields.find("answer")) {
    outcome.answer = stepAnswerFromJson(*answer);
    if (jsonOf(outcome.answer) != *answer) outcome.otherAnswer = *answer;
  }
  outcome.recording = ownFile(fields, "recording", fields.text("recording", std::string(), 0, kLongestFileName));
  for (const std::string& image : fields.texts("pictures", 0, kMostRemarks)) outcome.images.push_back(ownFile(fields, "pictures", image));
  outcome.at = readTimestamp(fields, "at", true).value_or(sys_seconds{});
  outcome.otherFields = without(fields.value(), kOutcomeFields);
  return outcome;
}

json jsonOf(const StepOutcome& outcome) {
  json made = outcome.otherFields.is_object() ? outcome.otherFields : json::object();
  made["step"] = outcome.stepId;
  writeStepResult(outcome, made);
  made["seconds"] = outcome.seconds;
  if (outcome.hints > 0) made["hints"] = outcome.hints;
  if (json answer = outcome.answerJson(); !answer.is_null()) made["answer"] = std::move(answer);
  if (!outcome.recording.empty()) made["recording"] = outcome.recording;
  if (!outcome.images.empty()) made["pictures"] = outcome.images;
  made["at"] = timestampText(outcome.at);
  return made;
}

/// The folder of all attempts. One that several accounts share on purpose has the sticky bit, as /tmp has, and stays as it is: what lies in
/// it is each account's own.
Result<void> makeAttemptsFolder(const fs::path& root) {
  std::error_code problem;
  const auto status = fs::status(root, problem);
  const bool isShared = fs::is_directory(status) && (status.permissions() & fs::perms::sticky_bit) != fs::perms::none;
  return isShared ? Result<void>() : makePrivateFolder(root);
}

}  // namespace

Message verdictWord(StepVerdict verdict) {
  switch (verdict) {
    case StepVerdict::passed:
      return passedWord(true);
    case StepVerdict::failed:
      return passedWord(false);
    case StepVerdict::skipped:
      return say<"skipped">();
    case StepVerdict::handedIn:
      return say<"handed in">();
  }
  return {};
}

Message passedWord(bool passed) { return passed ? say<"passed">() : say<"not passed">(); }

StepResult readStepResult(const JsonFields& fields, std::size_t most) {
  StepResult result;
  result.verdict = fields.word("verdict", kVerdicts);
  result.score = fields.number("score", 0.0, 1.0);
  for (const JsonFields& figure : fields.objects("figures", 0, most))
    result.figures.push_back({figure.text("name"), figure.number("value", -1e300, 1e300), figure.text("unit", std::string(), 0, 20)});
  for (const JsonFields& remark : fields.objects("remarks", 0, most)) {
    AttemptRemark made{remark.flag("good", false), {}};
    try {
      if (const json* text = remark.find("text")) made.text = text->get<Message>();
    } catch (const std::exception&) {
      remark.refuse("text", say<"a sentence">());
    }
    result.remarks.push_back(std::move(made));
  }
  return result;
}

void writeStepResult(const StepResult& result, json& into) {
  into["verdict"] = wordIn(kVerdicts, result.verdict);
  into["score"] = result.score;
  for (const Figure& figure : result.figures) {
    json each = {{"name", figure.name}, {"value", figure.value}};
    if (!figure.unit.empty()) each["unit"] = figure.unit;
    into["figures"].push_back(std::move(each));
  }
  for (const AttemptRemark& remark : result.remarks) into["remarks"].push_back({{"good", remark.good}, {"text", remark.text}});
}

std::string launchOfEnvironment() {
  const char* said = std::getenv(kLaunchVariable);
  const std::string launch = said != nullptr ? said : "";
  const bool isOurs = launch.size() <= kLongestLaunch && std::all_of(launch.begin(), launch.end(), [](unsigned char letter) {
                        return std::isalnum(letter) != 0 || letter == '-' || letter == '.';
                      });
  return isOurs ? launch : std::string();
}

std::optional<double> masteryScoreOfEnvironment() {
  const char* said = std::getenv(kMasteryVariable);
  const auto score = said != nullptr && !launchOfEnvironment().empty() ? parseNumber(said) : std::nullopt;
  return score && *score >= 0.0 && *score <= 1.0 ? score : std::nullopt;
}

json StepOutcome::answerJson() const { return otherAnswer.is_null() ? jsonOf(answer) : otherAnswer; }

const StepOutcome* Attempt::outcomeOf(const std::string& stepId) const {
  const auto last = std::find_if(outcomes.rbegin(), outcomes.rend(), [&](const StepOutcome& one) { return one.stepId == stepId; });
  return last == outcomes.rend() ? nullptr : &*last;
}

std::string idOfAttempt(sys_seconds now) {
  std::string id = timestampText(now);
  std::erase_if(id, [](char letter) { return letter == '-' || letter == ':' || letter == 'Z'; });
  std::replace(id.begin(), id.end(), 'T', '-');
  // Attempts of one second stand in their order, too: three digits are the millisecond, the rest is chance.
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  const auto within_ms = static_cast<unsigned>(std::chrono::duration_cast<std::chrono::milliseconds>(since).count() % 1000);
  constexpr unsigned kChance = 0xFFFFFU;
  std::array<char, 12> end{};
  std::snprintf(end.data(), end.size(), "-%03x%05x", within_ms, static_cast<unsigned>(std::random_device{}()) & kChance);
  return id + end.data();
}

Result<Attempt> attemptFromJson(const json& document) {
  JsonReading reading(verbatim(kAttemptFile));
  const JsonFields fields(document, reading);
  const auto format = fields.whole("format", 1, 1'000'000);
  if (reading.good() && format > kAttemptFormat)
    return failure(ErrorCode::newerFormat,
                   say<"%1 has format %2, and this program reads formats up to %3; open it with a newer EchoWeave.">(
                       std::string(kAttemptFile), std::to_string(format), kAttemptFormat),
                   {{"field", "format"}, {"found", std::to_string(format)}});
  Attempt made;
  made.id = fields.text("id", {}, 1, 100);
  made.caseId = fields.text("case", {}, 1, 100);
  made.lessonId = fields.text("lesson", {}, 1, 100);
  made.lessonTitle = fields.text("lesson_title", std::string(), 0);
  made.lessonContent = fields.text("lesson_content", std::string(), 0);
  made.person = fields.text("person", std::string(), 0, kLongestPerson);
  made.program = fields.text("program", std::string(), 0);
  made.launch = fields.text("launch", std::string(), 0, kLongestLaunch);
  if (fields.has("mastery_score")) made.masteryScore = fields.number("mastery_score", 0.0, 1.0);
  made.startedAt = readTimestamp(fields, "started_at", true).value_or(sys_seconds{});
  made.finishedAt = readTimestamp(fields, "finished_at", false);
  made.runningStep = fields.text("running", std::string(), 0, 100);
  for (const JsonFields& each : fields.objects("outcomes", 0, kMostOutcomes)) made.outcomes.push_back(readOutcome(each));
  made.otherFields = without(fields.value(), kAttemptFields);
  if (reading.problem()) return passOn(*reading.problem());
  return made;
}

json jsonOf(const Attempt& attempt) {
  json made = attempt.otherFields.is_object() ? attempt.otherFields : json::object();
  made["format"] = kAttemptFormat;
  made["id"] = attempt.id;
  made["case"] = attempt.caseId;
  made["lesson"] = attempt.lessonId;
  const auto text = [&](const char* key, const std::string& value) {
    if (!value.empty()) made[key] = value;
  };
  text("lesson_title", attempt.lessonTitle);
  text("lesson_content", attempt.lessonContent);
  text("person", attempt.person);
  text("program", attempt.program);
  text("launch", attempt.launch);
  if (attempt.masteryScore) made["mastery_score"] = *attempt.masteryScore;
  made["started_at"] = timestampText(attempt.startedAt);
  if (attempt.finishedAt) made["finished_at"] = timestampText(*attempt.finishedAt);
  text("running", attempt.runningStep);
  made["outcomes"] = json::array();
  for (const StepOutcome& outcome : attempt.outcomes) made["outcomes"].push_back(jsonOf(outcome));
  return made;
}

Result<AttemptFolder> AttemptFolder::begin(const fs::path& root, Attempt attempt) {
  const fs::path folder = root / attempt.id;
  std::error_code error;
  fs::create_directories(root.parent_path(), error);
  auto closed = error ? Result<void>() : makeAttemptsFolder(root);
  if (closed && !error) closed = makePrivateFolder(folder);
  if (error || !closed)
    return failure(ErrorCode::notWritable,
                   say<"The folder '%1' for this attempt cannot be made (%2); free some space, or choose a library you may write to.">(
                       folder, error ? verbatim(error.message()) : closed.error().message),
                   {{"file", folder.string()}});
  AttemptFolder kept(folder, {});
  if (auto written = kept.keep(std::move(attempt)); !written) return passOn(written.error());
  return kept;
}

Result<AttemptFolder> AttemptFolder::open(const fs::path& folder) {
  auto document = readJsonFile(folder / kAttemptFile, verbatim(kAttemptFile), kLargestAttempt_bytes);
  if (!document) return passOn(document.error());
  auto attempt = attemptFromJson(*document);
  if (!attempt) return passOn(attempt.error());
  return AttemptFolder(folder, std::move(*attempt));
}

Result<void> AttemptFolder::keep(Attempt next) {
  std::string text;
  try {
    text = jsonOf(next).dump(1) + "\n";
  } catch (const json::exception&) {
    return failure(ErrorCode::badField, say<"A text of the attempt is not valid UTF-8 and cannot be saved; type it again.">());
  }
  if (auto written = writeFileSafely(folder_ / kAttemptFile, text); !written) return written;
  // Recordings and images come from writers that ask the umask; the folder has kept them from others until here.
  if (auto closed = closeToOthers(folder_); !closed) return closed;
  attempt_ = std::move(next);
  return {};
}

Result<void> AttemptFolder::beginStep(const std::string& stepId) {
  Attempt next = attempt_;
  next.runningStep = stepId;
  return keep(std::move(next));
}

Result<void> AttemptFolder::endStep(StepOutcome outcome, std::optional<sys_seconds> finishedAt) {
  Attempt next = attempt_;
  if (finishedAt) next.finishedAt = finishedAt;
  next.runningStep.clear();
  next.outcomes.push_back(std::move(outcome));
  return keep(std::move(next));
}

Result<void> AttemptFolder::leaveStep() {
  if (attempt_.runningStep.empty()) return {};
  Attempt next = attempt_;
  next.runningStep.clear();
  return keep(std::move(next));
}

Result<void> AttemptFolder::finish(sys_seconds now) {
  Attempt next = attempt_;
  next.runningStep.clear();
  next.finishedAt = now;
  return keep(std::move(next));
}

Result<void> AttemptFolder::goOnAt(const Lesson& lesson) {
  const std::string content = contentOf(lesson);
  if (attempt_.lessonContent == content) return {};
  Attempt next = attempt_;
  next.lessonTitle = lesson.title;
  next.lessonContent = content;
  return keep(std::move(next));
}

std::string AttemptFolder::nameForFile(const std::string& stepId, const std::string& ending) const {
  std::array<char, 24> number{};
  std::snprintf(number.data(), number.size(), "step-%02zu-", attempt_.outcomes.size() + 1);
  std::string name = number.data() + idFor(stepId, {});
  std::error_code ignored;
  for (int again = 2; fs::exists(folder_ / (name + ending), ignored); ++again)
    name = number.data() + idFor(stepId, {}) + "-" + std::to_string(again);
  return name + ending;
}

AttemptList listAttempts(const fs::path& root) {
  AttemptList list;
  std::error_code error;
  if (!fs::exists(root, error)) return list;
  fs::directory_iterator entries(root, error);
  if (error) {
    list.problems.push_back({ErrorCode::notReadable,
                             say<"The attempts in '%1' cannot be read (%2); check that the folder is there and that you may read it.">(
                                 root, verbatim(error.message())),
                             {{"file", root.string()}}});
    return list;
  }
  for (; entries != fs::directory_iterator(); entries.increment(error)) {
    const fs::path folder = entries->path();
    std::error_code ignored;
    if (folder.filename().string().starts_with('.') || !fs::exists(folder / kAttemptFile, ignored)) continue;
    auto kept = AttemptFolder::open(folder);
    if (kept) {
      list.attempts.emplace_back(folder, kept->attempt());
    } else {
      Error problem = kept.error();
      problem.message = say<"The attempt in the folder '%1' is left out: %2">(folder.filename(), std::move(problem.message));
      list.problems.push_back(std::move(problem));
    }
  }
  std::sort(list.attempts.begin(), list.attempts.end(), [](const auto& a, const auto& b) { return a.second.id > b.second.id; });
  std::sort(list.problems.begin(), list.problems.end(), [](const Error& a, const Error& b) { return a.sentence() < b.sentence(); });
  return list;
}

}  // namespace ew
