#include <algorithm>
#include <cmath>

#include "alignment_words.h"
#include "ew/core/order_statistics.h"
#include "ew/tracking/face_calibration.h"
#include "face_readings.h"

namespace ew {
namespace {

using Eigen::Vector3d;

constexpr double kTukeyWide = 4.685;  // 95 % efficient at normal noise
constexpr double kWorstSpread_mm = 2.0;
constexpr double kWorstPivot_mm = 5.0;

/// R_i tip - point = -t_i, stacked, each with its weight.
struct PivotSolution {
  Vector3d tip, point;
  Eigen::Matrix3d tipVariance;  ///< at unit noise
};

PivotSolution solvePivot(const std::vector<TurnAndPlace>& readings, const std::vector<double>& weight) {
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  for (std::size_t n = 0; n < readings.size(); ++n) {
    Eigen::Matrix<double, 3, 6> row;
    row << readings[n].turn, -Eigen::Matrix3d::Identity();
    normal += weight[n] * row.transpose() * row;
    right -= weight[n] * row.transpose() * readings[n].place;
  }
  const Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 6, 6>> solver(normal);
  const Eigen::Matrix<double, 6, 1> x = solver.solve(right);
  return {x.head<3>(), x.tail<3>(), solver.pseudoInverse().topLeftCorner<3, 3>()};
}

std::vector<double> distancesAt(const std::vector<TurnAndPlace>& readings, const PivotSolution& at) {
  std::vector<double> distance;
  for (const TurnAndPlace& reading : readings) distance.push_back((reading.turn * at.tip + reading.place - at.point).norm());
  return distance;
}

/// How far the direction to the tip swings, in the narrower of the two directions square to its mean: twice its standard deviation.
double tippedBy(const std::vector<TurnAndPlace>& readings, const Vector3d& tip) {
  if (tip.norm() < 1.0) return 0.0;
  Vector3d mean = Vector3d::Zero();
  for (const TurnAndPlace& reading : readings) mean += reading.turn * tip.normalized();
  mean.normalize();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const TurnAndPlace& reading : readings) {
    const Vector3d d = reading.turn * tip.normalized(), beside = d - d.dot(mean) * mean;
    second += beside * beside.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second / static_cast<double>(readings.size()));
  return 2.0 * std::sqrt(std::max(0.0, solver.eigenvalues()[1]));  // the smallest is that along the mean
}

}  // namespace

Result<Pivot> pivotOf(std::span<const ToolReading> readings, const PivotOptions& options) {
  const auto live = liveReadings(readings);
  if (!live) return passOn(live.error());
  std::vector<double> weight(live->size(), 1.0);
  PivotSolution at = solvePivot(*live, weight);
  double scale = options.noise_mm;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const auto distance = distancesAt(*live, at);
    scale = std::max(options.noise_mm, upperMedianOf(distance) / 1.5382);  // of three independent normal numbers
    for (std::size_t n = 0; n < weight.size(); ++n) {
      const double u = distance[n] / (kTukeyWide * 1.5 * scale);
      weight[n] = u < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
    }
    const Vector3d before = at.tip;
    at = solvePivot(*live, weight);
    if ((at.tip - before).norm() < 1e-9) break;
  }
  Pivot pivot;
  double squares = 0.0;
  std::vector<TurnAndPlace> used;
  const auto distance = distancesAt(*live, at);
  for (std::size_t n = 0; n < live->size(); ++n) {
    if (weight[n] < 0.1) {
      ++pivot.slipped;
      continue;
    }
    used.push_back((*live)[n]);
    squares += distance[n] * distance[n];
  }
  pivot.readings = static_cast<int>(used.size());
  pivot.tip_tool_mm = glmOf(at.tip);
  pivot.point_tracker_mm = glmOf(at.point);
  pivot.rms_mm = used.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(used.size()));
  const double noise = std::max(0.1 * options.noise_mm, pivot.rms_mm / std::sqrt(3.0));
  pivot.spread_mm = noise * std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(at.tipVariance).eigenvalues()[2]);
  pivot.tipped_rad = tippedBy(used, at.tip);
  if (2 * pivot.slipped > static_cast<int>(live->size())) {
    pivot.sentence = say<"The tip did not stay in its place. Set it into a small hollow and turn the probe about it again.">();
  } else if (pivot.tipped_rad < options.widest_rad) {
    pivot.sentence =
        say<"The probe was not tipped far enough both ways: tip it to the left and right and to the front and back, by about 30 degrees "
            "each, while "
            "its tip stays in its place.">();
  } else if (pivot.rms_mm > kWorstPivot_mm || pivot.spread_mm > kWorstSpread_mm) {
    pivot.sentence = say<"The tip is known within %1 mm only. Turn the probe more slowly and let its tip not slide.">(
        tenths(std::max(pivot.spread_mm, pivot.rms_mm)));
  } else {
    pivot.isKnown = true;
    pivot.sentence = say<"The tip was found; it stayed in its place within %1 mm.">(tenths(pivot.rms_mm));
  }
  return pivot;
}

}  // namespace ew
