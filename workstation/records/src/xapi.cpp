#include "ew/records/xapi.h"

#include <cmath>
#include <map>

#include "ew/core/figure.h"
#include "ew/core/find_entry.h"
#include "ew/core/version.h"
#include "iri.h"

namespace ew {
namespace {

using nlohmann::json;
using records::encoded;
using records::inQuotes;
using std::chrono::sys_seconds;

constexpr std::string_view kStatementSpace = "6a1b0c52-4f5b-5d0e-9f0e-3a7c5f8e2d41";  // of ids that this program makes
constexpr std::size_t kLongestResponse_bytes = 4000;

/// Makes the statements of one attempt.
class AttemptStatements {
 public:
  AttemptStatements(const Attempt& attempt, const XapiOptions& options)
      : attempt_(attempt),
        options_(options),
        result_(options.result ? *options.result
                               : attemptResultOf(attempt, options.lesson ? &*options.lesson : nullptr, AssessmentPlan(), std::nullopt)) {}
  std::vector<json> all();

 private:
  json statement(XapiVerb verb, const std::string& event, sys_seconds at, json object, json result, const std::string& stepId);
  json ofOutcome(const StepOutcome& outcome, int repetition);
  json context(const std::string& stepId) const;
  json actor() const;
  json activity(const std::string& path, const std::string& name, const char* type) const;
  json lessonActivity() const;
  json stepActivity(const std::string& stepId) const;
  json metricsOf(const std::string& stepId) const;
  void sayHowItEnded(std::vector<json>& said);
  const LessonStep* stepOf(const std::string& id) const;
  std::string lessonPath() const { return encoded(attempt_.caseId) + "/" + encoded(attempt_.lessonId); }
  std::string iri(const std::string& path) const { return options_.activityBase + path; }

