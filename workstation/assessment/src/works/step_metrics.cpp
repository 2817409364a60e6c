#include "ew/assessment/step_metrics.h"

#include <algorithm>
#include <cmath>

#include "ew/assessment/organ_coverage.h"
#include "ew/assessment/plane_error.h"
#include "ew/assessment/time_warping.h"
#include "ew/core/figure.h"
#include "ew/core/find_entry.h"
#include "ew/imaging/display.h"
#include "ew/library/step_answer.h"

namespace ew {
namespace {

/// The plane that a step is about, if it is one of the case's.
const ReferencePlane* planeOfStep(const LessonTask& task, const CaseTruth& truth) {
  if (const auto* plane = std::get_if<PlaneTask>(&task)) return entryNamed(truth.planes, plane->target);
  if (const auto* measure = std::get_if<MeasureTask>(&task))
    if (const auto* expected = entryNamed(truth.measurements, measure->measurement)) return entryNamed(truth.planes, expected->plane);
  return nullptr;
}

PlaneTarget targetIn(const ScanState& image, const ReferencePlane& plane, const CaseTruth& truth) {
  return targetOf(plane, truth, resolvedDepth_mm(image.probe, image.knobs));
}

/// Valid poses, about five a second: what alignment and planes are worked out of.
std::vector<Pose> thinned(const ScanLog& scan) {
  constexpr double kStep_s = 0.2;
  std::vector<Pose> poses;
  for (const Pose& pose : heldPosesOf(scan))
    if (pose.status == PoseStatus::ok && (poses.empty() || pose.time_s - poses.back().time_s >= kStep_s - 1e-9)) poses.push_back(pose);
  return poses;
}

/// Poses that differ from one another by 3 mm at least (poseDistance_mm).
std::vector<Pose> distinct(const std::vector<Pose>& poses) {
  constexpr double kApart_mm = 3.0;
  std::vector<Pose> found;
  for (const Pose& pose : poses)
    if (std::none_of(found.rbegin(), found.rend(),
                     [&](const Pose& one) { return poseDistance_mm(one.probeToWorld, pose.probeToWorld) < kApart_mm; }))
      found.push_back(pose);
  return found;
}

double overlap_pct(const std::vector<Pose>& expert, const std::vector<Pose>& trainee, double depth_mm) {
  constexpr PlaneTolerance kSame{10.0, 15.0};
  const auto planes = distinct(expert), visited = distinct(trainee);
  const auto isVisited = [&](const Pose& plane) {
    const PlaneTarget target{plane.probeToWorld, {0.0, 0.5 * depth_mm}};
    return std::any_of(visited.begin(), visited.end(), [&](const Pose& pose) {
      // Far faces cannot hold the same plane within the image: most pairs end here.
      const glm::dvec3 away_mm(pose.probeToWorld.matrix[3] - plane.probeToWorld.matrix[3]);
      return glm::length(away_mm) <= depth_mm && isFound(planeError(target, pose.probeToWorld), kSame);
    });
  };
  const auto count = std::count_if(planes.begin(), planes.end(), isVisited);
  return 100.0 * static_cast<double>(count) / static_cast<double>(planes.size());
}

/// Collects the figures that are asked for.
class Figures {
 public:
  Figures(const StepRecord& record, const CaseGround& ground, const ExpertStep& expert)
      : record_(record), ground_(ground), expert_(expert) {}

  Result<std::vector<MetricValue>> all(Progress& progress) {
    ofWork();
    if (record_.scan != nullptr && record_.scan->frameCount() > 0) {
      last_ = record_.scan->frame(record_.scan->frameCount() - 1);
      ofMotion();
      ofTarget();
      ofSettings();
      if (auto found = ofExpert(progress); !found) return passOn(found.error());
    }
    return inOrder();
  }

 private:
  void add(const char* id, const std::optional<double>& value) {
    const Metric* metric = metricOf(id);
    if (value && std::isfinite(*value) && isFor(*metric, taskWord(record_.step.task))) values_.push_back({id, metric->version, *value});
  }

  /// Of the judgement; empty: it has none of that name.
  [[nodiscard]] std::optional<double> figure(const char* name) const {
    const auto& figures = record_.outcome.figures;
    const auto at = std::find_if(figures.begin(), figures.end(), [&](const Figure& one) { return one.name == name; });
    return at == figures.end() ? std::nullopt : std::optional(at->value);
  }

  void ofWork() {
    const StepOutcome& outcome = record_.outcome;
    add("hints", outcome.hints);
    if (outcome.verdict != StepVerdict::skipped) add("answer_error", 100.0 * (1.0 - outcome.score));
    if (std::holds_alternative<PointTask>(record_.step.task)) add("landmark_distance", figure("distance"));
    const auto* task = std::get_if<MeasureTask>(&record_.step.task);
    const auto* expected = task != nullptr ? entryNamed(ground_.truth().measurements, task->measurement) : nullptr;
    const auto* answer = std::get_if<MeasurementAnswer>(&outcome.answer);
    if (expected == nullptr || answer == nullptr) return;
    if (expected->value != 0.0) add("measurement_error", 100.0 * std::abs(answer->value - expected->value) / std::abs(expected->value));
    add("caliper_distance", figure("place"));
  }

