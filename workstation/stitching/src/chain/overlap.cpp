#include "chain/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "chain/pair_match.h"

namespace ew::stitching {
namespace {

constexpr double kSample_mm = 3.0;

/// The voxels of `own` that can lie in the box of `other`.
VoxelBox reached(const Grid& own, const Grid& other, const Transform<frame::Voxel, frame::Voxel>& otherVoxelToOwnVoxel) {
  glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 last = other.dims - 1;
    const glm::dvec3 at =
        carried(otherVoxelToOwnVoxel, glm::dvec3((corner & 1) * last.x, ((corner >> 1) & 1) * last.y, (corner >> 2) * last.z));
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  const glm::dvec3 limit(own.dims);
  const VoxelBox box{glm::ivec3(glm::floor(glm::clamp(low, glm::dvec3(0.0), limit))),
                     glm::ivec3(glm::ceil(glm::clamp(high + 1.0, glm::dvec3(0.0), limit)))};
  if (glm::any(glm::lessThanEqual(box.size(), glm::ivec3(0)))) return {};
  return box;
}

template <class Value>
std::vector<Value> cut(const std::vector<Value>& values, const Grid& grid, const VoxelBox& box) {
  std::vector<Value> part;
  if (values.empty()) return part;
  part.reserve(gridOf(grid, box).voxelCount());
  for (int k = box.begin.z; k < box.end.z; ++k)
    for (int j = box.begin.y; j < box.end.y; ++j) {
      const auto row = values.begin() + static_cast<std::ptrdiff_t>(grid.indexOf(box.begin.x, j, k));
      part.insert(part.end(), row, row + box.size().x);
    }
  return part;
}

}  // namespace

std::optional<Overlap> overlapOf(const Volume& fixed, const Volume& moving, const Transform<frame::Moving, frame::Fixed>& fixedToMoving) {
  const Grid& grid = fixed.grid;
  const auto toFixed = grid.voxelTo<frame::Fixed>();
  const auto toMoving = moving.grid.toVoxel<frame::Moving>() * fixedToMoving * toFixed;
  glm::ivec3 step(1);
  for (int axis = 0; axis < 3; ++axis) step[axis] = std::max(1, static_cast<int>(kSample_mm / grid.spacing_mm[axis]));
  // What lies between the places that are looked at may belong to it.
  const glm::ivec3 beside = step - 1;
  glm::ivec3 besideThere;
  for (int axis = 0; axis < 3; ++axis) besideThere[axis] = static_cast<int>(std::ceil(kSample_mm / moving.grid.spacing_mm[axis]));
  glm::dvec3 sum(0.0);
  std::size_t count = 0;
  VoxelBox in{grid.dims, glm::ivec3(0)}, there{moving.grid.dims, glm::ivec3(0)};
  for (int k = 0; k < grid.dims.z; k += step.z)
    for (int j = 0; j < grid.dims.y; j += step.y)
      for (int i = 0; i < grid.dims.x; i += step.x) {
        if (fixed.coverageAt(grid.indexOf(i, j, k)) == Coverage::absent) continue;
        const glm::ivec3 voxel(i, j, k);
        const glm::ivec3 other(glm::floor(carried(toMoving, glm::dvec3(voxel)) + 0.5));
        if (!moving.grid.contains(other) || moving.coverageAt(moving.grid.indexOf(other.x, other.y, other.z)) == Coverage::absent) continue;
        sum += glm::dvec3(voxel);
        ++count;
        in.begin = glm::min(in.begin, voxel - beside);
        in.end = glm::max(in.end, voxel + beside + 1);
        there.begin = glm::min(there.begin, other - besideThere);
        there.end = glm::max(there.end, other + besideThere + 1);
      }
  if (count == 0) return std::nullopt;
  in = {glm::max(in.begin, glm::ivec3(0)), glm::min(in.end, grid.dims)};
  there = {glm::max(there.begin, glm::ivec3(0)), glm::min(there.end, moving.grid.dims)};
  return Overlap{carried(toFixed, sum / static_cast<double>(count)), in, there};
}

VoxelBox widened(const VoxelBox& box, const Grid& grid, double by_mm) {
  const glm::ivec3 by(glm::ceil(by_mm / grid.spacing_mm));
  return {glm::max(box.begin - by, glm::ivec3(0)), glm::min(box.end + by, grid.dims)};
}

std::pair<VoxelBox, VoxelBox> sharedBoxes(const Grid& fixed, const Grid& moving,
                                          const Transform<frame::Moving, frame::Fixed>& fixedToMoving, double by_mm) {
  const auto there = moving.toVoxel<frame::Moving>() * fixedToMoving * fixed.voxelTo<frame::Fixed>();
  const VoxelBox in = reached(fixed, moving, inverse(there)), on = reached(moving, fixed, there);
  if (in.size() == glm::ivec3(0) || on.size() == glm::ivec3(0)) return {};
  return {widened(in, fixed, by_mm + kSample_mm), widened(on, moving, by_mm + kSample_mm)};
}

bool boxesMeet(const Grid& a, const Grid& b, double margin_mm) {
  const glm::dvec3 apart = middleOf(b) - middleOf(a);
  const auto reach = [margin_mm](const Grid& grid, const glm::dvec3& axis) {
    double sum = margin_mm;
    for (int d = 0; d < 3; ++d) sum += std::abs(glm::dot(axis, grid.directions[d])) * 0.5 * (grid.dims[d] - 1) * grid.spacing_mm[d];
    return sum;
  };
  const auto parted = [&](const glm::dvec3& axis) {
    const double length = glm::length(axis);
    if (length < 1e-9) return false;
    const glm::dvec3 unit = axis / length;
    return std::abs(glm::dot(apart, unit)) > reach(a, unit) + reach(b, unit);
  };
  for (int d = 0; d < 3; ++d) {
    if (parted(a.directions[d]) || parted(b.directions[d])) return false;
    for (int e = 0; e < 3; ++e)
      if (parted(glm::cross(a.directions[d], b.directions[e]))) return false;
  }
  return true;
}

Grid gridOf(const Grid& grid, const VoxelBox& box) {
  Grid part = grid;
  part.dims = box.size();
  part.origin_mm = carried(grid.voxelToWorld(), glm::dvec3(box.begin));
  return part;
}

PartOfView partOf(const ViewData& view, const VoxelBox& box) {
  const Volume& whole = *view.volume;
  PartOfView part;
  part.volume.grid = gridOf(whole.grid, box);
  part.volume.echo = cut(whole.echo, whole.grid, box);
  part.volume.coverage = cut(whole.coverage, whole.grid, box);
  const std::vector<std::uint8_t> bytes = cut(view.confidence, whole.grid, box);
  part.confidence.resize(bytes.size());
  std::transform(bytes.begin(), bytes.end(), part.confidence.begin(), [](std::uint8_t c) { return static_cast<float>(c) / 255.0F; });
  part.beams = view.beams;
  return part;
}

}  // namespace ew::stitching
