#pragma once

#include <functional>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/labelling/label_surfaces.h"

namespace ew {

/// Organs whose shapes are known: where several hold a place, the first has it. Label n is the organ n - 1.
class TrueOrgans {
 public:
  /// Twelve of them in a cube: vessels, a ring, organs that touch and cut one another, a body around all.
  explicit TrueOrgans(int side_voxel);

  /// Distance to the surface of one organ's own shape, below 0 inside. In voxels, as everything here. Beyond 3 it may be less than it is.
  [[nodiscard]] double distance(std::size_t organ, const glm::dvec3& p) const { return shapes_[organ](p); }
  [[nodiscard]] std::size_t count() const { return shapes_.size(); }
  [[nodiscard]] int side() const { return side_; }

  /// @error cancelled
  [[nodiscard]] Result<Volume> labels(Progress& progress) const;
  /// Where surfaces pass between voxels of `labels`, along each axis, on every fourth line.
  [[nodiscard]] std::vector<glm::dvec3> surfacePoints(const Volume& labels) const;

 private:
  using Shape = std::function<double(const glm::dvec3&)>;
  void addEllipsoid(const glm::dvec3& middle, const glm::dvec3& radii);
  void addRing(const glm::dvec3& middle, double ring, double tube, const glm::dvec3& axis);
  void addTube(const glm::dvec3& from, const glm::dvec3& to, double radius);

  int side_;
  std::vector<Shape> shapes_;
};

/// How near surfaces come to the organs, as in benchSurfaces.
struct SurfacesAccuracy {
  double farthest = 0.0, farthestBack = 0.0, mean = 0.0;  ///< voxels
  double normal_deg = 0.0;
  double volume_percent = 0.0;
};
[[nodiscard]] SurfacesAccuracy accuracyOf(const labelling::LabelSurfaces& surfaces, const TrueOrgans& organs, const Volume& labels);

}  // namespace ew
