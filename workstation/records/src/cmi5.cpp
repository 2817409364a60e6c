#include "ew/records/cmi5.h"

#include <array>
#include <map>

#include "ew/core/foreign_json.h"
#include "ew/core/json_fields.h"
#include "ew/records/xapi.h"
#include "iri.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestLaunch_bytes = 64u << 10;

constexpr std::array<std::pair<std::string_view, Cmi5Mode>, 3> kModes = {
    {{"Normal", Cmi5Mode::normal}, {"Browse", Cmi5Mode::browse}, {"Review", Cmi5Mode::review}}};
constexpr std::array<std::pair<std::string_view, Cmi5MoveOn>, 5> kMoveOns = {{{"NotApplicable", Cmi5MoveOn::notApplicable},
                                                                              {"Passed", Cmi5MoveOn::passed},
                                                                              {"Completed", Cmi5MoveOn::completed},
                                                                              {"CompletedAndPassed", Cmi5MoveOn::completedAndPassed},
                                                                              {"CompletedOrPassed", Cmi5MoveOn::completedOrPassed}}};

tl::unexpected<Error> unusable(const char* field, Message why) {
  return failure(ErrorCode::badField,
                 say<"This launch cannot be used: %1 %2. Start the lesson again from the learning management system.">(std::string(field),
                                                                                                                       std::move(why)),
                 {{"field", field}});
}

/// The parameters behind '?', decoded; the first of each name.
Result<std::map<std::string, std::string>> parametersOf(std::string_view url) {
  std::map<std::string, std::string> found;
  const auto question = url.find('?');
  if (question == std::string_view::npos || url.size() > kLongestLaunch_bytes)
    return unusable("url", say<"has no parameters behind a question mark">());
  std::string_view rest = url.substr(question + 1);
  rest = rest.substr(0, rest.find('#'));
  while (!rest.empty()) {
    const auto end = std::min(rest.find('&'), rest.size());
    std::string pair(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const auto equals = std::min(pair.find('='), pair.size());
    for (std::size_t n = equals; n < pair.size(); ++n)
      if (pair[n] == '+') pair[n] = ' ';  // as forms write a space
    const auto name = records::decoded(std::string_view(pair).substr(0, equals));
    const auto value = records::decoded(std::string_view(pair).substr(std::min(equals + 1, pair.size())));
    if (!name || !value) return unusable("url", say<"has a '%' that is not followed by two hexadecimal digits">());
    found.emplace(*name, *value);
  }
  return found;
}

/// An agent with an account, as 9.2 asks for. Some systems put it into a list of one.
Result<json> actorOf(const std::string& text) {
  json actor = jsonOrNull(text);
  if (actor.is_array() && actor.size() == 1) actor = json(actor[0]);
  const bool isAgent = memberOf(actor, "objectType").is_null() || textAt(actor, "objectType") == "Agent";
  const json& account = memberOf(actor, "account");
  const bool hasAccount = memberOf(account, "homePage").is_string() && memberOf(account, "name").is_string();
  if (!isAgent || !hasAccount) return unusable("actor", say<"is no agent with an account">());
  actor["objectType"] = "Agent";
  return actor;
}

}  // namespace

Result<Cmi5Launch> cmi5LaunchOf(std::string_view url, const Cmi5Options& options) {
  const auto parameters = parametersOf(url);
  if (!parameters) return passOn(parameters.error());
  for (const char* name : {"endpoint", "fetch", "actor", "registration", "activityId"})
    if (const auto at = parameters->find(name); at == parameters->end() || at->second.empty()) return unusable(name, say<"is missing">());
  Cmi5Launch launch;
  auto endpoint = records::safeEndpoint(parameters->at("endpoint"), options.allowsHttp, say<"The launch's endpoint">());
  if (!endpoint) return passOn(endpoint.error());
  auto fetch = records::safeAddress(parameters->at("fetch"), options.allowsHttp, say<"The launch's fetch address">());
  if (!fetch) return passOn(fetch.error());
  auto actor = actorOf(parameters->at("actor"));
  if (!actor) return passOn(actor.error());
  launch.endpoint = std::move(*endpoint);
  launch.fetch = std::move(*fetch);
  launch.actor = std::move(*actor);
  launch.registration = parameters->at("registration");
  launch.activityId = parameters->at("activityId");
  if (!isUuid(launch.registration)) return unusable("registration", say<"is no UUID">());
  if (!records::isIri(launch.activityId)) return unusable("activityId", say<"is no address">());
  return launch;
}

std::string launchHost(const Cmi5Launch& launch) { return records::hostOf(launch.endpoint); }

Result<Cmi5LaunchData> cmi5LaunchDataOf(const json& document) {
  JsonReading reading(verbatim("LMS.LaunchData"));
  const JsonFields fields(document, reading);
  Cmi5LaunchData data;
  const JsonFields context = fields.object("contextTemplate");
  if (!fields.has("contextTemplate")) fields.refuse("contextTemplate", say<"an object">());
  for (const char* part : {"contextActivities", "extensions"}) static_cast<void>(context.object(part));  // statements are put into these
  data.contextTemplate = context.value();
  data.mode = fields.word("launchMode", kModes);
  data.moveOn = fields.word("moveOn", kMoveOns, std::optional(Cmi5MoveOn::notApplicable));
  if (fields.has("masteryScore") && !fields.find("masteryScore")->is_null()) data.masteryScore = fields.number("masteryScore", 0.0, 1.0);
  data.launchParameters = fields.text("launchParameters", std::string(), 0, 20'000);
  data.returnUrl = fields.text("returnURL", std::string(), 0, 4000);
  if (reading.problem()) return passOn(*reading.problem());
  if (!data.returnUrl.empty() && !records::isWebAddress(data.returnUrl)) data.returnUrl.clear();  // nothing that is opened afterwards
  return data;
}

}  // namespace ew
