#include "camera_pose.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

namespace ew {
namespace {

constexpr double kCornerFloor_px = 0.08;  // what print, paper and lens model leave, however sharp the edges are
constexpr double kMostMisfit = 400.0;     // of one corner: from 20 standard deviations on, further away is not worse
constexpr double kHuber = 3.0;            // standard deviations
constexpr int kMostFaces = 3;             // of a cuboid are in sight

using Pose6 = std::array<double, 6>;  // angle axis, translation in mm

Pose6 sixOf(const glm::dmat4& matrix) {
  Pose6 six{};
  const glm::dmat3 turn(matrix);
  ceres::RotationMatrixToAngleAxis(&turn[0][0], six.data());  // column by column
  for (int n = 0; n < 3; ++n) six[static_cast<std::size_t>(3 + n)] = matrix[3][n];
  return six;
}
glm::dmat4 matrixOf(const Pose6& six) {
  double turn[9];
  ceres::AngleAxisToRotationMatrix(six.data(), turn);  // column by column
  glm::dmat4 matrix(1.0);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) matrix[c][r] = turn[3 * c + r];
  matrix[3] = glm::dvec4(six[3], six[4], six[5], 1.0);
  return matrix;
}

/// A corner's distance from where a pose puts it, in its standard deviations.
struct CornerResidual {
  glm::dvec3 corner_mm;
  glm::dvec2 ray, perBleed;
  double weight;
  template <class T>
  bool operator()(const T* pose, const T* bleed, T* residual) const {
    const T corner[3] = {T(corner_mm.x), T(corner_mm.y), T(corner_mm.z)};
    T at[3];
    ceres::AngleAxisRotatePoint(pose, corner, at);
    const T depth = at[2] + pose[5];
    if (depth < T(1.0)) return false;
    residual[0] = weight * ((at[0] + pose[3]) / depth - ray.x - bleed[0] * perBleed.x);
    residual[1] = weight * ((at[1] + pose[4]) / depth - ray.y - bleed[0] * perBleed.y);
    return true;
  }
};

struct BleedResidual {
  MarkerBleed known;
  template <class T>
  bool operator()(const T* bleed, T* residual) const {
    residual[0] = (bleed[0] - known.value) / known.deviation;
    return true;
  }
};

double spreadOf(const MarkerObservation& seen) { return std::hypot(kCornerFloor_px, seen.spread_px); }

bool faces(const MarkerObservation& seen, const glm::dmat4& bodyToCamera) {
  const glm::dvec3 outward = glm::dmat3(bodyToCamera) * outwardOf(*seen.marker);
  const glm::dvec3 middle = glm::dvec3(bodyToCamera * glm::dvec4(middleOf(*seen.marker), 1.0));
  return middle.z > 0.0 && glm::dot(outward, middle) < 0.0;
}

class BodySolver {
 public:
  BodySolver(const std::vector<MarkerObservation>& seen, double focal_px, const MarkerBleed& bleed)
      : seen_(seen), focal_px_(focal_px), bleed_(bleed) {}

  [[nodiscard]] std::vector<glm::dmat4> starts() const;
  /// With its misfit.
  [[nodiscard]] std::optional<BodyHypothesis> refined(const glm::dmat4& start, const std::vector<bool>& used) const;
  /// Over all observations: also those that the best leaves out speak for or against the others.
  [[nodiscard]] double misfit(const glm::dmat4& bodyToCamera, double bleed) const {
    double sum = std::pow((bleed - bleed_.value) / bleed_.deviation, 2);
    for (const MarkerObservation& each : seen_) {
      if (!faces(each, bodyToCamera)) {
        sum += 4.0 * kMostMisfit;
        continue;
      }
      for (std::size_t n = 0; n < 4; ++n)
        sum += std::min(kMostMisfit, std::pow(offBy_px(each, n, bodyToCamera, bleed) / spreadOf(each), 2));
    }
    return sum;
  }
  [[nodiscard]] double residual_px(const MarkerObservation& each, const BodyHypothesis& pose) const {
    double sum = 0.0;
    for (std::size_t n = 0; n < 4; ++n) sum += std::pow(offBy_px(each, n, pose.bodyToCamera, pose.bleed), 2);
    return std::sqrt(sum / 4.0);
  }
  void judgeSpread(BodyEstimate& estimate, const glm::dvec3& at_body) const;

