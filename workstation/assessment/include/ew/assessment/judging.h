#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/organ_voxels.h"
#include "ew/assessment/plane_error.h"
#include "ew/library/attempt.h"

namespace ew {

// A bound belongs to what it bounds, though binary fractions may put a value a few digits beyond it: 12.3 - 12.1 is
// 0.2000000000000011, and 12.1 lies within 12.3 +- 0.2. Whatever is judged asks these.

/// @param tolerance >= 0
[[nodiscard]] bool isWithinTolerance(double value, double expected, double tolerance);
[[nodiscard]] bool isWithinRange(double value, double lowest, double highest);
/// How far a value is off, in tolerances: at most 1 where, and only where, it is within. @param tolerance > 0
[[nodiscard]] double shareOfTolerance(double value, double expected, double tolerance);
/// Whether a score passes. @param score, level 0 to 1
[[nodiscard]] bool reachesLevel(double score, double level);

/// The score at the tolerance's rim. 1 at no error, falling evenly to it; beyond, falling evenly to 0 at three tolerances.
inline constexpr double kPassScore = 0.7;
/// @param shareOfTolerance the worst error in tolerances, >= 0
[[nodiscard]] double scoreAt(double shareOfTolerance);

// A score is kPassScore and more where, and only where, everything is within tolerance.

/// A probe held at a plane. A marker on the wrong side is remarked and never passes.
[[nodiscard]] StepResult judgePlane(const PlaneTarget& target, const PlaneTolerance& tolerance, const Pose& pose);

/// A click on an organ. @param margin_mm beside it that still counts, >= 0
[[nodiscard]] StepResult judgePointing(const OrganVoxels& organ, const glm::dvec3& clicked_world_mm, double margin_mm);

/// A click on a point.
[[nodiscard]] StepResult judgePointing(const ReferencePoint& point, const glm::dvec3& clicked_world_mm);

/// A sweep through an organ. @param share of its voxels (OrganCoverage); @param needed of them, above 0 to 1
[[nodiscard]] StepResult judgeSweep(double share, double needed);

/// What calipers read where they stand: the distance of two points, or the circumference of the ellipse whose long axis has the first two
/// as ends and whose short axis the last two.
/// @return nothing for other counts of points
[[nodiscard]] std::optional<double> readingOf(const std::vector<glm::dvec3>& points_mm);

/// Where calipers may stand beside the expected points, mm: twice the tolerance, at least 5 and at most 15.
[[nodiscard]] double placeTolerance_mm(double tolerance);

/// A measurement: its value, and that it was taken in the right place, for the right number in the wrong place is chance. The two points of
/// a distance may be set in either order; of other measurements the middle of the points is compared. Places are not looked at where the
/// measurement expects no points or `points_mm` is empty.
/// @param value in the measurement's unit; @param points_mm in the world; @param tolerance in the unit, > 0
[[nodiscard]] StepResult judgeMeasurement(const ReferenceMeasurement& expected, double value, const std::vector<glm::dvec3>& points_mm,
                                          double tolerance);

/// The tolerance of a measurement: the case's, or a tenth of its value and no less than 2 of its unit.
[[nodiscard]] double toleranceOf(const ReferenceMeasurement& expected);

}  // namespace ew
