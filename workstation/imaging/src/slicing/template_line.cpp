#include "template_line.h"

#include <algorithm>
#include <cmath>

namespace ew::detail {
namespace {

// Three terms of 2^30 voxels with 31 fraction bits stay below 2^63.
constexpr double kFarthest_voxel = 1073741824.0;

std::int64_t fixed(double voxel) { return std::llrint(voxel * static_cast<double>(kOneVoxel)); }

bool isInRange(const glm::dvec3& v) {
  // Written so that NaN is out of range.
  return std::abs(v.x) <= kFarthest_voxel && std::abs(v.y) <= kFarthest_voxel && std::abs(v.z) <= kFarthest_voxel;
}

}  // namespace

FixedPosition TemplateLine::base(int y) const {
  const glm::dvec3 at = origin_voxel + static_cast<double>(y) * acrossRows_voxel;
  return {fixed(at.x), fixed(at.y), fixed(at.z)};
}

TemplateLine layTemplate(const SliceSource& source, const glm::dvec3& origin_voxel, const glm::dvec3& alongRow_voxel,
                         const glm::dvec3& acrossRows_voxel, int width, int height, SliceScratch& scratch) {
  TemplateLine line;
  line.voxels = source.voxels;
  line.dims = source.grid.dims;
  line.origin_voxel = origin_voxel;
  line.alongRow_voxel = alongRow_voxel;
  line.acrossRows_voxel = acrossRows_voxel;
  const bool hasVoxels = source.voxels != nullptr && line.dims.x > 0 && line.dims.y > 0 && line.dims.z > 0;
  line.empty = !hasVoxels || width < 1 || height < 1 || !isInRange(origin_voxel) ||
               !isInRange(alongRow_voxel * static_cast<double>(width)) || !isInRange(acrossRows_voxel * static_cast<double>(height));
  if (line.empty) return line;

  const auto nx = static_cast<std::uint64_t>(line.dims.x);
  const auto ny = static_cast<std::uint64_t>(line.dims.y);
  line.stride = {line.dims.x > 1 ? 1U : 0U, line.dims.y > 1 ? nx : 0U, line.dims.z > 1 ? nx * ny : 0U};
  line.needsLongOffsets = source.grid.voxelCount() > 0xffffffffULL;

  const auto count = static_cast<std::size_t>(width);
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    auto& position = scratch.templatePosition[a];
    auto& fraction = scratch.templateFraction[a];
    position.resize(count);
    fraction.resize(count);
    for (std::size_t x = 0; x < count; ++x) {
      // Each entry from its own product: stepping would add up the rounding of the step.
      position[x] = fixed(static_cast<double>(x) * alongRow_voxel[axis]);
      fraction[x] = static_cast<std::int32_t>(static_cast<std::uint64_t>(position[x]) & kFractionMask);
    }
  }
  const auto offsetOf = [&](std::size_t x) {
    std::uint64_t offset = 0;
    for (std::size_t a = 0; a < 3; ++a)
      offset += static_cast<std::uint64_t>(scratch.templatePosition[a][x] >> kFractionBits) * line.stride[a];
    return offset;
  };
  if (line.needsLongOffsets) {
    scratch.longTemplateOffset.resize(count);
    for (std::size_t x = 0; x < count; ++x) scratch.longTemplateOffset[x] = offsetOf(x);
  } else {
    scratch.templateOffset.resize(count);
    for (std::size_t x = 0; x < count; ++x) scratch.templateOffset[x] = static_cast<std::uint32_t>(offsetOf(x));
  }
  return line;
}

namespace {

/// First x of [begin, end) with reached(x), which is false up to some x and true from there on; `guess` is near it.
template <class Reached>
int firstWhere(int begin, int end, double guess, Reached reached) {
  int x = begin;
  if (guess > static_cast<double>(begin)) x = guess < static_cast<double>(end) ? static_cast<int>(guess) : end;
  while (x < end && !reached(x)) ++x;
  while (x > begin && reached(x - 1)) --x;
  return x;
}

}  // namespace

RowSpan clipRow(const TemplateLine& line, const SliceScratch& scratch, const FixedPosition& base, RowSpan within,
                const FixedPosition& lowest, const FixedPosition& highest) {
  for (std::size_t axis = 0; axis < 3 && within.begin < within.end; ++axis) {
    const std::int64_t* position = scratch.templatePosition[axis].data();
    const std::int64_t low = lowest[axis] - base[axis];
    const std::int64_t high = highest[axis] - base[axis];
    const std::int64_t first = position[within.begin];
    const std::int64_t last = position[within.end - 1];
    if (low > high || std::max(first, last) < low || std::min(first, last) > high) return {};
    if (std::min(first, last) >= low && std::max(first, last) <= high) continue;
    const double step = line.alongRow_voxel[static_cast<int>(axis)] * static_cast<double>(kOneVoxel);
    const double toLow = static_cast<double>(low) / step;
    const double toHigh = static_cast<double>(high) / step;
    if (first < last) {
      within.begin = firstWhere(within.begin, within.end, toLow, [&](int x) { return position[x] >= low; });
      within.end = firstWhere(within.begin, within.end, toHigh, [&](int x) { return position[x] > high; });
    } else {
      within.begin = firstWhere(within.begin, within.end, toHigh, [&](int x) { return position[x] <= high; });
      within.end = firstWhere(within.begin, within.end, toLow, [&](int x) { return position[x] < low; });
    }
  }
  return within.begin < within.end ? within : RowSpan{};
}

}  // namespace ew::detail