 private:
  [[nodiscard]] double offBy_px(const MarkerObservation& each, std::size_t corner, const glm::dmat4& bodyToCamera, double bleed) const {
    const glm::dvec3 at = glm::dvec3(bodyToCamera * glm::dvec4(each.marker->corners_mm[corner], 1.0));
    if (at.z < 1.0) return 1e3;
    return focal_px_ * glm::distance(glm::dvec2(at) / at.z, each.rays[corner] + bleed * each.perBleed[corner]);
  }
  void addPlaneStarts(const std::vector<const MarkerObservation*>& plane, std::vector<glm::dmat4>& starts) const;
  const std::vector<MarkerObservation>& seen_;
  double focal_px_;
  MarkerBleed bleed_;
};

double areaOf(const MarkerObservation& seen) {
  const auto& r = seen.rays;
  const glm::dvec2 a = r[2] - r[0], b = r[3] - r[1];
  return 0.5 * std::abs(a.x * b.y - a.y * b.x);
}

/// A frame in the plane of a marker: z away from whoever sees it, as a camera's.
glm::dmat4 planeToBody(const Marker& marker) {
  const glm::dvec3 x = glm::normalize(marker.corners_mm[1] - marker.corners_mm[0]);
  const glm::dvec3 z = -outwardOf(marker);
  glm::dmat4 frame(1.0);
  frame[0] = glm::dvec4(x, 0.0);
  frame[1] = glm::dvec4(glm::cross(z, x), 0.0);
  frame[2] = glm::dvec4(z, 0.0);
  frame[3] = glm::dvec4(middleOf(marker), 1.0);
  return frame;
}

/// Observations on one flat face together, the largest face first.
std::vector<std::vector<const MarkerObservation*>> facesSeen(const std::vector<MarkerObservation>& seen) {
  std::vector<std::vector<const MarkerObservation*>> planes;
  for (const MarkerObservation& each : seen) {
    const auto same = std::find_if(planes.begin(), planes.end(), [&](const auto& plane) {
      const glm::dvec3 normal = outwardOf(*plane.front()->marker);
      return glm::dot(normal, outwardOf(*each.marker)) > 0.9999 &&
             std::abs(glm::dot(normal, middleOf(*each.marker) - middleOf(*plane.front()->marker))) < 0.2;
    });
    if (same == planes.end())
      planes.push_back({&each});
    else
      same->push_back(&each);
  }
  const auto area = [](const auto& plane) {
    double sum = 0.0;
    for (const auto* each : plane) sum += areaOf(*each);
    return sum;
  };
  std::stable_sort(planes.begin(), planes.end(), [&](const auto& a, const auto& b) { return area(a) > area(b); });
  if (planes.size() > kMostFaces) planes.resize(kMostFaces);
  return planes;
}

void BodySolver::addPlaneStarts(const std::vector<const MarkerObservation*>& plane, std::vector<glm::dmat4>& starts) const {
  const glm::dmat4 toBody = planeToBody(*plane.front()->marker), fromBody = glm::inverse(toBody);
  std::vector<cv::Point3d> corners;
  std::vector<cv::Point2d> rays;
  for (const auto* each : plane)
    for (std::size_t n = 0; n < 4; ++n) {
      const glm::dvec4 at = fromBody * glm::dvec4(each->marker->corners_mm[n], 1.0);
      corners.emplace_back(at.x, at.y, 0.0);
      const glm::dvec2 ray = each->rays[n] + bleed_.value * each->perBleed[n];
      rays.emplace_back(ray.x, ray.y);
    }
  std::vector<cv::Vec3d> turns, places;
  try {
    cv::solvePnPGeneric(corners, rays, cv::Matx33d::eye(), cv::noArray(), turns, places, false, cv::SOLVEPNP_IPPE);
  } catch (const cv::Exception&) {
    return;  // corners on a line
  }
  for (std::size_t n = 0; n < turns.size(); ++n) {
    const Pose6 six{turns[n][0], turns[n][1], turns[n][2], places[n][0], places[n][1], places[n][2]};
    if (std::all_of(six.begin(), six.end(), [](double each) { return std::isfinite(each); }) && six[5] > 1.0)
      starts.push_back(matrixOf(six) * fromBody);
  }
}

std::vector<glm::dmat4> BodySolver::starts() const {
  std::vector<glm::dmat4> found;
  for (const auto& plane : facesSeen(seen_)) {
    addPlaneStarts(plane, found);
    if (plane.size() > 1) addPlaneStarts({plane.front()}, found);  // should another of the face be measured wrongly
  }
  return found;
}

std::optional<BodyHypothesis> BodySolver::refined(const glm::dmat4& start, const std::vector<bool>& used) const {
  Pose6 six = sixOf(start);
  double bleed = bleed_.value;
  ceres::HuberLoss loss(kHuber);
  ceres::Problem::Options ownership;
  ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  for (std::size_t m = 0; m < seen_.size(); ++m) {
    if (!used[m]) continue;
    for (std::size_t n = 0; n < 4; ++n)
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<CornerResidual, 2, 6, 1>(new CornerResidual{
                                   seen_[m].marker->corners_mm[n], seen_[m].rays[n], seen_[m].perBleed[n], focal_px_ / spreadOf(seen_[m])}),
                               &loss, six.data(), &bleed);
  }
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<BleedResidual, 1, 1>(new BleedResidual{bleed_}), nullptr, &bleed);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 20;
  options.function_tolerance = 1e-7;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable() || !std::isfinite(bleed)) return {};
  for (double each : six)
    if (!std::isfinite(each)) return {};
  const glm::dmat4 pose = matrixOf(six);
  return BodyHypothesis{pose, bleed, misfit(pose, bleed), 0.0};
}

