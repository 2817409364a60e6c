#include "ew/assessment/judging.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/core/contract.h"
#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/measurement/ellipse.h"

namespace ew {
namespace {

std::string whole(double value) { return std::to_string(std::lround(value)); }
std::string tenths(double value) { return roundedText(value, 1); }

void missed(StepResult& judged, Message text) { judged.remarks.push_back({false, std::move(text)}); }
void wellDone(StepResult& judged, Message text) { judged.remarks.push_back({true, std::move(text)}); }

StepResult judgedBy(double share) {
  StepResult judged;
  judged.score = scoreAt(share);
  if (share <= 1.0) judged.verdict = StepVerdict::passed;
  return judged;
}

StepResult withoutPose() {
  StepResult judged;
  missed(judged, say<"The probe was not seen; hold it where the tracker sees it.">());
  return judged;
}

/// The farthest that a caliper stands from its place: of two points in the better order.
double placeError_mm(const std::vector<glm::dvec3>& expected, const std::vector<glm::dvec3>& set) {
  if (expected.size() == 2 && set.size() == 2) {
    const auto worst = [&](const glm::dvec3& a, const glm::dvec3& b) {
      return std::max(glm::distance(expected[0], a), glm::distance(expected[1], b));
    };
    return std::min(worst(set[0], set[1]), worst(set[1], set[0]));
  }
  const auto middle = [](const std::vector<glm::dvec3>& points) {
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& p : points) sum += p;
    return sum / static_cast<double>(points.size());
  };
  return glm::distance(middle(expected), middle(set));
}

}  // namespace

bool isWithinTolerance(double value, double expected, double tolerance) {
  // What is lost where two numbers of this size are subtracted; and of the tolerance itself, which lengths and angles go through roots for.
  if (!std::isfinite(value) || !std::isfinite(expected)) return false;
  constexpr double kOfSize = 4.0 * std::numeric_limits<double>::epsilon(), kOfTolerance = 1e-9;
  const double lost = kOfSize * std::max(std::abs(value), std::abs(expected)) + kOfTolerance * tolerance;
  return std::abs(value - expected) <= tolerance + lost;
}

bool isWithinRange(double value, double lowest, double highest) {
  return (value >= lowest || isWithinTolerance(value, lowest, 0.0)) && (value <= highest || isWithinTolerance(value, highest, 0.0));
}

double shareOfTolerance(double value, double expected, double tolerance) {
  EW_EXPECTS(tolerance > 0.0);
  const double share = std::abs(value - expected) / tolerance;
  return isWithinTolerance(value, expected, tolerance) ? std::min(share, 1.0) : std::max(share, std::nextafter(1.0, 2.0));
}

bool reachesLevel(double score, double level) {
  constexpr double kOfMean = 1e-12;  // three steps of 0.7 have a mean of 0.6999999999999998
  return score >= level - kOfMean;
}

double scoreAt(double shareOfTolerance) {
  EW_EXPECTS(shareOfTolerance >= 0.0);
  if (shareOfTolerance <= 1.0) return 1.0 - (1.0 - kPassScore) * shareOfTolerance;
  // Just beyond the rim is just below passing, also in the last digit.
  return std::min(std::nextafter(kPassScore, 0.0), std::max(0.0, kPassScore * 0.5 * (3.0 - shareOfTolerance)));
}

StepResult judgePlane(const PlaneTarget& target, const PlaneTolerance& tolerance, const Pose& pose) {
  if (pose.status != PoseStatus::ok) return withoutPose();
  const PlaneError error = planeError(target, pose.probeToWorld);
  StepResult judged = judgedBy(shareOfTolerance(error, tolerance));
  judged.figures = {{"angle", error.angle_deg, "deg"},
                    {"distance", error.distance_mm, "mm"},
                    {"roll", error.roll_deg, "deg"},
                    {"in_picture", error.inImage_mm, "mm"},
                    {"face", error.face_mm, "mm"}};
  if (judged.passed() && !error.isMirrored)
    wellDone(judged,
             say<"The plane is found: %1 degrees and %2 mm from the expert's.">(tenths(error.angle_deg), tenths(error.distance_mm)));
  if (!isWithinTolerance(error.angle_deg, 0.0, tolerance.angle_deg))
    missed(judged, std::abs(error.rotate_deg) > std::abs(error.tilt_deg)
                       ? say<"The plane is %1 degrees off, the probe above all rotated about its beam; %2 degrees are allowed.">(
                             tenths(error.angle_deg), tenths(tolerance.angle_deg))
                       : say<"The plane is %1 degrees off, the probe above all tilted; %2 degrees are allowed.">(
                             tenths(error.angle_deg), tenths(tolerance.angle_deg)));
  if (!isWithinTolerance(error.distance_mm, 0.0, tolerance.position_mm))
    missed(judged,
           say<"The plane passes %1 mm beside the target; %2 mm are allowed.">(tenths(error.distance_mm), tenths(tolerance.position_mm)));
  if (!isWithinTolerance(error.inImage_mm, 0.0, kInImageFactor * tolerance.position_mm))
    missed(judged, say<"The target lies %1 mm elsewhere in the image; bring it to where the expert has it.">(whole(error.inImage_mm)));
  if (error.isMirrored) {
    judged.verdict = StepVerdict::failed;
    judged.score = std::min(judged.score, 0.5);
    missed(judged, say<"The marker points the wrong way; left and right are exchanged.">());
  }
  return judged;
}

