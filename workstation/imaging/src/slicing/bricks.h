#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace ew::detail {

/// The bricked layout: a brick is one line of the cache, kStored x kRows x kSlices voxels, i fastest. Along i neighbouring bricks share
/// three voxels, so that the two or four of a row that a sample reads always lie in one brick. Beyond the last voxel along each axis it is
/// repeated once.
struct Bricks {
  static constexpr int kStored = 16, kCells = 13, kRows = 2, kSlices = 2;
  static constexpr int kBytes = kStored * kRows * kSlices;
  static constexpr int kRowBytes = kStored, kSliceBytes = kStored * kRows;
  static constexpr int kAfter = 1;
  static_assert(kBytes == 64 && kStored - kCells == 3);

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
    if (axis == 1) return at / kRows * stride[1] + at % kRows * kRowBytes;
    return at / kSlices * stride[2] + at % kSlices * kSliceBytes;
  }
  /// The first voxel index of the brick that holds `n` along an axis.
  [[nodiscard]] static std::int64_t brickBegin(std::size_t axis, std::int64_t n) {
    const std::int64_t per = axis == 0 ? kCells : axis == 1 ? kRows : kSlices;
    return n / per * per;
  }
};

}  // namespace ew::detail