/// Covariance of a small turn about the point, of a move of it and of the bleed, from the corners' variances as the residuals show them.
void BodySolver::judgeSpread(BodyEstimate& estimate, const glm::dvec3& at_body) const {
  const glm::dmat4& pose = estimate.best.bodyToCamera;
  const glm::dvec3 about = glm::dvec3(pose * glm::dvec4(at_body, 1.0));
  Eigen::Matrix<double, 7, 7> information = Eigen::Matrix<double, 7, 7>::Zero();
  double squares = 0.0;
  int corners = 0;
  for (std::size_t m = 0; m < seen_.size(); ++m) {
    if (!estimate.used[m]) continue;
    const double weight = focal_px_ / spreadOf(seen_[m]);
    for (std::size_t n = 0; n < 4; ++n) {
      const glm::dvec3 q = glm::dvec3(pose * glm::dvec4(seen_[m].marker->corners_mm[n], 1.0)), arm = q - about;
      Eigen::Matrix<double, 2, 3> byPlace;
      byPlace << 1.0 / q.z, 0.0, -q.x / (q.z * q.z), 0.0, 1.0 / q.z, -q.y / (q.z * q.z);
      Eigen::Matrix3d byTurn;  // of w x arm
      byTurn << 0.0, arm.z, -arm.y, -arm.z, 0.0, arm.x, arm.y, -arm.x, 0.0;
      const glm::dvec2& byBleed = seen_[m].perBleed[n];
      Eigen::Matrix<double, 2, 7> slope;
      slope << byPlace * byTurn, byPlace, Eigen::Vector2d(-byBleed.x, -byBleed.y);
      slope *= weight;
      information += slope.transpose() * slope;
      squares += std::pow(offBy_px(seen_[m], n, pose, estimate.best.bleed) / spreadOf(seen_[m]), 2);
      ++corners;
    }
  }
  const double variance = std::max(1.0, squares / std::max(1, 2 * corners - 6));
  information /= variance;
  information(6, 6) += 1.0 / (bleed_.deviation * bleed_.deviation);
  const Eigen::Matrix<double, 7, 7> covariance = information.inverse();
  const double turn = covariance.topLeftCorner<3, 3>().trace(), place = covariance.block<3, 3>(3, 3).trace();
  estimate.bleed = {estimate.best.bleed, covariance(6, 6) > 0.0 ? std::sqrt(covariance(6, 6)) : bleed_.deviation};
  estimate.spread_rad = turn >= 0.0 ? std::sqrt(turn) : 1e9;  // also where it is not a number
  estimate.spread_mm = place >= 0.0 ? std::sqrt(place) : 1e9;
}

/// Markers that agree with a pose as the better half of them does.
std::vector<bool> agreeing(const std::vector<double>& residuals_px) {
  std::vector<double> sorted = residuals_px;
  std::sort(sorted.begin(), sorted.end());
  const double limit_px = std::max(0.6, 4.0 * sorted[(sorted.size() - 1) / 2]);
  std::vector<bool> used(residuals_px.size());
  for (std::size_t n = 0; n < used.size(); ++n) used[n] = residuals_px[n] <= limit_px;
  return used;
}

}  // namespace

double angleBetween(const glm::dmat4& a, const glm::dmat4& b) {
  const glm::dmat3 turn = glm::transpose(glm::dmat3(a)) * glm::dmat3(b);
  const glm::dvec3 axis{turn[1][2] - turn[2][1], turn[2][0] - turn[0][2], turn[0][1] - turn[1][0]};
  return std::atan2(glm::length(axis), turn[0][0] + turn[1][1] + turn[2][2] - 1.0);
}

