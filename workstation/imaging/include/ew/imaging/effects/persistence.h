#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ew/imaging/slicing.h"

namespace ew {

/// What persistence remembers of earlier pictures: levels with 7 fraction bits, so that a still picture is reached exactly.
struct PersistenceMemory {
  std::vector<std::uint16_t> levels;
  bool empty = true;  ///< the next picture starts afresh
};

/// memory = share * memory + (1 - share) * picture, shown rounded, in place: a first-order recursive filter over frames.
/// Rows [firstRow, firstRow + rows); call `begin` once a frame before, in one thread.
/// @param share 0..0.95
void beginPersistence(int width, int height, PersistenceMemory& memory);
void persist(double share, std::span<const std::vector<RowSpan>> spans, int firstRow, int rows, ImageView<std::uint8_t> picture,
             PersistenceMemory& memory);

}  // namespace ew
