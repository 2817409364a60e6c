#include "view_sampler.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"
#include "ew/core/depth_curves.h"

namespace ew::stitching {

double GreyCorrection::at(const glm::dvec3& p_mm) const {
  if (grey.empty()) return 0.0;
  if (!beams) return grey.front();
  return atDepth(grey, knot_mm, beams->depth_mm(p_mm) - firstKnot_mm);
}

ViewSampler::ViewSampler(const View& view, const Grid& result, double interpolatedWeight, const std::vector<float>* distance_mm)
    : view_(&view), distance_mm_(distance_mm), interpolatedWeight_(interpolatedWeight) {
  const Volume& volume = *view.volume;
  EW_EXPECTS(volume.echo.size() == volume.grid.voxelCount());
  EW_EXPECTS(volume.coverage.empty() || volume.coverage.size() == volume.grid.voxelCount());
  EW_EXPECTS(view.confidence.empty() || view.confidence.size() == volume.grid.voxelCount());
  const auto worldToVoxel = placed(volume.grid, view.toWorld).worldToVoxel();
  resultToVoxel_ = (worldToVoxel * result.voxelToWorld()).matrix;
  warpToVoxel_ = glm::dmat3(worldToVoxel.matrix);
  if (view.warp != nullptr && !view.warp->displacement_mm.empty()) {
    EW_EXPECTS(view.warp->displacement_mm.size() == view.warp->nodes.voxelCount());
    resultToNode_ = (view.warp->nodes.worldToVoxel() * result.voxelToWorld()).matrix;
    for (const glm::vec3& u : view.warp->displacement_mm)
      farthestWarp_voxel_ = glm::max(farthestWarp_voxel_, glm::abs(warpToVoxel_ * glm::dvec3(u)));
  }
  // A view's own frame is that of its file; along parallel beams depth is linear in its voxels.
  const GreyCorrection& correction = view.correction;
  voxelToFile_ = volume.grid.voxelToWorld().matrix;
  if (correction.grey.size() > 1 && correction.beams && !correction.beams->fan) {
    const glm::dvec3 along = glm::normalize(correction.beams->direction);
    for (int axis = 0; axis < 3; ++axis) depthPerVoxel_[axis] = glm::dot(glm::dvec3(voxelToFile_[axis]), along) / correction.knot_mm;
    depthOfFirst_knot_ = (glm::dot(glm::dvec3(voxelToFile_[3]), along) - correction.firstKnot_mm) / correction.knot_mm;
  }
}

bool ViewSampler::mayReach(const glm::ivec3& lowest, const glm::ivec3& highest) const {
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 ijk((corner & 1) ? highest.x : lowest.x, (corner & 2) ? highest.y : lowest.y, (corner & 4) ? highest.z : lowest.z);
    const glm::dvec3 where(resultToVoxel_ * glm::dvec4(ijk, 1.0));
    low = glm::min(low, where);
    high = glm::max(high, where);
  }
  low -= farthestWarp_voxel_ + 1e-3;
  high += farthestWarp_voxel_ + 1e-3;
  return glm::all(glm::lessThanEqual(low, glm::dvec3(view_->volume->grid.dims - 1))) &&
         glm::all(glm::greaterThanEqual(high, glm::dvec3(0.0)));
}

std::pair<glm::ivec3, glm::ivec3> ViewSampler::reach() const {
  const glm::dmat4 voxelToResult = glm::inverse(resultToVoxel_);
  glm::dvec3 low(1e9);
  glm::dvec3 high(-1e9);
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 ijk(0.0);
    // A warp reads up to so far outside the place it stands for.
    for (int axis = 0; axis < 3; ++axis)
      ijk[axis] = ((corner >> axis) & 1) != 0 ? view_->volume->grid.dims[axis] - 1 + farthestWarp_voxel_[axis] : -farthestWarp_voxel_[axis];
    const glm::dvec3 where(voxelToResult * glm::dvec4(ijk, 1.0));
    low = glm::min(low, where);
    high = glm::max(high, where);
  }
  const glm::dvec3 farthest(1e9);
  return {glm::ivec3(glm::floor(glm::clamp(low, -farthest, farthest) - 1e-3)),
          glm::ivec3(glm::ceil(glm::clamp(high, -farthest, farthest) + 1e-3))};
}

