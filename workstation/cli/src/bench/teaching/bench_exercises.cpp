#include <algorithm>
#include <cmath>
#include <random>

#include "bench/teaching/bench_teaching.h"
#include "bench/tools/bench_parts.h"
#include "ew/assessment/exercise.h"
#include "ew/core/parallel.h"
#include "ew/scanning/contact.h"
#include "ew/simulated_people/simulated_hand.h"
#include "ew/simulated_people/teaching_case.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr double kClick_mm = 0.5;  // as far as a hand clicks beside what it means
constexpr int kLevels[] = {1, 3, 5};

/// One draw: seeded, so that it does not matter which thread makes it.
struct Draw {
  const Exercise& exercise;
  const ExerciseGround& ground;
  int level;
  std::mt19937_64 random;

  [[nodiscard]] double between(double lowest, double highest) {
    return lowest + (highest - lowest) * (static_cast<double>(random() >> 11U) * 0x1.0p-53);
  }
  [[nodiscard]] glm::dvec2 click() {
    const double radius = kClick_mm * std::sqrt(between(0.0, 1.0)), angle = between(0.0, 6.283185307179586);
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
  }
  [[nodiscard]] std::optional<Hold> anywhere() {
    return randomHold(ground.region, *ground.skin, random(), {3.14159, 0.5, usualPress_mm(ground.probe)});
  }
  /// Evenly in the fan.
  [[nodiscard]] glm::dvec2 anywhereInFan() {
    const Fan fan = ground.fan();
    const double reach_mm = fan.depth_mm + fan.probe.radius_mm + fan.probe.width_mm;
    for (;;) {
      const glm::dvec2 p_mm(between(-reach_mm, reach_mm), between(-fan.probe.radius_mm, fan.depth_mm));
      if (placeInFan(fan, p_mm)) return p_mm;
    }
  }
};

/// The expert: follows the compass to planes, points at the middle of an organ's section, sets calipers where the truth has them.
bool expertPasses(Draw draw, const std::optional<Hold>& view) {
  ExerciseAnswer answer;
  const CaseTruth& truth = draw.ground.truth;
  if (draw.exercise.kind == ExerciseKind::findPlane) {
    const auto start = startOf(draw.exercise, draw.ground, draw.level, draw.random());
    if (!start) return false;
    const ReferencePlane& plane = *planeOf(draw.exercise, truth);
    const double factor = difficultyOf(draw.level).toleranceFactor;
    const PlaneTolerance tolerance{factor * plane.positionTolerance_mm, factor * plane.angleTolerance_deg};
    const CompassTarget target = compassTargetOf(targetOf(plane, truth, draw.ground.fan().depth_mm), tolerance, *draw.ground.skin);
    answer.pose = poseOf(followCompass(target, *start, *draw.ground.skin, draw.random()).end);
  } else if (draw.exercise.kind == ExerciseKind::pointAtOrgan) {
    if (!startOf(draw.exercise, draw.ground, draw.level, draw.random())) return false;
    const int label = structureOf(draw.exercise, truth)->label;
    if (!view) return false;
    const OrganSection section = sectionOf(*draw.ground.labels, label, draw.ground.fan(), poseOf(*view), 0.5);
    answer.points_mm = {carried(poseOf(*view).probeToWorld, glm::dvec3(section.inside_mm + draw.click(), 0.0))};
  } else {
    if (!startOf(draw.exercise, draw.ground, draw.level, draw.random())) return false;
    const ReferenceMeasurement& measurement = *measurementOf(draw.exercise, truth);
    // Clicks are off along the line and across it, within the plane that holds the points.
    const glm::dvec3 along = glm::normalize(measurement.points_mm[1] - measurement.points_mm[0]);
    const glm::dvec3 across =
        measurement.points_mm.size() > 2
            ? glm::normalize(measurement.points_mm[3] - measurement.points_mm[2])
            : glm::normalize(glm::cross(along, std::abs(along.z) < 0.7 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0)));
    for (const glm::dvec3& p_mm : measurement.points_mm) {
      const glm::dvec2 off = draw.click();
      answer.points_mm.push_back(p_mm + off.x * along + off.y * across);
    }
  }
  return judgeExercise(draw.exercise, draw.ground, draw.level, answer).passed();
}

