#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/core/progress.h"
#include "ew/imaging/tissue_maps.h"
#include "patient/anatomy.h"

namespace ew::phantom {

/// Where a voxel's nearest visible surface is.
struct SurfaceFoot {
  glm::ivec3 voxel{0};
  float distance_mm = 0.0F;  ///< signed, negative inside the surface's organ
  glm::vec3 normal{0.0F};    ///< out of that organ, unit length; the foot lies at the voxel - distance * normal
  std::uint16_t key = 0;     ///< of SurfaceFinder
};

/// Finds the reflecting surfaces next to a point: borders of organs, and boundaries between tissues of different impedance, where no organ
/// of higher priority covers them.
class SurfaceFinder {
 public:
  /// @param reach_mm of surfaces next to a point: half a voxel's diagonal, so that no part of a surface lies between voxels unfound
  SurfaceFinder(const Patient& patient, double reach_mm);

  /// Organs that are farther than this from a point are not asked for anything there, so their distance may be any that is.
  [[nodiscard]] static double asked_mm(double reach_mm);

  /// @param skin_mm      distance to the skin at p
  /// @param near         organs that can matter here, by priority, with whatever contains a point within the reach
  /// @param distances_mm of the first of them, at p; of the others nothing is asked, for they are hidden here
  [[nodiscard]] std::optional<SurfaceFoot> nearest(const glm::dvec3& p_mm, double skin_mm, const std::vector<const Organ*>& near,
                                                   const std::vector<double>& distances_mm) const;
  /// The surface that a key stands for.
  [[nodiscard]] ReflectingSurface surfaceOf(std::uint16_t key) const;

 private:
  /// What is known of a point beside a foot.
  struct Near {
    const std::vector<const Organ*>& organs;
    const std::vector<double>& distances_mm;  ///< of the first of them, at the point
    double skin_mm = 0.0;
    double away_mm = 0.0;  ///< the foot
    /// How far beyond a place of the point's distance one may lie that is `more_mm` behind the foot.
    [[nodiscard]] double reach_mm(double more_mm) const;
  };
  [[nodiscard]] bool isHidden(const glm::dvec3& foot_mm, std::size_t n, const Near& near) const;
  /// Nothing where the surface sends too little back, or has no tissue outside.
  [[nodiscard]] std::optional<std::uint16_t> keyAt(const glm::dvec3& foot_mm, const glm::dvec3& normal, const Organ& organ,
                                                   const Near& near) const;
  [[nodiscard]] std::optional<std::size_t> tissueAt(const glm::dvec3& p_mm, double behind_mm, const Near& near) const;

  const Patient& patient_;
  double reach_mm_;
};

/// Fills the distances and kinds of maps, whose grid is set, from the feet found at voxels next to surfaces: every other voxel takes the
/// nearest of them, as far as it lies above a surface and not beside its rim.
/// @param feet in any number of parts; voxels in each part and parts themselves may come in any order
/// @return false when cancelled
[[nodiscard]] bool spreadSurfaces(const SurfaceFinder& finder, const std::vector<std::vector<SurfaceFoot>>& feet, int threads,
                                  Progress& progress, TissueMaps& maps);

/// Bytes that finding and spreading surfaces hold, for each voxel: what of the volume's voxels lies next to a surface, and what is spread.
inline constexpr double kSurfaceBytesPerVoxel = 0.25 * sizeof(SurfaceFoot);
[[nodiscard]] double spreadForecast_bytes(const Grid& grid, int threads);

}  // namespace ew::phantom
