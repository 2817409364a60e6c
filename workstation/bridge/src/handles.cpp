#include "ew/bridge/handles.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace ew::bridge {
namespace {

const double kLeastAlong = std::sin(glm::radians(8.0));    // between a line of sight and an axis that can be dragged along
const double kLeastFacing = std::sin(glm::radians(12.0));  // between a line of sight and the plane of a ring
constexpr double kFarthestDrag_mm = 2000.0;                // towards the horizon a pixel means ever more
constexpr double kLeastReach_px = 62.0;                    // of the reach
constexpr double kMostReach_px = 120.0;

glm::dvec3 handleAxis(const HandlesToWorld& toWorld, int axis) { return glm::normalize(glm::dvec3(toWorld.matrix[axis])); }
glm::dvec3 handlesOrigin(const HandlesToWorld& toWorld) { return glm::dvec3(toWorld.matrix[3]); }

double pixelsToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * along);
}

/// Distance on the screen from a point to a handle.
double distanceTo_px(const HandlesPlace& place, const Handle& handle, glm::dvec2 at_px,
                     const std::function<glm::dvec2(const glm::dvec3&)>& pixelOf) {
  const auto seen = [&](const glm::dvec3& p_handles) { return pixelOf(carried(place.toWorld, p_handles)); };
  glm::dvec3 unit(0.0);
  unit[handle.axis] = 1.0;
  if (handle.kind == Handle::Kind::move)
    return pixelsToSegment(at_px, seen(kArrowFrom * place.reach_mm * unit), seen(place.reach_mm * unit));
  constexpr int kPieces = 64;
  double least = std::numeric_limits<double>::infinity();
  glm::dvec2 before(0.0);
  for (int n = 0; n <= kPieces; ++n) {
    const double angle_rad = glm::two_pi<double>() * n / kPieces;
    glm::dvec3 p(0.0);
    p[(handle.axis + 1) % 3] = std::cos(angle_rad);
    p[(handle.axis + 2) % 3] = std::sin(angle_rad);
    const glm::dvec2 here = seen(kRingShare * place.reach_mm * p);
    if (n > 0) least = std::min(least, pixelsToSegment(at_px, before, here));
    before = here;
  }
  return least;
}

}  // namespace

double handlesReach_mm(double mmPerPixel, const glm::dvec3& halfSize_mm) {
  const double wanted_mm = 0.8 * glm::length(halfSize_mm);
  return std::clamp(wanted_mm, kLeastReach_px * mmPerPixel, kMostReach_px * mmPerPixel);
}

bool isUsable(const HandlesPlace& place, const Handle& handle, const glm::dvec3& eye_mm) {
  if (handle.kind == Handle::Kind::turn) return true;  // one that is seen from its edge is dragged along its tangent
  const glm::dvec3 sight = glm::normalize(handlesOrigin(place.toWorld) - eye_mm);
  return glm::length(glm::cross(sight, handleAxis(place.toWorld, handle.axis))) > 2.0 * kLeastAlong;
}

std::optional<Handle> handleAt(const HandlesPlace& place, const glm::dvec3& eye_mm, glm::dvec2 at_px,
                               const std::function<glm::dvec2(const glm::dvec3&)>& pixelOf, double near_px) {
  for (const auto kind : {Handle::Kind::move, Handle::Kind::turn}) {
    std::optional<Handle> best;
    double least_px = near_px;
    for (int axis = 0; axis < 3; ++axis) {
      const Handle handle{kind, axis};
      if (!isUsable(place, handle, eye_mm)) continue;
      const double here_px = distanceTo_px(place, handle, at_px, pixelOf);
      if (here_px > least_px) continue;
      least_px = here_px;
      best = handle;
    }
    if (best) return best;
  }
  return std::nullopt;
}

std::optional<double> alongAxis_mm(const Ray& ray, const glm::dvec3& origin_mm, const glm::dvec3& axis) {
  // The two lines' nearest points: with w from the eye to the origin, s = (b (d.w) - a.w) / (1 - b^2), b = a.d.
  const double b = glm::dot(axis, ray.direction);
  const double apart = 1.0 - b * b;  // squared sine of the angle between them
  if (apart < kLeastAlong * kLeastAlong) return std::nullopt;
  const glm::dvec3 w = origin_mm - ray.from_mm;
  return std::clamp((b * glm::dot(ray.direction, w) - glm::dot(axis, w)) / apart, -kFarthestDrag_mm, kFarthestDrag_mm);
}

