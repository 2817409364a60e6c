#include "ew/acquisition/screen_edit.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {

constexpr double kLeastSpread_rad = 0.02;
constexpr double kMostSpread_rad = 3.141592653589793;
constexpr double kLeastDepth_px = 2.0;
constexpr double kSectorShare = 0.1;  ///< of the far radius: a fan whose near one is smaller is a sector
constexpr double kFirstHalfAngle_rad = 0.55;

glm::dvec2 along(double angle_rad) { return {std::sin(angle_rad), std::cos(angle_rad)}; }
double angleTo(glm::dvec2 d) { return std::atan2(d.x, d.y); }
double middleOf(const FanOutline& fan) { return 0.5 * (fan.left_rad + fan.right_rad); }
glm::dvec2 on(const FanOutline& fan, double radius_px, double angle_rad) { return fan.apex_px + radius_px * along(angle_rad); }

/// The fan with its apex elsewhere, and its far corners and the middle of its near edge where they were.
FanOutline withApexAt(const FanOutline& fan, glm::dvec2 to_px) {
  const glm::dvec2 left = on(fan, fan.far_px, fan.left_rad) - to_px, right = on(fan, fan.far_px, fan.right_rad) - to_px;
  const glm::dvec2 face = on(fan, fan.near_px, middleOf(fan)) - to_px;
  FanOutline moved = fan;
  moved.apex_px = to_px;
  moved.left_rad = angleTo(left);
  moved.right_rad = angleTo(right);
  moved.far_px = 0.5 * (glm::length(left) + glm::length(right));
  moved.near_px = std::max(0.0, glm::dot(face, along(middleOf(moved))));
  return moved;
}

FanOutline withFanGripAt(const FanOutline& fan, OutlineGrip grip, glm::dvec2 to_px) {
  FanOutline moved = fan;
  const glm::dvec2 d = to_px - fan.apex_px;
  if (grip == OutlineGrip::apex) moved = withApexAt(fan, to_px);
  if (grip == OutlineGrip::left) moved.left_rad = std::min(angleTo(d), fan.right_rad - kLeastSpread_rad);
  if (grip == OutlineGrip::right) moved.right_rad = std::max(angleTo(d), fan.left_rad + kLeastSpread_rad);
  if (grip == OutlineGrip::nearEdge)
    moved.near_px = std::clamp(glm::dot(d, along(middleOf(fan))), 0.0, std::max(0.0, fan.far_px - kLeastDepth_px));
  if (grip == OutlineGrip::farEdge) moved.far_px = std::max(glm::length(d), fan.near_px + kLeastDepth_px);
  // An apex that was dragged into the scan or below it is no apex of it.
  const double spread_rad = moved.right_rad - moved.left_rad;
  if (spread_rad < kLeastSpread_rad || spread_rad > kMostSpread_rad || moved.far_px - moved.near_px < kLeastDepth_px) return fan;
  moved.shape = moved.near_px < kSectorShare * moved.far_px ? FanShape::sector : FanShape::convex;
  return moved;
}

FanOutline withCornerGripAt(const FanOutline& outline, OutlineGrip grip, glm::dvec2 to_px) {
  FanOutline moved = outline;
  auto& c = moved.corners_px;
  const auto shift = [&](std::size_t a, std::size_t b, glm::dvec2 axis) {
    const glm::dvec2 by = axis * (to_px - 0.5 * (c[a] + c[b]));
    c[a] += by;
    c[b] += by;
  };
  switch (grip) {
    case OutlineGrip::upperLeft:
      c[0] = to_px;
      break;
    case OutlineGrip::upperRight:
      c[1] = to_px;
      break;
    case OutlineGrip::lowerRight:
      c[2] = to_px;
      break;
    case OutlineGrip::lowerLeft:
      c[3] = to_px;
      break;
    case OutlineGrip::left:
      shift(0, 3, {1.0, 0.0});
      break;
    case OutlineGrip::right:
      shift(1, 2, {1.0, 0.0});
      break;
    case OutlineGrip::nearEdge:
      shift(0, 1, {0.0, 1.0});
      break;
    case OutlineGrip::farEdge:
      shift(3, 2, {0.0, 1.0});
      break;
    default:
      break;
  }
  return moved;
}

glm::dvec2 middleOfCorners(const FanOutline& outline) {
  const auto& c = outline.corners_px;
  return 0.25 * (c[0] + c[1] + c[2] + c[3]);
}

FanOutline within(FanShape shape, glm::dvec2 from_px, glm::dvec2 to_px) {
  FanOutline outline;
  outline.shape = shape;
  if (shape == FanShape::linear) {
    outline.corners_px = {from_px, glm::dvec2(to_px.x, from_px.y), to_px, glm::dvec2(from_px.x, to_px.y)};
    return outline;
  }
  const glm::dvec2 extent = to_px - from_px;
  outline.right_rad = kFirstHalfAngle_rad;
  outline.left_rad = -kFirstHalfAngle_rad;
  outline.far_px = std::max(extent.y, 0.5 * extent.x / std::sin(kFirstHalfAngle_rad));
  outline.near_px = std::clamp((outline.far_px - extent.y) / std::cos(kFirstHalfAngle_rad), 0.0, outline.far_px - kLeastDepth_px);
  outline.apex_px = {0.5 * (from_px.x + to_px.x), to_px.y - outline.far_px};
  outline.shape = outline.near_px < kSectorShare * outline.far_px ? FanShape::sector : FanShape::convex;
  return outline;
}

