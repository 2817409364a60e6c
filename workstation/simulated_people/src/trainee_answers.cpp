#include "trainee_answers.h"

#include <algorithm>
#include <utility>

#include "ew/assessment/judging.h"
#include "ew/imaging/display.h"

namespace ew::assessment {
namespace {

double errorBy(RandomNumbers& random, double deviation) { return deviation * std::clamp(random.normal(), -2.5, 2.5); }

/// A point's place in an image plane, and back.
glm::dvec2 projected(const ScanState& image, const glm::dvec3& p_mm) {
  return glm::dvec2(glm::inverse(image.pose.probeToWorld.matrix) * glm::dvec4(p_mm, 1.0));
}
glm::dvec3 inWorld(const ScanState& image, const glm::dvec2& p_mm) {
  return glm::dvec3(image.pose.probeToWorld.matrix * glm::dvec4(p_mm, 0.0, 1.0));
}

/// Anywhere in the fan.
glm::dvec2 somewhereIn(const Fan& fan, RandomNumbers& random) {
  glm::dvec2 p_mm(0.0, 0.5 * fan.depth_mm);
  for (int n = 0; n < 100; ++n) {
    const double x_mm = random.between(-fan.depth_mm, fan.depth_mm);
    const glm::dvec2 tried_mm(x_mm, random.between(0.1, 0.95) * fan.depth_mm);
    if (placeInFan(fan, tried_mm)) return tried_mm;
  }
  return p_mm;
}

OptionsAnswer chosenBy(const TraineeHabits& habits, RandomNumbers& random, const AnswerTask& task) {
  std::vector<std::size_t> right, wrong;
  for (std::size_t n = 0; n < task.options.size(); ++n) (task.options[n].right ? right : wrong).push_back(n);
  std::vector<std::size_t> chosen;
  // Each answer is a decision of its own; whoever misses the only right one takes a wrong one.
  for (const std::size_t n : right)
    if (random.unit() >= habits.wrongAnswer)
      chosen.push_back(n);
    else if (!wrong.empty()) {
      const auto which = std::min(wrong.size() - 1, static_cast<std::size_t>(random.unit() * static_cast<double>(wrong.size())));
      chosen.push_back(wrong[which]);
      wrong.erase(wrong.begin() + static_cast<std::ptrdiff_t>(which));
    }
  std::sort(chosen.begin(), chosen.end());
  return {std::move(chosen)};
}

}  // namespace

StepAnswer answerBy(const TraineeHabits& habits, RandomNumbers& random, const AnswerTask& task) {
  if (!task.options.empty()) return chosenBy(habits, random, task);
  const bool isWrong = random.unit() < habits.wrongAnswer;
  const double side = random.unit() < 0.5 ? -1.0 : 1.0, far = random.between(1.2, 5.0);
  const double right = std::clamp(errorBy(random, habits.numberError), -1.0, 1.0);
  return NumberAnswer{task.number.value_or(0.0) + task.tolerance * (isWrong ? side * far : right)};
}

StepAnswer measuredBy(const TraineeHabits& habits, RandomNumbers& random, const ReferenceMeasurement& expected, const ScanState& image) {
  std::vector<glm::dvec3> points_mm;
  for (const glm::dvec3& p_mm : expected.points_mm) {
    const double x_mm = errorBy(random, habits.caliperError_mm);
    points_mm.push_back(inWorld(image, projected(image, p_mm) + glm::dvec2(x_mm, errorBy(random, habits.caliperError_mm))));
  }
  const auto reading_mm = expected.unit == "mm" ? readingOf(points_mm) : std::nullopt;
  if (!reading_mm) {
    constexpr double kLength_mm = 20.0;  // of the diameters that a volume is made of
    const double factor = std::max(0.1, 1.0 + 2.0 * errorBy(random, habits.caliperError_mm / kLength_mm));
    return MeasurementAnswer{expected.value * factor, expected.unit, {}, {}};
  }
  if (points_mm.size() == 2) return MeasurementAnswer{*reading_mm, "mm", "distance", points_mm};
  return MeasurementAnswer{*reading_mm, "mm", "ellipse", {}};
}

StepAnswer pointedBy(const TraineeHabits& habits, RandomNumbers& random, const TraineeCase& on, int structure, const glm::dvec3& point_mm,
                     const ScanState& image) {
  const Fan fan{image.probe, resolvedDepth_mm(image.probe, image.knobs)};
  const bool isMistaken = random.unit() < habits.mistaken;
  glm::dvec2 meant_mm = projected(image, point_mm);
  if (isMistaken) {
    meant_mm = somewhereIn(fan, random);
  } else if (structure != 0 && on.teaching().labels) {
    const OrganSection section = sectionOf(*on.teaching().labels, structure, fan, image.pose, 1.0);
    if (section.area_mm2 > 0.0) meant_mm = section.inside_mm;
  }
  const double x_mm = errorBy(random, habits.pointError_mm);
  return PointAnswer{inWorld(image, meant_mm + glm::dvec2(x_mm, errorBy(random, habits.pointError_mm)))};
}

}  // namespace ew::assessment
