#include "panel/aids_drawer.h"

#include <algorithm>
#include <cmath>

#include "ew/imaging/display.h"
#include "logic/outline.h"

namespace ew::lessons {
namespace {

constexpr double kPathStep_mm = 2.0;
constexpr std::size_t kLongestPath = 4000;
constexpr double kOutlineStep_mm = 1.5;

/// The structure a step is about; empty: none.
std::string structureOf(const LessonTask& task) {
  if (const auto* sweep = std::get_if<SweepTask>(&task)) return sweep->target;
  if (const auto* point = std::get_if<PointTask>(&task)) return point->target;
  return {};
}

}  // namespace

AidsDrawer::AidsDrawer(sdk::Host& host, const LessonStep& step, StepScene scene)
    : host_(host), step_(step), scene_(std::move(scene)), overScan_(host.overlays().overScan()), overBody_(host.overlays().overBody()) {
  if (const auto* task = std::get_if<PlaneTask>(&step_.task))
    for (const ReferencePlane& plane : scene_.truth->planes)
      if (plane.name == task->target) plane_ = plane;
  for (const ReferenceStructure& structure : scene_.truth->structures)
    if (structure.name == structureOf(step_.task)) label_ = structure.label;
  for (const ReferencePoint& point : scene_.truth->points)
    if (point.name == structureOf(step_.task)) point_ = point;
}

void AidsDrawer::setAids(const LessonAids& aids) {
  const LessonAids& allowed = step_.aids;
  aids_ = {allowed.translucentSkin && aids.translucentSkin,
           allowed.organs && aids.organs,
           allowed.volumeBox && aids.volumeBox,
           allowed.ownPath && aids.ownPath,
           allowed.expertProbe && aids.expertProbe,
           allowed.outline && aids.outline,
           allowed.compass && aids.compass};
  sdk::BodyAids inBody{aids_.translucentSkin, {}, aids_.volumeBox};
  if (aids_.organs)
    for (const ReferenceStructure& structure : scene_.truth->structures) inBody.organs.push_back(structure.label);
  sdk::Ticket shown = host_.overlays().showInBody(inBody);
  inBody_ = std::move(shown);  // the one before goes only now, so that nothing flickers in between
  drawBody();
  if (!aids_.outline) overScan_->show({});
}

void AidsDrawer::see(const ScanState& image) {
  if (image.pose.status != PoseStatus::ok) return;
  const Point<frame::World> face{glm::dvec3(image.pose.probeToWorld.matrix[3])};
  if (path_.size() < kLongestPath && (path_.empty() || glm::distance(path_.back().at, face.at) > kPathStep_mm)) {
    path_.push_back(face);
    if (aids_.ownPath) drawBody();
  }
  if (aids_.outline) drawScan(image);
}

void AidsDrawer::drawBody() {
  sdk::BodyDrawing drawing;
  if (aids_.ownPath && path_.size() > 1) {
    sdk::OverlayLine<frame::World> line;
    line.points = path_;
    line.role = sdk::OverlayRole::trainee;
    drawing.lines.push_back(std::move(line));
  }
  if (aids_.expertProbe && plane_) {
    sdk::OverlayPlane plane;
    plane.probeToWorld = plane_->probeToWorld;
    plane.role = sdk::OverlayRole::expert;
    drawing.planes.push_back(plane);
    sdk::OverlayLabel<frame::World> label;
    label.at = {glm::dvec3(plane_->probeToWorld.matrix[3])};
    label.role = sdk::OverlayRole::expert;
    drawing.labels.push_back(std::move(label));
  }
  overBody_->show(std::move(drawing));
}

void AidsDrawer::drawScan(const ScanState& image) {
  sdk::ScanDrawing drawing;
  drawing.lines = outlineOf(scene_.scanned, label_, image, kOutlineStep_mm);
  bool isHere = !drawing.lines.empty();
  if (point_) {
    const glm::dvec3 at = carried(rigidInverse(image.pose.probeToWorld), point_->at_mm);
    isHere = std::abs(at.z) <= point_->tolerance_mm && isInFan(image.probe, resolvedDepth_mm(image.probe, image.knobs), glm::dvec2(at));
    sdk::OverlayLabel<frame::Probe> label;
    label.at = {{at.x, at.y, 0.0}};
    label.role = sdk::OverlayRole::expert;
    if (isHere) drawing.labels.push_back(std::move(label));
  }
  isElsewhere_ = !isHere && (point_ || label_ != 0);
  overScan_->show(std::move(drawing));
}

namespace {

LessonStep withOutlineAlone(LessonStep step) {
  step.aids = {};
  step.aids.outline = true;
  return step;
}

}  // namespace

TargetShown::TargetShown(sdk::Host& host, const LessonStep& step, const StepScene& scene, std::shared_ptr<sdk::ScanOverlay> point)
    : host_(host), drawer_(host, withOutlineAlone(step), scene), point_(std::move(point)) {
  drawer_.setAids(withOutlineAlone(step).aids);
  events_ = host_.scan().onEvent([this](const ScanEvent& event) {
    if (std::holds_alternative<FrameMade>(event.what)) see();
  });
  see();
}

void TargetShown::see() {
  const auto image = host_.scan().state();
  if (!image) return;
  if (!pose_) pose_ = image->pose;
  if (pose_->probeToWorld != image->pose.probeToWorld) point_.reset();  // it was a place in another image
  drawer_.see(*image);
}

}  // namespace ew::lessons
