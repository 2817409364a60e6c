#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ew/imaging/slicing.h"

namespace ew {

/// What persistence remembers of earlier images: levels with 7 fraction bits.
struct PersistenceMemory {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> levels;
  bool empty = true;      ///< the next image starts afresh; set this when the fan moves in the image
  bool starting = false;  ///< this image starts afresh
};

/// Call once a frame before `persist`, in one thread. A change of size starts afresh; only then memory is allocated.
void beginPersistence(int width, int height, PersistenceMemory& memory);

/// memory = share * memory + (1 - share) * image, shown rounded, in place: a first-order recursive filter over frames. The first
/// image is shown as it is. After a step, frame n differs from the new image by share^n of the step's height, within 0.7 grey levels.
/// What rounding would leave over still moves by 1/128 of a level a frame: a still image is reached to the last bit, within 200 frames
/// for any share, and never passed.
/// Rows firstRow .. firstRow + rows - 1, the pixels of `spans` alone: threads share an image by bands of rows.
/// @param share 0..0.95, brought into this range; not a number counts as 0
/// @param memory as beginPersistence left it for an image of this size
void persist(double share, std::span<const std::vector<RowSpan>> spans, int firstRow, int rows, ImageView<std::uint8_t> image,
             PersistenceMemory& memory);

}  // namespace ew
