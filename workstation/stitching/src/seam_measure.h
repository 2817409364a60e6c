#pragma once

#include <array>
#include <functional>
#include <map>

#include "ew/stitching/join.h"

namespace ew::stitching {

/// Sums for SeamVisibility over boxes of voxels; a run across the seam that leaves the box is not counted.
class SeamMeasure {
 public:
  SeamMeasure(const glm::dvec3& spacing_mm, double blend_mm);

  /// @param size of the box, whose arrays are i fastest; rows of slices [0, size.z) are looked at
  void look(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> echo, std::span<const std::uint8_t> source,
            const std::function<bool()>& stopped);
  [[nodiscard]] SeamVisibility result() const;

 private:
  /// Along one axis, in voxels from the seam's face.
  struct Reach {
    int blend = 1;             ///< voxels on one side that lie in the blend
    int slab = 3;              ///< thickness of the layers whose means are compared
    std::array<int, 3> lag{};  ///< between two voxels of one layer that are compared, along each of the axes
  };
  /// Means of the layers beside a patch of the seam.
  struct Patch {
    double count = 0.0;
    double nearFirst = 0.0, nearSecond = 0.0, farFirst = 0.0, farSecond = 0.0;
  };
  using Place = std::array<int, 6>;  ///< axis, the two sources, patch along i, j, k

  glm::dvec3 spacing_mm_;
  std::array<Reach, 3> reach_;
  std::size_t faces_ = 0;
  double across_ = 0.0;
  double beside_ = 0.0;
  double inside_ = 0.0;
  double outside_ = 0.0;
  std::size_t insideCount_ = 0;
  std::size_t outsideCount_ = 0;
  std::map<Place, Patch> patches_;
};

}  // namespace ew::stitching
