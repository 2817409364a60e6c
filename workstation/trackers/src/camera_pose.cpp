#include "camera_pose.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

namespace ew {
namespace {

constexpr double kCornerFloor_px = 0.08;  // what print, paper and lens model leave, however sharp the edges are
constexpr double kMostMisfit = 400.0;     // of one corner: from 20 standard deviations on, further away is not worse
constexpr double kHuber = 3.0;            // standard deviations
constexpr int kMostFaces = 3;             // of a cuboid are in sight
// How far a folded and glued face lies off its place (standard deviation). Without it a cube 0.3 mm too thick at 600 mm would be taken
// for one 3 mm nearer, since what stands beside each other weighs more in the image than the size of a marker.
constexpr double kPaper_mm = 0.2;

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
  glm::dvec3 corner_mm, outward;
  glm::dvec2 ray, perBleed;
  double weight;
  template <class T>
  bool operator()(const T* pose, const T* bleed, const T* bulge, T* residual) const {
    const T corner[3] = {corner_mm.x + bulge[0] * outward.x, corner_mm.y + bulge[0] * outward.y, corner_mm.z + bulge[0] * outward.z};
    T at[3];
    ceres::AngleAxisRotatePoint(pose, corner, at);
    const T depth = at[2] + pose[5];
    if (depth < T(1.0)) return false;
    residual[0] = weight * ((at[0] + pose[3]) / depth - ray.x - bleed[0] * perBleed.x);
    residual[1] = weight * ((at[1] + pose[4]) / depth - ray.y - bleed[0] * perBleed.y);
    return true;
  }
};

/// What is known of a number beforehand.
struct PriorResidual {
  double value, deviation;
  template <class T>
  bool operator()(const T* number, T* residual) const {
    residual[0] = (number[0] - value) / deviation;
    return true;
  }
};
ceres::CostFunction* known(double value, double deviation) {
  return new ceres::AutoDiffCostFunction<PriorResidual, 1, 1>(new PriorResidual{value, deviation});
}

double spreadOf(const MarkerObservation& seen) { return std::hypot(kCornerFloor_px, seen.spread_px); }

bool faces(const MarkerObservation& seen, const glm::dmat4& bodyToCamera) {
  const glm::dvec3 outward = glm::dmat3(bodyToCamera) * outwardOf(*seen.marker);
  const glm::dvec3 middle = glm::dvec3(bodyToCamera * glm::dvec4(middleOf(*seen.marker), 1.0));
  return middle.z > 0.0 && glm::dot(outward, middle) < 0.0;
}

class BodySolver {
 public:
  BodySolver(const std::vector<MarkerObservation>& seen, double focal_px, const MarkerBleed& bleed);

  [[nodiscard]] std::vector<BodyHypothesis> starts() const;
  [[nodiscard]] BodyHypothesis at(const glm::dmat4& bodyToCamera) const;
  [[nodiscard]] std::optional<BodyHypothesis> refined(const BodyHypothesis& start, const std::vector<bool>& used) const;
  [[nodiscard]] double residual_px(std::size_t marker, const BodyHypothesis& pose) const {
    double sum = 0.0;
    for (std::size_t n = 0; n < 4; ++n) sum += std::pow(offBy_px(marker, n, pose), 2);
    return std::sqrt(sum / 4.0);
  }
  void judgeSpread(BodyEstimate& estimate, const glm::dvec3& at_body) const;
  /// Of one flat face: the pose whose normal is mirrored at the line of sight, which a distant camera could not tell apart; carried to its
  /// minimum where that is another one than this pose's.
  [[nodiscard]] std::optional<BodyHypothesis> mirrored(const BodyHypothesis& pose, const std::vector<bool>& used) const;

 private:
  /// Over all observations: also those that the best leaves out speak for or against the others.
  [[nodiscard]] double misfit(const BodyHypothesis& pose) const;
  [[nodiscard]] glm::dvec3 cornerAt(std::size_t marker, std::size_t corner, const BodyHypothesis& pose) const {
    const glm::dvec3 at_body = seen_[marker].marker->corners_mm[corner] + pose.bulges_mm[faceOf_[marker]] * outwards_[marker];
    return glm::dvec3(pose.bodyToCamera * glm::dvec4(at_body, 1.0));
  }
  [[nodiscard]] double offBy_px(std::size_t marker, std::size_t corner, const BodyHypothesis& pose) const {
    const glm::dvec3 at = cornerAt(marker, corner, pose);
    if (at.z < 1.0) return 1e3;
    return focal_px_ * glm::distance(glm::dvec2(at) / at.z, seen_[marker].rays[corner] + pose.bleed * seen_[marker].perBleed[corner]);
  }
  void addPlaneStarts(const std::vector<std::size_t>& plane, std::vector<BodyHypothesis>& starts) const;

