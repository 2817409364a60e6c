#include "ew/measurement/caliper_drawing.h"

#include <algorithm>
#include <cmath>

namespace ew::measurement {
namespace {

constexpr std::size_t kFewPoints = 24;  // of an outline that was clicked: each handle stands for itself
constexpr double kFollow_mm = 4.0;      // standard deviation, along an outline, of what follows a handle
constexpr double kDrawn_mm = 0.5;       // between the points of an outline that is drawn

/// Both ends of an ellipse's second axis from a point that lies beside the first one.
std::pair<glm::dvec2, glm::dvec2> secondAxis(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& beside) {
  const glm::dvec2 middle = 0.5 * (from + to), along = to - from;
  const double length = glm::length(along);
  const glm::dvec2 across = length > 0.0 ? glm::dvec2(-along.y, along.x) / length : glm::dvec2(0.0, 1.0);
  const glm::dvec2 half = glm::dot(beside - middle, across) * across;
  return {middle + half, middle - half};
}

void moveEllipse(std::vector<glm::dvec2>& points, std::size_t moved, glm::dvec2 to) {
  if (points.size() != 4) return;
  if (moved >= 2) {
    auto [here, there] = secondAxis(points[0], points[1], to);
    // The end at hand goes to the side of the pointer.
    points[moved] = here;
    points[moved == 2 ? 3 : 2] = there;
    return;
  }
  const double half = 0.5 * glm::distance(points[2], points[3]);
  const glm::dvec2 before = points[1] - points[0];
  const double side = before.x * (points[2] - points[3]).y - before.y * (points[2] - points[3]).x < 0.0 ? -1.0 : 1.0;
  points[moved] = to;
  const glm::dvec2 middle = 0.5 * (points[0] + points[1]), along = points[1] - points[0];
  const double length = glm::length(along);
  if (!(length > 0.0)) return;
  const glm::dvec2 across = side * half / length * glm::dvec2(-along.y, along.x);
  points[2] = middle + across;
  points[3] = middle - across;
}

void moveOutline(std::vector<glm::dvec2>& points, std::size_t moved, glm::dvec2 to) {
  const glm::dvec2 by = to - points[moved];
  const std::vector<glm::dvec2> before = points;
  const std::size_t count = points.size();
  points[moved] = to;
  for (const bool forward : {true, false}) {
    double along_mm = 0.0;
    std::size_t last = moved;
    for (std::size_t n = 1; n <= count / 2; ++n) {
      const std::size_t next = forward ? (moved + n) % count : (moved + count - n) % count;
      along_mm += glm::distance(before[next], before[last]);
      if (along_mm > 4.0 * kFollow_mm) break;
      points[next] = before[next] + std::exp(-0.5 * along_mm * along_mm / (kFollow_mm * kFollow_mm)) * by;
      last = next;
    }
  }
}

}  // namespace

Caliper withHandleAt(const Caliper& caliper, Handle handle, glm::dvec2 to) {
  Caliper moved = caliper;
  if (handle.part >= moved.parts.size() || handle.point >= moved.parts[handle.part].points.size()) return moved;
  auto& points = moved.parts[handle.part].points;
  if (caliper.kind == CaliperKind::ellipse)
    moveEllipse(points, handle.point, to);
  else if (caliper.kind == CaliperKind::trace && points.size() > kFewPoints)
    moveOutline(points, handle.point, to);
  else
    points[handle.point] = to;
  return moved;
}

const std::vector<CaliperKind>& drawnKinds() {
  static const std::vector<CaliperKind> kinds{CaliperKind::distance,      CaliperKind::polyLine, CaliperKind::trace, CaliperKind::ellipse,
                                              CaliperKind::fittedEllipse, CaliperKind::angle,    CaliperKind::discs};
  return kinds;
}

const std::vector<CaliperKind>& stripKinds() {
  static const std::vector<CaliperKind> kinds{CaliperKind::interval, CaliperKind::heartRate, CaliperKind::slope,
                                              CaliperKind::depthDistance};
  return kinds;
}

bool endsWhenAsked(CaliperKind kind) {
  return kind == CaliperKind::polyLine || kind == CaliperKind::trace || kind == CaliperKind::fittedEllipse || kind == CaliperKind::discs;
}

void CaliperDrawing::take(CaliperKind kind, Purpose purpose) {
  tool_ = kind;
  purpose_ = std::move(purpose);
  selected_ = 0;
  points_.clear();
  pressedAt_.reset();
  dragged_.reset();
  isDrawn_ = false;
}

void CaliperDrawing::add(std::vector<glm::dvec2> points) {
  selected_ = list_.add(of(*tool_, std::move(points)), {}, purpose_.item, purpose_.side);
  points_.clear();
  isDrawn_ = false;
  pressedAt_.reset();
}

CaliperDrawing::Press CaliperDrawing::set(glm::dvec2 at, double reach_mm) {
  const CaliperKind kind = *tool_;
  // Where the outline began it ends; where the last point was set, too: that is what a second click or Enter means.
  if (endsWhenAsked(kind) && !points_.empty()) {
    const bool isAtLast = apart(points_.back(), at) <= 0.5 * reach_mm;
    // The outline of discs begins behind the two ends of their axis.
    const std::size_t first = kind == CaliperKind::discs ? 2 : 0;
    const bool isClosed = kind == CaliperKind::trace || kind == CaliperKind::discs;
    const bool isAtFirst = isClosed && points_.size() >= first + 3 && apart(points_[first], at) <= reach_mm;
    if (isAtLast || isAtFirst) return finish() ? Press::finished : Press::nothing;
  }
  // Two ends in one place measure nothing: the second is still to come.
  if (!points_.empty() && points_.back() == at) return Press::nothing;
  points_.push_back(at);
  if (kind == CaliperKind::ellipse && points_.size() == 3) {
    const auto [here, there] = secondAxis(points_[0], points_[1], points_[2]);
    if (here == there) return points_.pop_back(), Press::nothing;
    points_ = {points_[0], points_[1], here, there};
    add(points_);
    return Press::finished;
  }
  if (!endsWhenAsked(kind) && kind != CaliperKind::ellipse && points_.size() == (kind == CaliperKind::angle ? 3U : 2U)) {
    add(points_);
    return Press::finished;
  }
  return Press::point;
}

CaliperDrawing::Press CaliperDrawing::press(glm::dvec2 at, double reach_mm) {
  pointer_ = at;
  if (points_.empty()) {
    const auto near = handleNear(shown(), image_, at, reach_mm, scale_);
    if (const Measurement* held = near ? shown().find(near->number) : nullptr) {
      selected_ = near->number;
      dragged_ = Dragged{near->number, near->handle, held->caliper, false};
      return Press::handle;
    }
  }
  if (!tool_) {
    selected_ = 0;
    return Press::nothing;
  }
  const Press pressed = set(at, reach_mm);
  if (pressed == Press::point) pressedAt_ = at;
  return pressed;
}

void CaliperDrawing::moveTo(glm::dvec2 at, double reach_mm) {
  pointer_ = at;
  if (dragged_) {
    const Caliper moved = withHandleAt(dragged_->before, dragged_->handle, at);
    list_.setCaliper(dragged_->number, moved, dragged_->hasMoved ? Change::goesOn : Change::begins);
    dragged_->hasMoved = true;
    return;
  }
  if (!pressedAt_ || tool_ != CaliperKind::trace) return;
  if (apart(*pressedAt_, at) > reach_mm) isDrawn_ = true;
  if (isDrawn_ && glm::distance(points_.back(), at) >= kDrawn_mm) points_.push_back(at);
}

void CaliperDrawing::release(glm::dvec2 at, double reach_mm) {
  pointer_ = at;
  dragged_.reset();
  if (!pressedAt_) return;
  const glm::dvec2 from = *std::exchange(pressedAt_, std::nullopt);
  if (isDrawn_) {
    isDrawn_ = false;
    // Back where it began it is whole; else it waits for more of it.
    if (apart(points_.front(), at) <= 2.0 * reach_mm) finish();
  } else if (tool_ && tool_ != CaliperKind::trace && apart(from, at) > reach_mm) {
    set(at, reach_mm);
  }
}

void CaliperDrawing::letGo() {
  dragged_.reset();
  pressedAt_.reset();
  isDrawn_ = false;
}

bool CaliperDrawing::isNearHandle(glm::dvec2 at, double reach_mm) const {
  return handleNear(shown(), image_, at, reach_mm, scale_).has_value();
}

std::optional<glm::dvec2> CaliperDrawing::fixedEnd() const {
  if (!dragged_) return std::nullopt;
  const auto& points = dragged_->before.parts[dragged_->handle.part].points;
  return points.size() == 2 ? std::optional(points[1 - dragged_->handle.point]) : std::nullopt;
}

bool CaliperDrawing::finish() {
  if (!tool_ || !endsWhenAsked(*tool_) || points_.size() < shapeOf(*tool_).fewest) return false;
  add(points_);
  return true;
}

bool CaliperDrawing::setCyclesOf(int number, int cycles) {
  const Measurement* found = shown().find(number);
  if (found == nullptr || found->caliper.kind != CaliperKind::heartRate || found->caliper.cycles == cycles) return false;
  Caliper caliper = found->caliper;
  caliper.cycles = cycles;
  return list_.setCaliper(number, std::move(caliper));
}

bool CaliperDrawing::takeBack() {
  if (!points_.empty()) return points_.pop_back(), true;
  if (selected_ != 0) return remove(selected_);
  return !shown().all.empty() && remove(shown().all.back().number);
}

bool CaliperDrawing::cancel() {
  dragged_.reset();
  pressedAt_.reset();
  isDrawn_ = false;
  if (!points_.empty()) return points_.clear(), true;
  if (tool_) return tool_.reset(), purpose_ = {}, true;
  return std::exchange(selected_, 0) != 0;
}

bool CaliperDrawing::remove(int number) {
  if (!list_.remove(number)) return false;
  if (selected_ == number) selected_ = 0;
  dragged_.reset();
  return true;
}

bool CaliperDrawing::clear() {
  const bool hadPoints = !points_.empty();
  points_.clear();
  dragged_.reset();
  pressedAt_.reset();
  selected_ = 0;
  return list_.clear() || hadPoints;
}

void CaliperDrawing::select(int number) { selected_ = shown().find(number) != nullptr ? number : 0; }

bool CaliperDrawing::undo() {
  dragged_.reset();
  pressedAt_.reset();
  if (!points_.empty()) return points_.pop_back(), true;
  if (!list_.undo()) return false;
  select(selected_);
  return true;
}

bool CaliperDrawing::redo() {
  if (!canRedo() || !list_.redo()) return false;
  select(selected_);
  return true;
}

std::optional<Caliper> CaliperDrawing::unfinished() const {
  if (!tool_ || points_.empty()) return std::nullopt;
  std::vector<glm::dvec2> points = points_;
  if (pointer_ && *pointer_ != points.back() && !isDrawn_) points.push_back(*pointer_);
  if (*tool_ == CaliperKind::ellipse && points.size() == 3) {
    const auto [here, there] = secondAxis(points[0], points[1], points[2]);
    points = {points[0], points[1], here, there};
  }
  return of(*tool_, std::move(points));
}

bool CaliperDrawing::refine(int number, std::vector<glm::dvec2> outline) {
  const Measurement* found = shown().find(number);
  if (found == nullptr || (found->caliper.kind != CaliperKind::trace && found->caliper.kind != CaliperKind::fittedEllipse)) return false;
  return list_.setCaliper(number, of(found->caliper.kind, std::move(outline)));
}

}  // namespace ew::measurement
