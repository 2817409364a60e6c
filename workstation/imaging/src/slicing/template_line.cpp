#include "template_line.h"

#include <algorithm>
#include <cmath>

#include "bricks.h"
#include "row_kernels.h"

namespace ew::detail {
namespace {

// Three terms of 2^30 voxels with 31 fraction bits stay below 2^63.
constexpr double kFarthest_voxel = 1073741824.0;

std::int64_t fixed(double voxel) { return std::llrint(voxel * static_cast<double>(kOneVoxel)); }

}  // namespace

bool isInRange(const glm::dvec3& p_voxel) {
  // Written so that NaN is out of range.
  return std::abs(p_voxel.x) <= kFarthest_voxel && std::abs(p_voxel.y) <= kFarthest_voxel && std::abs(p_voxel.z) <= kFarthest_voxel;
}

FixedPosition fixedPosition(const glm::dvec3& p_voxel) { return {fixed(p_voxel.x), fixed(p_voxel.y), fixed(p_voxel.z)}; }

TemplateLine layTemplate(const SliceSource& source, const glm::dvec3& step_voxel, int width, SliceScratch& scratch) {
  TemplateLine line;
  line.dims = source.grid.dims;
  line.layout = source.layout;
  line.voxels = source.voxels;
  line.step_voxel = step_voxel;
  const bool hasVoxels = line.voxels != nullptr && line.dims.x > 0 && line.dims.y > 0 && line.dims.z > 0;
  line.empty = !hasVoxels || width < 1 || !isInRange(step_voxel * static_cast<double>(width));
  if (line.empty) return line;

  if (line.layout == VoxelLayout::bricked) {
    line.stride = Bricks(line.dims).stride;
  } else {
    const auto nx = static_cast<std::uint64_t>(line.dims.x), ny = static_cast<std::uint64_t>(line.dims.y);
    line.stride = {1, nx, nx * ny};
  }

  constexpr std::size_t kEntries = kBlock + kLanesAtMost;
  scratch.templateLine.resize(7 * kEntries);
  const int count = std::min(width, kBlock);
  for (std::size_t a = 0; a < 3; ++a) {
    std::uint32_t* whole = scratch.templateLine.data() + 2 * a * kEntries;
    std::uint32_t* fraction = whole + kEntries;
    const double step = step_voxel[static_cast<int>(a)] * static_cast<double>(kOneVoxel);
    const double high = std::nearbyint(step);
    fillTemplate(static_cast<std::int64_t>(high), static_cast<std::int32_t>(std::lrint((step - high) * 65536.0)), count, whole, fraction);
    line.whole[a] = whole;
    line.fraction[a] = fraction;
    line.samplesPerUnit[a] = 1.0 / step;
  }
  if (line.layout == VoxelLayout::linear) {
    std::uint32_t* offset = scratch.templateLine.data() + 6 * kEntries;
    fillOffsets(line.whole, line.stride, count, offset);
    line.offset = offset;
  }
  return line;
}

}  // namespace ew::detail
