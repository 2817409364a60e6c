#include "logic/case_volume.h"

#include <charconv>
#include <set>
#include <string_view>

namespace ew::stitching {
namespace {

using nlohmann::json;

constexpr std::string_view kTarget = "targets[";

std::string fieldOf(const Error& problem) {
  for (const auto& [name, value] : problem.context)
    if (name == "field") return value;
  return {};
}

/// Of "targets[3]" and "targets[3].name"; -1: of something else.
int targetOf(const std::string& field) {
  int number = -1;
  if (field.starts_with(kTarget)) std::from_chars(field.data() + kTarget.size(), field.data() + field.size(), number);
  return number;
}

}  // namespace

CaseWithVolume caseWithVolume(json manifest, const std::string& file, const std::string& level,
                              const std::function<std::vector<Error>(const json&)>& check) {
  json volume = {{"file", file}};
  if (!level.empty()) volume["level"] = level;
  if (manifest.contains("volume") && manifest["volume"].is_object() && manifest["volume"].contains("file_to_world"))
    volume["file_to_world"] = manifest["volume"]["file_to_world"];
  manifest["volume"] = std::move(volume);
  CaseWithVolume made{std::move(manifest), 0, 0, {}};
  // Twice: some problems are only told when there are no others.
  for (int round = 0; round < 2; ++round) {
    made.problems.clear();
    std::set<std::size_t> lost;
    bool areMeasurementsLost = false;
    for (Error& problem : check(made.manifest)) {
      const std::string field = fieldOf(problem);
      if (field == "volume.file" || field == "volume.level") continue;  // they are about to be written
      const int target = targetOf(field);
      if (target >= 0 && made.manifest.contains("targets") && static_cast<std::size_t>(target) < made.manifest["targets"].size())
        lost.insert(static_cast<std::size_t>(target));
      else if (field.starts_with("measurements") && made.manifest.contains("measurements"))
        areMeasurementsLost = true;
      else
        made.problems.push_back(std::move(problem));
    }
    for (auto at = lost.rbegin(); at != lost.rend(); ++at) made.manifest["targets"].erase(*at);
    made.targets += lost.size();
    if (areMeasurementsLost) {
      made.measurements += made.manifest["measurements"].size();
      made.manifest.erase("measurements");
    }
    if (made.manifest.contains("targets") && made.manifest["targets"].empty()) made.manifest.erase("targets");
    if (lost.empty() && !areMeasurementsLost) break;
  }
  return made;
}

}  // namespace ew::stitching
