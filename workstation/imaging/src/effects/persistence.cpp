#include "ew/imaging/effects/persistence.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {

constexpr int kFractionBits = 7;  // 255 << 7 still fits a signed 16 bit difference

void startRow(std::uint16_t* level, const std::uint8_t* pixel, int count) {
  for (int x = 0; x < count; ++x) level[x] = static_cast<std::uint16_t>(pixel[x] << kFractionBits);
}

/// @param fresh share of the new picture, 15 fraction bits
void persistRow(int fresh, std::uint16_t* level, std::uint8_t* pixel, int count) {
  for (int x = 0; x < count; ++x) {
    const int difference = (pixel[x] << kFractionBits) - level[x];
    int move = (difference * fresh + (1 << 14)) >> 15;
    if (move == 0) move = (difference > 0) - (difference < 0);
    const int moved = level[x] + move;
    level[x] = static_cast<std::uint16_t>(moved);
    pixel[x] = static_cast<std::uint8_t>((moved + (1 << (kFractionBits - 1))) >> kFractionBits);
  }
}

}  // namespace

void beginPersistence(int width, int height, PersistenceMemory& memory) {
  EW_EXPECTS(width >= 0 && height >= 0);
  if (memory.width != width || memory.height != height) {
    memory.width = width;
    memory.height = height;
    memory.levels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    memory.empty = true;
  }
  memory.starting = memory.empty;
  memory.empty = false;
}

void persist(double share, std::span<const std::vector<RowSpan>> spans, int firstRow, int rows, ImageView<std::uint8_t> picture,
             PersistenceMemory& memory) {
  EW_EXPECTS(picture.width == memory.width && picture.height == memory.height);
  EW_EXPECTS(spans.size() == static_cast<std::size_t>(picture.height));
  EW_EXPECTS(firstRow >= 0 && rows >= 0 && firstRow + rows <= picture.height);
  const double usable = share > 0.0 ? std::min(share, 0.95) : 0.0;
  const bool start = memory.starting || usable == 0.0;
  const int fresh = std::min(static_cast<int>(std::lround((1.0 - usable) * 32768.0)), 32767);
  for (int y = firstRow; y < firstRow + rows; ++y) {
    std::uint16_t* level = memory.levels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(memory.width);
    for (const RowSpan& span : spans[static_cast<std::size_t>(y)]) {
      if (start)
        startRow(level + span.begin, picture.row(y) + span.begin, span.end - span.begin);
      else
        persistRow(fresh, level + span.begin, picture.row(y) + span.begin, span.end - span.begin);
    }
  }
}

}  // namespace ew
