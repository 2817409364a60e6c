#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "ew/bridge/scene3d.h"
#include "ew/core/frames.h"

/// Handles by which a rigid body is moved in the scene: what a mouse means by them, without drawing.
namespace ew::bridge {

/// The frame of what is moved; its origin is where the handles' axes meet. mm.
struct HandlesFrame {};
using HandlesToWorld = Transform<frame::World, HandlesFrame>;

/// An arrow along an axis of the frame, or the ring about it.
struct Handle {
  enum class Kind { move, turn };
  Kind kind = Kind::move;
  int axis = 0;  ///< 0, 1, 2 for x, y, z
  bool operator==(const Handle&) const = default;
};

/// Where handles stand. Arrows reach from the origin to `reach_mm`, rings have kRingShare of that as radius.
struct HandlesPlace {
  HandlesToWorld toWorld;
  double reach_mm = 60.0;
};
inline constexpr double kRingShare = 0.78;
inline constexpr double kArrowFrom = 0.16;  ///< of the reach: where the shaft begins, so that the middle stays free

/// How far handles reach: beyond the box where that is seen well, and never so small or large on the screen that they cannot be used.
[[nodiscard]] double handlesReach_mm(double mmPerPixel, const glm::dvec3& halfSize_mm);

/// Whether a handle can be used as it is seen: an arrow that points at the viewer cannot.
[[nodiscard]] bool isUsable(const HandlesPlace& place, const Handle& handle, const glm::dvec3& eye_mm);

/// The handle under a point of the screen, within `near_px`; of several the nearest, arrows before rings. Empty: none.
/// @param pixelOf where a point of the world is seen
[[nodiscard]] std::optional<Handle> handleAt(const HandlesPlace& place, const glm::dvec3& eye_mm, glm::dvec2 at_px,
                                             const std::function<glm::dvec2(const glm::dvec3&)>& pixelOf, double near_px);

/// Where on the line through `origin_mm` along `axis` (unit) the line of sight passes it nearest, mm from the origin.
/// Empty when the two are closer to parallel than 8 degrees: then a pixel means metres.
[[nodiscard]] std::optional<double> alongAxis_mm(const Ray& ray, const glm::dvec3& origin_mm, const glm::dvec3& axis);

/// At which angle about `axis` the line of sight meets the plane through `centre_mm`, from `zero` (unit, square to the axis),
/// counter-clockwise seen from the axis's tip; in (-pi, pi]. Empty when it meets it at less than 12 degrees, or behind the viewer.
[[nodiscard]] std::optional<double> angleAbout_rad(const Ray& ray, const glm::dvec3& centre_mm, const glm::dvec3& axis,
                                                   const glm::dvec3& zero);

/// The pose moved along, or turned about, one axis of its own. @param amount mm or radians
[[nodiscard]] HandlesToWorld moved(const HandlesToWorld& from, const Handle& handle, double amount);

/// One drag of one handle. What it gives depends on where it began and where the pointer is, not on the way between, but for whole turns.
class HandleDrag {
 public:
  HandleDrag(const HandlesPlace& from, const Handle& handle, const Ray& grabbed);

  /// How far the handle has been dragged when the pointer is on this line of sight: mm, or radians with whole turns counted. A line of
  /// sight that says nothing leaves it as it was.
  double follow(const Ray& ray);
  [[nodiscard]] double amount() const { return amount_; }
  [[nodiscard]] const Handle& handle() const { return handle_; }
  [[nodiscard]] const HandlesToWorld& from() const { return from_.toWorld; }
  /// The pose now. @param step of the amount, mm or radians: it is brought to the nearest multiple; 0: any
  [[nodiscard]] HandlesToWorld toWorld(double step = 0.0) const;
  [[nodiscard]] double stepped(double step) const;

 private:
  [[nodiscard]] std::optional<double> read(const Ray& ray) const;

  HandlesPlace from_;
  Handle handle_;
  glm::dvec3 axis_{0.0};           ///< world
  std::optional<glm::dvec3> rim_;  ///< of a ring that is seen from its edge: the point that is dragged along its tangent
  glm::dvec3 zero_{0.0};           ///< world: of a ring, where angles begin; of its rim, the tangent
  std::optional<double> last_;
  double amount_ = 0.0;
};

/// An axis of the frame and which way along it something is seen to go.
struct AxisSense {
  int axis = 0;
  double sign = 1.0;  ///< 1 or -1
  bool operator==(const AxisSense&) const = default;
};
/// What keys mean by right, up and away as the frame is seen: each of its axes once, so that their sum fits best.
struct ViewAxes {
  AxisSense right, up, away;
};
/// @param right, up, forward unit vectors of the camera, world
[[nodiscard]] ViewAxes axesAsSeen(const HandlesToWorld& toWorld, const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& forward);

}  // namespace ew::bridge
