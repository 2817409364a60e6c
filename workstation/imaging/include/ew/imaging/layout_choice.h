#pragma once

#include <bitset>
#include <glm/glm.hpp>

#include "ew/imaging/knobs.h"

namespace ew {

/// How voxels lie in memory: i, j, k after one another, or in bricks that each fill one line of the cache (resources/decisions/0013 and
/// 0030 have the figures).
enum class VoxelLayout { linear, bricked };

/// What decides from which layout a slice is read faster (decision 0030).
struct SliceClass {
  enum class Meets { few, some, many };
  Quality quality = Quality::weave;
  Meets meets = Meets::few;  ///< rows of voxels (along i) that a sample meets and its neighbours do not: below 0.12, below 0.4, more
  bool alongI = false;       ///< samples follow one another within 45 degrees of i, as the voxels of a row do

  static constexpr std::size_t kCount = 18;
  [[nodiscard]] std::size_t index() const;
  [[nodiscard]] static SliceClass at(std::size_t index);
  bool operator==(const SliceClass&) const = default;
};

/// @param step_voxel    from a sample to the next one of its row
/// @param nextRow_voxel from a sample to the one below it
[[nodiscard]] SliceClass sliceClassOf(Quality quality, const glm::dvec3& step_voxel, const glm::dvec3& nextRow_voxel);

/// The classes that are read from bricks, by SliceClass::index.
using LayoutChoice = std::bitset<SliceClass::kCount>;

}  // namespace ew
