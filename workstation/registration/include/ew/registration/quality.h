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
  std::size_t voxels = 0;     ///< that both sides cover
  double correlation = 0.0;
  double uncertainty_mm = 0.0;  ///< expected error of the displacement from residual, gradient and stiffness; infinite when nothing says
};

struct Quality {
  Agreement before;
  Agreement after;
  double greyCorrelationBefore = 0.0;  ///< plain, of grey levels
  double greyCorrelationAfter = 0.0;
  double localCorrelationBefore = 0.0;  ///< mean over windows
  double localCorrelationAfter = 0.0;
  std::array<std::size_t, 64> residualHistogram{};  ///< fixed minus moving, in grey levels, -128..128
  double residualRms_grey = 0.0;
  JacobianSummary jacobian;
  std::optional<double> inverseConsistencyMedian_mm;  ///< forth and back: present when the backward result was given
  std::optional<double> inverseConsistency95_mm;
  std::vector<RegionQuality> regions;
};

/// How well a deformation brings two subvolumes together.
/// @param before   what it is compared with: the start
/// @param backward movingToFixed found on its own, or null
/// @error emptyVolume, badField, cancelled
[[nodiscard]] Result<Quality> assessQuality(const Input& fixed, const Input& moving, const glm::dmat4& before,
                                            const Deformation& fixedToMoving, const Deformation* backward, const QualityOptions& options,
                                            Progress& progress);

/// Largest mismatch around loops of transforms a->b, b->c, c->a: where the corners of a cube of side 2 * reach_mm come back to.
[[nodiscard]] double closureError_mm(const std::vector<glm::dmat4>& loop, double reach_mm);

}  // namespace ew::registration
