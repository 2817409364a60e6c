#include <array>
#include <cmath>
#include <cstdio>

#include "ew/records/xapi.h"

namespace ew {
namespace {

struct VerbWords {
  XapiVerb verb;
  const char* id;
  const char* en;
  const char* de;
};
// ADL's vocabulary (https://w3id.org/xapi/adl/verbs); "skipped" is not in it and comes from the Tin Can registry.
constexpr std::array<VerbWords, 8> kVerbs = {{
    {XapiVerb::attempted, "http://adlnet.gov/expapi/verbs/attempted", "attempted", "versuchte"},
    {XapiVerb::answered, "http://adlnet.gov/expapi/verbs/answered", "answered", "beantwortete"},
    {XapiVerb::completed, "http://adlnet.gov/expapi/verbs/completed", "completed", "schloss ab"},
    {XapiVerb::passed, "http://adlnet.gov/expapi/verbs/passed", "passed", "bestand"},
    {XapiVerb::failed, "http://adlnet.gov/expapi/verbs/failed", "failed", "bestand nicht"},
    {XapiVerb::skipped, "http://id.tincanapi.com/verb/skipped", "skipped", "übersprang"},
    {XapiVerb::initialized, "http://adlnet.gov/expapi/verbs/initialized", "initialized", "begann"},
    {XapiVerb::terminated, "http://adlnet.gov/expapi/verbs/terminated", "terminated", "beendete"},
}};

}  // namespace

nlohmann::json jsonOf(XapiVerb verb) {
  for (const VerbWords& each : kVerbs)
    if (each.verb == verb) return {{"id", each.id}, {"display", {{"en", each.en}, {"de", each.de}}}};
  return nullptr;
}

std::string isoDuration(double seconds) {
  const long long hundredths = std::llround(std::max(seconds, 0.0) * 100.0);
  const long long hours = hundredths / 360'000, minutes = hundredths / 6000 % 60, rest = hundredths % 6000;
  std::string text = "PT";
  if (hours > 0) text += std::to_string(hours) + "H";
  if (minutes > 0) text += std::to_string(minutes) + "M";
  if (rest == 0 && hundredths > 0) return text;
  text += std::to_string(rest / 100);
  if (rest % 100 != 0) {
    std::array<char, 8> fraction{};
    std::snprintf(fraction.data(), fraction.size(), ".%02d", static_cast<int>(rest % 100));
    text += fraction.data();
  }
  return text + "S";
}

std::string timestampText(std::chrono::sys_time<std::chrono::milliseconds> moment) {
  const auto day = std::chrono::floor<std::chrono::days>(moment);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss time(moment - day);
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), static_cast<int>(time.hours().count()),
                static_cast<int>(time.minutes().count()), static_cast<int>(time.seconds().count()),
                static_cast<int>(time.subseconds().count()));
  return text.data();
}

std::optional<std::chrono::sys_time<std::chrono::milliseconds>> momentOfTimestamp(const std::string& text) {
  int year = 0, hour = 0, minute = 0, second = 0, end = 0;
  unsigned month = 0, day = 0;
  if (std::sscanf(text.c_str(), "%4d-%2u-%2uT%2d:%2d:%2d%n", &year, &month, &day, &hour, &minute, &second, &end) != 6) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  if (!date.ok() || hour > 23 || minute > 59 || second > 60) return std::nullopt;
  auto at = static_cast<std::size_t>(end);
  int thousandths = 0;
  if (at < text.size() && (text[at] == '.' || text[at] == ',')) {
    int weight = 100;
    for (++at; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at, weight /= 10) thousandths += weight * (text[at] - '0');
  }
  std::chrono::minutes offset{0};
  const std::string zone = text.substr(at);
  if (zone != "Z" && zone != "z") {
    int hours = 0, minutes = 0, length = 0;
    if (zone.size() < 3 || (zone[0] != '+' && zone[0] != '-')) return std::nullopt;
    const char* format = zone.find(':') != std::string::npos ? "%2d:%2d%n" : "%2d%2d%n";
    if (std::sscanf(zone.c_str() + 1, format, &hours, &minutes, &length) != 2 && zone.size() != 3) return std::nullopt;
    offset = std::chrono::minutes((zone[0] == '-' ? -1 : 1) * (hours * 60 + minutes));
  }
  return std::chrono::sys_days(date) + std::chrono::hours(hour) + std::chrono::minutes(minute) + std::chrono::seconds(second) +
         std::chrono::milliseconds(thousandths) - offset;
}

}  // namespace ew
