// What the panel by which a volume is placed shows in the 3D view: the near face, how it lies, and handles.
#include <QPushButton>
#include <algorithm>

#include "panel/place_panel.h"

namespace ew::case_authoring {
namespace {

constexpr std::size_t kMostMarks = 81;  // of the near face: more are no clearer, and are drawn with every image

}  // namespace

void PlacePanel::drawFace(const Placed& now, const PlacingShape& shape) {
  if (!over_) over_ = host_.overlays().overBody();
  if (!aids_) aids_ = host_.overlays().showInBody({.translucentSkin = true, .organs = {}, .volumeBox = true});
  sdk::BodyDrawing drawing;
  const auto corners = nearSideOf(now.own, now.axes, now.fileToWorld);
  sdk::OverlayLine<frame::World> side;
  side.points.assign(corners.begin(), corners.end());
  side.isClosed = true;
  side.width_px = 2.0;
  drawing.lines.push_back(side);
  // Contact is a filled square, a gap a cross, below the skin a dash: told apart without their colours.
  const glm::dvec3 x = (now.fileToWorld * Direction<frame::File>{now.axes.lateral}).along;
  const glm::dvec3 z = (now.fileToWorld * Direction<frame::File>{glm::cross(now.axes.lateral, now.axes.depth)}).along;
  const double r_mm = std::clamp(0.018 * glm::distance(corners[0].at, corners[2].at), 0.8, 3.0);
  for (const FaceMark& mark : faceMarksOf(shape, now.fileToWorld, *now.skin, kMostMarks)) {
    const auto line = [&](std::initializer_list<glm::dvec2> points, sdk::OverlayRole role, bool isFilled) {
      sdk::OverlayLine<frame::World> made;
      for (const glm::dvec2& p : points) made.points.push_back({mark.at.at + r_mm * (p.x * x + p.y * z)});
      made.role = role;
      made.width_px = 1.2;
      made.isClosed = made.isFilled = isFilled;
      drawing.lines.push_back(std::move(made));
    };
    switch (mark.kind) {
      case FaceMark::Kind::touching:
        line({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, sdk::OverlayRole::guide, true);
        break;
      case FaceMark::Kind::above:
        line({{-1, -1}, {1, 1}}, sdk::OverlayRole::danger, false);
        line({{-1, 1}, {1, -1}}, sdk::OverlayRole::danger, false);
        break;
      case FaceMark::Kind::below:
        line({{-1, 0}, {1, 0}}, sdk::OverlayRole::quiet, false);
        break;
    }
  }
  const auto pairs = pairsIn(host_.caseParts().read(kPlacingPart));
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const std::string name = pairs[n].name.empty() ? std::to_string(n + 1) : pairs[n].name;
    if (pairs[n].world_mm) drawing.labels.push_back({{*pairs[n].world_mm}, name, sdk::OverlayRole::expert});
    if (!pairs[n].isComplete()) continue;
    sdk::OverlayLine<frame::World> apart;
    apart.points = {now.fileToWorld * Point<frame::File>{*pairs[n].file_mm}, {*pairs[n].world_mm}};
    apart.role = sdk::OverlayRole::expert;
    apart.isDashed = true;
    drawing.lines.push_back(std::move(apart));
  }
  over_->show(std::move(drawing));
}

void PlacePanel::showHandles() {
  const auto now = placed();
  if (!now || !handles_->isChecked() || !isVisible()) {
    handlesShown_.reset();
    return;
  }
  sdk::BodyHandles handles = handlesOf(now->own, now->axes, now->fileToWorld);
  handles.axes = {tr("across").toStdString(), tr("along the beams").toStdString(), tr("along the sweep").toStdString()};
  if (handlesShown_) return handlesShown_->show(std::move(handles));
  handlesShown_ = host_.overlays().showHandles(handles, [this](const HandlesPose& to, bool isOver) { dragged(to, isOver); });
}

void PlacePanel::dragged(const HandlesPose& to, bool isOver) {
  if (!drag_) {
    const auto now = placed();
    if (!now) return;
    drag_ = Drag{now->fileToWorld, handlesOf(now->own, now->axes, now->fileToWorld).toWorld};
    ++drags_;
  }
  place(movedWith(drag_->fileToWorld, drag_->handles, to), tr("Move the volume by its handles"), "placing.drag" + std::to_string(drags_));
  if (isOver) drag_.reset();
}

}  // namespace ew::case_authoring