bool holds(const PixelRect& rect, glm::dvec2 p) {
  // Pixel centres lie at integers, so that a pixel reaches half a pixel to either side.
  return p.x >= rect.x - 0.5 && p.y >= rect.y - 0.5 && p.x < rect.x + rect.width - 0.5 && p.y < rect.y + rect.height - 0.5;
}

}  // namespace

std::vector<GripPosition> gripsOf(const FanOutline& outline) {
  if (outline.shape == FanShape::linear) {
    const auto& c = outline.corners_px;
    return {{OutlineGrip::upperLeft, c[0]},
            {OutlineGrip::upperRight, c[1]},
            {OutlineGrip::lowerRight, c[2]},
            {OutlineGrip::lowerLeft, c[3]},
            {OutlineGrip::left, 0.5 * (c[0] + c[3])},
            {OutlineGrip::right, 0.5 * (c[1] + c[2])},
            {OutlineGrip::nearEdge, 0.5 * (c[0] + c[1])},
            {OutlineGrip::farEdge, 0.5 * (c[3] + c[2])},
            {OutlineGrip::whole, middleOfCorners(outline)}};
  }
  const double half_px = 0.5 * (outline.near_px + outline.far_px), middle = middleOf(outline);
  return {{OutlineGrip::apex, outline.apex_px},
          {OutlineGrip::left, on(outline, half_px, outline.left_rad)},
          {OutlineGrip::right, on(outline, half_px, outline.right_rad)},
          {OutlineGrip::nearEdge, on(outline, outline.near_px, middle)},
          {OutlineGrip::farEdge, on(outline, outline.far_px, middle)},
          {OutlineGrip::whole, on(outline, half_px, middle)}};
}

FanOutline withGripAt(const FanOutline& outline, OutlineGrip grip, glm::dvec2 to_px) {
  if (grip == OutlineGrip::whole) return outline.movedBy(to_px - gripsOf(outline).back().at_px);
  return outline.shape == FanShape::linear ? withCornerGripAt(outline, grip, to_px) : withFanGripAt(outline, grip, to_px);
}

FanOutline withShape(const FanOutline& outline, FanShape shape) {
  if ((outline.shape == FanShape::linear) == (shape == FanShape::linear)) return outline;
  const auto bounds = outline.bounds_px();
  return within(shape, bounds[0], bounds[1]);
}

FanOutline outlineToBeginWith(FanShape shape, int width_px, int height_px) {
  const glm::dvec2 size(width_px, height_px);
  return within(shape, 0.2 * size, 0.8 * size);
}

std::vector<TextBox> ScreenEdit::boxes() const {
  std::vector<TextBox> boxes;
  const auto& removed = correction_.removed;
  std::vector<PixelRect> drawn = correction_.added;
  for (const ScreenPart& part : found_.parts) {
    if (part.kind == ScreenPartKind::text)
      boxes.push_back({part.rect, std::find(removed.begin(), removed.end(), part.rect) == removed.end(), false});
    if (part.kind == ScreenPartKind::possibleText) boxes.push_back({part.rect, std::erase(drawn, part.rect) > 0, false, true});
  }
  for (const PixelRect& rect : drawn) boxes.push_back({rect, true, true});
  return boxes;
}

void ScreenEdit::addBox(const PixelRect& rect) {
  if (rect.width > 0 && rect.height > 0) correction_.added.push_back(rect);
}

bool ScreenEdit::toggleBoxAt(glm::dvec2 p_px) {
  const std::vector<TextBox> all = boxes();
  const TextBox* hit = nullptr;
  const auto areaOf = [](const PixelRect& rect) { return static_cast<long long>(rect.width) * rect.height; };
  for (const TextBox& box : all)
    if (holds(box.rect, p_px) && (hit == nullptr || areaOf(box.rect) <= areaOf(hit->rect))) hit = &box;
  if (hit == nullptr) return false;
  if (hit->isAdded || (hit->isPossible && hit->counts))
    std::erase(correction_.added, hit->rect);
  else if (hit->isPossible)
    correction_.added.push_back(hit->rect);
  else if (hit->counts)
    correction_.removed.push_back(hit->rect);
  else
    std::erase(correction_.removed, hit->rect);
  return true;
}

bool ScreenEdit::setTurned(const Orientation& turned) {
  const ScreenCorrection before = correction_;
  backToFound();
  const bool isChanged = before != correction_;
  correction_.turned = turned;
  return isChanged;
}

void ScreenEdit::backToFound() {
  correction_.outline.reset();
  correction_.added.clear();
  correction_.removed.clear();
}

}  // namespace ew
