#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "../comparable.h"
#include "ew/registration/rigid.h"
#include "normal_equations.h"

namespace ew::registration {

/// A small rigid motion about `centre`: t and w (rad) of exp.
[[nodiscard]] Transform<frame::Fixed, frame::Fixed> motionAbout(const glm::dvec3& centre_mm, const glm::dvec3& shift_mm,
                                                                const glm::dvec3& rotation_rad);
/// The rotation by |turn| about turn.
[[nodiscard]] glm::dmat3 rotationBy(const glm::dvec3& rotation_rad);
[[nodiscard]] double rotationBetween_rad(const Transform<frame::Moving, frame::Fixed>& a, const Transform<frame::Moving, frame::Fixed>& b);

/// How far two poses differ: the turn between them, and how far apart they take `at`.
struct PoseDifference {
  double rotation_deg = 0.0;
  double shift_mm = 0.0;
};
[[nodiscard]] PoseDifference differenceOf(const Transform<frame::Moving, frame::Fixed>& a, const Transform<frame::Moving, frame::Fixed>& b,
                                          const glm::dvec3& at_mm);

struct DescentOptions {
  int iterations = 20;
  double stop_mm = 0.01;  ///< a step that moves the overlap's rim by less ends the descent
  double limit_mm = 4.0;  ///< largest step of the rim
  int blockVoxels = 0;
  int half = -1;
};

/// Gauss-Newton on six parameters at one level.
struct Descent {
  Transform<frame::Moving, frame::Fixed> fixedToMoving;
  PoseSums sums;              ///< of the last pass, at the pose before the last step
  glm::dvec3 centre_mm{0.0};  ///< about which the normal equations are
  double lever_mm = 50.0;     ///< half the overlap's diagonal: turns are compared with shifts by it
  int iterations = 0;
  double correlationBefore = 0.0;
  StopReason stop = StopReason::notRun;  ///< converged, iterationLimit, singular, noOverlap, cancelled
};
[[nodiscard]] Descent descend(const ComparableImage& fixed, const KernelImage& moving, const Transform<frame::Moving, frame::Fixed>& start,
                              const DescentOptions& options, int threads, Progress& progress);

/// Voxels of `image` that count as one independent sample, from the correlations between neighbours of both sides along each axis.
[[nodiscard]] double voxelsPerSample(const ComparableImage& fixed, const ComparableImage& moving);

}  // namespace ew::registration
