#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace ew::detail {

/// The bricked layout: a brick is one line of the cache, kStored x kRows x kSlices voxels, i fastest. Along i neighbouring bricks share a
/// voxel, so that the pair of a linear row always lies in one brick. Beyond the last voxel along each axis it is repeated once.
struct Bricks {
  static constexpr int kStored = 4, kCells = 3, kRows = 4, kSlices = 4;
  static constexpr int kBytes = kStored * kRows * kSlices;
  static constexpr int kAfter = 1;
  static constexpr int kRowBits = 2, kSliceBits = 2;
  static constexpr std::uint32_t kLastRow = kRows - 1, kLastSlice = kSlices - 1;
  static_assert(kBytes == 64 && kStored - kCells == 1 && kRows == 1 << kRowBits && kSlices == 1 << kSliceBits);

  std::array<std::uint64_t, 3> count{};   ///< of bricks along i, j, k
  std::array<std::uint64_t, 3> stride{};  ///< bytes from a brick to the next along i, j, k

  explicit Bricks(const glm::ivec3& dims) {
    const auto bricks = [&](int axis, int per) {
      return (static_cast<std::uint64_t>(dims[axis]) + kAfter - 1) / static_cast<std::uint64_t>(per) + 1;
    };
    count = {bricks(0, kCells), bricks(1, kRows), bricks(2, kSlices)};
    stride = {kBytes, kBytes * count[0], kBytes * count[0] * count[1]};
  }
  [[nodiscard]] std::uint64_t bytes() const { return stride[2] * count[2]; }

  /// Bytes from the first brick to voxel index `n` >= 0 along an axis.
  [[nodiscard]] static std::uint64_t offsetAlong(std::size_t axis, std::int64_t n, const std::array<std::uint64_t, 3>& stride) {
    const auto at = static_cast<std::uint64_t>(n);
    if (axis == 0) return at / kCells * stride[0] + at % kCells;
    if (axis == 1) return at / kRows * stride[1] + at % kRows * kStored;
    return at / kSlices * stride[2] + at % kSlices * (kStored * kRows);
  }
  /// The first voxel index of the brick that holds `n` along an axis.
  [[nodiscard]] static std::int64_t brickBegin(std::size_t axis, std::int64_t n) {
    const std::int64_t per = axis == 0 ? kCells : axis == 1 ? kRows : kSlices;
    return n / per * per;
  }
};

}  // namespace ew::detail
