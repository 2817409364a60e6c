#include "logic/case_volume.h"

#include <algorithm>
#include <charconv>
#include <glm/common.hpp>
#include <limits>
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

/// The box of a grid after a matrix of 16 numbers, row by row.
Bounds boxAfter(const json& rows, const Grid& grid) {
  const Bounds own = boundsOf(grid);
  Bounds box{glm::dvec3(std::numeric_limits<double>::max()), glm::dvec3(std::numeric_limits<double>::lowest())};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 from((corner & 1) != 0 ? own.highest_mm.x : own.lowest_mm.x, (corner & 2) != 0 ? own.highest_mm.y : own.lowest_mm.y,
                          (corner & 4) != 0 ? own.highest_mm.z : own.lowest_mm.z);
    glm::dvec3 to(0.0);
    for (std::size_t row = 0; row < 3; ++row) {
      to[static_cast<int>(row)] = rows[4 * row + 3].get<double>();
      for (std::size_t at = 0; at < 3; ++at) to[static_cast<int>(row)] += rows[4 * row + at].get<double>() * from[static_cast<int>(at)];
    }
    box.lowest_mm = glm::min(box.lowest_mm, to);
    box.highest_mm = glm::max(box.highest_mm, to);
  }
  return box;
}

/// How much of the smaller of two boxes lies in the other, 0 to 1.
double sharedPart(const Bounds& a, const Bounds& b) {
  const glm::dvec3 both = glm::min(a.highest_mm, b.highest_mm) - glm::max(a.lowest_mm, b.lowest_mm);
  if (both.x <= 0.0 || both.y <= 0.0 || both.z <= 0.0) return 0.0;
  const glm::dvec3 sizeA = a.highest_mm - a.lowest_mm, sizeB = b.highest_mm - b.lowest_mm;
  const double smaller = std::min(sizeA.x * sizeA.y * sizeA.z, sizeB.x * sizeB.y * sizeB.z);
  return smaller > 0.0 ? both.x * both.y * both.z / smaller : 0.0;
}

/// Moves the place of a volume so that the new one lies where the one before lay. @return whether it had to be moved
bool isPlacedAnew(json& volume, const Grid& before, const Grid& now) {
  constexpr double kSameRecording = 0.1;  // sweeps of one recording overlap by more
  json rows = volume.contains("file_to_world") ? volume["file_to_world"] : json{1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0};
  const Bounds was = boxAfter(rows, before), is = boxAfter(rows, now);
  if (sharedPart(was, is) >= kSameRecording) return false;
  const glm::dvec3 by_mm = (was.lowest_mm + was.highest_mm - is.lowest_mm - is.highest_mm) / 2.0;
  for (std::size_t row = 0; row < 3; ++row) rows[4 * row + 3] = rows[4 * row + 3].get<double>() + by_mm[static_cast<int>(row)];
  volume["file_to_world"] = std::move(rows);
  return true;
}

}  // namespace

CaseWithVolume caseWithVolume(json manifest, const VolumeForCase& next, const std::function<std::vector<Error>(const json&)>& check) {
  CaseWithVolume made;
  json volume = manifest.contains("volume") && manifest["volume"].is_object() ? manifest["volume"] : json::object();
  made.hadRecipe = volume.contains("recipe");
  made.hadLabels = volume.contains("labels");
  for (const char* ofTheVolumeBefore : {"labels", "level", "recipe", "recipe_spacing_mm", "sweeps", "reconstruct"})
    volume.erase(ofTheVolumeBefore);
  volume["file"] = next.file;
  if (!next.level.empty()) volume["level"] = next.level;
  if (next.grids) made.isMoved = isPlacedAnew(volume, next.grids->first, next.grids->second);
  manifest["volume"] = std::move(volume);
  made.manifest = std::move(manifest);
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
