#include "ew/labelling/labels.h"

#include "contour.h"
#include "ew/core/contract.h"
#include "voxel_boxes.h"

namespace ew::labelling {

VoxelBox joined(const VoxelBox& a, const VoxelBox& b) {
  if (a.empty()) return b.empty() ? VoxelBox{} : b;
  if (b.empty()) return a;
  return {glm::min(a.first, b.first), glm::max(a.end, b.end)};
}

Grid labelGridFor(const Grid& volume, std::size_t mostVoxels) {
  EW_EXPECTS(volume.voxelCount() > 0 && mostVoxels > 0);
  const glm::dvec3 extent_mm = glm::dvec3(volume.dims) * volume.spacing_mm;
  const double coarse_mm = std::cbrt(extent_mm.x * extent_mm.y * extent_mm.z / static_cast<double>(mostVoxels));
  double spacing_mm = std::max(coarse_mm, std::min({volume.spacing_mm.x, volume.spacing_mm.y, volume.spacing_mm.z}));
  Grid grid = volume;
  // Rounding up may go beyond what is allowed.
  for (;; spacing_mm *= 1.02) {
    grid.dims = glm::max(glm::ivec3(glm::ceil(extent_mm / spacing_mm - 1e-6)), glm::ivec3(1));
    if (grid.voxelCount() <= mostVoxels || grid.dims == glm::ivec3(1)) break;
  }
  grid.spacing_mm = glm::dvec3(spacing_mm);
  // The middle stays where it is.
  grid.origin_mm = glm::dvec3(0.0);
  grid.origin_mm = middleOf(volume) - middleOf(grid);
  return grid;
}

VoxelBox paintBall(Volume& labels, std::span<const glm::dvec3> path, double radius_mm, const Brush& brush) {
  EW_EXPECTS(!path.empty() && radius_mm >= 0.0);
  const auto toVoxel = labels.grid.toVoxel<frame::File>();
  const glm::dvec3 reach = radius_mm * voxelsPerMm(labels.grid);
  VoxelBox changed;
  // Piece by piece: the box of a long stroke holds far more than the stroke.
  for (std::size_t n = 0; n < std::max<std::size_t>(1, path.size() - 1); ++n) {
    const glm::dvec3 &a = path[n], &b = path[std::min(n + 1, path.size() - 1)];
    const glm::dvec3 ends[] = {carried(toVoxel, a), carried(toVoxel, b)};
    changed = joined(changed, put(labels, boxAround(ends, reach, labels.grid), brush,
                                  [&](const glm::dvec3& at_mm) { return toSegment_mm(at_mm, a, b) <= radius_mm; }));
  }
  return changed;
}

VoxelBox paintDisc(Volume& labels, const Transform<frame::File, frame::Probe>& planeToFile, std::span<const glm::dvec2> path,
                   double radius_mm, double halfThickness_mm, const Brush& brush) {
  EW_EXPECTS(!path.empty() && radius_mm >= 0.0 && halfThickness_mm >= 0.0);
  const auto toVoxel = labels.grid.toVoxel<frame::File>() * planeToFile;
  const auto toPlane = rigidInverse(planeToFile);
  const glm::dvec3 reach = std::hypot(radius_mm, halfThickness_mm) * voxelsPerMm(labels.grid);
  VoxelBox changed;
  for (std::size_t n = 0; n < std::max<std::size_t>(1, path.size() - 1); ++n) {
    const glm::dvec2 &a = path[n], &b = path[std::min(n + 1, path.size() - 1)];
    const glm::dvec3 ends[] = {carried(toVoxel, {a, 0.0}), carried(toVoxel, {b, 0.0})};
    changed = joined(changed, put(labels, boxAround(ends, reach, labels.grid), brush, [&](const glm::dvec3& at_mm) {
                       const glm::dvec3 p = carried(toPlane, at_mm);
                       return std::abs(p.z) <= halfThickness_mm && toSegment_mm(glm::dvec2(p), a, b) <= radius_mm;
                     }));
  }
  return changed;
}

double thinnestHalf_mm(const Grid& grid) { return 0.5 * glm::length(grid.spacing_mm); }

std::size_t voxelsOf(const Volume& labels, std::uint8_t label) {
  return static_cast<std::size_t>(std::count(labels.echo.begin(), labels.echo.end(), label));
}

double volume_ml(const Volume& labels, std::uint8_t label) {
  const double voxel_mm3 = std::abs(glm::determinant(glm::dmat3(labels.grid.voxelToWorld().matrix)));
  return static_cast<double>(voxelsOf(labels, label)) * voxel_mm3 * 1e-3;
}

VoxelBox boxOf(const Volume& labels, std::uint8_t label) {
  VoxelBox box;
  const Grid& grid = labels.grid;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j) {
      const std::uint8_t* row = labels.echo.data() + grid.indexOf(0, j, k);
      const std::uint8_t* const end = row + grid.dims.x;
      const std::uint8_t* const first = std::find(row, end, label);
      if (first == end) continue;
      const std::uint8_t* last = end;
      while (*(last - 1) != label) --last;
      box = joined(box, {{first - row, j, k}, {last - row, j + 1, k + 1}});
    }
  return box;
}

}  // namespace ew::labelling
