#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "echoes/echo_levels.h"
#include "echoes/reflecting_surfaces.h"
#include "patient/anatomy.h"

namespace ew::phantom {

/// The grid of a patient's voxels, from the box that they fill.
[[nodiscard]] Grid voxelGridOver(const Bounds& box, double spacing_mm);

/// Voxels along each side of a block that asks only for the organs around it: of a whole patient, and of a part, which smaller ones hug.
inline constexpr int kPaintedBlock = 8;
inline constexpr int kInnerBlock = 4;
/// From the middle of a block of so many voxels along each side to the farthest of its voxels' middles.
[[nodiscard]] double blockRadius_mm(int voxels, double spacing_mm);
/// The middle of a block whose first voxel is this one.
[[nodiscard]] glm::dvec3 blockCentre_mm(const Grid& grid, const glm::ivec3& first, int voxels);

/// What of a voxel's tissue may stay unknown.
inline constexpr double kNothingLeft = 1e-3;
/// The part of a voxel that lies inside a surface at a signed distance from its middle, so that edges are not stairs.
[[nodiscard]] inline double partInside(double distance_mm, double spacing_mm) {
  return std::clamp(0.5 - distance_mm / spacing_mm, 0.0, 1.0);
}

/// Which organs there are around blocks and voxels.
class OrganFinder {
 public:
  OrganFinder(const Patient& patient, double spacing_mm);

  /// Whether no voxel of a block of so many voxels about this point lies in the body.
  /// @param asksForPart whether voxels count of which only a part lies in it
  [[nodiscard]] bool isOutside(const glm::dvec3& centre_mm, int voxels, bool asksForPart) const;
  /// Those that can matter to such a block, by priority.
  void select(const glm::dvec3& centre_mm, int voxels, std::vector<const Organ*>& near) const;
  /// @param distances_mm becomes those of the organs that are not hidden here, exact where anything asks for them (distanceUpTo_mm)
  /// @return the label of the point: 0 outside all of them
  [[nodiscard]] int distancesAt(const glm::dvec3& p_mm, const std::vector<const Organ*>& near, std::vector<double>& distances_mm) const;

 private:
  const Patient& patient_;
  double spacing_mm_;
  std::vector<const Organ*> all_;
  double asked_mm_;  ///< farther away no distance matters to levels and surfaces, beside a border
};

/// The tissue itself, as TissueMaps keeps it.
class TissuePainter {
 public:
  TissuePainter(const Patient& patient, double spacing_mm);

  /// How much of a voxel lies inside the skin.
  [[nodiscard]] double bodyPart(double skin_mm) const { return partInside(skin_mm, spacing_mm_); }

  /// Mean level of a voxel; what it shares with another tissue or with the air adds up as power.
  /// @param near, distances_mm as OrganFinder has them
  [[nodiscard]] std::uint8_t levelAt(const glm::dvec3& p_mm, double skin_mm, const std::vector<const Organ*>& near,
                                     const std::vector<double>& distances_mm) const;
  [[nodiscard]] const SurfaceFinder& surfaces() const { return surfaces_; }

 private:
  /// The tissue of a voxel that holds one alone.
  [[nodiscard]] std::optional<std::size_t> onlyTissue(double bodyPart, const std::vector<const Organ*>& near,
                                                      const std::vector<double>& distances_mm) const;

  const Patient& patient_;
  double spacing_mm_;
  PowerOfLevel power_;
  SurfaceFinder surfaces_;
};

}  // namespace ew::phantom