/// Chance: a random pose, a random pixel of a random pose, random calipers in the very plane that is measured in.
bool chancePasses(Draw draw) {
  ExerciseAnswer answer;
  const auto hold = draw.anywhere();
  if (!hold) return false;
  answer.pose = poseOf(*hold);
  if (draw.exercise.kind == ExerciseKind::pointAtOrgan)
    answer.points_mm = {carried(answer.pose.probeToWorld, glm::dvec3(draw.anywhereInFan(), 0.0))};
  if (draw.exercise.kind == ExerciseKind::measure) {
    const ReferenceMeasurement& measurement = *measurementOf(draw.exercise, draw.ground.truth);
    for (const ReferencePlane& plane : draw.ground.truth.planes)
      if (plane.name == measurement.plane) answer.pose.probeToWorld = plane.probeToWorld;
    for (std::size_t n = 0; n < measurement.points_mm.size(); ++n)
      answer.points_mm.push_back(carried(answer.pose.probeToWorld, glm::dvec3(draw.anywhereInFan(), 0.0)));
  }
  return judgeExercise(draw.exercise, draw.ground, draw.level, answer).passed();
}

struct Passed {
  int byExpert = 0;
  int byChance = 0;
};

Result<Passed> drawn(const Exercise& exercise, const ExerciseGround& ground, int level, const ExerciseBenchOptions& options,
                     Progress& progress) {
  std::optional<Hold> view;  // where an expert looks at the organ from, the same at every draw
  if (exercise.kind == ExerciseKind::pointAtOrgan)
    view = viewOfOrgan(ground, structureOf(exercise, ground.truth)->label, options.seed + static_cast<std::uint64_t>(level));
  std::vector<std::uint8_t> expert(static_cast<std::size_t>(options.draws), 0), chance(expert);
  const bool done = forEachTask(options.draws, options.threads, progress, say<"Exercises are tried: %1">(exercise.target), [&](int n) {
    const std::uint64_t seed = options.seed * 1000003 + static_cast<std::uint64_t>(n) * 10 + static_cast<std::uint64_t>(level);
    const Draw draw{exercise, ground, level, std::mt19937_64(seed)};
    expert[static_cast<std::size_t>(n)] = expertPasses(draw, view) ? 1 : 0;
    chance[static_cast<std::size_t>(n)] = chancePasses(draw) ? 1 : 0;
  });
  if (!done) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
  return Passed{static_cast<int>(std::count(expert.begin(), expert.end(), 1)),
                static_cast<int>(std::count(chance.begin(), chance.end(), 1))};
}

}  // namespace

Result<json> benchExercises(const ExerciseBenchOptions& options, Progress& progress) {
  json report = {{"seed", options.seed},
                 {"draws", options.draws},
                 {"results", json::array()},
                 {"exercises", json::array()},
                 {"withheld", json::array()}};
  for (std::size_t n = 0; n < options.cases.size(); ++n) {
    const Case& each = options.cases[n];
    PartOfProgress part(progress, static_cast<double>(n) / static_cast<double>(options.cases.size()),
                        static_cast<double>(n + 1) / static_cast<double>(options.cases.size()));
    auto teaching = teachingCaseOf(each, true, options.threads, part);
    if (!teaching) return passOn(teaching.error());
    const ExerciseGround ground{teaching->truth, teaching->skin, teaching->region, teaching->probe, 0.0, teaching->labels};
    const ExerciseList list = exercisesOf(each, ground, options.seed);
    json row = {{"name", each.id}, {"offered", list.offered.size()}, {"withheld", list.withheld.size()}, {"draws", 0}, {"expert", 0},
                {"chance", 0}};
    for (const WithheldExercise& withheld : list.withheld)
      report["withheld"].push_back({{"id", withheld.exercise.id}, {"why", withheld.why.english()}});
    for (const Exercise& exercise : list.offered)
      for (const int level : kLevels) {
        const auto passed = drawn(exercise, ground, level, options, part);
        if (!passed) return passOn(passed.error());
        report["exercises"].push_back(
            {{"id", exercise.id}, {"level", level}, {"draws", options.draws}, {"expert", passed->byExpert}, {"chance", passed->byChance}});
        row["draws"] = row["draws"].get<int>() + options.draws;
        row["expert"] = row["expert"].get<int>() + passed->byExpert;
        row["chance"] = row["chance"].get<int>() + passed->byChance;
      }
    report["results"].push_back(std::move(row));
  }
  return report;
}

}  // namespace ew