StepResult judgePointing(const OrganVoxels& organ, const glm::dvec3& clicked_world_mm, double margin_mm) {
  EW_EXPECTS(margin_mm >= 0.0);
  const double beside_mm = distanceTo_mm(organ, clicked_world_mm);
  // In tolerances of at least a millimetre, or one beside an organ without a margin would count as infinitely far.
  const double unit_mm = std::max(1.0, margin_mm);
  StepResult judged =
      judgedBy(isWithinTolerance(beside_mm, 0.0, margin_mm) ? std::min(1.0, beside_mm / unit_mm)
                                                            : std::max(1.0 + 1e-9, 1.0 + (beside_mm - margin_mm) / (5.0 * unit_mm)));
  judged.figures = {{"distance", std::isfinite(beside_mm) ? beside_mm : 1e6, "mm"}};
  if (judged.passed())
    wellDone(judged, say<"That is it.">());
  else if (std::isfinite(beside_mm))
    missed(judged, say<"The point lies %1 mm beside it.">(tenths(beside_mm)));
  else
    missed(judged, say<"Nothing of it is near the point.">());
  return judged;
}

StepResult judgePointing(const ReferencePoint& point, const glm::dvec3& clicked_world_mm) {
  EW_EXPECTS(point.tolerance_mm > 0.0);
  const double off_mm = glm::distance(point.at_mm, clicked_world_mm);
  StepResult judged = judgedBy(shareOfTolerance(off_mm, 0.0, point.tolerance_mm));
  judged.figures = {{"distance", off_mm, "mm"}};
  if (judged.passed())
    wellDone(judged, say<"That is it.">());
  else
    missed(judged, say<"The point lies %1 mm beside it.">(tenths(off_mm)));
  return judged;
}

StepResult judgeSweep(double share, double needed) {
  EW_EXPECTS(needed > 0.0 && needed <= 1.0 && share >= 0.0);
  StepResult judged;
  if (reachesLevel(share, needed)) judged.verdict = StepVerdict::passed;
  // Nothing passed through is nothing; all of what is needed is passing, and the rest of the organ the rest of the score.
  judged.score =
      judged.passed()
          ? (needed < 1.0 ? kPassScore + (1.0 - kPassScore) * std::max(0.0, std::min(share, 1.0) - needed) / (1.0 - needed) : 1.0)
          : std::min(std::nextafter(kPassScore, 0.0), kPassScore * share / needed);
  judged.figures = {{"coverage", 100.0 * share, "%"}};
  if (judged.passed())
    wellDone(judged, say<"The images passed through %1 % of it.">(whole(100.0 * share)));
  else
    missed(judged, say<"The images passed through %1 % of it; %2 % are needed.">(whole(100.0 * share), whole(100.0 * needed)));
  return judged;
}

std::optional<double> readingOf(const std::vector<glm::dvec3>& points_mm) {
  if (points_mm.size() == 2) return glm::distance(points_mm[0], points_mm[1]);
  if (points_mm.size() != 4) return std::nullopt;
  const double a_mm = 0.5 * glm::distance(points_mm[0], points_mm[1]);
  const double b_mm = 0.5 * glm::distance(points_mm[2], points_mm[3]);
  if (a_mm <= 0.0 || b_mm <= 0.0) return std::nullopt;
  return measurement::ellipseCircumference_mm(a_mm, b_mm);
}

double placeTolerance_mm(double tolerance) { return std::clamp(2.0 * tolerance, 5.0, 15.0); }

double toleranceOf(const ReferenceMeasurement& expected) {
  return expected.tolerance.value_or(std::max(2.0, 0.1 * std::abs(expected.value)));
}

StepResult judgeMeasurement(const ReferenceMeasurement& expected, double value, const std::vector<glm::dvec3>& points_mm,
                            double tolerance) {
  EW_EXPECTS(tolerance > 0.0);
  const double off = value - expected.value;
  double share = shareOfTolerance(value, expected.value, tolerance);
  double place_mm = 0.0;
  const bool knowsPlace = !expected.points_mm.empty() && !points_mm.empty();
  if (knowsPlace) place_mm = placeError_mm(expected.points_mm, points_mm);
  const double placeAllowed_mm = placeTolerance_mm(tolerance);
  const bool isElsewhere = knowsPlace && !isWithinTolerance(place_mm, 0.0, placeAllowed_mm);
  if (isElsewhere) share = std::max(share, place_mm / placeAllowed_mm);
  StepResult judged = judgedBy(share);
  judged.figures = {{"value", value, expected.unit}, {"off", off, expected.unit}};
  if (knowsPlace) judged.figures.push_back({"place", place_mm, "mm"});
  if (judged.passed())
    wellDone(judged, say<"Measured: %1 %2; the expert has %3 %2.">(tenths(value), expected.unit, tenths(expected.value)));
  if (!isWithinTolerance(value, expected.value, tolerance))
    missed(judged, say<"%1 %2 were measured; it is %3 %2, and %4 %2 more or less are allowed.">(tenths(value), expected.unit,
                                                                                                tenths(expected.value), tenths(tolerance)));
  if (isElsewhere) missed(judged, say<"The calipers stand %1 mm from where they belong.">(whole(place_mm)));
  return judged;
}

}  // namespace ew