glm::dvec3 outwardOf(const Marker& marker) {
  // As seen from outside x goes right and y down, so x cross y goes away from the viewer.
  return glm::normalize(glm::cross(marker.corners_mm[3] - marker.corners_mm[0], marker.corners_mm[1] - marker.corners_mm[0]));
}
glm::dvec3 middleOf(const Marker& marker) {
  return 0.25 * (marker.corners_mm[0] + marker.corners_mm[1] + marker.corners_mm[2] + marker.corners_mm[3]);
}

std::optional<BodyEstimate> estimateBody(const std::vector<MarkerObservation>& seen, double focal_px, const glm::dvec3& at_body,
                                         const std::optional<glm::dmat4>& before, const MarkerBleed& bleed) {
  if (seen.empty()) return {};
  const BodySolver solver(seen, focal_px, bleed);
  std::vector<glm::dmat4> starts = solver.starts();
  if (before) starts.push_back(*before);
  std::vector<std::pair<double, glm::dmat4>> ranked;
  for (const glm::dmat4& start : starts) ranked.emplace_back(solver.misfit(start, bleed.value), start);
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  // Everything at its limit: this start explains nothing.
  const double hopeless = 4.0 * kMostMisfit * static_cast<double>(seen.size());

  // The nearest starts to different poses are carried to their minima.
  constexpr double kSamePose_rad = 0.0175;
  const std::vector<bool> all(seen.size(), true);
  std::vector<BodyHypothesis> minima;
  std::vector<glm::dmat4> begun;
  for (const auto& [misfit, start] : ranked) {
    if (misfit >= hopeless && !minima.empty()) break;
    const auto near = [&start = start](const glm::dmat4& other) { return angleBetween(start, other) < 2.0 * kSamePose_rad; };
    if (std::any_of(begun.begin(), begun.end(), near)) continue;
    if (std::any_of(minima.begin(), minima.end(), [&](const auto& each) { return near(each.bodyToCamera); })) continue;
    begun.push_back(start);
    const auto pose = solver.refined(start, all);
    if (!pose) continue;
    const auto same = [&](const BodyHypothesis& each) { return angleBetween(each.bodyToCamera, pose->bodyToCamera) < kSamePose_rad; };
    if (std::none_of(minima.begin(), minima.end(), same)) minima.push_back(*pose);
    if (begun.size() == 4) break;
  }
  if (minima.empty()) return {};
  std::stable_sort(minima.begin(), minima.end(), [](const auto& a, const auto& b) { return a.misfit < b.misfit; });

  BodyEstimate estimate;
  estimate.best = minima.front();
  const auto judge = [&] {
    estimate.residuals_px.clear();
    for (const auto& each : seen)
      estimate.residuals_px.push_back(faces(each, estimate.best.bodyToCamera) ? solver.residual_px(each, estimate.best) : 1e3);
    estimate.used = agreeing(estimate.residuals_px);
  };
  judge();
  if (!std::all_of(estimate.used.begin(), estimate.used.end(), [](bool each) { return each; })) {
    if (const auto again = solver.refined(estimate.best.bodyToCamera, estimate.used)) {
      estimate.best = *again;
      judge();
    }
  }
  double squares = 0.0;
  for (std::size_t n = 0; n < seen.size(); ++n) {
    if (!estimate.used[n]) continue;
    if (!faces(seen[n], estimate.best.bodyToCamera)) return {};
    squares += estimate.residuals_px[n] * estimate.residuals_px[n];
    ++estimate.markers;
  }
  if (estimate.markers == 0) return {};
  estimate.best.rms_px = std::sqrt(squares / estimate.markers);
  solver.judgeSpread(estimate, at_body);

  if (minima.size() > 1) {
    estimate.other = minima[1];
    estimate.otherAngle_rad = angleBetween(minima[1].bodyToCamera, estimate.best.bodyToCamera);
    double otherSquares = 0.0;
    for (std::size_t n = 0; n < seen.size(); ++n)
      if (estimate.used[n]) otherSquares += std::pow(solver.residual_px(seen[n], minima[1]), 2);
    estimate.other->rms_px = std::sqrt(otherSquares / estimate.markers);
    const double freedom = std::max(2.0, 8.0 * static_cast<double>(seen.size()) - 6.0);
    estimate.evidence = (minima[1].misfit - estimate.best.misfit) / std::max(1.0, estimate.best.misfit / freedom);
  }
  return estimate;
}

}  // namespace ew
