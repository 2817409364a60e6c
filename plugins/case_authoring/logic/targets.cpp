#include "logic/targets.h"

#include <algorithm>
#include <array>

#include "logic/edits.h"

namespace ew::case_authoring {
namespace {

using nlohmann::json;

json targetsIn(const json& manifest) {
  auto list = fieldOf(manifest, "targets");
  return list.is_array() ? list : json::array();
}

json withTargets(json manifest, json list) {
  return withField(std::move(manifest), "targets", list.empty() ? std::nullopt : std::optional<json>(std::move(list)));
}

/// Calls `call(text)` for each place in the steps of lessons that names a target.
template <class Json, class Call>
void eachName(Json& manifest, const Call& call) {
  const json::json_pointer lessonsAt("/parts/lessons/lessons");
  if (!manifest.contains(lessonsAt) || !manifest[lessonsAt].is_array()) return;
  for (auto& lesson : manifest[lessonsAt]) {
    if (!lesson.is_object() || !lesson.contains("steps") || !lesson["steps"].is_array()) continue;
    for (auto& step : lesson["steps"]) {
      if (!step.is_object() || step.contains("case")) continue;
      if (step.contains("target") && step["target"].is_string()) call(step["target"]);
      if (!step.contains("targets") || !step["targets"].is_array()) continue;
      for (auto& each : step["targets"])
        if (each.is_string()) call(each);
    }
  }
}

}  // namespace

std::size_t targetCount(const json& manifest) { return targetsIn(manifest).size(); }

json targetAt(const json& manifest, std::size_t number) {
  const json list = targetsIn(manifest);
  return number < list.size() ? list[number] : json();
}

std::string kindOf(const json& target) { return textOf(target, "kind"); }

json pointTarget(const std::string& name, const glm::dvec3& at_mm) {
  return {{"kind", "point"}, {"name", name}, {"at_mm", {at_mm.x, at_mm.y, at_mm.z}}, {"tolerance_mm", 5.0}};
}
json planeTarget(const std::string& name, const Transform<frame::File, frame::Probe>& probeToFile) {
  return {{"kind", "plane"},
          {"name", name},
          {"probe_to_world", rowsOf(probeToFile)},
          {"position_tolerance_mm", 5.0},
          {"angle_tolerance_deg", 10.0}};
}
json structureTarget(const std::string& name, int label) { return {{"kind", "structure"}, {"name", name}, {"label", label}}; }
json organTarget(const std::string& name, const std::string& organ) { return {{"kind", "structure"}, {"name", name}, {"organ", organ}}; }

json withTargetAdded(json manifest, const json& target) {
  json list = targetsIn(manifest);
  list.push_back(target);
  return withTargets(std::move(manifest), std::move(list));
}

json withTarget(json manifest, std::size_t number, const json& target) {
  json list = targetsIn(manifest);
  if (number >= list.size()) return manifest;
  list[number] = target;
  return withTargets(std::move(manifest), std::move(list));
}

json withoutTarget(json manifest, std::size_t number) {
  json list = targetsIn(manifest);
  if (number >= list.size()) return manifest;
  list.erase(number);
  return withTargets(std::move(manifest), std::move(list));
}

json withTargetMoved(json manifest, std::size_t from, std::size_t to) {
  json list = targetsIn(manifest);
  if (from >= list.size() || to >= list.size() || from == to) return manifest;
  const json moved = list[from];
  list.erase(from);
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(to), moved);
  return withTargets(std::move(manifest), std::move(list));
}

json withTargetRenamed(json manifest, std::size_t number, const std::string& name) {
  json target = targetAt(manifest, number);
  if (target.is_null()) return manifest;
  const std::string before = textOf(target, "name");
  target["name"] = name;
  json renamed = withTarget(std::move(manifest), number, target);
  // Names need not differ: while another target has the old one, steps may mean that.
  const json list = targetsIn(renamed);
  const bool isShared = std::any_of(list.begin(), list.end(), [&](const json& each) { return textOf(each, "name") == before; });
  if (!isShared && !before.empty())
    eachName(renamed, [&](json& named) {
      if (named == before) named = name;
    });
  return renamed;
}

std::size_t stepsNaming(const json& manifest, const std::string& target) {
  std::size_t count = 0;
  eachName(manifest, [&](const json& named) { count += named == target ? 1 : 0; });
  return count;
}

std::string freeTargetName(const json& manifest, const std::string& wished) {
  const json list = targetsIn(manifest);
  const auto isTaken = [&](const std::string& name) {
    return std::any_of(list.begin(), list.end(), [&](const json& each) { return textOf(each, "name") == name; });
  };
  std::string name = wished;
  for (int number = 2; isTaken(name); ++number) name = wished + " " + std::to_string(number);
  return name;
}

std::optional<glm::dvec3> pointOf(const json& target) {
  const json at = fieldOf(target, "at_mm");
  if (!at.is_array() || at.size() != 3 || !std::all_of(at.begin(), at.end(), [](const json& n) { return n.is_number(); }))
    return std::nullopt;
  return glm::dvec3(at[0].get<double>(), at[1].get<double>(), at[2].get<double>());
}

std::optional<Transform<frame::File, frame::Probe>> planeOf(const json& target) {
  const json rows = fieldOf(target, "probe_to_world");
  if (!rows.is_array() || rows.size() != 16 || !std::all_of(rows.begin(), rows.end(), [](const json& n) { return n.is_number(); }))
    return std::nullopt;
  return Transform<frame::File, frame::Probe>{matrixFromRows(rows.get<std::array<double, 16>>())};
}

std::optional<int> labelOf(const json& target) {
  const json label = fieldOf(target, "label");
  return label.is_number_integer() ? std::optional(label.get<int>()) : std::nullopt;
}

double numberOf(const json& target, const char* key, double otherwise) {
  const json number = fieldOf(target, key);
  return number.is_number() ? number.get<double>() : otherwise;
}

bool isLabelled(const json& manifest, int label) {
  const json list = targetsIn(manifest);
  return std::any_of(list.begin(), list.end(), [&](const json& each) { return labelOf(each) == label; });
}

bool hasPatient(const json& manifest) { return fieldOf(manifest, "volume.recipe").is_string(); }

int freeLabel(const json& manifest, const Volume* labels) {
  std::array<bool, 256> isTaken{};
  isTaken[0] = true;
  const auto take = [&](const json& list) {
    if (!list.is_array()) return;
    for (const json& each : list)
      if (const auto label = labelOf(each); label && *label >= 0 && *label < 256) isTaken[static_cast<std::size_t>(*label)] = true;
  };
  take(targetsIn(manifest));
  take(fieldOf(manifest, "scene.tissues"));
  if (labels != nullptr)
    for (const std::uint8_t label : labels->echo) isTaken[label] = true;
  const auto free = std::find(isTaken.begin(), isTaken.end(), false);
  return free == isTaken.end() ? 0 : static_cast<int>(free - isTaken.begin());
}

}  // namespace ew::case_authoring
