#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "ew/assessment/organ_coverage.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/scanning/events.h"
#include "logic/review_clock.h"

namespace ew::review {

/// The regions of a volume that there is something to see in: cubes of even size in the volume's own axes.
class VolumeRegions {
 public:
  /// @param volume with its own grid; a region counts when one of the voxels that its centre and the middles of its eighths lie in has an
  /// echo and was not left out when it was made
  /// @param placed where the volume lies in the world, of the same dims @param side_mm of a cube, > 0
  VolumeRegions(const Volume& volume, const Grid& placed, double side_mm = 4.0);

  [[nodiscard]] double side_mm() const { return side_mm_; }
  [[nodiscard]] const std::shared_ptr<const OrganVoxels>& voxels() const { return voxels_; }
  /// Middles in the world; the n-th region of RegionCoverage.
  [[nodiscard]] const std::vector<glm::vec3>& middles_mm() const { return voxels_->centres_mm(); }
  [[nodiscard]] std::size_t count() const { return voxels_->count(); }

 private:
  double side_mm_ = 4.0;
  std::shared_ptr<const OrganVoxels> voxels_;
};

/// How often and how long the regions of a volume were seen: a frame sees those whose middles lie in its slab, inside its fan, and below a
/// part of the face that touches (OrganCoverage).
struct RegionCoverage {
  std::vector<std::uint32_t> frames;  ///< of each region
  std::vector<float> seconds;         ///< a frame counts until the next one, at most kLongestFrame_s; while it is frozen no time passes
  [[nodiscard]] float longest_s() const;
};
inline constexpr double kLongestFrame_s = 0.5;

/// @error cancelled
[[nodiscard]] Result<RegionCoverage> regionCoverageOf(const VolumeRegions& regions, const ScanLog& log, const Part& part,
                                                      Progress& progress = noProgress());

}  // namespace ew::review
