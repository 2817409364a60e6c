#pragma once

#include <cstdint>
#include <vector>

#include "ew/scanning/state.h"
#include "ew/sdk/scan.h"

namespace ew::lessons {

/// How much of a structure images have passed through: the share of its voxels that lay within half a slice of an image plane, inside the
/// fan. Cheap enough for every image: all voxels of the structure are looked at, and of large ones an even sample.
class SweepCover {
 public:
  /// @param scanned with labels @param label of the structure; one that no voxel has gives a share of 0
  SweepCover(const sdk::Scanned& scanned, int label);
  /// An image whose pose is not ok shows nothing.
  void add(const ScanState& image);
  [[nodiscard]] double share() const;

 private:
  std::vector<glm::dvec3> points_mm_;  ///< world
  std::vector<std::uint8_t> seen_;
  std::size_t seenCount_ = 0;
  double half_mm_ = 1.0;  ///< of the slice
};

}  // namespace ew::lessons
