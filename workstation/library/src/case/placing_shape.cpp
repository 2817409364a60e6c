#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/core/contract.h"
#include "ew/core/order_statistics.h"
#include "ew/library/placing.h"

namespace ew {
namespace {

constexpr double kFaceBand_mm = 12.0;    // behind its foremost point: the arc of a convex face and its tilts, and no more
constexpr double kForemostShare = 0.01;  // lines that may lie before what counts as the foremost: single voxels are noise
constexpr int kLinesAcross = 96;         // of the lattice that looks for the face, each way
constexpr std::size_t kMostFacePoints = 400;
constexpr std::size_t kMostInsidePoints = 600;
constexpr int kRun = 3;  // voxels with data one behind the other that make a face

bool hasData(const Volume& volume, std::size_t index) {
  return volume.coverage.empty() ? volume.echo[index] > 0 : volume.coverageAt(index) != Coverage::absent;
}

std::vector<glm::dvec3> thinned(const std::vector<glm::dvec3>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<glm::dvec3> few;
  const double step = static_cast<double>(all.size()) / static_cast<double>(most);
  for (std::size_t n = 0; n < most; ++n) few.push_back(all[static_cast<std::size_t>((static_cast<double>(n) + 0.5) * step)]);
  return few;
}

/// The box of a grid along the axes of its recording, in mm: x lateral, y depth, z elevational.
struct ProbeBox {
  glm::dmat3 axes{1.0};  // columns: the three directions in the file
  glm::dvec3 lowest_mm{std::numeric_limits<double>::infinity()};
  glm::dvec3 highest_mm{-std::numeric_limits<double>::infinity()};
  [[nodiscard]] glm::dvec3 inFile(const glm::dvec3& p_mm) const { return axes * p_mm; }
};

ProbeBox probeBoxOf(const Grid& grid, const SweepAxes& along) {
  ProbeBox box;
  box.axes = glm::dmat3(along.lateral, along.depth, glm::cross(along.lateral, along.depth));
  const auto voxelToFile = grid.voxelTo<frame::File>();
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 ijk = glm::dvec3(grid.dims - 1) * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 at = glm::transpose(box.axes) * carried(voxelToFile, ijk);
    box.lowest_mm = glm::min(box.lowest_mm, at);
    box.highest_mm = glm::max(box.highest_mm, at);
  }
  return box;
}

/// Depth of the first run of voxels with data along the line through (lateral, elevational); infinity when there is none.
class FirstData {
 public:
  FirstData(const Volume& volume, const ProbeBox& box)
      : volume_(volume), box_(box), fileToVoxel_(volume.grid.toVoxel<frame::File>()), step_mm_(spacingOf(volume.grid)) {}

  [[nodiscard]] double depthAt(double lateral_mm, double elevational_mm) const {
    int run = 0;
    for (double depth_mm = box_.lowest_mm.y; depth_mm <= box_.highest_mm.y; depth_mm += step_mm_) {
      const glm::ivec3 ijk(glm::round(carried(fileToVoxel_, box_.inFile({lateral_mm, depth_mm, elevational_mm}))));
      const bool isData = volume_.grid.contains(ijk) && hasData(volume_, volume_.grid.indexOf(ijk.x, ijk.y, ijk.z));
      run = isData ? run + 1 : 0;
      if (run == kRun) return depth_mm - (kRun - 1) * step_mm_;
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  static double spacingOf(const Grid& grid) { return std::min({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z}); }
  const Volume& volume_;
  const ProbeBox& box_;
  Transform<frame::Voxel, frame::File> fileToVoxel_;
  double step_mm_;
};

double acrossAt(double lowest_mm, double highest_mm, int n) {
  return lowest_mm + (highest_mm - lowest_mm) * (n + 0.5) / static_cast<double>(kLinesAcross);
}

std::vector<glm::dvec3> faceOf(const Volume& volume, const ProbeBox& box) {
  const FirstData first(volume, box);
  std::vector<glm::dvec3> starts;
  std::vector<double> depths_mm;
  for (int z = 0; z < kLinesAcross; ++z)
    for (int x = 0; x < kLinesAcross; ++x) {
      const double lateral_mm = acrossAt(box.lowest_mm.x, box.highest_mm.x, x);
      const double elevational_mm = acrossAt(box.lowest_mm.z, box.highest_mm.z, z);
      const double depth_mm = first.depthAt(lateral_mm, elevational_mm);
      if (std::isinf(depth_mm)) continue;
      starts.emplace_back(lateral_mm, depth_mm, elevational_mm);
      depths_mm.push_back(depth_mm);
    }
  if (starts.empty()) return {};
  const double foremost_mm = valueAtRank(depths_mm, static_cast<std::size_t>(kForemostShare * static_cast<double>(depths_mm.size())));
  std::vector<glm::dvec3> face_mm;
  for (const glm::dvec3& each : starts)
    if (each.y <= foremost_mm + kFaceBand_mm) face_mm.push_back(box.inFile(each));
  return thinned(face_mm, kMostFacePoints);
}

std::vector<glm::dvec3> insideOf(const Volume& volume) {
  const auto voxelToFile = volume.grid.voxelTo<frame::File>();
  const double share = std::cbrt(static_cast<double>(volume.grid.voxelCount()) / (20.0 * static_cast<double>(kMostInsidePoints)));
  const int stride = std::max(1, static_cast<int>(std::lround(share)));
  std::vector<glm::dvec3> points_mm;
  for (int k = stride / 2; k < volume.grid.dims.z; k += stride)
    for (int j = stride / 2; j < volume.grid.dims.y; j += stride)
      for (int i = stride / 2; i < volume.grid.dims.x; i += stride)
        if (hasData(volume, volume.grid.indexOf(i, j, k))) points_mm.push_back(carried(voxelToFile, glm::dvec3(i, j, k)));
  return thinned(points_mm, kMostInsidePoints);
}

}  // namespace

PlacingShape placingShapeOf(const Volume& volume, const SweepAxes& axes) {
  EW_EXPECTS(volume.echo.size() == volume.grid.voxelCount());
  return {axes, faceOf(volume, probeBoxOf(volume.grid, axes)), insideOf(volume)};
}

PlacingShape placingShapeOf(const Grid& grid, const SweepAxes& axes) {
  constexpr int kAcross = 20, kDeep = 6, kWide = 10;
  const ProbeBox box = probeBoxOf(grid, axes);
  PlacingShape shape{axes, {}, {}};
  const auto at = [&](double x, double y, double z) {
    return box.inFile(box.lowest_mm + (box.highest_mm - box.lowest_mm) * glm::dvec3(x, y, z));
  };
  for (int z = 0; z < kAcross; ++z)
    for (int x = 0; x < kAcross; ++x) shape.face_mm.push_back(at((x + 0.5) / kAcross, 0.0, (z + 0.5) / kAcross));
  for (int z = 0; z < kWide; ++z)
    for (int y = 0; y < kDeep; ++y)
      for (int x = 0; x < kWide; ++x) shape.inside_mm.push_back(at((x + 0.5) / kWide, (y + 0.5) / kDeep, (z + 0.5) / kWide));
  return shape;
}

}  // namespace ew