std::pair<int, int> ViewSampler::insideOf(const glm::dvec3& start, const glm::dvec3& step, int begin, int end) const {
  double first = begin;
  double last = end - 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = -kOnLattice_voxel - start[axis];
    const double high = view_->volume->grid.dims[axis] - 1.0 + kOnLattice_voxel - start[axis];
    if (std::abs(step[axis]) < 1e-15) {
      if (low > 0.0 || high < 0.0) return {0, 0};
      continue;
    }
    const auto [enter, leave] = std::minmax({low / step[axis], high / step[axis]});
    first = std::max(first, enter);
    last = std::min(last, leave);
  }
  if (!(first <= last)) return {0, 0};
  return {static_cast<int>(std::ceil(first)), static_cast<int>(std::floor(last)) + 1};
}

double ViewSampler::correctionAt(const glm::dvec3& where) const {
  const GreyCorrection& correction = view_->correction;
  if (correction.grey.size() == 1 || !correction.beams) return correction.grey.front();
  if (correction.beams->fan) return correction.at(glm::dvec3(voxelToFile_ * glm::dvec4(where, 1.0)));
  return atDepth(correction.grey, 1.0, glm::dot(where, depthPerVoxel_) + depthOfFirst_knot_);
}

ViewSample ViewSampler::at(const glm::dvec3& where) const {
  const Volume& volume = *view_->volume;
  const Grid& grid = volume.grid;
  glm::ivec3 low{0};
  glm::dvec3 part{0.0};
  glm::ivec3 nearest{0};
  for (int axis = 0; axis < 3; ++axis) {
    const double whole = std::round(where[axis]);
    const double on = std::abs(where[axis] - whole) < kOnLattice_voxel ? whole : where[axis];
    const double bounded = std::clamp(on, 0.0, static_cast<double>(grid.dims[axis] - 1));
    low[axis] = std::min(static_cast<int>(bounded), std::max(grid.dims[axis] - 2, 0));
    part[axis] = bounded - low[axis];
    nearest[axis] = static_cast<int>(bounded + 0.5);
  }
  const std::size_t own = grid.indexOf(nearest.x, nearest.y, nearest.z);
  const Coverage coverage = volume.coverageAt(own);
  // The covered region neither grows nor shrinks: its nearest voxel decides whether a point belongs to it.
  if (coverage == Coverage::absent) return {};

  double level = 0.0;
  double present = 0.0;
  double quality = 0.0;
  double distance = 0.0;
  double confidence = 0.0;
  double heard = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const double share =
        (step.x != 0 ? part.x : 1.0 - part.x) * (step.y != 0 ? part.y : 1.0 - part.y) * (step.z != 0 ? part.z : 1.0 - part.z);
    if (share <= 0.0) continue;
    const std::size_t index = grid.indexOf(low.x + step.x, low.y + step.y, low.z + step.z);
    const Coverage there = volume.coverageAt(index);
    if (there == Coverage::absent) continue;
    const double echo = volume.echo[index];
    level += share * echo;
    present += share;
    quality += share * (there == Coverage::measured ? 1.0 : interpolatedWeight_);
    if (echo > 0.0) heard += share;
    if (distance_mm_ != nullptr) distance += share * static_cast<double>((*distance_mm_)[index]);
    if (!view_->confidence.empty()) confidence += share * view_->confidence[index];
  }
  ViewSample sample;
  sample.level = level / present;  // the nearest voxel is covered and has at least an eighth of the share
  if (!view_->correction.grey.empty()) sample.level = correctedBy(sample.level, correctionAt(where), heard / present);
  sample.quality = quality / present;
  sample.distance = distance / present;
  if (!view_->confidence.empty()) sample.confidence = confidence / present / 255.0;
  sample.measured = coverage == Coverage::measured;
  return sample;
}

ViewSample ViewSampler::nearestTo(const glm::dvec3& where) const {
  const Volume& volume = *view_->volume;
  const Grid& grid = volume.grid;
  const glm::ivec3 nearest(glm::clamp(where, glm::dvec3(0.0), glm::dvec3(grid.dims - 1)) + 0.5);
  const std::size_t index = grid.indexOf(nearest.x, nearest.y, nearest.z);
  const Coverage coverage = volume.coverageAt(index);
  if (coverage == Coverage::absent) return {};
  ViewSample sample;
  sample.level = volume.echo[index];
  if (!view_->correction.grey.empty()) sample.level = correctedBy(sample.level, correctionAt(where), 1.0);
  sample.measured = coverage == Coverage::measured;
  sample.quality = sample.measured ? 1.0 : interpolatedWeight_;
  if (!view_->confidence.empty()) sample.confidence = view_->confidence[index] / 255.0;
  return sample;
}

}  // namespace ew::stitching
