#include "annotate/mark_place.h"

#include <array>
#include <cstdint>

namespace ew::ui {
namespace {

constexpr int kSmaller_px = 8;

QRect inCorner(const QRect& room, int corner, int side_px) {
  QRect square(room.topLeft(), QSize(side_px, side_px));
  if ((corner & 1) != 0) square.moveRight(room.right());
  if ((corner & 2) != 0) square.moveBottom(room.bottom());
  return square;
}

std::int64_t coveredArea(const QRect& square, const std::vector<QRect>& taken) {
  std::int64_t sum = 0;
  for (const QRect& each : taken) {
    const QRect both = square.intersected(each);
    if (!both.isEmpty()) sum += std::int64_t{both.width()} * both.height();
  }
  return sum;
}

/// The corner that was asked for, the other one at the same side, the other one at the same height, the one across.
std::array<int, 4> inOrder(int corner) { return {corner, corner ^ 2, corner ^ 1, corner ^ 3}; }

}  // namespace

QRect placeOfMark(const QRect& room, const std::vector<QRect>& taken, int corner, int most_px, int least_px) {
  for (int side_px = most_px; side_px >= least_px; side_px -= kSmaller_px) {
    if (side_px > room.width() || side_px > room.height()) continue;
    for (const int each : inOrder(corner)) {
      const QRect square = inCorner(room, each, side_px);
      if (coveredArea(square, taken) == 0) return square;
    }
  }
  QRect best = inCorner(room, corner, least_px);
  for (const int each : inOrder(corner)) {
    const QRect square = inCorner(room, each, least_px);
    if (coveredArea(square, taken) < coveredArea(best, taken)) best = square;
  }
  return best;
}

}  // namespace ew::ui
