#include "ew/imaging/layout_choice.h"

#include <cmath>

#include "ew/imaging/slice_source.h"

namespace ew {
namespace {

constexpr std::size_t kWays = 6;  ///< classes of one quality

}  // namespace

std::size_t SliceClass::index() const {
  return kWays * static_cast<std::size_t>(quality) + 2 * static_cast<std::size_t>(meets) + (alongI ? 1 : 0);
}

SliceClass SliceClass::at(std::size_t index) {
  return {static_cast<Quality>(index / kWays), static_cast<Meets>(index % kWays / 2), index % 2 == 1};
}

SliceClass sliceClassOf(Quality quality, const glm::dvec3& step_voxel, const glm::dvec3& nextRow_voxel) {
  // The area of a sample seen along i. A line of the cache is one voxel high and wide and 64 long, so this is nearly the number of lines.
  const double met = std::abs(step_voxel.y * nextRow_voxel.z - step_voxel.z * nextRow_voxel.y);
  const SliceClass::Meets meets = met < 0.12 ? SliceClass::Meets::few : met < 0.4 ? SliceClass::Meets::some : SliceClass::Meets::many;
  return {quality, meets, std::abs(step_voxel.x) >= std::hypot(step_voxel.y, step_voxel.z)};
}

SliceSource SliceSource::inLayoutFor(const SliceClass& slice) const {
  SliceSource chosen = *this;
  chosen.bricks = nullptr;
  if (bricks != nullptr && choice.test(slice.index())) {
    chosen.voxels = bricks;
    chosen.layout = VoxelLayout::bricked;
  }
  return chosen;
}

SliceSource inBothLayouts(const VolumeView<const std::uint8_t>& rows, const BrickVolume& bricks, const LayoutChoice& choice) {
  SliceSource both = rows;
  both.bricks = bricks.source(rows.grid).voxels;
  both.choice = choice;
  return both;
}

}  // namespace ew
