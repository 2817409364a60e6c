#pragma once

#include <optional>
#include <utility>

#include "ew/stitching/join.h"

namespace ew::stitching {

/// Rounding errors of a transform must not turn a voxel's own centre into a mix of two.
inline constexpr double kOnLattice_voxel = 1e-6;
/// Keeps the rounding of a tie (10.5) from depending on the order in which values were added up.
inline constexpr double kTie = 1e-7;

inline std::uint8_t greyOf(double level) { return static_cast<std::uint8_t>(glm::clamp(glm::floor(level + 0.5 + kTie), 0.0, 255.0)); }

/// What a view shows at a point.
struct ViewSample {
  double level = 0.0;     ///< corrected grey level
  double quality = 0.0;   ///< 1 measured, the weight of an interpolated voxel, or between; 0: nothing there
  double distance = 0.0;  ///< from the border, where distances were given
  double confidence = 1.0;
  bool measured = false;
};

/// Reads one view on the lattice of a result: rows of voxels become lines (or warped lines) of the view's voxels. The one sampler of all
/// ways to join. What it gives for a voxel depends on that voxel alone, never on the row's beginning or the block.
class ViewSampler {
 public:
  /// @param distance_mm one value per voxel of the view, or null; view, distances and warp must outlive this
  ViewSampler(const View& view, const Grid& result, double interpolatedWeight, const std::vector<float>* distance_mm = nullptr);

  /// False when no voxel of the box can lie in the view (a warp may bring less than it promises).
  [[nodiscard]] bool mayReach(const glm::ivec3& lowest, const glm::ivec3& highest) const;

  /// The voxels of the result that can lie in the view: first and last, perhaps outside the result.
  [[nodiscard]] std::pair<glm::ivec3, glm::ivec3> reach() const;

  /// Calls take(i, where) for the voxels [begin, end) of row (j, k) that lie in the view's grid, in order.
  template <class Take>
  void alongRow(int j, int k, int begin, int end, const Take& take) const;

  [[nodiscard]] ViewSample at(const glm::dvec3& where) const;

  /// The nearest voxel: quick, for looks at coarse cells. Level 0 and quality 0 where absent.
  [[nodiscard]] ViewSample nearestTo(const glm::dvec3& where) const;

  [[nodiscard]] const View& view() const { return *view_; }

 private:
  /// The samples [begin, end) of a row at start + i * step that lie inside the view's grid; clipped once per row, never per voxel.
  [[nodiscard]] std::pair<int, int> insideOf(const glm::dvec3& start, const glm::dvec3& step, int begin, int end) const;
  [[nodiscard]] bool inside(const glm::dvec3& where) const {
    for (int axis = 0; axis < 3; ++axis)
      if (!(where[axis] >= -kOnLattice_voxel && where[axis] <= view_->volume->grid.dims[axis] - 1.0 + kOnLattice_voxel)) return false;
    return true;
  }
  [[nodiscard]] double correctionAt(const glm::dvec3& where) const;
  [[nodiscard]] double correctedBy(double level, double adds, double share) const {
    // Where part of the sample is 0, nothing was received there, and it stays so.
    return level <= 0.0 ? level : glm::clamp(level + adds * share, share, 255.0);
  }

  /// The displacement along a row, with the lattice's cell kept between neighbours.
  class BendAlongRow {
   public:
    BendAlongRow(const ViewSampler& owner, int j, int k);
    [[nodiscard]] glm::dvec3 at(int i);

   private:
    const registration::ControlGrid* warp_;
    glm::dvec3 start_;
    glm::dvec3 step_;
    glm::ivec3 cell_{-1};
    glm::dvec3 corner_[8];
  };

  const View* view_;
  const std::vector<float>* distance_mm_;
  double interpolatedWeight_;
  glm::dmat4 resultToVoxel_{1.0};  ///< without the warp
  glm::dmat4 resultToNode_{1.0};
  glm::dmat3 warpToVoxel_{1.0};  ///< a displacement of the world in voxels of the view
  glm::dvec3 farthestWarp_voxel_{0.0};
  glm::dmat4 voxelToFile_{1.0};
  glm::dvec3 depthPerVoxel_{0.0};  ///< along parallel beams
  double depthOfFirst_knot_ = 0.0;
};

inline ViewSampler::BendAlongRow::BendAlongRow(const ViewSampler& owner, int j, int k)
    : warp_(owner.view_->warp), start_(owner.resultToNode_ * glm::dvec4(0.0, j, k, 1.0)), step_(owner.resultToNode_[0]) {}

inline glm::dvec3 ViewSampler::BendAlongRow::at(int i) {
  const Grid& nodes = warp_->nodes;
  const glm::dvec3 where = glm::clamp(start_ + static_cast<double>(i) * step_, glm::dvec3(0.0), glm::dvec3(nodes.dims - 1));
  const glm::ivec3 cell = glm::min(glm::ivec3(where), glm::max(nodes.dims - 2, glm::ivec3(0)));
  if (cell != cell_) {
    cell_ = cell;
    for (int c = 0; c < 8; ++c) {
      const glm::ivec3 node = glm::min(cell + glm::ivec3(c & 1, (c >> 1) & 1, c >> 2), nodes.dims - 1);
      corner_[c] = glm::dvec3(warp_->displacement_mm[nodes.indexOf(node.x, node.y, node.z)]);
    }
  }
  const glm::dvec3 part = where - glm::dvec3(cell);
  const auto alongX = [&](int c) { return corner_[c] + part.x * (corner_[c + 1] - corner_[c]); };
  const glm::dvec3 low = alongX(0) + part.y * (alongX(2) - alongX(0));
  const glm::dvec3 high = alongX(4) + part.y * (alongX(6) - alongX(4));
  return low + part.z * (high - low);
}

template <class Take>
void ViewSampler::alongRow(int j, int k, int begin, int end, const Take& take) const {
  const glm::dvec3 start(resultToVoxel_ * glm::dvec4(0.0, j, k, 1.0));
  const glm::dvec3 step(resultToVoxel_[0]);
  if (view_->warp == nullptr || view_->warp->displacement_mm.empty()) {
    const auto [first, last] = insideOf(start, step, begin, end);
    for (int i = first; i < last; ++i) take(i, start + static_cast<double>(i) * step);
    return;
  }
  BendAlongRow warp(*this, j, k);
  for (int i = begin; i < end; ++i) {
    const glm::dvec3 where = start + static_cast<double>(i) * step + warpToVoxel_ * warp.at(i);
    if (inside(where)) take(i, where);
  }
}

}  // namespace ew::stitching
