#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ew::measurement {

/// Stack of discs (Simpson), as echocardiographers do it: Schiller et al., J. Am. Soc. Echocardiogr. 2, 1989; Lang et al., ibid. 28, 2015.
inline constexpr int kDiscs = 20;

/// A number with its derivatives by some points.
struct ByPoints {
  double value = 0.0;
  std::vector<glm::dvec2> gradient;
};

/// What one plane says: length of the long axis, and how wide the outline is across the middle of each disc.
/// @param points ends of the long axis, then the outline, which is closed
struct DiscPlane {
  ByPoints length_mm;
  std::vector<ByPoints> widths_mm;
};
[[nodiscard]] DiscPlane discPlaneOf(std::span<const glm::dvec2> points);

/// pi / 4 L / n sum w_i v_i in mm3; of one plane when both are the same. `first` stands before `second` in the gradient of two planes.
/// L is the longer one of both lengths.
[[nodiscard]] ByPoints discVolume(const DiscPlane& plane);
[[nodiscard]] ByPoints discVolume(const DiscPlane& first, const DiscPlane& second);

}  // namespace ew::measurement
