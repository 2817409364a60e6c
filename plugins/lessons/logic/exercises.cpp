#include "logic/exercises.h"

#include <algorithm>

#include "ew/imaging/display.h"
#include "ew/library/step_answer.h"

namespace ew::lessons {
namespace {

constexpr double kDeepestBelow_mm = 30.0;  // as far as there have to be data below skin that can be scanned

Result<LessonStep> lost() {
  return failure(ErrorCode::badField, say<"The case does not have this target any more; take another exercise.">());
}

/// The step's work with another judge.
class ExerciseWork final : public StepWork {
 public:
  ExerciseWork(Exercise exercise, std::shared_ptr<const ExercisePlan> plan, int level, std::unique_ptr<StepWork> inner)
      : exercise_(std::move(exercise)), plan_(std::move(plan)), level_(level), inner_(std::move(inner)) {}

  void see(const ScanState& image) override {
    StepWork::see(image);
    inner_->see(image);
  }
  [[nodiscard]] std::vector<LiveFigure> live() const override { return inner_->live(); }
  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override { return inner_->missing(handed); }

  [[nodiscard]] StepAnswer answerOf(const Handed& handed) const override { return inner_->answerOf(handed); }
  [[nodiscard]] StepResult judge(const StepAnswer& given) const override {
    // Calipers are read by what they are and not by their points alone, which the step's own work does with the same judgement.
    if (exercise_.kind == ExerciseKind::measure || !last()) return inner_->judge(given);
    ExerciseGround ground = plan_->ground;
    ground.probe = last()->probe;
    ground.depth_mm = resolvedDepth_mm(last()->probe, last()->knobs);
    ExerciseAnswer answer;
    answer.pose = last()->pose;
    if (const auto* point = std::get_if<PointAnswer>(&given)) answer.points_mm = {point->at_mm};
    return judgeExercise(exercise_, ground, level_, answer);
  }