  void ofMotion() {
    const auto poses = heldPosesOf(*record_.scan);
    const Motion motion = motionOf(poses);
    const MotionFigures figures = figuresOf(motion);
    const ContactFigures contact = contactOf(*record_.scan);
    const double before_s = contact.first_s ? *contact.first_s - record_.scan->begin_s() : 0.0;
    add("time", std::max(0.0, record_.outcome.seconds - before_s));
    if (figures.known_s <= 0.0) return;
    add("path_length", figures.path_mm);
    add("angular_path", figures.angularPath_deg);
    add("spectral_arc_length", figures.spectralArcLength);
    add("log_dimensionless_jerk", figures.logDimensionlessJerk);
    add("idle_share", 100.0 * figures.idleShare);
    std::vector<glm::dvec3> places_mm;
    for (const Pose& pose : poses)
      if (pose.status == PoseStatus::ok) places_mm.emplace_back(pose.probeToWorld.matrix[3]);
    constexpr double kMm3PerMl = 1000.0;
    add("working_volume", hullVolume_mm3(places_mm) / kMm3PerMl);
    if (contact.first_s) add("contact_loss", 100.0 * contact.lossShare);
    add("pressure", contact.press_mm);
  }

  void ofTarget() {
    ofCoverage();
    const ReferencePlane* plane = planeOfStep(record_.step.task, ground_.truth());
    if (plane == nullptr || last_->pose.status != PoseStatus::ok) return;
    const PlaneError error = planeError(targetIn(*last_, *plane, ground_.truth()), last_->pose.probeToWorld);
    add("plane_angle", error.angle_deg);
    add("plane_roll", std::abs(error.roll_deg));
    add("plane_distance", error.distance_mm);
    add("plane_in_picture", error.inImage_mm);
  }

  void ofCoverage() {
    std::vector<std::string> names;
    if (const auto* sweep = std::get_if<SweepTask>(&record_.step.task)) {
      if (const auto judged = figure("coverage")) return add("coverage", judged);  // it takes long to work out
      names = {sweep->target};
    }
    if (const auto* free = std::get_if<FreeTask>(&record_.step.task)) {
      if (record_.passed) return addCoverage(*record_.passed);
      names = free->targets;
    }
    std::vector<OrganCoverage> organs;
    for (const std::string& name : names)
      if (const auto* structure = entryNamed(ground_.truth().structures, name))
        if (auto voxels = ground_.organ(structure->label); !voxels->empty()) organs.emplace_back(std::move(voxels));
    if (organs.empty()) return;
    ScanState image;
    for (std::size_t n = 0; n < record_.scan->frameCount(); ++n) {
      record_.scan->frame(n, image);
      const Fan fan{image.probe, resolvedDepth_mm(image.probe, image.knobs)};
      for (OrganCoverage& organ : organs) organ.add(fan, image.pose, image.gaps_mm);
    }
    VoxelPass voxels;
    for (const OrganCoverage& organ : organs) {
      voxels.passed += organ.passed();
      voxels.of += organ.of();
    }
    addCoverage(voxels);
  }

  void addCoverage(const VoxelPass& voxels) {
    if (voxels.of > 0) add("coverage", 100.0 * static_cast<double>(voxels.passed) / static_cast<double>(voxels.of));
  }

  void ofSettings() {
    if (!expert_.image) return;
    for (const auto& [id, setting] :
         {std::pair{"gain_difference", "gain_db"}, {"depth_difference", "depth_mm"}, {"focus_difference", "focus_mm"}}) {
      const auto own = settingOf(*last_, setting), experts = settingOf(*expert_.image, setting);
      if (own && experts) add(id, std::abs(*own - *experts));
    }
  }

  Result<void> ofExpert(Progress& progress) {
    if (expert_.scan == nullptr) return {};
    const auto own = thinned(*record_.scan), experts = thinned(*expert_.scan);
    if (own.empty() || experts.empty()) return {};
    const auto warped = warpTime(own, experts, progress);
    if (!warped && warped.error().code == ErrorCode::cancelled) return passOn(warped.error());
    if (warped) add("expert_distance", warped->mean_mm);  // too long to align: the figure is left out
    add("plane_overlap", overlap_pct(experts, own, resolvedDepth_mm(last_->probe, last_->knobs)));
    return {};
  }

  [[nodiscard]] std::vector<MetricValue> inOrder() const {
    std::vector<MetricValue> ordered;
    for (const Metric& metric : metrics())
      for (const MetricValue& value : values_)
        if (value.id == metric.id) ordered.push_back(value);
    return ordered;
  }

  const StepRecord& record_;
  const CaseGround& ground_;
  const ExpertStep& expert_;
  std::optional<ScanState> last_;
  std::vector<MetricValue> values_;
};

}  // namespace

Result<std::vector<MetricValue>> metricsOf(const StepRecord& record, const CaseGround& ground, const ExpertStep& expert,
                                           Progress& progress) {
  return Figures(record, ground, expert).all(progress);
}

std::optional<ScanState> bestImageOf(const ScanLog& scan, const ReferencePlane& plane, const CaseTruth& truth) {
  std::optional<std::size_t> best;
  double least = 0.0;
  for (std::size_t n = 0; n < scan.frameCount(); ++n) {
    const ScanState image = scan.frame(n);
    if (image.pose.status != PoseStatus::ok) continue;
    const double share = shareOfTolerance(planeError(targetIn(image, plane, truth), image.pose.probeToWorld), toleranceOf(plane));
    if (best && share >= least) continue;
    best = n;
    least = share;
  }
  return best ? std::optional(scan.frame(*best)) : std::nullopt;
}

}  // namespace ew
