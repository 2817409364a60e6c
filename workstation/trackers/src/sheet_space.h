#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace ew {

/// What is still white on a page, in squares of 1 mm.
class SheetSpace {
 public:
  struct Room {
    glm::dvec2 at{0.0};
    glm::dvec2 size{0.0};
  };
  SheetSpace(const glm::dvec2& at_mm, const glm::dvec2& size_mm);
  /// @param piece convex, in page coordinates
  void occupy(const std::array<glm::dvec2, 4>& piece, double clearance_mm);
  /// The rightmost free place for a box, the lowest of these; it is then occupied.
  [[nodiscard]] std::optional<glm::dvec2> take(const glm::dvec2& box_mm);
  /// The free rectangle of the largest area that is at least so wide and high.
  [[nodiscard]] std::optional<Room> largest(double leastWidth_mm, double leastHeight_mm) const;

 private:
  [[nodiscard]] bool isFree(int column, int row) const { return !taken_[static_cast<std::size_t>(row * columns_ + column)]; }
  glm::dvec2 at_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<char> taken_;
};

}  // namespace ew
