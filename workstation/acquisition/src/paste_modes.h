#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "ew/acquisition/reconstruct.h"
#include "paste_rows.h"

namespace ew::paste {

/// Voxel coordinates with 40 bits after the point: 22 bits remain for the index, and stepping along a row is exact integer arithmetic, so a
/// row cut at a brick's border lands on the same voxels as the whole row.
inline constexpr int kFractionBits = 40;
inline constexpr std::int64_t kOneVoxel = std::int64_t{1} << kFractionBits;
inline constexpr double kMeasuredWeight = 1e-9;

/// One piece of a row: fixed-point position of its first pixel relative to the first cell of a brick, and the step to the next pixel.
struct Walk {
  std::int64_t at[3];
  std::int64_t step[3];
  const std::uint8_t* pixels;
  const std::uint8_t* weights;  ///< null: all are 255
  int count;
  std::uint16_t source;  ///< 1 + number of the frame
};

/// Cells of a brick: the sums of its voxels, a guard of one cell around it for the linear modes, rows padded to whole blocks.
template <class Cell>
struct Cells {
  Cell* cells;
  std::uint8_t* touched;  ///< one flag for each block of kBlock cells a pixel's first cell fell into
  std::ptrdiff_t rowStride;
  std::ptrdiff_t layerStride;
};
inline constexpr int kBlockBits = 5;
inline constexpr int kBlock = 1 << kBlockBits;

template <class Cell, class Put>
inline void walkNearest(const Walk& walk, const Cells<Cell>& brick, const Put& put) {
  std::int64_t x = walk.at[0], y = walk.at[1], z = walk.at[2];
  for (int n = 0; n < walk.count; ++n) {
    const std::ptrdiff_t cell = (z >> kFractionBits) * brick.layerStride + (y >> kFractionBits) * brick.rowStride + (x >> kFractionBits);
    put(brick.cells[cell], n);
    brick.touched[cell >> kBlockBits] = 1;
    x += walk.step[0];
    y += walk.step[1];
    z += walk.step[2];
  }
}

template <class Cell, class Put>
inline void walkLinear(const Walk& walk, const Cells<Cell>& brick, const Put& put) {
  constexpr double kPerUnit = 1.0 / static_cast<double>(kOneVoxel);
  constexpr std::int64_t kFraction = kOneVoxel - 1;
  std::int64_t x = walk.at[0], y = walk.at[1], z = walk.at[2];
  for (int n = 0; n < walk.count; ++n) {
    const std::ptrdiff_t cell = (z >> kFractionBits) * brick.layerStride + (y >> kFractionBits) * brick.rowStride + (x >> kFractionBits);
    const double fx = static_cast<double>(x & kFraction) * kPerUnit;
    const double fy = static_cast<double>(y & kFraction) * kPerUnit;
    const double fz = static_cast<double>(z & kFraction) * kPerUnit;
    Cell* const near = brick.cells + cell;
    Cell* const far = near + brick.layerStride;
    put(near, brick.rowStride, far, fx, fy, fz, n);
    brick.touched[cell >> kBlockBits] = 1;
    x += walk.step[0];
    y += walk.step[1];
    z += walk.step[2];
  }
}

inline std::uint64_t weightAt(const Walk& walk, int n) { return walk.weights == nullptr ? 255u : walk.weights[n]; }

/// What a cell says in the end.
struct Voxel {
  bool measured = false;
  std::uint8_t echo = 0;
  double weight = 0.0;
};

/// The mean where no voxel can get more than kMostSmallPixels: half the memory of NearestMean, and no flags, since looking at every cell of
/// a brick costs less than a flag for every pixel.
struct NearestFewMean {
  using Cell = SmallSum;
  static constexpr int kGuard = 0;
  static void walk(const Walk& row, const Cells<Cell>& brick) {
    constexpr int kPiece = 512;
    std::uint32_t cells[kPiece];
    Cell* const sums = brick.cells;
    std::int64_t at[3] = {row.at[0], row.at[1], row.at[2]};
    for (int begin = 0; begin < row.count; begin += kPiece) {
      const int count = std::min(kPiece, row.count - begin);
      cellsOfRow(at, row.step, static_cast<std::uint32_t>(brick.rowStride), static_cast<std::uint32_t>(brick.layerStride), count, cells);
      const std::uint8_t* const pixels = row.pixels + begin;
      for (int n = 0; n < count; ++n) sums[cells[n]] += (Cell{1} << kSmallSumBits) + pixels[n];
      for (int axis = 0; axis < 3; ++axis) at[axis] += count * row.step[axis];
    }
  }
  static Voxel voxelOf(Cell cell) {
    const Cell count = cell >> kSmallSumBits;
    if (count == 0) return {};
    const double pixels = count;
    return {true, static_cast<std::uint8_t>((cell & ((Cell{1} << kSmallSumBits) - 1)) / pixels + 0.5), pixels};
  }
};

struct NearestMean {
  using Cell = std::uint64_t;  // sum in the low 36 bits, count in the high 28: one addition per pixel
  static constexpr int kGuard = 0;
  static constexpr int kSumBits = 36;
  static void walk(const Walk& row, const Cells<Cell>& brick) {
    walkNearest(row, brick, [&](Cell& cell, int n) { cell += (Cell{1} << kSumBits) | row.pixels[n]; });
  }
  static Voxel voxelOf(Cell cell) {
    const Cell count = cell >> kSumBits;
    if (count == 0) return {};
    const double pixels = static_cast<double>(count);
    const double sum = static_cast<double>(cell & ((Cell{1} << kSumBits) - 1));
    return {true, static_cast<std::uint8_t>(sum / pixels + 0.5), pixels};
  }
};

/// Cells that keep one pixel: its value + 1, so that a measured zero differs from nothing.
using PixelCell = std::uint16_t;
inline Voxel voxelOfKept(PixelCell cell) { return cell == 0 ? Voxel{} : Voxel{true, static_cast<std::uint8_t>(cell - 1), 1.0}; }
inline PixelCell kept(std::uint8_t value) { return static_cast<PixelCell>(value + 1); }

struct NearestMaximum {
  using Cell = PixelCell;
  static constexpr int kGuard = 0;
  static void walk(const Walk& row, const Cells<Cell>& brick) {
    walkNearest(row, brick, [&](Cell& cell, int n) { cell = std::max(cell, kept(row.pixels[n])); });
  }
  static Voxel voxelOf(Cell cell) { return voxelOfKept(cell); }
};

struct NearestLatest {
  using Cell = PixelCell;
  static constexpr int kGuard = 0;
  static void walk(const Walk& row, const Cells<Cell>& brick) {
    walkNearest(row, brick, [&](Cell& cell, int n) { cell = kept(row.pixels[n]); });
  }
  static Voxel voxelOf(Cell cell) { return voxelOfKept(cell); }
};

/// The mean of weighted pixels, in whole numbers: 255 for a weight of 1.
struct NearestWeighted {
  struct Cell {
    std::uint64_t total = 0;  ///< of weight * value
    std::uint64_t weight = 0;
  };
  static constexpr int kGuard = 0;
  static void walk(const Walk& row, const Cells<Cell>& brick) {
    walkNearest(row, brick, [&](Cell& cell, int n) {
      const std::uint64_t weight = weightAt(row, n);
      cell.total += weight * row.pixels[n];
      cell.weight += weight;
    });
  }
  static Voxel voxelOf(const Cell& cell) {
    if (cell.weight == 0) return {};
    const double weight = static_cast<double>(cell.weight);
    return {true, static_cast<std::uint8_t>(static_cast<double>(cell.total) / weight + 0.5), weight / 255.0};
  }
};

using Pair = double __attribute__((vector_size(16)));
struct LinearSums {
  Pair sums;  ///< of weight * value, of weight: one vector addition per corner
};

/// Adds a pixel's value and weight to the 8 cells around it.
inline void putLinear(LinearSums* near, std::ptrdiff_t rowStride, LinearSums* far, double fx, double fy, double fz, Pair pixel) {
  const Pair left = pixel * (1.0 - fx);
  const Pair right = pixel * fx;
  const double w00 = (1.0 - fy) * (1.0 - fz), w10 = fy * (1.0 - fz), w01 = (1.0 - fy) * fz, w11 = fy * fz;
  near[0].sums += left * w00;
  near[1].sums += right * w00;
  near[rowStride].sums += left * w10;
  near[rowStride + 1].sums += right * w10;
  far[0].sums += left * w01;
  far[1].sums += right * w01;
  far[rowStride].sums += left * w11;
  far[rowStride + 1].sums += right * w11;
}
inline Voxel voxelOfLinear(const LinearSums& cell) {
  const double total = cell.sums[0], weight = cell.sums[1];
  if (!(weight > kMeasuredWeight)) return {};
  return {true, static_cast<std::uint8_t>(std::min(total / weight + 0.5, 255.0)), weight};
}

struct LinearMean {
  using Cell = LinearSums;
  static constexpr int kGuard = 1;
  static void walk(const Walk& row, const Cells<Cell>& brick) {
    walkLinear(row, brick, [&](Cell* near, std::ptrdiff_t rowStride, Cell* far, double fx, double fy, double fz, int n) {
      putLinear(near, rowStride, far, fx, fy, fz, Pair{static_cast<double>(row.pixels[n]), 1.0});
    });
  }
  static Voxel voxelOf(const Cell& cell) { return voxelOfLinear(cell); }
};

struct LinearWeighted {
  using Cell = LinearSums;
  static constexpr int kGuard = 1;
  static void walk(const Walk& row, const Cells<Cell>& brick) {
    walkLinear(row, brick, [&](Cell* near, std::ptrdiff_t rowStride, Cell* far, double fx, double fy, double fz, int n) {
      const double weight = static_cast<double>(weightAt(row, n)) / 255.0;
      putLinear(near, rowStride, far, fx, fy, fz, Pair{weight * static_cast<double>(row.pixels[n]), weight});
    });
  }
  static Voxel voxelOf(const Cell& cell) { return voxelOfLinear(cell); }
};

template <class Keep>
inline void putWhereWeighty(PixelCell* near, std::ptrdiff_t rowStride, PixelCell* far, double fx, double fy, double fz, std::uint8_t value,
                            const Keep& keep) {
  constexpr double kLeastWeight = 0.125;
  const PixelCell candidate = kept(value);
  const double wx[2] = {1.0 - fx, fx};
  const double wyz[4] = {(1.0 - fy) * (1.0 - fz), fy * (1.0 - fz), (1.0 - fy) * fz, fy * fz};
  PixelCell* const rows[4] = {near, near + rowStride, far, far + rowStride};
  for (int row = 0; row < 4; ++row)
    for (int side = 0; side < 2; ++side)
      if (wx[side] * wyz[row] >= kLeastWeight) rows[row][side] = keep(rows[row][side], candidate);
}

struct LinearMaximum {
  using Cell = PixelCell;
  static constexpr int kGuard = 1;
  static void walk(const Walk& row, const Cells<Cell>& brick) {
    walkLinear(row, brick, [&](Cell* near, std::ptrdiff_t rowStride, Cell* far, double fx, double fy, double fz, int n) {
      putWhereWeighty(near, rowStride, far, fx, fy, fz, row.pixels[n], [](Cell before, Cell now) { return std::max(before, now); });
    });
  }
  static Voxel voxelOf(Cell cell) { return voxelOfKept(cell); }
};

struct LinearLatest {
  using Cell = PixelCell;
  static constexpr int kGuard = 1;
  static void walk(const Walk& row, const Cells<Cell>& brick) {
    walkLinear(row, brick, [&](Cell* near, std::ptrdiff_t rowStride, Cell* far, double fx, double fy, double fz, int n) {
      putWhereWeighty(near, rowStride, far, fx, fy, fz, row.pixels[n], [](Cell, Cell now) { return now; });
    });
  }
  static Voxel voxelOf(Cell cell) { return voxelOfKept(cell); }
};

/// Which frame has the pixel nearest to a voxel's centre, among the pixels less than one voxel from it along each axis.
struct NearestSource {
  struct Cell {
    float distance2_voxel = 0.0F;  ///< 0 and no source: nothing yet
    std::uint16_t source = 0;
  };
  static constexpr int kGuard = 1;
  static void walk(const Walk& row, const Cells<Cell>& brick) {
    walkLinear(row, brick, [&](Cell* near, std::ptrdiff_t rowStride, Cell* far, double fx, double fy, double fz, int) {
      const double x2[2] = {fx * fx, (1.0 - fx) * (1.0 - fx)}, y2[2] = {fy * fy, (1.0 - fy) * (1.0 - fy)};
      const double z2[2] = {fz * fz, (1.0 - fz) * (1.0 - fz)};
      Cell* const rows[4] = {near, near + rowStride, far, far + rowStride};
      for (int line = 0; line < 4; ++line)
        for (int side = 0; side < 2; ++side) {
          Cell& cell = rows[line][side];
          const auto distance2 = static_cast<float>(x2[side] + y2[line & 1] + z2[line >> 1]);
          if (cell.source == 0 || distance2 < cell.distance2_voxel) cell = {distance2, row.source};
        }
    });
  }
};

}  // namespace ew::paste
