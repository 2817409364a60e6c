#pragma once

#include <optional>
#include <vector>

#include "view_sampler.h"

namespace ew::stitching {

/// Seams are sought on cells: bricks of ratio.x * ratio.y * ratio.z voxels of the result, the last of a row cut off.
[[nodiscard]] glm::ivec3 cellRatio(const Grid& result, double cell_mm);
[[nodiscard]] Grid cellGrid(const Grid& result, const glm::ivec3& ratio);
/// The ratio of cells that were made for this result; empty when they belong to another.
[[nodiscard]] std::optional<glm::ivec3> ratioOf(const Grid& cells, const Grid& result);

/// A box of cells, first and one past the last.
struct CellBox {
  glm::ivec3 begin{0};
  glm::ivec3 end{0};
  [[nodiscard]] glm::ivec3 size() const { return glm::max(end - begin, glm::ivec3(0)); }
  [[nodiscard]] std::size_t count() const { return samplesIn(size()); }
  [[nodiscard]] std::size_t indexOf(int i, int j, int k) const { return sampleIndex(size(), i - begin.x, j - begin.y, k - begin.z); }
  [[nodiscard]] bool contains(int i, int j, int k) const {
    return i >= begin.x && j >= begin.y && k >= begin.z && i < end.x && j < end.y && k < end.z;
  }
};

/// What a view shows in a cell: up to two voxels of the result along each axis are looked at.
struct CellLook {
  float share = 0.0F;  ///< of the looks that met a covered voxel
  float level = 0.0F;  ///< mean over these
  float trust = 0.0F;  ///< mean over all looks of confidence, an interpolated voxel counting three quarters, an absent one nothing
};

/// Looks at a row of cells [begin, end) x (j, k).
void lookAlongCells(const ViewSampler& view, const glm::ivec3& ratio, int j, int k, int begin, int end, CellLook* looks);

/// Mean over a box of +-reach cells (a fraction of a cell at its ends) of values on `box`, taps outside `box` left out of the sum. Each
/// value depends on its neighbours alone, to the last bit.
void boxSum(std::vector<float>& values, const CellBox& box, const glm::dvec3& reach_cells, std::vector<float>& scratch);

}  // namespace ew::stitching
