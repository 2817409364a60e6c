#include "sheet_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ew {

SheetSpace::SheetSpace(const glm::dvec2& at_mm, const glm::dvec2& size_mm)
    : at_(at_mm),
      columns_(static_cast<int>(size_mm.x)),
      rows_(static_cast<int>(size_mm.y)),
      taken_(static_cast<std::size_t>(columns_ * rows_), 0) {}

void SheetSpace::occupy(const std::array<glm::dvec2, 4>& piece, double clearance_mm) {
  double area = 0.0;  // its sign tells which way round the piece goes
  for (std::size_t n = 0; n < 4; ++n) area += piece[n].x * piece[(n + 1) % 4].y - piece[n].y * piece[(n + 1) % 4].x;
  const double way = area < 0.0 ? -1.0 : 1.0;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const glm::dvec2 p = at_ + glm::dvec2(column + 0.5, row + 0.5);
      double depth = std::numeric_limits<double>::infinity();
      for (std::size_t n = 0; n < 4; ++n) {
        const glm::dvec2 edge = glm::normalize(piece[(n + 1) % 4] - piece[n]);
        depth = std::min(depth, way * (edge.x * (p.y - piece[n].y) - edge.y * (p.x - piece[n].x)));
      }
      if (depth > -clearance_mm - 0.5) taken_[static_cast<std::size_t>(row * columns_ + column)] = 1;
    }
}

std::optional<glm::dvec2> SheetSpace::take(const glm::dvec2& box_mm) {
  const int width = static_cast<int>(std::ceil(box_mm.x)), height = static_cast<int>(std::ceil(box_mm.y));
  for (int column = columns_ - width; column >= 0; --column)
    for (int row = rows_ - height; row >= 0; --row) {
      bool fits = true;
      for (int y = 0; fits && y < height; ++y)
        for (int x = 0; fits && x < width; ++x) fits = isFree(column + x, row + y);
      if (!fits) continue;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) taken_[static_cast<std::size_t>((row + y) * columns_ + column + x)] = 1;
      return at_ + glm::dvec2(column, row);
    }
  return std::nullopt;
}

std::optional<SheetSpace::Room> SheetSpace::largest(double leastWidth_mm, double leastHeight_mm) const {
  std::vector<int> above(static_cast<std::size_t>(columns_), 0);  // free squares from this row upwards
  std::optional<Room> best;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      int& height = above[static_cast<std::size_t>(column)];
      height = isFree(column, row) ? height + 1 : 0;
    }
    for (int left = 0; left < columns_; ++left) {
      int height = std::numeric_limits<int>::max();
      for (int right = left; right < columns_; ++right) {
        height = std::min(height, above[static_cast<std::size_t>(right)]);
        if (height < leastHeight_mm) break;
        const int width = right - left + 1;
        if (width >= leastWidth_mm && (!best || width * height > best->size.x * best->size.y))
          best = Room{at_ + glm::dvec2(left, row + 1 - height), glm::dvec2(width, height)};
      }
    }
  }
  return best;
}

}  // namespace ew
