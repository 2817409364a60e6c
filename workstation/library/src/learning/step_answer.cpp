#include "ew/library/step_answer.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "ew/core/foreign_json.h"

namespace ew {
namespace {

using nlohmann::json;

json placeJson(const glm::dvec3& p_mm) { return {p_mm.x, p_mm.y, p_mm.z}; }

std::optional<glm::dvec3> placeIn(const json& value) {
  if (!value.is_array() || value.size() != 3) return std::nullopt;
  glm::dvec3 at_mm(0.0);
  glm::length_t axis = 0;
  for (const json& each : value) {
    if (!each.is_number()) return std::nullopt;
    at_mm[axis++] = each.get<double>();
  }
  return at_mm;
}

std::vector<glm::dvec3> placesIn(const json& of) {
  std::vector<glm::dvec3> places_mm;
  for (const json& each : listAt(of, "points_mm"))
    if (const auto at_mm = placeIn(each)) places_mm.push_back(*at_mm);
  return places_mm;
}

struct AnswerJson {
  json operator()(std::monostate) const { return nullptr; }
  json operator()(const OptionsAnswer& answer) const { return {{"chosen", answer.chosen}}; }
  json operator()(const NumberAnswer& answer) const { return {{"number", answer.number}}; }
  json operator()(const WatchAnswer& answer) const { return {{"watched", answer.watched}}; }
  json operator()(const PointAnswer& answer) const { return {{"at_mm", placeJson(answer.at_mm)}}; }
  json operator()(const MeasurementAnswer& answer) const {
    json made = {{"value", answer.value}, {"unit", answer.unit}};
    if (answer.caliper) made["caliper"] = *answer.caliper;
    for (const glm::dvec3& p_mm : answer.points_mm) made["points_mm"].push_back(placeJson(p_mm));
    return made;
  }
  json operator()(const CalipersAnswer& answer) const {
    json measurements = json::array();
    for (const CaliperReading& each : answer.measurements) {
      json one = {{"caliper", each.caliper}, {"figures", json::array()}, {"points_mm", json::array()}};
      for (const Figure& figure : each.figures)
        one["figures"].push_back({{"name", figure.name}, {"value", figure.value}, {"unit", figure.unit}});
      for (const glm::dvec3& p_mm : each.points_mm) one["points_mm"].push_back(placeJson(p_mm));
      measurements.push_back(std::move(one));
    }
    return {{"measurements", std::move(measurements)}};
  }
};

CaliperReading readingIn(const json& each) {
  CaliperReading made{textAt(each, "caliper"), {}, placesIn(each)};
  for (const json& figure : listAt(each, "figures")) {
    const auto value = numberAt(figure, "value");
    if (value && memberOf(figure, "name").is_string() && memberOf(figure, "unit").is_string())
      made.figures.push_back({textAt(figure, "name"), *value, textAt(figure, "unit")});
  }
  return made;
}

MeasurementAnswer measurementIn(const json& document, double value) {
  MeasurementAnswer made{value, textAt(document, "unit"), {}, placesIn(document)};
  if (memberOf(document, "caliper").is_string()) made.caliper = textAt(document, "caliper");
  return made;
}

}  // namespace

StepAnswer stepAnswerFromJson(const json& document) {
  if (memberOf(document, "measurements").is_array()) {
    CalipersAnswer made;
    for (const json& each : listAt(document, "measurements")) made.measurements.push_back(readingIn(each));
    return made;
  }
  if (const auto value = numberAt(document, "value"); value && memberOf(document, "unit").is_string())
    return measurementIn(document, *value);
  if (memberOf(document, "chosen").is_array()) {
    OptionsAnswer made;
    for (const json& each : listAt(document, "chosen"))
      if (each.is_number_unsigned()) made.chosen.push_back(each.get<std::size_t>());
    return made;
  }
  if (const auto number = numberAt(document, "number")) return NumberAnswer{*number};
  if (memberOf(document, "watched").is_boolean()) return WatchAnswer{flagAt(document, "watched")};
  if (const auto at_mm = placeIn(memberOf(document, "at_mm"))) return PointAnswer{*at_mm};
  return {};
}

json jsonOf(const StepAnswer& answer) { return std::visit(AnswerJson{}, answer); }

}  // namespace ew
