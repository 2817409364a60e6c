#include "ew/tracking/face_calibration.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "alignment_words.h"
#include "ew/core/order_statistics.h"
#include "face_readings.h"

namespace ew {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::size_t kFewestReadings = 20;
constexpr double kLeastTurn_rad = 80.0 * kDegree;
constexpr double kWorstLean_rad = 6.0 * kDegree;
constexpr double kShortestSlide_mm = 40.0;
constexpr double kLeastBetween_rad = 60.0 * kDegree;

Message degrees(double angle_rad) { return tenths(angle_rad / kDegree); }

/// The directions a of the tool and b of the tracker with R_i a = b as nearly as can be: the largest singular pair of the mean rotation,
/// since sum |R_i a - b|^2 = 2 N (1 - b . mean(R) a).
struct AxisPair {
  Vector3d tool, tracker;
};

AxisPair keptDirection(const std::vector<TurnAndPlace>& readings) {
  Matrix3d mean = Matrix3d::Zero();
  for (const TurnAndPlace& reading : readings) mean += reading.turn;
  const Eigen::JacobiSVD<Matrix3d> svd(mean, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixV().col(0), svd.matrixU().col(0)};
}

/// How far the tool was turned about the kept direction: the widest gap-free range that its readings cover.
double turnedAbout(const std::vector<TurnAndPlace>& readings, const AxisPair& kept) {
  const Vector3d across = kept.tool.unitOrthogonal();
  const Vector3d first = (readings.front().turn * across - kept.tracker * kept.tracker.dot(readings.front().turn * across)).normalized();
  std::vector<double> angles;
  for (const TurnAndPlace& reading : readings) {
    const Vector3d d = reading.turn * across;
    angles.push_back(std::atan2(kept.tracker.dot(first.cross(d)), first.dot(d)));
  }
  std::sort(angles.begin(), angles.end());
  double widest = 2.0 * std::numbers::pi - (angles.back() - angles.front());
  for (std::size_t n = 1; n < angles.size(); ++n) widest = std::max(widest, angles[n] - angles[n - 1]);
  return 2.0 * std::numbers::pi - widest;
}

}  // namespace

Result<std::vector<TurnAndPlace>> liveReadings(std::span<const ToolReading> readings) {
  std::vector<TurnAndPlace> live;
  for (const ToolReading& reading : readings)
    if (reading.state == TrackingState::live && checkRigid(reading.toolToTracker))
      live.push_back({turnOf(reading.toolToTracker.matrix), eigenOf(glm::dvec3(reading.toolToTracker.matrix[3]))});
  if (live.size() < kFewestReadings)
    return failure(ErrorCode::noValidPose, say<"The tool was seen %1 times only; repeat this where the tracker sees it.">(live.size()),
                   {{"readings", std::to_string(live.size())}});
  return live;
}

