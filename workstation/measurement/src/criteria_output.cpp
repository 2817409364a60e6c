#include <nlohmann/json.hpp>

#include "ew/core/numbers.h"
#include "ew/measurement/criteria.h"
#include "quantity_json.h"

namespace ew::measurement {
namespace {

using nlohmann::ordered_json;

Message titleList(const std::vector<Words>& all, std::string_view language) {
  std::vector<Message> parts;
  for (const Words& each : all) parts.push_back(verbatim(each.in(language)));
  return joined(std::move(parts), ", ");
}

Message criteriaNameOf(const Grade& grade, std::string_view language) { return criteriaName(grade.name, grade.year, language); }

Message valueText(const ConditionReading& reading, std::string_view language) {
  return reading.value ? quantityText(*reading.value) : verbatim(reading.seen.in(language));
}

/// "Peak systolic velocity 200 cm/s (125 to 230 cm/s)", "Plaque seen".
Message basisText(const ConditionReading& reading, std::string_view language) {
  const std::string& title = reading.title.in(language);
  if (!reading.value) return say<"%1 %2">(title, valueText(reading, language));
  return say<"%1 %2 (%3)">(title, valueText(reading, language), conditionText(reading, language));
}

/// What was assumed has a sentence of its own.
Message basesText(const std::vector<ConditionReading>& all, std::string_view language) {
  std::vector<Message> parts;
  for (const ConditionReading& each : all)
    if (!each.isAssumed) parts.push_back(basisText(each, language));
  return joined(std::move(parts), "; ");
}

Message disagreementText(const Grade& grade, const Disagreement& each, std::string_view language) {
  const std::string& title = each.expected.title.in(language);
  if (each.speaksFor.empty())
    return say<"%1 %2 does not go with %3, which expects %4; %5 decides by %6.">(
        title, valueText(each.expected, language), grade.title.in(language), conditionText(each.expected, language),
        criteriaNameOf(grade, language), titleList(grade.primaries, language));
  return say<"%1 %2 speaks for %3, not for %4; %5 decides by %6.">(title, valueText(each.expected, language),
                                                                   titleList(each.speaksFor, language), grade.title.in(language),
                                                                   criteriaNameOf(grade, language), titleList(grade.primaries, language));
}

}  // namespace

Message criteriaName(const Words& name, int year, std::string_view language) {
  return year == 0 ? verbatim(name.in(language)) : say<"%1 (%2)">(name.in(language), year);
}

Message conditionText(const ConditionReading& reading, std::string_view language) {
  const Condition& condition = reading.condition;
  if (!condition.words.empty()) return titleList(reading.asked, language);
  const std::string unit = condition.unit == Unit::one ? "" : " " + std::string(symbolOf(condition.unit));
  // An end whose table goes by something unknown has no number.
  const auto end = [](const std::optional<double>& known) { return known ? numeral(textOf(*known)) : verbatim("?"); };
  if (condition.low && condition.high) {
    if (condition.holdsLow && condition.holdsHigh) return say<"%1 to %2%3">(end(reading.low), end(reading.high), unit);
    if (condition.holdsLow) return say<"from %1 to below %2%3">(end(reading.low), end(reading.high), unit);
    if (condition.holdsHigh) return say<"above %1 up to %2%3">(end(reading.low), end(reading.high), unit);
    return say<"above %1 and below %2%3">(end(reading.low), end(reading.high), unit);
  }
  if (condition.low) return condition.holdsLow ? say<"from %1%2">(end(reading.low), unit) : say<"above %1%2">(end(reading.low), unit);
  return condition.holdsHigh ? say<"up to %1%2">(end(reading.high), unit) : say<"below %1%2">(end(reading.high), unit);
}

std::vector<Message> sentencesOf(const Grade& grade, std::string_view language) {
  std::vector<Message> all;
  const Message name = criteriaNameOf(grade, language);
  if (!grade.word.empty()) {
    all.push_back(say<"%1: %2. Decisive: %3.">(name, grade.title.in(language), basesText(grade.decided, language)));
  } else if (grade.missing.empty()) {
    all.push_back(say<"%1 has no grade for these values.">(name));
  } else {
    std::vector<Words> titles;
    for (const auto& [input, title] : grade.missing) titles.push_back(title);
    all.push_back(
        say<"%1 gives no grade: missing is %2; possible are %3.">(name, titleList(titles, language), titleList(grade.possible, language)));
  }
  for (const auto& [input, choice] : grade.assumed) all.push_back(say<"Assumed: %1, %2.">(input.in(language), choice.in(language)));
  for (const ConditionReading& each : grade.decided)
    if (each.isWithinUncertainty) all.push_back(say<"%1 lies within its uncertainty of a limit.">(basisText(each, language)));
  for (const Disagreement& each : grade.disagreements) all.push_back(disagreementText(grade, each, language));
  return all;
}

std::vector<Message> differencesOf(const std::vector<Grade>& grades, std::string_view language) {
  std::vector<Message> all;
  for (std::size_t a = 0; a < grades.size(); ++a)
    for (std::size_t b = a + 1; b < grades.size(); ++b) {
      const Grade &one = grades[a], &other = grades[b];
      if (one.vessel != other.vessel || one.word == other.word) continue;
      const auto told = [&](const Grade& grade) {
        return grade.word.empty() ? say<"no grade by %1">(criteriaNameOf(grade, language))
                                  : say<"%1 by %2, from %3">(grade.title.in(language), criteriaNameOf(grade, language),
                                                             basesText(grade.decided, language));
      };
      all.push_back(say<"They differ: %1; %2.">(told(one), told(other)));
    }
  return all;
}

ordered_json toJson(const Grade& grade, std::string_view language) {
  ordered_json made = {{"criteria", grade.criteria}, {"name", grade.name.in(language)}};
  if (grade.year != 0) made["year"] = grade.year;
  made.update(ordered_json{{"vessel", grade.vessel}, {"source", grade.source}, {"notice", kTrainingOnly}});
  if (!grade.word.empty()) made.update(ordered_json{{"grade", grade.word}, {"title", grade.title.in(language)}});
  for (const ConditionReading& each : grade.decided) {
    ordered_json one = {{"of", each.condition.of}, {"condition", conditionText(each, language).english()}};
    if (each.value) one.update(jsonOf(*each.value));
    if (!each.value) one["seen"] = each.seen.in(language);
    if (each.isAssumed) one["assumed"] = true;
    if (each.isWithinUncertainty) one["within_uncertainty"] = true;
    made["decided"].push_back(std::move(one));
  }
  for (const auto& [name, title] : grade.missing) made["missing"].push_back(name);
  for (const Words& each : grade.possible) made["possible"].push_back(each.in(language));
  for (const Disagreement& each : grade.disagreements)
    made["disagreements"].push_back({{"of", each.expected.condition.of}, {"says", disagreementText(grade, each, language).english()}});
  for (const Message& sentence : sentencesOf(grade, language)) made["says"].push_back(sentence.english());
  return made;
}

}  // namespace ew::measurement