  const std::vector<MarkerObservation>& seen_;
  double focal_px_;
  MarkerBleed bleed_;
  std::vector<glm::dvec3> outwards_;             ///< of each observation
  std::vector<std::vector<std::size_t>> faces_;  ///< observations on one flat face, the largest face first
  std::vector<std::size_t> faceOf_;              ///< of each observation
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

BodySolver::BodySolver(const std::vector<MarkerObservation>& seen, double focal_px, const MarkerBleed& bleed)
    : seen_(seen), focal_px_(focal_px), bleed_(bleed), faceOf_(seen.size()) {
  for (const MarkerObservation& each : seen) outwards_.push_back(outwardOf(*each.marker));
  for (std::size_t m = 0; m < seen.size(); ++m) {
    const auto same = std::find_if(faces_.begin(), faces_.end(), [&](const auto& face) {
      const glm::dvec3 apart = middleOf(*seen[m].marker) - middleOf(*seen[face.front()].marker);
      return glm::dot(outwards_[face.front()], outwards_[m]) > 0.9999 && std::abs(glm::dot(outwards_[m], apart)) < 0.2;
    });
    if (same == faces_.end())
      faces_.push_back({m});
    else
      same->push_back(m);
  }
  const auto area = [&](const auto& face) {
    double sum = 0.0;
    for (const std::size_t each : face) sum += areaOf(seen[each]);
    return sum;
  };
  std::stable_sort(faces_.begin(), faces_.end(), [&](const auto& a, const auto& b) { return area(a) > area(b); });
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (const std::size_t each : faces_[f]) faceOf_[each] = f;
}

double BodySolver::misfit(const BodyHypothesis& pose) const {
  double sum = std::pow((pose.bleed - bleed_.value) / bleed_.deviation, 2);
  for (const double bulge_mm : pose.bulges_mm) sum += std::pow(bulge_mm / kPaper_mm, 2);
  for (std::size_t m = 0; m < seen_.size(); ++m) {
    if (!faces(seen_[m], pose.bodyToCamera)) {
      sum += 4.0 * kMostMisfit;
      continue;
    }
    for (std::size_t n = 0; n < 4; ++n) sum += std::min(kMostMisfit, std::pow(offBy_px(m, n, pose) / spreadOf(seen_[m]), 2));
  }
  return sum;
}

BodyHypothesis BodySolver::at(const glm::dmat4& bodyToCamera) const {
  BodyHypothesis pose{bodyToCamera, bleed_.value, std::vector<double>(faces_.size(), 0.0), 0.0, 0.0};
  pose.misfit = misfit(pose);
  return pose;
}

void BodySolver::addPlaneStarts(const std::vector<std::size_t>& plane, std::vector<BodyHypothesis>& starts) const {
  const glm::dmat4 toBody = planeToBody(*seen_[plane.front()].marker), fromBody = glm::inverse(toBody);
  std::vector<cv::Point3d> corners;
  std::vector<cv::Point2d> rays;
  for (const std::size_t each : plane)
    for (std::size_t n = 0; n < 4; ++n) {
      const glm::dvec4 at = fromBody * glm::dvec4(seen_[each].marker->corners_mm[n], 1.0);
      corners.emplace_back(at.x, at.y, 0.0);
      const glm::dvec2 ray = seen_[each].rays[n] + bleed_.value * seen_[each].perBleed[n];
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
      starts.push_back(at(matrixOf(six) * fromBody));
  }
}

std::vector<BodyHypothesis> BodySolver::starts() const {
  std::vector<BodyHypothesis> found;
  for (std::size_t f = 0; f < std::min<std::size_t>(kMostFaces, faces_.size()); ++f) {
    addPlaneStarts(faces_[f], found);
    if (faces_[f].size() > 1) addPlaneStarts({faces_[f].front()}, found);  // should another of the face be measured wrongly
  }
  return found;
}

std::optional<BodyHypothesis> BodySolver::refined(const BodyHypothesis& start, const std::vector<bool>& used) const {
  Pose6 six = sixOf(start.bodyToCamera);
  BodyHypothesis pose = start;
  ceres::HuberLoss loss(kHuber);
  ceres::Problem::Options ownership;
  ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(known(bleed_.value, bleed_.deviation), nullptr, &pose.bleed);
  for (double& bulge_mm : pose.bulges_mm) problem.AddResidualBlock(known(0.0, kPaper_mm), nullptr, &bulge_mm);
  for (std::size_t m = 0; m < seen_.size(); ++m) {
    if (!used[m]) continue;
    for (std::size_t n = 0; n < 4; ++n)
      problem.AddResidualBlock(
          new ceres::AutoDiffCostFunction<CornerResidual, 2, 6, 1, 1>(new CornerResidual{
              seen_[m].marker->corners_mm[n], outwards_[m], seen_[m].rays[n], seen_[m].perBleed[n], focal_px_ / spreadOf(seen_[m])}),
          &loss, six.data(), &pose.bleed, &pose.bulges_mm[faceOf_[m]]);
  }
  // Of one face alone it is a place along the line of sight like any other.
  if (faces_.size() == 1) problem.SetParameterBlockConstant(pose.bulges_mm.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 15;
  options.function_tolerance = 1e-6;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable() || !std::isfinite(pose.bleed)) return {};
  for (double each : six)
    if (!std::isfinite(each)) return {};
  pose.bodyToCamera = matrixOf(six);
  pose.misfit = misfit(pose);
  return pose;
}

std::optional<BodyHypothesis> BodySolver::mirrored(const BodyHypothesis& pose, const std::vector<bool>& used) const {
  if (faces_.size() > 1) return {};
  glm::dvec3 middle(0.0);
  for (const MarkerObservation& each : seen_)
    middle += glm::dvec3(pose.bodyToCamera * glm::dvec4(middleOf(*each.marker), 1.0)) / static_cast<double>(seen_.size());
  const glm::dvec3 outward = glm::dmat3(pose.bodyToCamera) * outwards_.front(), back = -glm::normalize(middle);
  const glm::dvec3 axis = glm::cross(outward, back);
  const double sine = glm::length(axis);
  if (sine < 1e-4) return {};
  glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 2.0 * std::atan2(sine, glm::dot(outward, back)), axis / sine);
  turn[3] = glm::dvec4(middle - glm::dmat3(turn) * middle, 1.0);
  const BodyHypothesis start = at(turn * pose.bodyToCamera);
  const auto carried = refined(start, used);
  // Where both lead to one minimum, its valley may be so flat that the mirrored pose fits as well all the same.
  if (!carried || angleBetween(carried->bodyToCamera, pose.bodyToCamera) < 0.5 * angleBetween(start.bodyToCamera, pose.bodyToCamera))
    return start;
  return carried->misfit < start.misfit ? *carried : start;
}

/// Covariance of a small turn about the point, of a move of it, of the bleed and of each face's place, from the corners' variances as the
/// residuals show them.
void BodySolver::judgeSpread(BodyEstimate& estimate, const glm::dvec3& at_body) const {
  const BodyHypothesis& pose = estimate.best;
  const glm::dvec3 about = glm::dvec3(pose.bodyToCamera * glm::dvec4(at_body, 1.0));
  const auto unknowns = static_cast<Eigen::Index>(7 + faces_.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(unknowns, unknowns);
  double squares = 0.0;
  int corners = 0;
  for (std::size_t m = 0; m < seen_.size(); ++m) {
    if (!estimate.used[m]) continue;
    const double weight = focal_px_ / spreadOf(seen_[m]);
    const glm::dvec3 outward = glm::dmat3(pose.bodyToCamera) * outwards_[m];
    for (std::size_t n = 0; n < 4; ++n) {
      const glm::dvec3 q = cornerAt(m, n, pose), arm = q - about;
      Eigen::Matrix<double, 2, 3> byPlace;
      byPlace << 1.0 / q.z, 0.0, -q.x / (q.z * q.z), 0.0, 1.0 / q.z, -q.y / (q.z * q.z);
      Eigen::Matrix3d byTurn;  // of w x arm
      byTurn << 0.0, arm.z, -arm.y, -arm.z, 0.0, arm.x, arm.y, -arm.x, 0.0;
      const glm::dvec2& byBleed = seen_[m].perBleed[n];
      Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(2, unknowns);
      slope.leftCols<7>() << byPlace * byTurn, byPlace, Eigen::Vector2d(-byBleed.x, -byBleed.y);
      slope.col(static_cast<Eigen::Index>(7 + faceOf_[m])) = byPlace * Eigen::Vector3d(outward.x, outward.y, outward.z);
      slope *= weight;
      information += slope.transpose() * slope;
      squares += std::pow(offBy_px(m, n, pose) / spreadOf(seen_[m]), 2);
      ++corners;
    }
  }
  information /= std::max(1.0, squares / std::max(1, 2 * corners - 6));
  information(6, 6) += 1.0 / (bleed_.deviation * bleed_.deviation);
  for (Eigen::Index n = 7; n < unknowns; ++n) information(n, n) += 1.0 / (kPaper_mm * kPaper_mm);
  const Eigen::MatrixXd covariance = information.inverse();
  const double turn = covariance.topLeftCorner<3, 3>().trace(), place = covariance.block<3, 3>(3, 3).trace();
  estimate.spread_rad = turn >= 0.0 ? std::sqrt(turn) : 1e9;  // also where it is not a number
  estimate.spread_mm = place >= 0.0 ? std::sqrt(place) : 1e9;
  estimate.bleed = {pose.bleed, covariance(6, 6) > 0.0 ? std::sqrt(covariance(6, 6)) : bleed_.deviation};
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
  std::vector<BodyHypothesis> starts = solver.starts();
  if (before) starts.push_back(solver.at(*before));
  const auto byMisfit = [](const BodyHypothesis& a, const BodyHypothesis& b) { return a.misfit < b.misfit; };
  std::stable_sort(starts.begin(), starts.end(), byMisfit);
  // Everything at its limit: this start explains nothing.
  const double hopeless = 4.0 * kMostMisfit * static_cast<double>(seen.size());

  // The nearest starts to different poses are carried to their minima.
  constexpr double kSamePose_rad = 0.0175;
  constexpr std::size_t kMostBegun = 4;
  const std::vector<bool> all(seen.size(), true);
  std::vector<BodyHypothesis> minima;
  std::vector<glm::dmat4> begun;
  const auto leftover = [&](const BodyHypothesis& pose) {  // variance, in that of the corners
    return std::max(1.0, pose.misfit / std::max(2.0, 8.0 * static_cast<double>(seen.size()) - 6.0));
  };
  for (const BodyHypothesis& start : starts) {
    if ((start.misfit >= hopeless && !minima.empty()) || begun.size() == kMostBegun) break;
    const auto near = [&](const glm::dmat4& other) { return angleBetween(start.bodyToCamera, other) < 2.0 * kSamePose_rad; };
    if (std::any_of(begun.begin(), begun.end(), near)) continue;
    // Starts of a whole face are near their minima: what fits so much worse here will not come to fit as well as what is found.
    if (!minima.empty() && start.misfit > 10.0 * (minima.front().misfit + 100.0 * leftover(minima.front()))) continue;
    if (std::any_of(minima.begin(), minima.end(), [&](const auto& each) { return near(each.bodyToCamera); })) continue;
    begun.push_back(start.bodyToCamera);
    const auto pose = solver.refined(start, all);
    if (!pose) continue;
    const auto same = [&](const BodyHypothesis& each) { return angleBetween(each.bodyToCamera, pose->bodyToCamera) < kSamePose_rad; };
    if (std::none_of(minima.begin(), minima.end(), same)) minima.push_back(*pose);
  }
  if (minima.empty()) return {};
  std::stable_sort(minima.begin(), minima.end(), byMisfit);

  BodyEstimate estimate;
  estimate.best = minima.front();
  const auto judge = [&] {
    estimate.residuals_px.clear();
    for (std::size_t n = 0; n < seen.size(); ++n)
      estimate.residuals_px.push_back(faces(seen[n], estimate.best.bodyToCamera) ? solver.residual_px(n, estimate.best) : 1e3);
    estimate.used = agreeing(estimate.residuals_px);
  };
  judge();
  if (!std::all_of(estimate.used.begin(), estimate.used.end(), [](bool each) { return each; })) {
    if (const auto again = solver.refined(estimate.best, estimate.used)) {
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

  if (minima.size() > 1) estimate.other = minima[1];
  if (const auto mirrored = solver.mirrored(estimate.best, estimate.used))
    if (!estimate.other || mirrored->misfit < estimate.other->misfit) estimate.other = mirrored;
  if (!estimate.other) return estimate;
  estimate.otherAngle_rad = angleBetween(estimate.other->bodyToCamera, estimate.best.bodyToCamera);
  double otherSquares = 0.0;
  for (std::size_t n = 0; n < seen.size(); ++n)
    if (estimate.used[n]) otherSquares += std::pow(solver.residual_px(n, *estimate.other), 2);
  estimate.other->rms_px = std::sqrt(otherSquares / estimate.markers);
  // Of the markers in use: one that was left out says nothing of how well the others are measured.
  double weighted = 0.0;
  for (std::size_t n = 0; n < seen.size(); ++n)
    if (estimate.used[n]) weighted += 4.0 * std::pow(estimate.residuals_px[n] / spreadOf(seen[n]), 2);
  const double variance = std::max(1.0, weighted / std::max(2.0, 8.0 * estimate.markers - 6.0));
  estimate.evidence = (estimate.other->misfit - estimate.best.misfit) / variance;
  return estimate;
}

}  // namespace ew