 private:
  Exercise exercise_;
  std::shared_ptr<const ExercisePlan> plan_;
  int level_;
  std::unique_ptr<StepWork> inner_;
};

}  // namespace

Result<ExercisePlan> planExercises(const Case& opened, const sdk::Scanned& scanned, const ScanState& image, Progress& progress) {
  if (!scanned.skin) return failure(ErrorCode::badUsage, say<"The body is still being read; try again in a moment.">());
  auto truth = loadCaseTruth(opened, progress);
  if (!truth) return passOn(truth.error());
  ExercisePlan plan;
  plan.ground.truth = std::move(*truth);
  plan.ground.skin = scanned.skin;
  plan.ground.probe = image.probe;
  plan.ground.depth_mm = resolvedDepth_mm(image.probe, image.knobs);
  plan.ground.region.placedGrid = scanned.volume;
  plan.ground.region.below_mm = std::min(kDeepestBelow_mm, 0.5 * plan.ground.depth_mm);
  if (scanned.labels) {
    auto labels = std::make_shared<Volume>(*scanned.labels);
    labels->grid = scanned.placedLabels;
    plan.ground.labels = std::move(labels);
  }
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The exercises were not planned.">());
  plan.list = exercisesOf(opened, plan.ground);
  return plan;
}

std::vector<Exercise> offered(const ExerciseList& list, bool withFindings) {
  std::vector<Exercise> exercises;
  for (const Exercise& each : list.offered)
    if (withFindings || !each.revealsFinding) exercises.push_back(each);
  return exercises;
}

std::optional<Exercise> exerciseOfId(const std::string& id) {
  const auto first = id.find('/');
  const auto second = first == std::string::npos ? first : id.find('/', first + 1);
  if (second == std::string::npos || first == 0 || second + 1 == id.size()) return std::nullopt;
  for (const ExerciseKind kind : {ExerciseKind::findPlane, ExerciseKind::pointAtOrgan, ExerciseKind::measure})
    if (id.substr(first + 1, second - first - 1) == wordOf(kind))
      return Exercise{id, id.substr(0, first), kind, id.substr(second + 1), false};
  return std::nullopt;
}

Result<LessonStep> stepOf(const Exercise& exercise, const ExerciseGround& ground, int level) {
  const ExerciseDifficulty difficulty = difficultyOf(level);
  LessonStep step;
  step.id = "exercise";
  step.title = titleOf(exercise, exercise.target).english();
  step.text = taskOf(exercise).english();
  step.aids = difficulty.aids;
  step.feedback = difficulty.aids.compass;
  // Those that say something of such an exercise.
  const bool isPlane = exercise.kind == ExerciseKind::findPlane;
  step.aids.compass = step.aids.compass && isPlane;
  step.aids.expertProbe = step.aids.expertProbe && isPlane;
  step.aids.outline = step.aids.outline && exercise.kind == ExerciseKind::pointAtOrgan;
  step.passLevel = kPassScore;
  step.time_s = difficulty.time_s;
  if (exercise.kind == ExerciseKind::findPlane) {
    const ReferencePlane* plane = planeOf(exercise, ground.truth);
    if (plane == nullptr) return lost();
    const PlaneTolerance tolerance = toleranceOf(*plane);
    step.task =
        PlaneTask{exercise.target, difficulty.toleranceFactor * tolerance.position_mm, difficulty.toleranceFactor * tolerance.angle_deg};
  } else if (exercise.kind == ExerciseKind::pointAtOrgan) {
    if (structureOf(exercise, ground.truth) == nullptr) return lost();
    step.task = PointTask{exercise.target};
  } else {
    const ReferenceMeasurement* measurement = measurementOf(exercise, ground.truth);
    if (measurement == nullptr) return lost();
    step.task = MeasureTask{exercise.target, std::max(kFinestTolerance_mm, difficulty.toleranceFactor * toleranceOf(*measurement))};
  }
  return step;
}

Message titleOf(const Exercise& exercise, const std::string& name) {
  switch (exercise.kind) {
    case ExerciseKind::findPlane:
      return say<"Find the plane: %1">(verbatim(name));
    case ExerciseKind::pointAtOrgan:
      return say<"Point at: %1">(verbatim(name));
    case ExerciseKind::measure:
      break;
  }
  return say<"Measure: %1">(verbatim(name));
}

Message taskOf(const Exercise& exercise) {
  switch (exercise.kind) {
    case ExerciseKind::findPlane:
      return say<"Bring the probe to this plane and press Done.">();
    case ExerciseKind::pointAtOrgan:
      return say<"Bring it into the image, point at it, and press Done.">();
    case ExerciseKind::measure:
      break;
  }
  return say<"Bring it into the image, freeze, set the calipers, and press Done.">();
}

Result<std::unique_ptr<StepWork>> exerciseWork(const Exercise& exercise, std::shared_ptr<const ExercisePlan> plan, int level,
                                               const LessonStep& step, const StepScene& scene) {
  auto inner = workOf(step, scene.ground());
  if (!inner) return inner;
  return std::make_unique<ExerciseWork>(exercise, std::move(plan), level, std::move(*inner));
}

ExerciseOverview overviewOf(const std::vector<RepetitionState>& states, const std::string& caseId, std::chrono::sys_seconds now) {
  ExerciseOverview overview;
  const RepetitionState* strongest = nullptr;
  const RepetitionState* weakest = nullptr;
  for (const RepetitionState& each : states) {
    const auto exercise = exerciseOfId(each.exerciseId);
    if (!exercise || exercise->caseId != caseId || each.tries == 0) continue;
    ++overview.tried;
    if (each.due <= now)
      ++overview.due;
    else
      overview.nextDue = std::min(overview.nextDue.value_or(each.due), each.due);
    if (each.repetitions >= 2 && (strongest == nullptr || each.interval_days > strongest->interval_days)) strongest = &each;
    if (each.repetitions == 0 && (weakest == nullptr || each.lapses > weakest->lapses)) weakest = &each;
  }
  if (strongest != nullptr) overview.strongest = exerciseOfId(strongest->exerciseId);
  if (weakest != nullptr) overview.weakest = exerciseOfId(weakest->exerciseId);
  return overview;
}

}  // namespace ew::lessons
