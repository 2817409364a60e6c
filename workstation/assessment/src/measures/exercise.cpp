#include "ew/assessment/exercise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ew/assessment/random_numbers.h"
#include "ew/core/find_entry.h"
#include "ew/core/word_table.h"
#include "ew/scanning/contact.h"

namespace ew {
namespace {

using assessment::RandomNumbers;

constexpr int kChanceHolds = 120;     // images of random hands that an organ's share is taken of
constexpr int kChanceImagesFree = 6;  // of them without the organ, or there is nowhere to begin
constexpr int kStartTries = 300;
constexpr double kNearlyFound = 2.0;  // tolerances: from here a plane is not a start any more

RandomHold freelyOf(const ExerciseGround& ground, double rotation_rad = 3.141592653589793, double tip_rad = 0.5) {
  return {rotation_rad, tip_rad, usualPress_mm(ground.probe)};
}

Exercise exerciseFor(const Case& edited, ExerciseKind kind, const std::string& target, bool reveals) {
  return {edited.id + "/" + std::string(wordOf(kind)) + "/" + target, edited.id, kind, target, reveals};
}

bool targetReveals(const Case& edited, const std::string& name) {
  const auto* target = entryNamed(edited.targets, name);
  return target != nullptr && target->revealsFinding;
}

bool measurementReveals(const Case& edited, const std::string& name) {
  const auto* measurement = entryNamed(edited.measurements, name);
  return measurement != nullptr && measurement->revealsFinding;
}

PlaneTolerance atLevel(const PlaneTolerance& tolerance, int level) {
  const double factor = difficultyOf(level).toleranceFactor;
  return {factor * tolerance.position_mm, factor * tolerance.angle_deg};
}

CompassTarget compassTo(const ReferencePlane& plane, const ExerciseGround& ground) {
  return compassTargetOf(targetOf(plane, ground.truth, ground.fan().depth_mm), toleranceOf(plane), *ground.skin);
}

std::optional<Message> whyNotPlane(const ReferencePlane& plane, const ExerciseGround& ground) {
  if (!compassTo(plane, ground).reachable) return say<"The plane cannot be reached from the skin.">();
  return std::nullopt;
}

/// Holds of random hands: found once for all organs, for each takes some milliseconds on a body.
std::vector<Hold> randomHolds(const ExerciseGround& ground, std::uint64_t seed) {
  std::vector<Hold> holds;
  for (std::uint64_t n = 0; n < kChanceHolds; ++n)
    if (const auto hold = randomHold(ground.region, *ground.skin, seed * 7919 + n, freelyOf(ground))) holds.push_back(*hold);
  return holds;
}

/// Where a point is looked at from a contact; the beam's tip is what remains of the direction once the probe is turned by `rotation_rad`.
Hold aimedAt(const Skin::Contact& contact, double rotation_rad, double press_mm, const glm::dvec3& at_mm) {
  Hold hold;
  hold.contact = contact;
  hold.press_mm = press_mm;
  hold = turned(hold, rotation_rad, 0.0, 0.0);
  const glm::dmat4 upright = poseOf(hold).probeToWorld.matrix;
  const glm::dvec3 to = glm::transpose(glm::dmat3(upright)) * (at_mm - glm::dvec3(upright[3]));
  // The y axis of Rx(tilt) Rz(rock) is (-sin rock, cos rock cos tilt, cos rock sin tilt).
  return turned(hold, 0.0, -std::asin(std::clamp(to.x / glm::length(to), -1.0, 1.0)), std::atan2(to.z, to.y));
}

/// The best of many views, half of them from the skin above the organ and half from `elsewhere`.
std::optional<Hold> viewFrom(const std::vector<Hold>& elsewhere, const OrganVoxels& organ, const ExerciseGround& ground, int label,
                             std::uint64_t seed) {
  constexpr int kViews = 160;
  constexpr double kFarthestTip_rad = 0.9;  // further, and the face leaves the skin
  RandomNumbers random(seed * 31 + static_cast<std::uint64_t>(label));
  std::optional<Hold> best;
  double largest_mm2 = 0.0;
  for (std::size_t n = 0; n < kViews; ++n) {
    // Its middle may lie outside of a curved organ, so voxels of it are aimed at.
    const auto voxel = static_cast<std::size_t>(random.unit() * static_cast<double>(organ.count()));
    const glm::dvec3 at_mm(organ.centres_mm()[std::min(voxel, organ.count() - 1)]);
    const double rotation_rad = random.between(-3.14159, 3.14159);
    if (n % 2 == 1 && elsewhere.empty()) continue;
    const Skin::Contact contact = n % 2 == 1 ? elsewhere[(n / 2) % elsewhere.size()].contact : ground.skin->nearest(at_mm);
    if (!isScannable(ground.region, contact)) continue;
    const Hold hold = aimedAt(contact, rotation_rad, usualPress_mm(ground.probe), at_mm);
    if (std::abs(hold.tilt_rad) > kFarthestTip_rad || std::abs(hold.rock_rad) > kFarthestTip_rad) continue;
    const double area_mm2 = sectionOf(*ground.labels, label, ground.fan(), poseOf(hold), 1.5).area_mm2;
    if (area_mm2 <= largest_mm2) continue;
    largest_mm2 = area_mm2;
    best = hold;
  }
  return best;
}

std::optional<Message> whyNotOrgan(const ReferenceStructure& structure, const ExerciseGround& ground, const std::vector<Hold>& holds,
                                   std::uint64_t seed) {
  if (!ground.labels) return say<"The case has no voxels of it.">();
  const OrganVoxels organ(*ground.labels, structure.label);
  if (organ.empty()) return say<"The case has no voxels of it.">();
  if (!viewFrom(holds, organ, ground, structure.label, seed)) return say<"It comes into no image from the skin.">();
  const Fan fan = ground.fan();
  const double whole_mm2 = areaOf_mm2(fan, 3.0);
  double byChance = 0.0;
  int without = 0;
  for (const Hold& hold : holds) {
    const double area_mm2 = sectionOf(*ground.labels, structure.label, fan, poseOf(hold), 3.0).area_mm2;
    byChance += area_mm2 / whole_mm2;
    without += area_mm2 > 0.0 ? 0 : 1;
  }
  if (byChance > kMostByChance * static_cast<double>(holds.size()))
    return say<"It fills so much of most images that pointing at random would do.">();
  if (without < kChanceImagesFree) return say<"It is in nearly every image, so that there is nothing to look for.">();
  return std::nullopt;
}

std::optional<Message> whyNotMeasurement(const ReferenceMeasurement& measurement) {
  const auto reading = readingOf(measurement.points_mm);
  if (measurement.unit != "mm" || !reading) return say<"Calipers alone cannot measure it.">();
  const double tolerance = toleranceOf(measurement);
  if (tolerance < kFinestTolerance_mm) return say<"Its tolerance is finer than calipers can be set.">();
  if (std::abs(*reading - measurement.value) > 0.5 * tolerance) return say<"Its points do not read its value.">();
  return std::nullopt;
}

void sort(ExerciseList& list, Exercise exercise, std::optional<Message> why) {
  if (why)
    list.withheld.push_back({std::move(exercise), *std::move(why)});
  else
    list.offered.push_back(std::move(exercise));
}

std::optional<Hold> startForPlane(const ReferencePlane& plane, const ExerciseGround& ground, int level, std::uint64_t seed, bool maySolve) {
  const CompassTarget target = compassTo(plane, ground);
  const auto difficulty = difficultyOf(level);
  const auto near_mm = maySolve ? std::optional<double>(15.0) : difficulty.startsWithin_mm;
  for (std::uint64_t n = 0; n < kStartTries; ++n) {
    const std::uint64_t each = seed * 104729 + n;
    const auto hold = near_mm ? randomHoldNear(ground.region, *ground.skin, target.hold, *near_mm, each, freelyOf(ground, 0.8, 0.35))
                              : randomHold(ground.region, *ground.skin, each, freelyOf(ground));
    if (!hold) continue;
    const double share = shareOfTolerance(planeError(target.plane, poseOf(*hold).probeToWorld), atLevel(target.tolerance, level));
    if (maySolve || share > kNearlyFound) return hold;
  }
  return std::nullopt;
}

std::optional<Hold> startForOrgan(int label, const ExerciseGround& ground, std::uint64_t seed) {
  if (!ground.labels) return std::nullopt;
  for (std::uint64_t n = 0; n < kStartTries; ++n) {
    const auto hold = randomHold(ground.region, *ground.skin, seed * 15485863 + n, freelyOf(ground));
    if (hold && sectionOf(*ground.labels, label, ground.fan(), poseOf(*hold)).area_mm2 <= 0.0) return hold;
  }
  return std::nullopt;
}

StepResult nothingToJudge(Message why) {
  StepResult judged;
  judged.remarks.push_back({false, std::move(why)});
  return judged;
}

constexpr WordTable<ExerciseKind, 3> kExerciseKindWords{
    {{"plane", ExerciseKind::findPlane}, {"point", ExerciseKind::pointAtOrgan}, {"measure", ExerciseKind::measure}}};

}  // namespace

std::string_view wordOf(ExerciseKind kind) { return wordIn(kExerciseKindWords, kind); }

ExerciseDifficulty difficultyOf(int level) {
  static const std::array<ExerciseDifficulty, kExerciseLevels> kLevels = [] {
    std::array<ExerciseDifficulty, kExerciseLevels> levels;
    levels[0] = {{true, true, true, true, true, true, true}, 1.5, 3.0, 50.0, std::nullopt};
    levels[1] = {{true, true, true, true, false, true, true}, 1.25, 2.0, 100.0, std::nullopt};
    levels[2] = {{true, true, true, true, false, false, false}, 1.0, 1.0, std::nullopt, std::nullopt};
    levels[3] = {{}, 1.0, 0.5, std::nullopt, 180.0};
    levels[4] = {{}, 0.75, 0.5, std::nullopt, 90.0};  // half a millimetre is what a hand clicks beside
    return levels;
  }();
  return kLevels[static_cast<std::size_t>(std::clamp(level, 1, kExerciseLevels) - 1)];
}

const ReferencePlane* planeOf(const Exercise& exercise, const CaseTruth& truth) { return entryNamed(truth.planes, exercise.target); }
const ReferenceStructure* structureOf(const Exercise& exercise, const CaseTruth& truth) {
  return entryNamed(truth.structures, exercise.target);
}
const ReferenceMeasurement* measurementOf(const Exercise& exercise, const CaseTruth& truth) {
  return entryNamed(truth.measurements, exercise.target);
}

ExerciseList exercisesOf(const Case& edited, const ExerciseGround& ground, std::uint64_t seed) {
  ExerciseList list;
  const std::vector<Hold> holds = ground.labels && !ground.truth.structures.empty() ? randomHolds(ground, seed) : std::vector<Hold>();
  for (const ReferencePlane& each : ground.truth.planes)
    sort(list, exerciseFor(edited, ExerciseKind::findPlane, each.name, targetReveals(edited, each.name)), whyNotPlane(each, ground));
  for (const ReferenceStructure& each : ground.truth.structures)
    sort(list, exerciseFor(edited, ExerciseKind::pointAtOrgan, each.name, targetReveals(edited, each.name)),
         whyNotOrgan(each, ground, holds, seed));
  for (const ReferenceMeasurement& each : ground.truth.measurements)
    sort(list, exerciseFor(edited, ExerciseKind::measure, each.name, measurementReveals(edited, each.name)), whyNotMeasurement(each));
  return list;
}

std::optional<Hold> viewOfOrgan(const ExerciseGround& ground, int label, std::uint64_t seed) {
  if (!ground.labels) return std::nullopt;
  const OrganVoxels organ(*ground.labels, label);
  return organ.empty() ? std::nullopt : viewFrom(randomHolds(ground, seed), organ, ground, label, seed);
}

std::optional<Hold> startOf(const Exercise& exercise, const ExerciseGround& ground, int level, std::uint64_t seed) {
  if (exercise.kind == ExerciseKind::findPlane) {
    const ReferencePlane* plane = planeOf(exercise, ground.truth);
    return plane != nullptr ? startForPlane(*plane, ground, level, seed, false) : std::nullopt;
  }
  if (exercise.kind == ExerciseKind::pointAtOrgan) {
    const ReferenceStructure* structure = structureOf(exercise, ground.truth);
    return structure != nullptr ? startForOrgan(structure->label, ground, seed) : std::nullopt;
  }
  const ReferenceMeasurement* measurement = measurementOf(exercise, ground.truth);
  if (measurement == nullptr) return std::nullopt;
  const ReferencePlane* plane = entryNamed(ground.truth.planes, measurement->plane);
  if (plane != nullptr && level <= 2) return startForPlane(*plane, ground, level, seed, true);
  return randomHold(ground.region, *ground.skin, seed * 104729, freelyOf(ground));
}

StepResult judgeExercise(const Exercise& exercise, const ExerciseGround& ground, int level, const ExerciseAnswer& answer) {
  const ExerciseDifficulty difficulty = difficultyOf(level);
  if (exercise.kind == ExerciseKind::findPlane) {
    const ReferencePlane* plane = planeOf(exercise, ground.truth);
    if (plane == nullptr) return nothingToJudge(say<"The case does not have this target any more; take another exercise.">());
    return judgePlane(targetOf(*plane, ground.truth, ground.fan().depth_mm), atLevel(toleranceOf(*plane), level), answer.pose);
  }
  if (answer.points_mm.empty()) return nothingToJudge(say<"No point was set; click in the image.">());
  if (exercise.kind == ExerciseKind::pointAtOrgan) {
    const ReferenceStructure* structure = structureOf(exercise, ground.truth);
    if (structure == nullptr || !ground.labels)
      return nothingToJudge(say<"The case does not have this target any more; take another exercise.">());
    return judgePointing(OrganVoxels(*ground.labels, structure->label), answer.points_mm.front(), difficulty.pointMargin_mm);
  }
  const ReferenceMeasurement* measurement = measurementOf(exercise, ground.truth);
  if (measurement == nullptr) return nothingToJudge(say<"The case does not have this target any more; take another exercise.">());
  const auto value = answer.value ? answer.value : readingOf(answer.points_mm);
  if (!value) return nothingToJudge(say<"These points read nothing; set the calipers that the measurement needs.">());
  const double tolerance = std::max(kFinestTolerance_mm, difficulty.toleranceFactor * toleranceOf(*measurement));
  return judgeMeasurement(*measurement, *value, answer.points_mm, tolerance);
}

}  // namespace ew
