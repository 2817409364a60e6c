#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ew/imaging/slicing.h"

namespace ew {

/// What persistence remembers of earlier pictures: levels with 7 fraction bits.
struct PersistenceMemory {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> levels;
  bool empty = true;      ///< the next picture starts afresh; set this when the fan moves in the picture
  bool starting = false;  ///< this picture starts afresh
};

/// Call once a frame before `persist`, in one thread. A change of size starts afresh; only then memory is allocated.
void beginPersistence(int width, int height, PersistenceMemory& memory);

/// memory = share * memory + (1 - share) * picture, shown rounded, in place: a first-order recursive filter over frames. The first
/// picture is shown as it is. After a step, frame n differs from the new picture by share^n of the step's height, within 0.7 grey levels.
/// What rounding would leave over still moves by 1/128 of a level a frame: a still picture is reached to the last bit, within 200 frames
/// for any share, and never passed.
/// Rows firstRow .. firstRow + rows - 1, the pixels of `spans` alone: threads share a picture by bands of rows.
/// @param share 0..0.95, brought into this range; not a number counts as 0
/// @param memory as beginPersistence left it for a picture of this size
void persist(double share, std::span<const std::vector<RowSpan>> spans, int firstRow, int rows, ImageView<std::uint8_t> picture,
             PersistenceMemory& memory);

}  // namespace ew
