#include "panel/aids_drawer.h"

#include <algorithm>
#include <cmath>

#include "ew/imaging/display.h"

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

std::vector<sdk::OverlayLine<frame::Probe>> outlineOf(const sdk::Scanned& scanned, int label, const ScanState& image, double step_mm) {
  std::vector<sdk::OverlayLine<frame::Probe>> lines;
  if (!scanned.labels || label == 0) return lines;
  const double depth_mm = resolvedDepth_mm(image.probe, image.knobs);
  const double half_mm = isSector(image.probe.kind) ? depth_mm : faceHalfWidth_mm(image.probe);
  const int columns = static_cast<int>(2.0 * half_mm / step_mm) + 2, rows = static_cast<int>(depth_mm / step_mm) + 2;
  const auto at = [&](int column, int row) { return glm::dvec2(-half_mm + column * step_mm, row * step_mm); };
  const auto worldToVoxel = inverse(scanned.placedLabels.voxelToWorld());
  const glm::ivec3 dims = scanned.placedLabels.dims;
  const auto isLabel = [&](const glm::dvec3& at_mm) {
    const glm::ivec3 voxel(glm::round((worldToVoxel * Point<frame::World>{at_mm}).at));
    if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(voxel, dims))) return false;
    return scanned.labels->echo[scanned.labels->grid.indexOf(voxel.x, voxel.y, voxel.z)] == label;
  };
  std::vector<bool> inside(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  const auto place = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const glm::dvec2 p = at(column, row);
      inside[place(column, row)] = isLabel((image.pose.probeToWorld * Point<frame::Probe>{{p.x, p.y, 0.0}}).at);
    }
  const auto add = [&](glm::dvec2 a, glm::dvec2 b) {
    sdk::OverlayLine<frame::Probe> line;
    line.points = {{{a.x, a.y, 0.0}}, {{b.x, b.y, 0.0}}};
    line.role = sdk::OverlayRole::expert;
    lines.push_back(std::move(line));
  };
  const double h = 0.5 * step_mm;
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const glm::dvec2 p = at(column, row);
      const bool here = inside[place(column, row)];
      if (here != inside[place(column + 1, row)]) add(p + glm::dvec2(h, -h), p + glm::dvec2(h, h));
      if (here != inside[place(column, row + 1)]) add(p + glm::dvec2(-h, h), p + glm::dvec2(h, h));
    }
  return lines;
}

AidsDrawer::AidsDrawer(sdk::Host& host, const LessonStep& step, StepScene scene)
    : host_(host), step_(step), scene_(std::move(scene)), overScan_(host.overlays().overScan()), overBody_(host.overlays().overBody()) {
  if (const auto* task = std::get_if<PlaneTask>(&step_.task))
    for (const ExpectedPlane& plane : scene_.truth->planes)
      if (plane.name == task->target) plane_ = plane;
  for (const ExpectedStructure& structure : scene_.truth->structures)
    if (structure.name == structureOf(step_.task)) label_ = structure.label;
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
    for (const ExpectedStructure& structure : scene_.truth->structures) inBody.organs.push_back(structure.label);
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
  overScan_->show(std::move(drawing));
}

}  // namespace ew::lessons
