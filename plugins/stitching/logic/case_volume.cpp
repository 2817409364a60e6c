#include "logic/case_volume.h"
#include "ew/library/echoes_field.h"

#include <algorithm>
#include <charconv>
#include <glm/common.hpp>
#include <limits>
#include <set>
#include <string_view>

namespace ew::stitching {
namespace {

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

/// The box of a grid that was placed.
Bounds placedBox(const Transform<frame::World, frame::File>& fileToWorld, const Grid& grid) {
  const Bounds own = boundsOf(grid);
  Bounds box{glm::dvec3(std::numeric_limits<double>::max()), glm::dvec3(std::numeric_limits<double>::lowest())};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 from((corner & 1) != 0 ? own.highest_mm.x : own.lowest_mm.x, (corner & 2) != 0 ? own.highest_mm.y : own.lowest_mm.y,
                          (corner & 4) != 0 ? own.highest_mm.z : own.lowest_mm.z);
    const glm::dvec3 to = carried(fileToWorld, from);
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
bool isPlacedAnew(CaseVolume& volume, const Grid& before, const Grid& now) {
  constexpr double kSameRecording = 0.1;  // sweeps of one recording overlap by more
  const Bounds was = placedBox(volume.fileToWorld, before), is = placedBox(volume.fileToWorld, now);
  if (sharedPart(was, is) >= kSameRecording) return false;
  volume.fileToWorld.matrix[3] += glm::dvec4((was.lowest_mm + was.highest_mm - is.lowest_mm - is.highest_mm) / 2.0, 0.0);
  return true;
}

}  // namespace

CaseWithVolume caseWithVolume(Case opened, const VolumeForCase& next, const std::function<std::vector<Error>(const Case&)>& check) {
  CaseWithVolume made;
  made.edited = withoutEchoes(std::move(opened));
  CaseVolume& volume = made.edited.volume;
  made.hadRecipe = !volume.recipe.empty();
  made.hadLabels = !volume.labels.empty();
  made.hadFrames = !volume.frames.empty();
  CaseVolume replaced;
  replaced.fileToWorld = volume.fileToWorld;
  replaced.file = next.file;
  replaced.level = next.level;
  if (next.grids) made.isMoved = isPlacedAnew(replaced, next.grids->first, next.grids->second);
  volume = std::move(replaced);
  auto& targets = made.edited.targets;
  // Twice: some problems are only told when there are no others.
  for (int round = 0; round < 2; ++round) {
    made.problems.clear();
    std::set<std::size_t> lost;
    bool areMeasurementsLost = false;
    for (Error& problem : check(made.edited)) {
      const std::string field = fieldOf(problem);
      if (field == "volume.file" || field == "volume.level") continue;  // they are about to be written
      const int target = targetOf(field);
      if (target >= 0 && static_cast<std::size_t>(target) < targets.size())
        lost.insert(static_cast<std::size_t>(target));
      else if (field.starts_with("measurements") && !made.edited.measurements.empty())
        areMeasurementsLost = true;
      else
        made.problems.push_back(std::move(problem));
    }
    for (auto at = lost.rbegin(); at != lost.rend(); ++at) targets.erase(targets.begin() + static_cast<std::ptrdiff_t>(*at));
    made.targets += lost.size();
    if (areMeasurementsLost) {
      made.measurements += made.edited.measurements.size();
      made.edited.measurements.clear();
    }
    if (lost.empty() && !areMeasurementsLost) break;
  }
  return made;
}

}  // namespace ew::stitching
