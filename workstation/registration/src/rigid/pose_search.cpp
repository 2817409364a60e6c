#include "pose_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ew::registration {

glm::dmat3 rotationBy(const glm::dvec3& turn) {
  const double angle = glm::length(turn);
  const double a = angle < 1e-8 ? 1.0 - angle * angle / 6.0 : std::sin(angle) / angle;
  const double b = angle < 1e-4 ? 0.5 - angle * angle / 24.0 : (1.0 - std::cos(angle)) / (angle * angle);
  const glm::dmat3 k(glm::dvec3(0.0, turn.z, -turn.y), glm::dvec3(-turn.z, 0.0, turn.x), glm::dvec3(turn.y, -turn.x, 0.0));
  return glm::dmat3(1.0) + a * k + b * (k * k);
}

Transform<frame::Fixed, frame::Fixed> motionAbout(const glm::dvec3& centre, const glm::dvec3& shift, const glm::dvec3& turn) {
  const glm::dmat3 r = rotationBy(turn);
  Transform<frame::Fixed, frame::Fixed> out{glm::dmat4(r)};
  out.matrix[3] = glm::dvec4(centre + shift - r * centre, 1.0);
  return out;
}

double rotationBetween_rad(const Transform<frame::Moving, frame::Fixed>& a, const Transform<frame::Moving, frame::Fixed>& b) {
  const glm::dmat3 r = glm::transpose(glm::dmat3(a.matrix)) * glm::dmat3(b.matrix);
  const glm::dvec3 axis(r[1][2] - r[2][1], r[2][0] - r[0][2], r[0][1] - r[1][0]);
  return std::atan2(0.5 * glm::length(axis), 0.5 * (r[0][0] + r[1][1] + r[2][2] - 1.0));
}

PoseDifference differenceOf(const Transform<frame::Moving, frame::Fixed>& a, const Transform<frame::Moving, frame::Fixed>& b,
                            const glm::dvec3& at) {
  const glm::dvec3 gap = carried(a, at) - carried(b, at);
  return {rotationBetween_rad(a, b) * 180.0 / std::numbers::pi, glm::length(gap)};
}

Descent descend(const ComparableImage& fixed, const KernelImage& moving, const Transform<frame::Moving, frame::Fixed>& start,
                const DescentOptions& options, int threads, Progress& progress) {
  Descent out;
  out.fixedToMoving = start;
  const auto toFixed = fixed.grid.voxelTo<frame::Fixed>();
  out.centre_mm = carried(toFixed, 0.5 * glm::dvec3(fixed.grid.dims - 1));
  const double voxel_mm = fixed.grid.spacing_mm.x;
  double scale = 0.0;
  double lastStep_mm = 1e300;
  double eager = 3.0;  // allowed overrelaxation; falls when steps grow
  out.stop = StopReason::iterationLimit;
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const PassOptions pass{scale, options.blockVoxels, options.half, false, true};
    if (!sumOverPair(fixed, moving, out.fixedToMoving, out.centre_mm, pass, threads, progress, out.sums)) {
      out.stop = StopReason::cancelled;
      return out;
    }
    const PoseSums& sums = out.sums;
    if (iteration == 0) out.correlationBefore = sums.correlation();
    if (sums.count < 50.0) {
      out.stop = StopReason::noOverlap;
      return out;
    }
    scale = 2.0 * sums.residualRms();
    // The centre of the overlap for the next pass: there turns and shifts hardly mix.
    const glm::dvec3 middle = carried(toFixed, 0.5 * (sums.lowest + sums.highest));
    out.lever_mm = std::max(5.0, 0.5 * voxel_mm * glm::length(sums.highest - sums.lowest));
    const double lever = out.lever_mm;

    Eigen::Matrix<double, 6, 6> normal;
    Eigen::Matrix<double, 6, 1> right;
    for (int r = 0; r < 6; ++r) {
      const double ur = r < 3 ? 1.0 : 1.0 / lever;
      right[r] = sums.right[r] * ur;
      for (int c = 0; c < 6; ++c) normal(r, c) = sums.normal[6 * r + c] * ur * (c < 3 ? 1.0 : 1.0 / lever);
    }
    const double most = normal.diagonal().maxCoeff();
    if (!(most > 0.0)) {
      out.stop = StopReason::singular;
      return out;
    }
    normal.diagonal().array() += 1e-3 * most;
    Eigen::Matrix<double, 6, 1> step = normal.ldlt().solve(right);
    step *= std::min(sums.stiffness(), eager);
    const double size_mm = step.norm();
    if (size_mm > 0.7 * lastStep_mm) eager = std::max(1.0, 0.7 * eager);
    lastStep_mm = size_mm;
    if (size_mm > options.limit_mm) step *= options.limit_mm / size_mm;
    const glm::dvec3 shift(step[0], step[1], step[2]);
    const glm::dvec3 turn = glm::dvec3(step[3], step[4], step[5]) / lever;
    out.fixedToMoving = out.fixedToMoving * motionAbout(out.centre_mm, shift, turn);
    out.iterations = iteration + 1;
    if (size_mm < options.stop_mm) {
      out.stop = StopReason::converged;
      return out;
    }
    out.centre_mm = middle;
  }
  return out;
}

double voxelsPerSample(const ComparableImage& fixed, const ComparableImage& moving) {
  const auto neighbours = [](const ComparableImage& image, int axis, int lag) {
    const glm::ivec3 dims = image.grid.dims;
    glm::ivec3 to = dims;
    to[axis] -= lag;
    const std::size_t step = axis == 0 ? 1 : axis == 1 ? dims.x : static_cast<std::size_t>(dims.x) * dims.y;
    double ab = 0.0;
    double aa = 0.0;
    for (int k = 0; k < to.z; ++k) {
      for (int j = 0; j < to.y; ++j) {
        const std::size_t at = image.grid.indexOf(0, j, k);
        for (int i = 0; i < to.x; ++i) {
          if (image.weight[at + i] == 0 || image.weight[at + i + lag * step] == 0) continue;
          const double here = image.value[at + i];
          const double there = image.value[at + i + lag * step];
          ab += here * there;
          aa += 0.5 * (here * here + there * there);
        }
      }
    }
    return aa > 0.0 ? ab / aa : 0.0;
  };
  // Bartlett: the variance of a correlation of two coloured signals grows by the sum of the products of their autocorrelations.
  double perSample = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    double sum = 1.0;
    for (int lag = 1; lag < std::min(fixed.grid.dims[axis], moving.grid.dims[axis]); ++lag) {
      const double product = neighbours(fixed, axis, lag) * neighbours(moving, axis, lag);
      if (lag > 8 || product < 0.01) break;
      sum += 2.0 * product;
    }
    perSample *= sum;
  }
  return perSample;
}

}  // namespace ew::registration
