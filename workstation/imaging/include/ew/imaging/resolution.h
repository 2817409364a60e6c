#pragma once

#include <glm/glm.hpp>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"

namespace ew {

/// How finely a place is resolved: full widths at half maximum of the two-way point spread, and which way the beam goes there.
struct Resolution {
  double axial_mm = 0.0;    ///< along the beam
  double lateral_mm = 0.0;  ///< across it, in the image's plane
  double beam_rad = 0.0;    ///< from the probe's +y towards its +x
  bool operator==(const Resolution&) const = default;
};

/// The point spread that live echoes are formed with. Of a recorded volume, whose own was lost with its echoes, that of the probe which
/// looks at it now: what such an image would have.
class ResolutionMap {
 public:
  /// @param knobs as the console has them @param depth_mm of the image, resolved, > 0
  ResolutionMap(const Probe& probe, const Knobs& knobs, const Scene& scene, double depth_mm);

  /// @param p_mm x and y of the probe frame; outside of the fan as at the nearest line
  [[nodiscard]] Resolution at(const glm::dvec2& p_mm) const;

 private:
  Probe probe_;
  Knobs knobs_;
  Scene scene_;
  double depth_mm_;
  BeamGrid grid_;
};

}  // namespace ew