  const Attempt& attempt_;
  const XapiOptions& options_;
  const AttemptResult result_;
};

json scoreOf(double score) { return {{"scaled", score}, {"raw", score * 100.0}, {"min", 0}, {"max", 100}}; }

const LessonStep* AttemptStatements::stepOf(const std::string& id) const {
  if (!options_.lesson) return nullptr;
  return entryWith(options_.lesson->steps, &LessonStep::id, id);
}

json AttemptStatements::actor() const {
  if (!options_.actor.is_null()) return options_.actor;
  json made = {{"objectType", "Agent"}, {"account", {{"homePage", options_.homePage}, {"name", options_.pseudonym}}}};
  if (options_.names && !attempt_.person.empty()) made["name"] = attempt_.person;
  return made;
}

json AttemptStatements::activity(const std::string& path, const std::string& name, const char* type) const {
  json definition = {{"type", std::string("http://adlnet.gov/expapi/activities/") + type}};
  if (!name.empty()) definition["name"] = {{options_.language, name}};
  return {{"objectType", "Activity"}, {"id", iri(path)}, {"definition", definition}};
}

json AttemptStatements::lessonActivity() const {
  const std::string& title = attempt_.lessonTitle.empty() && options_.lesson ? options_.lesson->title : attempt_.lessonTitle;
  return activity("lesson/" + lessonPath(), title.empty() ? attempt_.lessonId : title, "lesson");
}

/// ADL's activity types: a question, media to read or to watch, or something to do.
const char* typeOfTask(const LessonStep* step) {
  if (step == nullptr) return "performance";
  if (std::holds_alternative<AnswerTask>(step->task)) return "question";
  return std::holds_alternative<ReadingTask>(step->task) || std::holds_alternative<WatchTask>(step->task) ? "media" : "performance";
}

json AttemptStatements::stepActivity(const std::string& stepId) const {
  const LessonStep* step = stepOf(stepId);
  const std::string title = step != nullptr && !step->title.empty() ? step->title : stepId;
  return activity("step/" + lessonPath() + "/" + encoded(stepId), title, typeOfTask(step));
}

json AttemptStatements::context(const std::string& stepId) const {
  json grouping = json::array({activity("case/" + encoded(attempt_.caseId), options_.caseTitle, "simulation")});
  if (!options_.courseId.empty()) grouping.push_back(activity("course/" + encoded(options_.courseId), {}, "course"));
  json activities = {{"grouping", std::move(grouping)}, {"category", json::array({activity("profile/1", "EchoWeave", "profile")})}};
  if (!stepId.empty()) activities["parent"] = json::array({lessonActivity()});
  json made = {
      {"registration", options_.registration.empty() ? uuidOfName(kStatementSpace, "registration\n" + attempt_.id) : options_.registration},
      {"platform", "EchoWeave"},
      {"language", options_.language},
      {"contextActivities", std::move(activities)},
      {"extensions", {{iri("extension/attempt"), attempt_.id}}}};
  if (!attempt_.lessonContent.empty()) made["revision"] = attempt_.lessonContent;
  if (!attempt_.program.empty()) made["extensions"][iri("extension/judged-by")] = attempt_.program;
  return made;
}

json AttemptStatements::metricsOf(const std::string& stepId) const {
  json list = json::array();
  for (const XapiMetric& metric : options_.metrics) {
    if (metric.stepId != stepId) continue;
    json one = {{"id", metric.id}, {"version", metric.version}, {"value", metric.value}};
    if (!metric.unit.empty()) one["unit"] = metric.unit;
    list.push_back(std::move(one));
  }
  return list;
}

/// @param event which of the attempt's events it is: the id is made of that alone
json AttemptStatements::statement(XapiVerb verb, const std::string& event, sys_seconds at, json object, json result,
                                  const std::string& stepId) {
  const std::string name = attempt_.id + "\n" + attempt_.caseId + "\n" + attempt_.lessonId + "\n" + event;
  json made = {{"id", uuidOfName(kStatementSpace, name)},
               {"actor", actor()},
               {"verb", jsonOf(verb)},
               {"object", std::move(object)},
               {"context", context(stepId)},
               {"timestamp", timestampText(at)},
               {"version", kXapiVersion}};
  if (!result.empty()) made["result"] = std::move(result);
  return made;
}

XapiVerb verbOf(StepVerdict verdict, const LessonStep* step) {
  const std::string_view type = typeOfTask(step);
  if (type == "question" && verdict != StepVerdict::skipped) return XapiVerb::answered;
  switch (verdict) {
    case StepVerdict::skipped:
      return XapiVerb::skipped;
    case StepVerdict::handedIn:
      return XapiVerb::completed;  // nobody has judged it yet
    case StepVerdict::passed:
      return type == "media" ? XapiVerb::completed : XapiVerb::passed;
    case StepVerdict::failed:
      break;
  }
  return XapiVerb::failed;
}

/// What was entered, as xAPI wants it: a text.
std::string responseOf(const json& answer) {
  std::string text = answer.is_string() ? answer.get<std::string>() : answer.dump();
  return text.size() <= kLongestResponse_bytes ? text : std::string();
}

json AttemptStatements::ofOutcome(const StepOutcome& outcome, int repetition) {
  const StepScore* counted = attempt_.outcomeOf(outcome.stepId) == &outcome ? result_.counted.of(outcome.stepId) : nullptr;
  const StepVerdict verdict = counted != nullptr ? counted->verdict : outcome.verdict;
  const XapiVerb verb = verbOf(verdict, stepOf(outcome.stepId));
  const bool isSkipped = verdict == StepVerdict::skipped, isHandedIn = verdict == StepVerdict::handedIn;
  json result = {{"success", verdict == StepVerdict::passed}, {"completion", !isSkipped}, {"duration", isoDuration(outcome.seconds)}};
  if (isHandedIn) result.erase("success");  // nobody has judged it yet
  if (!isSkipped && !isHandedIn) result["score"] = scoreOf(counted != nullptr ? counted->score : outcome.score);
  if (const json answer = outcome.answerJson(); verb == XapiVerb::answered && !answer.is_null())
    if (std::string response = responseOf(answer); !response.empty()) result["response"] = std::move(response);
  result["extensions"] = {{iri("extension/hints"), outcome.hints}};
  if (!outcome.figures.empty()) {
    json figures = json::array();
    for (const Figure& figure : outcome.figures) figures.push_back({{"name", figure.name}, {"value", figure.value}, {"unit", figure.unit}});
    result["extensions"][iri("extension/figures")] = std::move(figures);
  }
  if (json metrics = metricsOf(outcome.stepId); !metrics.empty()) result["extensions"][iri("extension/metrics")] = std::move(metrics);
  // Its judgement is another event, which comes later.
  const std::string event = (isHandedIn ? "handed in\n" : "step\n") + outcome.stepId + "\n" + std::to_string(repetition);
  return statement(verb, event, outcome.at, stepActivity(outcome.stepId), std::move(result), outcome.stepId);
}

/// Completed; and passed or failed, when it is judged.
void AttemptStatements::sayHowItEnded(std::vector<json>& said) {
  int hints = 0;
  for (const StepOutcome& outcome : attempt_.outcomes) hints += outcome.hints;
  json result = {{"completion", true}, {"duration", isoDuration(result_.worked_s)}, {"extensions", {{iri("extension/hints"), hints}}}};
  if (json metrics = metricsOf({}); !metrics.empty()) result["extensions"][iri("extension/metrics")] = std::move(metrics);
  said.push_back(statement(XapiVerb::completed, "completed", *attempt_.finishedAt, lessonActivity(), result, {}));
  const auto passed = result_.passed();
  if (!passed || result_.counted.steps.empty()) return;
  result["success"] = *passed;
  result["score"] = scoreOf(*result_.score());
  said.push_back(statement(*passed ? XapiVerb::passed : XapiVerb::failed, "judged", *attempt_.finishedAt, lessonActivity(), result, {}));
}

std::vector<json> AttemptStatements::all() {
  std::vector<json> said = {statement(XapiVerb::attempted, "attempted", attempt_.startedAt, lessonActivity(), json::object(), {})};
  std::map<std::string, int> repetitions;
  for (const StepOutcome& outcome : attempt_.outcomes) said.push_back(ofOutcome(outcome, repetitions[outcome.stepId]++));
  if (attempt_.finishedAt) sayHowItEnded(said);
  return said;
}

Result<void> checkOptions(const XapiOptions& options) {
  const auto refused = [](const char* field, const std::string& found, Message expected) {
    return failure(ErrorCode::badField,
                   say<"Statements cannot be made: '%1' is %2; it must be %3.">(std::string(field), inQuotes(found), std::move(expected)),
                   {{"field", field}, {"found", found}});
  };
  if (options.actor.is_null() && !records::isWebAddress(options.homePage))
    return refused("home_page", options.homePage, say<"an address of your site, such as https://school.example/">());
  if (options.actor.is_null() && options.pseudonym.empty()) return refused("pseudonym", {}, say<"a word that stands for the person">());
  if (!records::isIri(options.activityBase)) return refused("activity_base", options.activityBase, say<"an address or a urn">());
  if (!options.registration.empty() && !isUuid(options.registration)) return refused("registration", options.registration, say<"a UUID">());
  if (!records::isLanguageTag(options.language)) return refused("language", options.language, say<"a language such as en or de-AT">());
  for (const XapiMetric& metric : options.metrics)
    if (!std::isfinite(metric.value)) return refused("metric", metric.id, say<"a finite number">());
  return {};
}

}  // namespace

Result<std::vector<json>> statementsOf(const Attempt& attempt, const XapiOptions& options) {
  if (auto usable = checkOptions(options); !usable) return passOn(usable.error());
  try {
    auto made = AttemptStatements(attempt, options).all();
    for (const json& each : made) (void)each.dump();
    return made;
  } catch (const json::exception&) {
    return failure(ErrorCode::badField,
                   say<"A text of the attempt '%1' is not valid UTF-8; open the attempt and save it again.">(attempt.id),
                   {{"attempt", attempt.id}});
  }
}

}  // namespace ew
