#include "ew/assessment/step_work.h"

#include <algorithm>

#include "ew/core/contract.h"
#include "ew/core/find_entry.h"
#include "ew/core/numbers.h"
#include "ew/imaging/display.h"
#include "works/step_works.h"

namespace ew {

std::optional<double> settingOf(const ScanState& state, const std::string& setting) {
  if (setting == "depth_mm") return resolvedDepth_mm(state.probe, state.knobs);
  if (setting == "gain_db") return state.knobs.gain_db;
  if (setting == "dynamic_range_db")
    return state.knobs.dynamicRange_db > 0.0 ? state.knobs.dynamicRange_db : state.scene.recordedDynamicRange_db;
  if (setting == "focus_mm") return state.knobs.focus_mm > 0.0 ? state.knobs.focus_mm : 0.5 * resolvedDepth_mm(state.probe, state.knobs);
  return std::nullopt;
}

StepWork::~StepWork() = default;
std::optional<Message> StepWork::missing(const Handed&) const { return std::nullopt; }
StepAnswer StepWork::answerOf(const Handed&) const { return {}; }

void StepWork::hand(const Handed& handed, StepOutcome& outcome) const {
  outcome.answer = answerOf(handed);
  outcome.result() = judge(outcome.answer);
}

void conclude(const LessonStep& step, double passLevel, StepOutcome& outcome) {
  constexpr double kTimer_s = 0.5;  // the timer that ends a step ticks more often than this
  const bool inTime = !step.time_s || outcome.seconds <= *step.time_s + kTimer_s;
  if (!inTime) outcome.remarks.push_back({false, say<"The time was over before the step was handed in.">()});
  outcome.verdict = inTime && reachesLevel(outcome.score, passLevel) ? StepVerdict::passed : StepVerdict::failed;
}

CaliperReading inWorld(const MeasurementSubmission& handed, const ScanState& image) {
  CaliperReading made{handed.kind, handed.figures, {}};
  for (Figure& figure : made.figures) figure.uncertainty = 0.0;  // which attempts do not keep
  for (const auto& point : handed.points) made.points_mm.push_back((image.pose.probeToWorld * point).at);
  return made;
}

Message noImage() { return say<"There is no image yet; put the probe on the body.">(); }

namespace {

Result<std::unique_ptr<StepWork>> notThere(const std::string& name) {
  if (name.empty())
    return failure(ErrorCode::badField, say<"The step does not say yet what it asks for; choose that in the lesson first.">());
  return failure(ErrorCode::badField, say<"The case has no '%1'; the lesson asks for something that is not there. Tell its author.">(name));
}

struct MakeWork {
  const LessonStep& step;
  std::shared_ptr<const CaseGround> ground;
  using Made = Result<std::unique_ptr<StepWork>>;

  Made operator()(const ReadingTask&) const { return readWork(); }
  Made operator()(const WatchTask&) const { return watchWork(); }
  Made operator()(const PlaneTask& task) const {
    const ReferencePlane* plane = entryNamed(ground->truth().planes, task.target);
    if (plane == nullptr) return notThere(task.target);
    return planeWork(task, *plane, ground);
  }
  Made operator()(const SweepTask& task) const {
    const ReferenceStructure* structure = entryNamed(ground->truth().structures, task.target);
    if (structure == nullptr || !ground->hasLabels()) return notThere(task.target);
    return sweepWork(task, ground->organ(structure->label));
  }
  Made operator()(const MeasureTask& task) const {
    const ReferenceMeasurement* expected = entryNamed(ground->truth().measurements, task.measurement);
    if (expected == nullptr) return notThere(task.measurement);
    const auto tolerance = task.tolerance ? task.tolerance : expected->tolerance;
    if (!tolerance) return notThere(task.measurement);
    return measureWork(*expected, *tolerance);
  }
  Made operator()(const PointTask& task) const {
    if (const ReferencePoint* point = entryNamed(ground->truth().points, task.target)) return pointWork(*point);
    const ReferenceStructure* structure = entryNamed(ground->truth().structures, task.target);
    if (structure == nullptr || !ground->hasLabels()) return notThere(task.target);
    return pointWork(ground->organ(structure->label));
  }
  Made operator()(const SettingsTask& task) const { return settingsWork(task); }
  Made operator()(const AnswerTask& task) const { return answerWork(task); }
  Made operator()(const FreeTask& task) const { return freeWork(task, ground); }
};

}  // namespace

Result<std::unique_ptr<StepWork>> workOf(const LessonStep& step, std::shared_ptr<const CaseGround> ground) {
  EW_EXPECTS(ground != nullptr);
  return std::visit(MakeWork{step, std::move(ground)}, step.task);
}

}  // namespace ew
