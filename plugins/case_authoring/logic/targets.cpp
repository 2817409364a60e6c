#include "logic/targets.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ew::case_authoring {
namespace {

using nlohmann::json;

/// Calls `call(text)` for each place in the steps of lessons that names a target.
template <class Json, class Call>
void eachName(Json& otherFields, const Call& call) {
  const json::json_pointer lessonsAt("/parts/lessons/lessons");
  if (!otherFields.contains(lessonsAt) || !otherFields[lessonsAt].is_array()) return;
  for (auto& lesson : otherFields[lessonsAt]) {
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

bool isNamed(const Case& shown, const std::string& name) {
  return std::any_of(shown.targets.begin(), shown.targets.end(), [&](const CaseTarget& each) { return each.name == name; });
}

}  // namespace

const CaseTarget* targetAt(const Case& shown, std::size_t number) {
  return number < shown.targets.size() ? &shown.targets[number] : nullptr;
}

CaseTarget pointTarget(const std::string& name, const glm::dvec3& at_mm) {
  return {.kind = CaseTarget::Kind::point, .name = name, .at_mm = at_mm, .tolerance_mm = 5.0};
}
CaseTarget planeTarget(const std::string& name, const Transform<frame::File, frame::Probe>& probeToFile) {
  return {
      .kind = CaseTarget::Kind::plane, .name = name, .probeToFile = probeToFile, .positionTolerance_mm = 5.0, .angleTolerance_deg = 10.0};
}
CaseTarget structureTarget(const std::string& name, int label) {
  return {.kind = CaseTarget::Kind::structure, .name = name, .label = label};
}
CaseTarget organTarget(const std::string& name, const std::string& organ) {
  return {.kind = CaseTarget::Kind::structure, .name = name, .organ = organ};
}

Case withTargetAdded(Case edited, CaseTarget target) {
  edited.targets.push_back(std::move(target));
  return edited;
}

Case withTarget(Case edited, std::size_t number, const std::function<void(CaseTarget&)>& change) {
  if (number < edited.targets.size()) change(edited.targets[number]);
  return edited;
}

Case withoutTarget(Case edited, std::size_t number) {
  if (number < edited.targets.size()) edited.targets.erase(edited.targets.begin() + static_cast<std::ptrdiff_t>(number));
  return edited;
}

Case withTargetMoved(Case edited, std::size_t from, std::size_t to) {
  auto& list = edited.targets;
  if (from >= list.size() || to >= list.size() || from == to) return edited;
  const CaseTarget moved = list[from];
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(from));
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(to), moved);
  return edited;
}

Case withTargetRenamed(Case edited, std::size_t number, const std::string& name) {
  if (number >= edited.targets.size()) return edited;
  const std::string before = std::exchange(edited.targets[number].name, name);
  // Names need not differ: while another target has the old one, steps may mean that.
  if (!isNamed(edited, before) && !before.empty())
    eachName(edited.otherFields, [&](json& named) {
      if (named == before) named = name;
    });
  return edited;
}

std::size_t stepsNaming(const Case& shown, const std::string& target) {
  std::size_t count = 0;
  eachName(shown.otherFields, [&](const json& named) { count += named == target ? 1 : 0; });
  return count;
}

std::string freeTargetName(const Case& shown, const std::string& wished) {
  std::string name = wished;
  for (int number = 2; isNamed(shown, name); ++number) name = wished + " " + std::to_string(number);
  return name;
}

bool isLabelled(const Case& shown, int label) {
  return std::any_of(shown.targets.begin(), shown.targets.end(), [&](const CaseTarget& each) { return each.label == label; });
}

bool hasPatient(const Case& shown) { return !shown.volume.recipe.empty(); }

int freeLabel(const Case& shown, const Volume* labels) {
  std::array<bool, 256> isTaken{};
  isTaken[0] = true;
  const auto take = [&](int label) {
    if (label >= 0 && label < 256) isTaken[static_cast<std::size_t>(label)] = true;
  };
  for (const CaseTarget& each : shown.targets) take(each.label.value_or(0));
  for (const TissueAcoustics& each : shown.scene.tissues) take(each.label);
  if (labels != nullptr)
    for (const std::uint8_t label : labels->echo) isTaken[label] = true;
  const auto free = std::find(isTaken.begin(), isTaken.end(), false);
  return free == isTaken.end() ? 0 : static_cast<int>(free - isTaken.begin());
}

}  // namespace ew::case_authoring
