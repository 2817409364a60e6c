#include "ew/simulated_people/trainee_case.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "ew/assessment/exercise.h"
#include "ew/assessment/hand_path.h"
#include "ew/core/find_entry.h"
#include "ew/library/lesson_links.h"
#include "ew/scanning/contact.h"

namespace ew {
namespace {

constexpr double kLooksEvery_s = 0.5;      // of an expert's recording
constexpr double kLeverOfTurns_mm = 60.0;  // as time warping compares poses

/// What the steps of lessons look for.
std::set<std::pair<TargetKind, std::string>> targetsIn(const std::vector<Lesson>& lessons) {
  std::set<std::pair<TargetKind, std::string>> targets;
  for (const Lesson& lesson : lessons)
    for (const LessonStep& step : lesson.steps) {
      if (const auto* plane = std::get_if<PlaneTask>(&step.task)) targets.insert({TargetKind::plane, plane->target});
      if (const auto* sweep = std::get_if<SweepTask>(&step.task)) targets.insert({TargetKind::place, sweep->target});
      if (const auto* point = std::get_if<PointTask>(&step.task)) targets.insert({TargetKind::place, point->target});
      if (const auto* measure = std::get_if<MeasureTask>(&step.task)) targets.insert({TargetKind::measurement, measure->measurement});
      if (const auto* free = std::get_if<FreeTask>(&step.task))
        for (const std::string& name : free->targets) {
          targets.insert({TargetKind::plane, name});
          targets.insert({TargetKind::place, name});
        }
    }
  return targets;
}

/// The contact from which points are looked at: the nearest skin that can be scanned, on the start's side of the body when the nearest
/// cannot.
Skin::Contact contactTowards(const TeachingCase& teaching, const Hold& start, const glm::dvec3& p_mm) {
  constexpr int kTries = 20;
  for (int n = 0; n <= kTries; ++n) {
    const auto contact = teaching.skin->nearest(glm::mix(p_mm, start.contact.point_mm, static_cast<double>(n) / kTries));
    if (isScannable(teaching.region, contact) && glm::dot(contact.outward, start.contact.outward) > -0.2) return contact;
  }
  return start.contact;
}

/// A hold whose image plane holds two points, or one of them twice, and the beam axis their middle.
Hold holdShowing(const TeachingCase& teaching, const Hold& start, const glm::dvec3& a_mm, const glm::dvec3& b_mm) {
  const glm::dvec3 middle_mm = 0.5 * (a_mm + b_mm);
  const Skin::Contact contact = contactTowards(teaching, start, middle_mm);
  const glm::dvec3 beam = glm::normalize(middle_mm - contact.point_mm);
  Hold hinted = start;
  hinted.contact = contact;
  glm::dvec3 lateral = b_mm - a_mm - glm::dot(b_mm - a_mm, beam) * beam;
  if (glm::length(lateral) < 1.0) lateral = glm::dvec3(uprightPoseOf(movedTo(hinted, contact)).probeToWorld.matrix[0]);
  lateral = glm::normalize(lateral - glm::dot(lateral, beam) * beam);
  if (glm::dot(lateral, glm::dvec3(-1.0, 0.0, 1.0)) < 0.0) lateral = -lateral;  // the marker to the patient's right, or head
  Pose pose;
  pose.probeToWorld.matrix = glm::dmat4(glm::dvec4(lateral, 0.0), glm::dvec4(beam, 0.0), glm::dvec4(glm::cross(lateral, beam), 0.0),
                                        glm::dvec4(contact.point_mm, 1.0));
  return holdFor(pose, *teaching.skin);
}

/// Whether calipers can be set to the points in a plane. An organ's longest diameter may leave its standard plane.
bool holds(const ReferencePlane& plane, const std::vector<glm::dvec3>& points_mm) {
  constexpr double kBeside_mm = 2.0;
  const glm::dmat4& matrix = plane.probeToWorld.matrix;
  return std::all_of(points_mm.begin(), points_mm.end(), [&](const glm::dvec3& p_mm) {
    return std::abs(glm::dot(p_mm - glm::dvec3(matrix[3]), glm::dvec3(matrix[2]))) <= kBeside_mm;
  });
}

TargetView viewOfStructure(const Hold& hold, const OrganVoxels& organ) {
  TargetView view{hold};
  if (organ.empty()) return view;
  const glm::dmat4 upright = uprightPoseOf(hold).probeToWorld.matrix;
  const glm::dvec3 x(upright[0]), y(upright[1]), z(upright[2]), origin_mm(upright[3]);
  view.left_mm = view.front_mm = 1e9;
  view.right_mm = view.back_mm = -1e9;
  for (const glm::vec3& centre : organ.centres_mm()) {
    const glm::dvec3 p_mm = glm::dvec3(centre) - origin_mm;
    view.left_mm = std::min(view.left_mm, glm::dot(p_mm, x));
    view.right_mm = std::max(view.right_mm, glm::dot(p_mm, x));
    view.front_mm = std::min(view.front_mm, glm::dot(p_mm, z));
    view.back_mm = std::max(view.back_mm, glm::dot(p_mm, z));
  }
  view.depth_mm = glm::dot(organ.middle_mm() - origin_mm, y);
  return view;
}

}  // namespace

Result<TraineeCase> TraineeCase::of(TeachingCase teaching, Progress& progress) {
  TraineeCase made;
  made.teaching_ = std::move(teaching);
  const Case& opened = made.teaching_.opened;
  auto lessons = lessonsOf(opened);
  if (!lessons) return passOn(lessons.error());
  made.lessons_ = *std::move(lessons);
  made.distance_ = std::make_shared<const SkinDistance>(made.teaching_.skin);
  const auto& labels = made.teaching_.labels;
  made.ground_ =
      std::make_shared<const CaseGround>(std::make_shared<const CaseTruth>(made.teaching_.truth), labels, labels ? labels->grid : Grid{});
  const auto probes = shippedProbes();
  if (!probes) return passOn(probes.error());
  made.probes_ = {made.teaching_.probe};
  for (const Probe& probe : *probes) {
    const bool isOffered = opened.probes.empty() || std::find(opened.probes.begin(), opened.probes.end(), probe.id) != opened.probes.end();
    if (isOffered && probe.id != made.teaching_.probe.id) made.probes_.push_back(probe);
  }
  if (opened.startPose) {
    made.start_ = pressedOn(*opened.startPose, *made.teaching_.skin, made.teaching_.probe);
  } else if (const auto anywhere =
                 randomHold(made.teaching_.region, *made.teaching_.skin, 1, {0.0, 0.0, usualPress_mm(made.teaching_.probe)})) {
    made.start_ = *anywhere;
  } else {
    return failure(ErrorCode::unsupported, say<"No skin of %1 can be scanned, so that nobody can begin there.">(opened.id),
                   {{"case", opened.id}});
  }
  if (auto read = made.readExperts(progress); !read) return passOn(read.error());
  made.findViews(progress);
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was changed.">());
  return made;
}

Result<void> TraineeCase::readExperts(Progress& progress) {
  for (const Lesson& lesson : lessons_)
    for (const LessonStep& step : lesson.steps) {
      const auto* watch = std::get_if<WatchTask>(&step.task);
      if (watch == nullptr || watch->recording.empty() || lengths_s_.contains(watch->recording)) continue;
      const auto recording = readRecording(teaching_.opened.folder / "parts" / std::string(kLessonsPart) / watch->recording, progress);
      if (!recording) return passOn(recording.error());
      const ScanLog& log = recording->log;
      lengths_s_[watch->recording] = watch->end_s.value_or(log.end_s()) - watch->begin_s.value_or(log.begin_s());
      for (double at_s = log.begin_s(); at_s <= log.end_s(); at_s += kLooksEvery_s) {
        const ScanState image = log.frame(log.frameAt(at_s));
        looks_.push_back({image.pose, image.knobs});
      }
    }
  return {};
}

std::optional<TargetView> TraineeCase::found(TargetKind kind, const std::string& name) const {
  const CaseTruth& truth = teaching_.truth;
  const auto viewOfPlane = [&](const ReferencePlane& plane) {
    return TargetView{holdFor(Pose{.probeToWorld = plane.probeToWorld}, *teaching_.skin)};
  };
  if (kind == TargetKind::plane) {
    const auto* plane = entryNamed(truth.planes, name);
    return plane != nullptr ? std::optional(viewOfPlane(*plane)) : std::nullopt;
  }
  if (kind == TargetKind::measurement) {
    const auto* measurement = entryNamed(truth.measurements, name);
    if (measurement == nullptr) return std::nullopt;
    const auto* plane = entryNamed(truth.planes, measurement->plane);
    if (plane != nullptr && (measurement->points_mm.size() != 2 || holds(*plane, measurement->points_mm))) return viewOfPlane(*plane);
    if (measurement->points_mm.size() < 2) return std::nullopt;
    return TargetView{holdShowing(teaching_, start_, measurement->points_mm[0], measurement->points_mm[1])};
  }
  if (const auto* point = entryNamed(truth.points, name)) return TargetView{holdShowing(teaching_, start_, point->at_mm, point->at_mm)};
  const auto* structure = entryNamed(truth.structures, name);
  if (structure == nullptr) return std::nullopt;
  const auto hold = viewOfOrgan({truth, teaching_.skin, teaching_.region, teaching_.probe, 0.0, teaching_.labels}, structure->label);
  if (!hold) return std::nullopt;
  return viewOfStructure(*hold, *ground_->organ(structure->label));
}

void TraineeCase::findViews(Progress& progress) {
  const auto targets = targetsIn(lessons_);
  std::size_t done = 0;
  for (const auto& [kind, name] : targets) {
    if (progress.cancelRequested()) return;
    progress.report(say<"Looking for views of targets">(), static_cast<double>(done++) / static_cast<double>(targets.size()));
    if (const auto view = found(kind, name)) views_.insert({{kind, name}, *view});
  }
}

const TargetView* TraineeCase::viewOf(TargetKind kind, const std::string& name) const {
  const auto at = views_.find({kind, name});
  return at == views_.end() ? nullptr : &at->second;
}

double TraineeCase::lengthOf_s(const std::string& recording) const {
  const auto found = lengths_s_.find(recording);
  return found == lengths_s_.end() ? 0.0 : found->second;
}

Knobs TraineeCase::expertKnobsAt(const Pose& pose) const {
  const glm::dmat4& at = pose.probeToWorld.matrix;
  const auto away = [&](const Look& look) {
    const glm::dmat4& other = look.pose.probeToWorld.matrix;
    const glm::dmat3 turn = glm::transpose(glm::dmat3(at)) * glm::dmat3(other);
    const double angle_rad = std::acos(std::clamp(0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1.0), -1.0, 1.0));
    return std::hypot(glm::distance(glm::dvec3(at[3]), glm::dvec3(other[3])), kLeverOfTurns_mm * angle_rad);
  };
  const auto nearest = std::min_element(looks_.begin(), looks_.end(), [&](const Look& a, const Look& b) { return away(a) < away(b); });
  return nearest == looks_.end() ? Knobs{} : nearest->knobs;
}

}  // namespace ew
