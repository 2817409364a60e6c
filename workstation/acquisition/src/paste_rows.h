#pragma once

#include <cstddef>
#include <cstdint>

// The inner loops of pasting into the nearest voxel that the compiler turns into vector code. Whole numbers, or divisions that are rounded
// right whatever the width of the vectors, so every machine gives the same bits.
namespace ew::paste {

/// Cells of the pixels of one row.
/// @param at, step   fixed-point position of the first pixel and step to the next, kFractionBits after the point; all of them in the brick
/// @param cells      count values; at most 2^32 cells in a brick
void cellsOfRow(const std::int64_t at[3], const std::int64_t step[3], std::uint32_t rowStride, std::uint32_t layerStride, int count,
                std::uint32_t* cells);

/// Sum in the low 20 bits, count in the high 12: one addition per pixel.
using SmallSum = std::uint32_t;
inline constexpr int kSmallSumBits = 20;
inline constexpr std::uint32_t kMostSmallPixels = 4095;

/// What the cells of a row say: echo floor(sum / count + 0.5), coverage measured (`measured`) where the count is not 0, else both 0.
/// @return how many of them are measured
std::size_t roundSums(const SmallSum* cells, int count, std::uint8_t measured, std::uint8_t* echo, std::uint8_t* coverage);

/// Whether a row of cells has one that is not 0.
bool anySum(const SmallSum* cells, int count);

}  // namespace ew::paste
