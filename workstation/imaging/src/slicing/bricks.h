#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace ew::detail {

/// The bricked layout: a brick is one line of the cache, kStored x kRows x kSlices voxels, i fastest. Along i neighbouring bricks share
/// kStored - kCells voxels, so that the four voxels of a cubic row (and the pair of a linear one) are always neighbours in one brick.
/// Around the volume lies a halo that repeats its outermost voxels: one voxel before the first, two after the last along each axis.
struct Bricks {
  static constexpr int kStored = 16, kCells = 13, kRows = 2, kSlices = 2;
  static constexpr int kBytes = kStored * kRows * kSlices;
  static constexpr int kBefore = 1, kAfter = 2;
  static constexpr int kRowBits = kRows == 1 ? 0 : kRows == 2 ? 1 : 2, kSliceBits = kSlices == 1 ? 0 : kSlices == 2 ? 1 : 2;
  static constexpr std::uint32_t kLastRow = kRows - 1, kLastSlice = kSlices - 1;
  static_assert(kBytes == 64 && kStored - kCells >= 3);

  std::array<std::uint64_t, 3> count{};   ///< of bricks along i, j, k
  std::array<std::uint64_t, 3> stride{};  ///< bytes from a brick to the next along i, j, k

  explicit Bricks(const glm::ivec3& dims) {
    const auto bricks = [&](int axis, int per) {
      return (static_cast<std::uint64_t>(dims[axis]) + kBefore + kAfter - 1) / static_cast<std::uint64_t>(per) + 1;
    };
    count = {bricks(0, kCells), bricks(1, kRows), bricks(2, kSlices)};
    stride = {kBytes, kBytes * count[0], kBytes * count[0] * count[1]};
  }
  [[nodiscard]] std::uint64_t bytes() const { return stride[2] * count[2]; }

  /// Bytes from the first brick to voxel index `n` along an axis, halo included: n >= -kBefore.
  [[nodiscard]] static std::uint64_t offsetAlong(std::size_t axis, std::int64_t n, const std::array<std::uint64_t, 3>& stride) {
    const auto at = static_cast<std::uint64_t>(n + kBefore);
    if (axis == 0) return at / kCells * stride[0] + at % kCells;
    if (axis == 1) return at / kRows * stride[1] + at % kRows * kStored;
    return at / kSlices * stride[2] + at % kSlices * (kStored * kRows);
  }
  /// The first voxel index of the brick that holds `n` along an axis.
  [[nodiscard]] static std::int64_t brickBegin(std::size_t axis, std::int64_t n) {
    const std::int64_t per = axis == 0 ? kCells : axis == 1 ? kRows : kSlices;
    return (n + kBefore) / per * per - kBefore;
  }
};

}  // namespace ew::detail
