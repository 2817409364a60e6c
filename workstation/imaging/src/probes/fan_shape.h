#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"

namespace ew::detail {

/// The area a probe looks at, as formulas: everything that asks where lines lie asks here. A place along the face is `across`, -1 at the
/// -x end to +1 at the +x end; lines are spaced evenly in it. Every formula is odd or even in x to the bit unless the lines are steered,
/// so a mirrored question gets the mirrored answer.
/// Steered lines of a sector leave its arc at that angle against their own radius, so they touch a circle of radius R sin steering.
struct FanShape {
  enum class Kind {
    parallel,   ///< from a straight face, all in the direction (sin steering, cos steering)
    trapezoid,  ///< evenly from a straight face, away from an apex behind it
    sector,     ///< evenly in angle from an arc about an apex; radius 0: from the apex itself
  };
  Kind kind = Kind::parallel;
  double halfWidth_mm = 0.0;   ///< parallel, trapezoid
  double steering_rad = 0.0;   ///< parallel, sector
  double apexToFace_mm = 0.0;  ///< trapezoid, sector
  double halfAngle_rad = 0.0;  ///< trapezoid, sector

  struct Line {
    glm::dvec2 origin_mm;
    glm::dvec2 direction;
  };
  [[nodiscard]] Line lineAt(double across) const;

  struct Place {
    double across;
    double depth_mm;
  };
  /// Of the line through a point, not behind the apex: lineAt(placeOf(p_mm).across).direction without an angle.
  [[nodiscard]] glm::dvec2 directionThrough(const glm::dvec2& p_mm) const;
  /// The inverse of lineAt(across).origin_mm + depth_mm * direction.
  [[nodiscard]] Place placeOf(const glm::dvec2& p_mm) const;
  /// How far the wavefront of a line lies ahead of its depth, at `across` of 1: lines that are steered leave the face one after another, so
  /// that points of one wavefront are not equally deep on their lines. In proportion to `across`.
  [[nodiscard]] double wavefrontLead_mm() const;

  /// Smallest box around the fan; x is symmetric about the middle of the face.
  struct Box {
    double halfWidth_mm = 0.0;
    double top_mm = 0.0;
    double bottom_mm = 0.0;
  };
  [[nodiscard]] Box box(double depth_mm) const;

  /// Points of the fan at one axial position: low <= x <= high and |x| >= gap; none when low > high.
  struct Row {
    double low_mm = std::numeric_limits<double>::infinity();
    double high_mm = -std::numeric_limits<double>::infinity();
    double gap_mm = 0.0;
  };
  [[nodiscard]] Row rowAt(double y_mm, double depth_mm) const;
};

/// Steering outside the probe's range is brought to the nearer end of it; steering that is no number is none.
/// @param look_rad how far the lines of one direction of a compound image are steered beyond it (compound.h)
[[nodiscard]] FanShape fanShapeOf(const Probe& probe, const Knobs& knobs, double look_rad = 0.0);

}  // namespace ew::detail
