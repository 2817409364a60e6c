#include <algorithm>

#include "ew/assessment/attempt_result.h"
#include "ew/core/foreign_json.h"
#include "ew/core/json_fields.h"
#include "ew/records/cmi5.h"
#include "ew/records/xapi.h"
#include "http.h"
#include "iri.h"

namespace ew {
namespace {

using nlohmann::json;
using records::encoded;
using records::HttpClient;
using records::HttpTrouble;

constexpr const char* kCmi5Category = "https://w3id.org/xapi/cmi5/context/categories/cmi5";
constexpr const char* kMoveOnCategory = "https://w3id.org/xapi/cmi5/context/categories/moveon";
constexpr const char* kMasteryExtension = "https://w3id.org/xapi/cmi5/context/extensions/masteryscore";
constexpr std::string_view kCmi5Space = "3b7a3c1e-0d0f-5c38-8a3b-0d5ce7b2a9f4";

tl::unexpected<Error> notBegun(Message why) {
  return failure(ErrorCode::notReadable,
                 say<"The lesson cannot be begun for the learning management system: %1. Start it there again.">(std::move(why)));
}

tl::unexpected<Error> noAnswer(const records::HttpFailure& failed) {
  if (failed.trouble == HttpTrouble::cancelled) return failure(ErrorCode::cancelled, say<"Stopped as asked.">());
  return notBegun(say<"it does not answer (%1)">(records::tamed(failed.why)));
}

/// 8.2: one POST. An error is either a status or an object with "error-code" and "error-text".
Result<std::string> fetchToken(const Cmi5Launch& launch, HttpClient& client, const Progress& progress) {
  const auto answer = client.ask({"POST", launch.fetch, {"Accept: application/json", "Content-Length: 0"}, {}}, progress);
  if (!answer) return noAnswer(answer.error());
  const json said = jsonOrNull(answer->body);
  if (said.is_object() && said.contains("error-code"))
    return notBegun(say<"it gives no token (error %1, %2)">(records::tamed(wordsAt(said, "error-code")),
                                                            records::inQuotes(wordsAt(said, "error-text"))));
  if (answer->status != 200)
    return notBegun(say<"it gives no token (%1 %2)">(answer->status, records::inQuotes(records::wordsOf(*answer, {}))));
  const std::string token = textAt(said, "auth-token");
  if (!bearerAuthorization(token)) return notBegun(say<"what it gives is no token">());  // letters of a token alone: it goes into a header
  return "Basic " + token;
}

Result<json> fetchLaunchData(const Cmi5Launch& launch, const RecordStore& store, HttpClient& client, const Progress& progress) {
  const std::string resource = "activities/state?stateId=LMS.LaunchData&activityId=" + encoded(launch.activityId) +
                               "&agent=" + encoded(launch.actor.dump()) + "&registration=" + encoded(launch.registration);
  const auto answer = client.ask(records::questionFor(store, "GET", resource), progress);
  if (!answer) return noAnswer(answer.error());
  if (answer->status != 200)
    return notBegun(say<"it has no launch data (%1 %2)">(
        answer->status, records::inQuotes(records::wordsOf(*answer, records::secretsIn(store.authorization)))));
  return parseJsonObject(answer->body, verbatim("LMS.LaunchData"));
}

/// 11: what the learner prefers. Nobody has to have it, so nothing is made of its absence.
std::string fetchLanguage(const Cmi5Launch& launch, const RecordStore& store, HttpClient& client, const Progress& progress) {
  const std::string resource = "agents/profile?profileId=cmi5LearnerPreferences&agent=" + encoded(launch.actor.dump());
  const auto answer = client.ask(records::questionFor(store, "GET", resource), progress);
  if (!answer || answer->status != 200) return {};
  const std::string language = textAt(jsonOrNull(answer->body), "languagePreference");
  return language.size() <= 200 ? language : std::string();
}

/// `theirs` into `ours`: lists of activities are joined, what they say about anything else stands.
void mergeTemplate(json& ours, const json& theirs) {
  for (const auto& [name, value] : theirs.items()) {
    if (name == "contextActivities" && value.is_object()) {
      for (const auto& [kind, activities] : value.items()) {
        json& list = ours["contextActivities"][kind];
        if (!list.is_array()) list = list.is_null() ? json::array() : json::array({list});
        for (const json& each : activities.is_array() ? activities : json::array({activities}))
          if (std::find(list.begin(), list.end(), each) == list.end()) list.push_back(each);
      }
    } else if (value.is_object() && ours.contains(name) && ours[name].is_object()) {
      ours[name].update(value);
    } else {
      ours[name] = value;
    }
  }
}

void addCategory(json& statement, const char* id) {
  statement["context"]["contextActivities"]["category"].push_back({{"objectType", "Activity"}, {"id", id}});
}

double secondsBetween(Cmi5Session::Moment from, Cmi5Session::Moment to) { return std::chrono::duration<double>(to - from).count(); }

}  // namespace

Result<Cmi5Session> Cmi5Session::begin(Cmi5Launch launch, const Cmi5Options& options, const Progress& progress) {
  Cmi5Session session;
  session.store_.endpoint = launch.endpoint;
  session.store_.allowsHttp = options.allowsHttp;
  session.store_.certificates = options.certificates;
  session.store_.connect_s = options.connect_s;
  session.store_.timeout_s = options.timeout_s;
  session.launch_ = std::move(launch);
  HttpClient client(session.store_);
  auto token = fetchToken(session.launch_, client, progress);
  if (!token) return passOn(token.error());
  session.store_.authorization = std::move(*token);
  auto document = fetchLaunchData(session.launch_, session.store_, client, progress);
  if (!document) return passOn(document.error());
  auto data = cmi5LaunchDataOf(*document);
  if (!data) return passOn(data.error());
  session.data_ = std::move(*data);
  session.data_.languagePreference = fetchLanguage(session.launch_, session.store_, client, progress);
  return session;
}

/// Ids come from the session and the verb: said twice it is the same statement.
json Cmi5Session::statement(const char* verb, Moment now) const {
  json made = {{"actor", launch_.actor},
               {"verb", {{"id", std::string("http://adlnet.gov/expapi/verbs/") + verb}, {"display", {{"en", verb}}}}},
               {"object", {{"objectType", "Activity"}, {"id", launch_.activityId}}},
               {"context", {{"registration", launch_.registration}, {"contextActivities", {{"category", json::array()}}}}},
               {"timestamp", timestampText(now)},
               {"version", kXapiVersion}};
  mergeTemplate(made["context"], data_.contextTemplate);
  made["context"]["registration"] = launch_.registration;
  addCategory(made, kCmi5Category);
  const std::string begun = timestampText(begunAt_.value_or(now));
  made["id"] = uuidOfName(
      kCmi5Space, launch_.registration + "\n" + launch_.activityId + "\n" + data_.contextTemplate.dump() + "\n" + begun + "\n" + verb);
  return made;
}

Result<void> Cmi5Session::expectOpen(const Message& what) const {
  if (isOpen()) return {};
  return failure(ErrorCode::badUsage,
                 say<"%1 cannot be said: the session %2.">(what, isTerminated_ ? say<"has ended">() : say<"has not begun">()));
}

Result<json> Cmi5Session::initialized(Moment now) {
  if (begunAt_) return failure(ErrorCode::badUsage, say<"A session is initialized once, and this one is.">());
  json made = statement("initialized", now);
  begunAt_ = now;
  return made;
}

Result<json> Cmi5Session::completed(Moment now, std::optional<double> worked_s) {
  if (auto open = expectOpen(say<"That the lesson was completed">()); !open) return passOn(open.error());
  if (data_.mode != Cmi5Mode::normal || isCompleted_)
    return failure(ErrorCode::badUsage, say<"That the lesson was completed is said once, and only when it counts.">());
  json made = statement("completed", now);
  made["result"] = {{"completion", true}, {"duration", isoDuration(worked_s.value_or(secondsBetween(*begunAt_, now)))}};
  addCategory(made, kMoveOnCategory);
  isCompleted_ = true;
  return made;
}

Result<json> Cmi5Session::judged(std::optional<double> score, bool success, Moment now, std::optional<double> worked_s) {
  if (auto open = expectOpen(say<"Whether the lesson was passed">()); !open) return passOn(open.error());
  if (data_.mode != Cmi5Mode::normal || passed_)
    return failure(ErrorCode::badUsage, say<"Whether the lesson was passed is said once, and only when it counts.">());
  if (score && !(*score >= 0.0 && *score <= 1.0))
    return failure(ErrorCode::badField, say<"A score must be a number from 0 to 1.">(), {{"field", "score"}});
  const bool isMeasured = score && data_.masteryScore;
  const bool isPassed = passedForSystem(score, success, data_.masteryScore);
  if (isMeasured && isPassed) score = std::max(*score, *data_.masteryScore);  // a "passed" below it, by a last digit, is refused
  json made = statement(isPassed ? "passed" : "failed", now);
  made["result"] = {{"success", isPassed}, {"duration", isoDuration(worked_s.value_or(secondsBetween(*begunAt_, now)))}};
  if (score) made["result"]["score"] = {{"scaled", *score}};
  if (data_.masteryScore) made["context"]["extensions"][kMasteryExtension] = *data_.masteryScore;
  addCategory(made, kMoveOnCategory);
  passed_ = isPassed;
  return made;
}

Result<json> Cmi5Session::terminated(Moment now) {
  if (auto open = expectOpen(say<"That the session has ended">()); !open) return passOn(open.error());
  json made = statement("terminated", now);
  made["result"] = {{"duration", isoDuration(secondsBetween(*begunAt_, now))}};
  isTerminated_ = true;
  return made;
}

bool Cmi5Session::movesOn() const {
  const bool isPassed = passed_.value_or(false);
  switch (data_.moveOn) {
    case Cmi5MoveOn::passed:
      return isPassed;
    case Cmi5MoveOn::completed:
      return isCompleted_;
    case Cmi5MoveOn::completedAndPassed:
      return isPassed && isCompleted_;
    case Cmi5MoveOn::completedOrPassed:
      return isPassed || isCompleted_;
    case Cmi5MoveOn::notApplicable:
      return true;
  }
  return true;
}

}  // namespace ew
