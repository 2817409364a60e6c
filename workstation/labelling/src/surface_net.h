#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ew/labelling/labels.h"

namespace ew::labelling {

/// Directions to the neighbours of a cell, as bits.
enum CellSide : std::uint8_t { kBefore_i = 1, kAfter_i = 2, kBefore_j = 4, kAfter_j = 8, kBefore_k = 16, kAfter_k = 32 };

/// Where the point of a cell lies beside the cell's middle, in voxels; the fourth number is 0 and makes it a vector of the processor.
struct alignas(16) CellOffset {
  float at[4] = {};
};

/// The points between labels and how they hang together. Cell (i, j, k) has the voxels i - 1 to i, j - 1 to j, k - 1 to k at its corners;
/// there are dims + 1 of them along each axis. Cells with more than one label are numbered with i varying fastest; their numbers are called
/// points.
struct SurfaceNet {
  Grid grid;
  glm::ivec3 cells{0};
  std::vector<std::int32_t> rowBegin;  ///< of the row (j, k) of cells the first point; one more than there are rows
  std::vector<std::int32_t> column;    ///< i of each point's cell
  /// The points behind the cell's sides towards +j and +k, where that side holds more than one label; else the point itself. Towards i they
  /// are the ones before and after.
  std::vector<std::array<std::int32_t, 2>> after;
  std::vector<std::array<std::int32_t, 4>> pulls;  ///< towards -j, +j, -k, +k the points it is smoothed by, or itself
  std::vector<std::uint8_t> pullSides;             ///< as CellSide: which those are
  std::vector<CellOffset> offsets;
  std::vector<std::uint8_t> labels;  ///< that occur, ascending, without 0

  [[nodiscard]] std::size_t points() const { return column.size(); }
  [[nodiscard]] std::size_t rowOf(int j, int k) const {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(cells.y) + static_cast<std::size_t>(j);
  }
};

/// Layers of cells that one task works on; results do not depend on who works on it.
inline constexpr int kSlab = 8;
[[nodiscard]] inline int slabsOf(const glm::ivec3& cells) { return (cells.z + kSlab - 1) / kSlab; }

/// Rows of voxels, and of zeros outside of the volume.
class LabelRows {
 public:
  explicit LabelRows(const VolumeView<const std::uint8_t>& labels) : labels_(labels), none_(static_cast<std::size_t>(labels.grid.dims.x)) {}
  [[nodiscard]] const std::uint8_t* at(int j, int k) const {
    const glm::ivec3& dims = labels_.grid.dims;
    return j < 0 || k < 0 || j >= dims.y || k >= dims.z ? none_.data() : labels_.data + labels_.grid.indexOf(0, j, k);
  }
  [[nodiscard]] const Grid& grid() const { return labels_.grid; }

 private:
  VolumeView<const std::uint8_t> labels_;
  std::vector<std::uint8_t> none_;
};

/// How many points each row of cells has. @return false when cancelled
[[nodiscard]] bool countPoints(const LabelRows& rows, int threads, Progress& progress, std::vector<std::int32_t>& ofRow);

/// The net of a volume, all points in the middle of their cells. @return false when cancelled
/// @param ofRow as countPoints gave it; their sum is below 2^30
[[nodiscard]] bool buildNet(const LabelRows& rows, std::vector<std::int32_t> ofRow, int threads, Progress& progress, SurfaceNet& net);

/// How far a point may be from the middle of its cell along each axis, in voxels. A little less than to the cell's side: a point on it
/// would lie on a side of its tetrahedra.
inline constexpr float kOffsetLimit = 0.49F;

/// Smooths the offsets, which are 0 before. @param shortestWave_voxel as in LabelSurfaceOptions. @return false when cancelled
[[nodiscard]] bool relaxNet(SurfaceNet& net, double shortestWave_voxel, int threads, Progress& progress);

}  // namespace ew::labelling
