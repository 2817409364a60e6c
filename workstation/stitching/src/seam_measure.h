#pragma once

#include <array>
#include <functional>
#include <map>

#include "ew/stitching/join.h"

namespace ew::stitching {

/// A difference met over and over, each time from another place: how large is what all have in common? Places of one key that lie within
/// 24 mm are taken together; what they scatter is taken off, so that speckle and tissue do not count as a step.
class CommonPart {
 public:
  /// @param key what must be equal for two places to be comparable
  void add(const std::array<int, 3>& key, const glm::dvec3& p_mm, double difference, double weight);
  /// Root of the mean square, never below 0.
  [[nodiscard]] double rms() const;

 private:
  struct Sums {
    double count = 0.0, weight = 0.0, first = 0.0, second = 0.0;
  };
  std::map<std::array<int, 6>, Sums> patches_;
};

inline constexpr double kDbPerGrey = 60.0 / 255.0;

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
    double step = 0.0;
  };
  using Place = std::array<int, 6>;  ///< axis, the two sources, patch along i, j, k

  glm::dvec3 spacing_mm_;
  std::array<Reach, 3> reach_;
  std::size_t faces_ = 0;
  double across_ = 0.0;
  double beside_ = 0.0;
  std::array<std::size_t, 256> inside_{};  ///< how often two voxels of a layer differ by so many grey levels
  std::array<std::size_t, 256> outside_{};
  std::map<Place, Patch> patches_;
};

}  // namespace ew::stitching