std::optional<double> angleAbout_rad(const Ray& ray, const glm::dvec3& centre_mm, const glm::dvec3& axis, const glm::dvec3& zero) {
  const double facing = glm::dot(ray.direction, axis);
  if (std::abs(facing) < kLeastFacing) return std::nullopt;
  const double way_mm = glm::dot(centre_mm - ray.from_mm, axis) / facing;
  if (way_mm <= 0.0) return std::nullopt;
  const glm::dvec3 p = ray.from_mm + way_mm * ray.direction - centre_mm;
  return std::atan2(glm::dot(p, glm::cross(axis, zero)), glm::dot(p, zero));
}

HandlesToWorld moved(const HandlesToWorld& from, const Handle& handle, double amount) {
  if (amount == 0.0) return from;
  glm::dvec3 unit(0.0);
  unit[handle.axis] = 1.0;
  return {handle.kind == Handle::Kind::move ? glm::translate(from.matrix, amount * unit) : glm::rotate(from.matrix, amount, unit)};
}

HandleDrag::HandleDrag(const HandlesPlace& from, const Handle& handle, const Ray& grabbed)
    : from_(from), handle_(handle), axis_(handleAxis(from.toWorld, handle.axis)) {
  if (handle.kind == Handle::Kind::turn) {
    zero_ = handleAxis(from.toWorld, (handle.axis + 1) % 3);
    const glm::dvec3 centre_mm = handlesOrigin(from.toWorld);
    if (!angleAbout_rad(grabbed, centre_mm, axis_, zero_)) {
      // Seen from its edge: the rim that faces the viewer, dragged across the line of sight.
      const glm::dvec3 towards = grabbed.from_mm - centre_mm;
      const glm::dvec3 out = glm::normalize(towards - glm::dot(towards, axis_) * axis_);
      rim_ = centre_mm + kRingShare * from.reach_mm * out;
      zero_ = glm::cross(axis_, out);
    }
  }
  last_ = read(grabbed);
}

std::optional<double> HandleDrag::read(const Ray& ray) const {
  const glm::dvec3 origin_mm = handlesOrigin(from_.toWorld);
  if (handle_.kind == Handle::Kind::move) return alongAxis_mm(ray, origin_mm, axis_);
  if (!rim_) return angleAbout_rad(ray, origin_mm, axis_, zero_);
  const auto along_mm = alongAxis_mm(ray, *rim_, zero_);
  return along_mm ? std::optional(*along_mm / (kRingShare * from_.reach_mm)) : std::nullopt;
}

double HandleDrag::follow(const Ray& ray) {
  const auto now = read(ray);
  if (!now) return amount_;
  if (last_) {
    const double by = *now - *last_;
    // The shorter way round: a pointer does not go half around a ring between two events.
    amount_ += handle_.kind == Handle::Kind::turn && !rim_ ? std::remainder(by, glm::two_pi<double>()) : by;
  }
  last_ = now;
  return amount_;
}

double HandleDrag::stepped(double step) const { return step > 0.0 ? std::round(amount_ / step) * step : amount_; }

HandlesToWorld HandleDrag::toWorld(double step) const { return moved(from_.toWorld, handle_, stepped(step)); }

ViewAxes axesAsSeen(const HandlesToWorld& toWorld, const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& forward) {
  const std::array<glm::dvec3, 3> views{right, up, forward};
  std::array<int, 3> order{0, 1, 2}, best = order;
  double most = -1.0;
  do {
    double sum = 0.0;
    for (std::size_t n = 0; n < 3; ++n) sum += std::abs(glm::dot(handleAxis(toWorld, order[n]), views[n]));
    if (sum > most + 1e-12) {
      most = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  const auto sense = [&](std::size_t n) { return AxisSense{best[n], glm::dot(handleAxis(toWorld, best[n]), views[n]) < 0.0 ? -1.0 : 1.0}; };
  return {sense(0), sense(1), sense(2)};
}

}  // namespace ew::bridge
