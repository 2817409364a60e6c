#include <algorithm>
#include <cstring>
#include <new>

#include "bricks.h"
#include "ew/core/contract.h"
#include "ew/core/large_pages.h"
#include "ew/core/parallel.h"
#include "ew/core/quiet_progress.h"
#include "ew/imaging/slice_source.h"

namespace ew {
namespace {

using detail::Bricks;

// A kernel's 32 bit offsets reach from a brick into the next slice of bricks.
constexpr std::uint64_t kLargestSlice_bytes = std::uint64_t{1} << 30;

glm::ivec3 halved(const glm::ivec3& dims) { return (dims + 1) / 2; }

Error tooLarge(const glm::ivec3& dims) {
  return {ErrorCode::tooLarge,
          say<"The volume cannot be kept in bricks: %1 MiB of memory are not to be had.">(bricksForecast_bytes(dims, 1) >> 20),
          {}};
}

tl::unexpected<Error> cancelled() { return failure(ErrorCode::cancelled, say<"Stopped as asked.">()); }

/// Copies one slice of bricks.
void fillSlice(const VolumeView<const std::uint8_t>& volume, const Bricks& bricks, std::uint64_t brickK, std::uint8_t* out) {
  const glm::ivec3 last = volume.grid.dims - 1;
  const auto clamped = [](std::uint64_t at, int most) { return std::clamp(static_cast<int>(at), 0, most); };
  for (std::uint64_t brickJ = 0; brickJ < bricks.count[1]; ++brickJ)
    for (std::uint64_t k = 0; k < Bricks::kSlices; ++k)
      for (std::uint64_t j = 0; j < Bricks::kRows; ++j) {
        const std::uint8_t* row = volume.data + volume.grid.indexOf(0, clamped(brickJ * Bricks::kRows + j, last.y),
                                                                    clamped(brickK * Bricks::kSlices + k, last.z));
        std::uint8_t* to = out + brickJ * bricks.stride[1] + (k * Bricks::kRows + j) * Bricks::kStored;
        for (std::uint64_t brickI = 0; brickI < bricks.count[0]; ++brickI, to += Bricks::kBytes) {
          const auto first = static_cast<std::int64_t>(brickI * Bricks::kCells);
          if (first + Bricks::kStored <= volume.grid.dims.x)
            std::memcpy(to, row + first, Bricks::kStored);
          else
            for (int i = 0; i < Bricks::kStored; ++i) to[i] = row[std::clamp<std::int64_t>(first + i, 0, last.x)];
        }
      }
}

/// Means of 2 x 2 x 2 voxels, rounded; beyond an odd end the last voxels count twice.
void halveSlice(const VolumeView<const std::uint8_t>& finer, const glm::ivec3& dims, int k, std::uint8_t* out) {
  const glm::ivec3 last = finer.grid.dims - 1;
  for (int j = 0; j < dims.y; ++j) {
    const auto row = [&](int dj, int dk) {
      return finer.data + finer.grid.indexOf(0, std::min(2 * j + dj, last.y), std::min(2 * k + dk, last.z));
    };
    const std::uint8_t *row00 = row(0, 0), *row10 = row(1, 0), *row01 = row(0, 1), *row11 = row(1, 1);
    for (int i = 0; i < dims.x; ++i) {
      const int a = 2 * i, b = std::min(2 * i + 1, last.x);
      const int sum = row00[a] + row00[b] + row10[a] + row10[b] + row01[a] + row01[b] + row11[a] + row11[b];
      *out++ = static_cast<std::uint8_t>((sum + 4) >> 3);
    }
  }
}

/// The grid of a coarser level: a voxel lies in the middle of those it is the mean of. An axis of one voxel stays as it is.
Grid gridOfLevel(Grid grid, int level) {
  for (int n = 0; n < level; ++n) {
    glm::dvec3 first_voxel(0.0);
    for (int axis = 0; axis < 3; ++axis)
      if (grid.dims[axis] > 1) first_voxel[axis] = 0.5;
    grid.origin_mm = (grid.voxelToWorld() * Point<frame::Voxel>{first_voxel}).at;
    for (int axis = 0; axis < 3; ++axis)
      if (grid.dims[axis] > 1) grid.spacing_mm[axis] *= 2.0;
    grid.dims = halved(grid.dims);
  }
  return grid;
}

}  // namespace

SliceSource BrickVolume::source(const Grid& placed) const { return sourceFor(placed, 0.0); }

SliceSource BrickVolume::sourceFor(const Grid& placed, double pixel_mm) const {
  SliceSource found;
  if (bricks_.empty()) return found;
  EW_EXPECTS(placed.dims == dims_);
  int level = 0;
  found.grid = placed;
  while (level + 1 < levels()) {
    const Grid coarser = gridOfLevel(found.grid, 1);
    if (!(std::max({coarser.spacing_mm.x, coarser.spacing_mm.y, coarser.spacing_mm.z}) <= pixel_mm)) break;
    found.grid = coarser;
    ++level;
  }
  if (level > 0) {
    found.voxels = coarser_[static_cast<std::size_t>(level - 1)].data();
  } else {
    found.voxels = bricks_.data();
    found.layout = VoxelLayout::bricked;
  }
  return found;
}

std::size_t BrickVolume::bytes() const {
  std::size_t sum = bricks_.size();
  for (const auto& level : coarser_) sum += level.size();
  return sum;
}

Result<BrickVolume> bricksOf(const VolumeView<const std::uint8_t>& volume, int levels, int threads, Progress& progress) {
  EW_EXPECTS(levels >= 1 && levels <= 30);
  BrickVolume made;
  if (volume.data == nullptr || volume.grid.voxelCount() == 0) return made;
  made.dims_ = volume.grid.dims;
  try {
    const Bricks bricks(volume.grid.dims);
    if (bricks.stride[2] > kLargestSlice_bytes) return passOn(tooLarge(volume.grid.dims));
    made.bricks_ = zerosInLargePages(bricks.bytes());
    const auto fill = [&](int brickK) {
      const auto at = static_cast<std::uint64_t>(brickK);
      fillSlice(volume, bricks, at, made.bricks_.data() + at * bricks.stride[2]);
    };
    // Coarser levels take an eighth of each other's time, and there is nothing to see after the first.
    PartOfProgress part(progress, 0.0, levels > 1 ? 0.9 : 1.0);
    if (!forEachTask(static_cast<int>(bricks.count[2]), threads, part, say<"Making the volume ready for fast slices">(), fill))
      return cancelled();
    VolumeView<const std::uint8_t> finer = volume;
    for (int level = 1; level < levels; ++level) {
      const Grid grid = gridOfLevel(finer.grid, 1);
      std::vector<std::uint8_t> coarser = zerosInLargePages(grid.voxelCount());
      const auto halve = [&](int k) { halveSlice(finer, grid.dims, k, coarser.data() + grid.indexOf(0, 0, k)); };
      QuietProgress quiet(progress);
      if (!forEachTask(grid.dims.z, threads, quiet, Message(), halve)) return cancelled();
      made.coarser_.push_back(std::move(coarser));
      finer = {made.coarser_.back().data(), grid};
    }
  } catch (const std::bad_alloc&) {
    return passOn(tooLarge(volume.grid.dims));
  }
  return made;
}

std::uint64_t bricksForecast_bytes(const glm::ivec3& dims, int levels) {
  std::uint64_t sum = Bricks(dims).bytes();
  glm::ivec3 size = dims;
  for (int level = 1; level < levels; ++level) {
    size = halved(size);
    sum += static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) * static_cast<std::uint64_t>(size.z);
  }
  return sum;
}

}  // namespace ew
