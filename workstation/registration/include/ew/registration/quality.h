#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/registration/deformation.h"
#include "ew/registration/verdict.h"

namespace ew::registration {

struct QualityOptions {
  double region_mm = 15.0;  ///< side of the regions for which local figures are given
  double window_mm = 12.0;  ///< of the local correlation
  int threads = 0;
};

/// A block of the overlap and what can be said there.
struct RegionQuality {
  glm::dvec3 centre_mm{0.0};  ///< fixed frame
  std::size_t voxels = 0;     ///< of the fixed volume, that both sides cover
  double correlation = 0.0;   ///< of the images made comparable, within the block
  /// Expected error of a shift of this block found from this block alone: residual over the gradients both images have in common, each
  /// speckle counted once. A regulariser can make the true error smaller; infinite when the block's gradients leave a direction open.
  double uncertainty_mm = 0.0;
};

struct Quality {
  Agreement before;
  Agreement after;
  double greyCorrelationBefore = 0.0;  ///< plain, of grey levels
  double greyCorrelationAfter = 0.0;
  double localCorrelationBefore = 0.0;  ///< mean over windows
  double localCorrelationAfter = 0.0;
  std::array<std::size_t, 64>
      residualHistogram{};  ///< fixed minus moving in bins of 4 grey levels from -128 on; what is beyond, in the end bins
  double residualRms_grey = 0.0;
  JacobianSummary jacobian;
  std::optional<double> inverseConsistencyMedian_mm;  ///< forth and back: present when the backward result was given
  std::optional<double> inverseConsistency95_mm;
  std::vector<RegionQuality> regions;
};

/// How well a deformation brings two subvolumes together.
/// A correlation that rose is no proof of success: a flexible warp fits the grain of unrelated speckle to each other and ends above the
/// correlation of the true field. Judge it together with chance, Jacobian, uncertainty and the way forth and back.
/// @param before   what it is compared with: the start
/// @param backward movingToFixed found on its own, or null
/// @error emptyVolume, badField, cancelled
[[nodiscard]] Result<Quality> assessQuality(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& before,
                                            const Deformation& fixedToMoving, const Deformation* backward, const QualityOptions& options,
                                            Progress& progress);

}  // namespace ew::registration
