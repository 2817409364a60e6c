#pragma once

#include <vector>

#include "byte_map.h"
#include "echo_motion.h"
#include "label_rows.h"

namespace ew::detail {

/// Lines on their way through a map of distances to surfaces (TissueMaps::surfaceDistance), all at one place of the elevational beam.
struct SurfaceWalk {
  const LineWays& ways;             ///< in voxels of the map
  glm::vec3 aside_voxel{0.0F};      ///< 1 mm beside the slice
  float sigmas = 0.0F;              ///< how far beside it
  const float* sigma_mm = nullptr;  ///< by whole mm of depth
  ByteMap distances;
  EchoMotion::Rows back;  ///< in voxels
  float depth_mm = 0.0F;
  float blind_mm = 0.0F;  ///< from a place that knows no surface at one of its voxels, this far nothing is missed
};

/// Where a line goes through a surface.
struct SurfaceCrossing {
  int line = 0;
  float range_mm = 0.0F;
  bool isEntering = false;
};

inline constexpr float kFineStep_mm = 0.3F;  ///< across a surface

/// Of `count` lines from `first` on; those of a line come in its order. The same on every instruction set.
/// @param found more are added
void findCrossings(const SurfaceWalk& walk, int first, int count, std::vector<SurfaceCrossing>& found);

/// Distances to surfaces beside crossings, as tissue lies now.
struct SurfaceProbe {
  int line = 0;
  float range_mm = 0.0F;
  float off_mm = 0.0F;  ///< beside the slice
};
/// @param lines of the probe frame: (origin, direction) of each
/// @param distance_mm of each place, not a number where none is known
void distancesOf(const SurfaceWalk& walk, const glm::mat4& probeToVoxel, const std::vector<glm::vec4>& lines,
                 const std::vector<SurfaceProbe>& probes, std::vector<float>& distance_mm);

}  // namespace ew::detail
