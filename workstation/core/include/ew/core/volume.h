#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <iosfwd>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/result.h"

namespace ew {

/// How many samples a block of this size has.
[[nodiscard]] inline std::size_t samplesIn(const glm::ivec3& size) {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
}
/// Where the sample (i, j, k) of a block of this size lies among them, i varying fastest.
[[nodiscard]] inline std::size_t sampleIndex(const glm::ivec3& size, int i, int j, int k) {
  return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(j)) * static_cast<std::size_t>(size.x) +
         static_cast<std::size_t>(i);
}

/// Where the voxels of a volume lie in the world.
struct Grid {
  glm::ivec3 dims{0};          ///< voxels along i, j, k; each > 0 in a usable grid
  glm::dvec3 spacing_mm{1.0};  ///< > 0
  glm::dvec3 origin_mm{0.0};   ///< centre of voxel (0, 0, 0) in the world (LPS)
  glm::dmat3 directions{1.0};  ///< columns: unit vectors of i, j, k in the world (LPS); may be left-handed or oblique

  bool operator==(const Grid&) const = default;

  [[nodiscard]] std::size_t voxelCount() const { return samplesIn(dims); }
  [[nodiscard]] std::size_t indexOf(int i, int j, int k) const { return sampleIndex(dims, i, j, k); }
  [[nodiscard]] bool contains(const glm::ivec3& ijk) const {
    return ijk.x >= 0 && ijk.y >= 0 && ijk.z >= 0 && ijk.x < dims.x && ijk.y < dims.y && ijk.z < dims.z;
  }
  [[nodiscard]] Transform<frame::World, frame::Voxel> voxelToWorld() const;
  [[nodiscard]] Transform<frame::Voxel, frame::World> worldToVoxel() const { return inverse(voxelToWorld()); }
  /// The same of a grid that is not placed yet, by the name its own frame has: File, View, Fixed or Moving.
  template <class Own>
  [[nodiscard]] Transform<Own, frame::Voxel> voxelTo() const {
    return renamed<Own, frame::Voxel>(voxelToWorld());
  }
  template <class Own>
  [[nodiscard]] Transform<frame::Voxel, Own> toVoxel() const {
    return renamed<frame::Voxel, Own>(worldToVoxel());
  }
};
std::ostream& operator<<(std::ostream& out, const Grid& grid);

/// The grid moved by a rigid transform: what a case's placement does to a volume.
[[nodiscard]] Grid placed(const Grid& grid, const Transform<frame::World, frame::File>& fileToWorld);
template <class Own>
[[nodiscard]] Grid placed(const Grid& grid, const Transform<frame::World, Own>& ownToWorld) {
  return placed(grid, renamed<frame::World, frame::File>(ownToWorld));
}

/// Centre of a grid, in its own mm.
[[nodiscard]] inline glm::dvec3 middleOf(const Grid& grid) { return carried(grid.voxelToWorld(), 0.5 * (glm::dvec3(grid.dims) - 1.0)); }

/// World-aligned corners (smallest, largest) of the box around all voxel centres.
struct Bounds {
  glm::dvec3 lowest_mm{0.0};
  glm::dvec3 highest_mm{0.0};
};
[[nodiscard]] Bounds boundsOf(const Grid& grid);

/// Why a grid cannot be used, or success.
/// @error emptyVolume (a dimension below 1), tooLarge (more than 2^40 voxels), badField (spacing or directions)
[[nodiscard]] Result<void> checkGrid(const Grid& grid);

/// What is known about a voxel.
enum class Coverage : std::uint8_t { absent = 0, interpolated = 1, measured = 2 };

/// A window onto voxels someone else owns, i fastest, then j, then k, without padding.
template <class T>
struct VolumeView {
  T* data = nullptr;
  Grid grid;
  operator VolumeView<const T>() const { return {data, grid}; }
};

/// Echo levels (dynamic range already compressed to 8 bits) on a grid, and per voxel whether they were measured.
struct Volume {
  Grid grid;
  std::vector<std::uint8_t> echo;  ///< voxelCount() values
  std::vector<std::uint8_t>
      coverage;  ///< voxelCount() values of Coverage, or empty when nothing is known: then every voxel counts as measured

  [[nodiscard]] VolumeView<const std::uint8_t> view() const { return {echo.data(), grid}; }
  [[nodiscard]] Coverage coverageAt(std::size_t index) const {
    return coverage.empty() ? Coverage::measured : static_cast<Coverage>(coverage[index]);
  }
  bool operator==(const Volume&) const = default;
};

}  // namespace ew
