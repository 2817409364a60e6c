#pragma once

#include <memory>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

class vtkPolyData;

namespace ew::bridge {

/// Surfaces of labelled structures, in the world, coloured by their number: what the 3D view shows inside the body. Immutable; made on a
/// worker and drawn by the window.
class OrganSurfaces {
 public:
  /// @param labels a number per voxel in `echo`
  /// @param placed where they lie in the world; of the dims of `labels`
  /// @param wanted numbers from 1; one that no voxel has gives no surface
  /// The boundary between voxels (discrete flying edges), smoothed by a windowed sinc filter with a pass band of 0.05, which keeps volumes
  /// within a few percent (Taubin, Zhang and Golub, ECCV 1996).
  /// @error cancelled
  [[nodiscard]] static Result<std::shared_ptr<const OrganSurfaces>> of(const Volume& labels, const Grid& placed, std::vector<int> wanted,
                                                                       Progress& progress);
  ~OrganSurfaces();
  [[nodiscard]] vtkPolyData* mesh() const;
  /// The numbers that have a surface, in rising order.
  [[nodiscard]] const std::vector<int>& labels() const;

 private:
  struct Parts;
  explicit OrganSurfaces(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::bridge
