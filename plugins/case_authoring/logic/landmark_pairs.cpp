#include "logic/landmark_pairs.h"

#include <utility>

namespace ew::case_authoring {
namespace {

std::optional<glm::dvec3> pairPoint(const nlohmann::json& pair, const char* key) {
  if (!pair.contains(key)) return std::nullopt;
  const auto& list = pair[key];
  if (!list.is_array() || list.size() != 3) return std::nullopt;
  glm::dvec3 at(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& number = list[static_cast<std::size_t>(axis)];
    if (!number.is_number()) return std::nullopt;
    at[axis] = number.get<double>();
  }
  return at;
}

std::string pairText(const nlohmann::json& pair, const char* key) {
  return pair.contains(key) && pair[key].is_string() ? pair[key].get<std::string>() : std::string();
}

}  // namespace

std::string placingSchema() {
  return R"({"$schema": "http://json-schema.org/draft-07/schema#", "description": "an object", "type": "object", "properties": {
    "pairs": {"description": "a list of at most 100 pairs of places", "type": "array", "maxItems": 100, "items": {
      "description": "an object", "type": "object", "properties": {
        "name": {"description": "a text of at most 200 characters", "type": "string", "maxLength": 200},
        "file_mm": {"description": "three numbers: a place in the volume's own file, in mm", "type": "array", "minItems": 3, "maxItems": 3,
          "items": {"description": "a number", "type": "number"}},
        "world_mm": {"description": "three numbers: a place on the body, in mm", "type": "array", "minItems": 3, "maxItems": 3,
          "items": {"description": "a number", "type": "number"}},
        "landmark": {"description": "the id of a named place of the mannequin", "type": "string", "maxLength": 200}}}}}})";
}

std::vector<DraftPair> pairsIn(const std::optional<nlohmann::json>& section) {
  std::vector<DraftPair> pairs;
  if (!section || !section->is_object() || !section->contains("pairs") || !(*section)["pairs"].is_array()) return pairs;
  for (const auto& one : (*section)["pairs"])
    if (one.is_object())
      pairs.push_back({pairText(one, "name"), pairPoint(one, "file_mm"), pairPoint(one, "world_mm"), pairText(one, "landmark")});
  return pairs;
}

std::optional<nlohmann::json> withPairs(std::optional<nlohmann::json> section, std::span<const DraftPair> pairs) {
  nlohmann::json next = section && section->is_object() ? *section : nlohmann::json::object();
  nlohmann::json list = nlohmann::json::array();
  const auto numbers = [](const glm::dvec3& at) { return nlohmann::json{at.x, at.y, at.z}; };
  for (const DraftPair& each : pairs) {
    nlohmann::json one = nlohmann::json::object();
    if (!each.name.empty()) one["name"] = each.name;
    if (each.file_mm) one["file_mm"] = numbers(*each.file_mm);
    if (each.world_mm) one["world_mm"] = numbers(*each.world_mm);
    if (!each.landmark.empty()) one["landmark"] = each.landmark;
    list.push_back(std::move(one));
  }
  if (list.empty())
    next.erase("pairs");
  else
    next["pairs"] = std::move(list);
  return next.empty() ? std::nullopt : std::optional(std::move(next));
}

PairsFit fitOf(std::span<const DraftPair> pairs) {
  std::vector<PlacingPair> complete;
  std::vector<std::size_t> drafts;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    if (!pairs[n].isComplete()) continue;
    complete.push_back({pairs[n].name.empty() ? std::to_string(n + 1) : pairs[n].name, *pairs[n].file_mm, *pairs[n].world_mm});
    drafts.push_back(n);
  }
  PairsFit found{placeByLandmarks(complete), std::vector<std::optional<double>>(pairs.size()), complete.size()};
  if (!found.fit) return found;
  for (std::size_t n = 0; n < drafts.size(); ++n) {
    const double here_mm = found.fit->residuals_mm[n];
    found.residuals_mm[drafts[n]] = here_mm;
    if (!found.worst || here_mm > *found.residuals_mm[*found.worst]) found.worst = drafts[n];
  }
  if (found.fit->wrong) found.wrong = drafts[*found.fit->wrong];
  return found;
}

}  // namespace ew::case_authoring
