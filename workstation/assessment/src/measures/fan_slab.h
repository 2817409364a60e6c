#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "ew/assessment/organ_voxels.h"
#include "ew/core/frames.h"

namespace ew::detail {

/// The part of a face whose lines hear, between two places on it: -1 at its -x end, 1 at its +x end.
struct FacePart {
  double from = -1.0, to = 1.0;
};

/// What a frame may pass through, in numbers of float, for the voxels of one grid: a slab about the image plane and in it the fan between
/// the lines that hear. All bounds are wider by a margin above what rounding takes, so that no voxel is left out that placeInFan and the
/// distance from the plane would take: whoever asks looks at the few that are found with those.
class FanSlab {
 public:
  using Layers = std::array<std::uint64_t, 8>;  ///< OrganVoxels::BlockMask::layers

  /// @param organ not empty: its grid, and how far from the world's origin it lies
  FanSlab(const Fan& fan, const Transform<frame::Probe, frame::World>& worldToProbe, const OrganVoxels& organ, double halfThickness_mm,
          const FacePart& heard);

  /// Whether a ball may reach into the fan; the slab is not looked at. @param middle_mm in the probe's frame
  [[nodiscard]] bool reachesFan(const glm::dvec3& middle_mm, double radius_mm) const;

  /// The voxels of a block that may lie within. @param corner_mm centre of its voxel (0, 0, 0), in the probe's frame
  /// @param asked those that are asked for; @return whether there are any
  [[nodiscard]] bool find(const glm::dvec3& corner_mm, const Layers& asked, Layers& found) const;

  /// What the kernel takes. In the image plane a point lies outside where its depth is (of a sector: its squared distance from the point
  /// where the lines meet, from which y is counted then) or where it lies beyond one of the two outer lines.
  struct Terms {
    alignas(64) std::array<float, 64> x_mm, y_mm, z_mm;  ///< of a layer's voxels, from its voxel (0, 0)
    glm::dvec3 layer_mm{0.0};                            ///< from one layer to the next
    float middleZ_mm = 0.0F, spreadZ_mm = 0.0F;          ///< of a layer: z_mm lies within middle +- spread
    float halfThickness_mm = 0.0F;
    bool isSector = false;
    float least = 0.0F, most = 0.0F;  ///< depth, or squared distance
    glm::vec2 low{0.0F}, high{0.0F};  ///< away from the fan across its outer lines
    float beyondLow_mm = 0.0F, beyondHigh_mm = 0.0F;
  };

 private:
  Terms terms_;
  double apex_mm_ = 0.0;  ///< how far behind the face the lines meet, of a sector
};

}  // namespace ew::detail
