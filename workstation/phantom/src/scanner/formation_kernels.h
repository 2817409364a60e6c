#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace ew::phantom {

/// How points of the probe frame come to lie on the fine grid of the frame being formed, and what they weigh there.
struct Gridding {
  bool sector = false;  ///< lines meet `apex_mm` behind the face; else they are parallel
  float apex_mm = 0.0F;
  float rowsPerUnit = 1.0F;  ///< of angle (rad), or of width (mm)
  float middleRow = 0.0F;
  float columnsPerMm = 1.0F;
  float firstColumn = 0.0F;  ///< where depth 0 lies
  float turnsPerMm = 1.0F;   ///< of the carrier's phase, both ways
  std::int32_t rows = 0;
  std::int32_t columns = 0;
  // Elevational beam, as Beams.
  float lensFocus_mm = 0.0F;
  float nearPerMm = 0.0F;  ///< 1 / range
  float farPerMm = 0.0F;
  float waistPerMm2 = 0.0F;  ///< 1 / (2 waist^2)
  float weight = 1.0F;       ///< at the middle of the focus
  float cut = 2.5F;          ///< where the beam ends: exponent of its amplitude
};

/// p = c0 + c1 x + c2 y + c3 z + c4 xy + c5 xz + c6 yz + c7 xyz: where a deformation takes the points of a block.
using Trilinear = std::array<glm::vec3, 8>;

/// Work space for one block; `kMost` points at a time.
struct PointBatch {
  static constexpr std::size_t kMost = 512;
  alignas(64) std::array<float, kMost> x, y, z, amplitude, row, range_mm;
  alignas(64) std::array<std::int32_t, kMost> cell;
  alignas(64) std::array<float, kMost> re, im, part;
};

/// x, y, z of `batch` from coordinates in a block; moveTrilinear takes the terms of second and third order too.
void moveAffine(const float* x, const float* y, const float* z, std::size_t count, const Trilinear& to, PointBatch& batch);
void moveTrilinear(const float* x, const float* y, const float* z, std::size_t count, const Trilinear& to, PointBatch& batch);

/// row and range_mm from x and y.
void placeOnLines(const Gridding& grid, std::size_t count, PointBatch& batch);

/// cell, part (of the next column), re and im from row, range_mm, z and amplitude; points off the grid get the cell rows * columns and the
/// weight 0.
void weigh(const Gridding& grid, std::size_t count, PointBatch& batch);

/// Adds the batch to a grid of rows * columns + 2 complex numbers: on the nearest row, shared by the two nearest columns.
void deposit(std::size_t count, const PointBatch& batch, float* grid);

/// out[n] += weight[n] * in[n]
void accumulate(const float* in, const float* weight, std::size_t count, float* out);
/// out[n] += weight * in[n]
void accumulate(const float* in, float weight, std::size_t count, float* out);

}  // namespace ew::phantom