Result<FlatFace> flatFaceOf(std::span<const ToolReading> readings, const glm::dvec3& towardsTip_tool) {
  const auto live = liveReadings(readings);
  if (!live) return passOn(live.error());
  // Moments when the face was not flat yet lean far; the direction is found again without them.
  std::vector<TurnAndPlace> used = *live;
  AxisPair kept = keptDirection(used);
  for (int pass = 0; pass < 3; ++pass) {
    std::vector<double> leans;
    for (const TurnAndPlace& reading : *live) leans.push_back(std::acos(std::clamp(kept.tracker.dot(reading.turn * kept.tool), -1.0, 1.0)));
    const double most = 3.0 * std::max(upperMedianOf(leans), 0.1 * kDegree);
    used.clear();
    for (std::size_t n = 0; n < leans.size(); ++n)
      if (leans[n] <= most) used.push_back((*live)[n]);
    kept = keptDirection(used);
  }
  FlatFace face;
  face.readings = static_cast<int>(used.size());
  double squares = 0.0;
  for (const TurnAndPlace& reading : used) squares += (reading.turn * kept.tool - kept.tracker).squaredNorm();
  face.rms_rad = std::sqrt(squares / static_cast<double>(used.size()));
  face.turned_rad = turnedAbout(used, kept);
  // The turn tells how well a lean of the tool is told from one of the table: one side of it alone cannot be.
  face.spread_rad = face.rms_rad / std::sqrt(static_cast<double>(used.size())) /
                    std::max(1e-3, std::sin(0.5 * std::min(face.turned_rad, std::numbers::pi)));
  const double side = kept.tool.dot(eigenOf(towardsTip_tool)) < 0.0 ? -1.0 : 1.0;
  face.axial_tool = glmOf(side * kept.tool);
  if (face.turned_rad < kLeastTurn_rad) {
    face.sentence = say<"Keep the face flat on the table and turn the probe on it by at least a quarter.">();
  } else if (face.rms_rad > kWorstLean_rad) {
    face.sentence = say<"The face did not stay flat on the table: it leaned by %1 degrees. Press it down lightly and turn it again.">(
        degrees(face.rms_rad));
  } else {
    face.isKnown = true;
    face.sentence = say<"The face stayed flat within %1 degrees.">(degrees(face.rms_rad));
  }
  return face;
}

Result<glm::dvec3> lateralOf(std::span<const ToolReading> readings) {
  const auto live = liveReadings(readings);
  if (!live) return passOn(live.error());
  std::vector<Vector3d> places;
  Matrix3d sum = Matrix3d::Zero();
  for (const TurnAndPlace& reading : *live) {
    places.push_back(reading.place);
    sum += reading.turn;
  }
  const Spread spread = spreadOf(places);
  Vector3d along = spread.axes.col(0);
  if (along.dot(places.back() - places.front()) < 0.0) along = -along;
  const double length_mm = (places.back() - places.front()).dot(along);
  const auto refuse = [](Message why) { return failure(ErrorCode::badField, std::move(why), {{"field", "slide"}}); };
  if (length_mm < kShortestSlide_mm)
    return refuse(
        say<"The probe was slid by %1 mm only; slide it straight along a ruler, by at least a hand's breadth, towards its marker side.">(
            tenths(length_mm)));
  if (spread.deviation[1] > 0.08 * spread.deviation[0] + 1.0)
    return refuse(say<"The probe was not slid straight; slide it along a ruler towards its marker side.">());
  const Eigen::JacobiSVD<Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Matrix3d turn = svd.matrixU() * Vector3d(1.0, 1.0, (svd.matrixU() * svd.matrixV().transpose()).determinant()).asDiagonal() *
                        svd.matrixV().transpose();
  std::vector<double> angles;
  for (const TurnAndPlace& reading : *live) angles.push_back(Eigen::AngleAxisd(turn.transpose() * reading.turn).angle());
  if (upperMedianOf(angles) > kWorstLean_rad) return refuse(say<"The probe turned while it was slid; keep it upright against a ruler.">());
  return glmOf(turn.transpose() * along);
}

Result<Face> faceFrom(const glm::dvec3& tip_tool_mm, const glm::dvec3& axial_tool, const glm::dvec3& lateral_tool) {
  const Vector3d axial = eigenOf(axial_tool).normalized(), given = eigenOf(lateral_tool).normalized();
  const double between = std::acos(std::clamp(std::abs(axial.dot(given)), 0.0, 1.0));
  if (!axial.allFinite() || !given.allFinite() || between < kLeastBetween_rad)
    return failure(ErrorCode::badField,
                   say<"The slide and the flat face do not fit together: they are only %1 degrees apart instead of 90. Repeat both steps "
                       "on the same table.">(degrees(between)),
                   {{"field", "lateral"}});
  Matrix3d axes;
  axes.col(0) = (given - given.dot(axial) * axial).normalized();
  axes.col(1) = axial;
  axes.col(2) = axes.col(0).cross(axial);
  return Face{{matrixOf(axes, eigenOf(tip_tool_mm))}};
}

}  // namespace ew
