#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/core/volume.h"

namespace ew {

/// A view of one scene, drawn voxel by voxel: quick, and every figure known. For tests and benches of joining, where the forward model of a
/// virtual sweep would only be slow. The scene fills the world: tissue whose level drifts, an organ, vessels, a plate that throws shadows.
struct SpeckleViewRecipe {
  glm::ivec3 dims{128};
  double spacing_mm = 0.5;
  glm::dvec3 origin_mm{0.0};                          ///< of its first voxel in its own frame, in which y runs down the beams
  Transform<frame::World, frame::View> toWorld = {};  ///< rigid
  bool scene = true;                                  ///< false: even tissue of kEvenScene_db
  std::uint64_t speckle = 1;  ///< two views of one number, spacing and frame show the same speckle where they overlap
  double gain_db = 0.0;       ///< added everywhere
  double depthGain_db = 0.0;  ///< from minus this at the first row to plus this at the last
  struct Shadow {
    double from_mm = 0.0;  ///< along x of the view's own frame
    double to_mm = 0.0;
    double below_mm = 0.0;  ///< along y
    double loss_db = 30.0;
  };
  std::optional<Shadow> shadow;
};

struct SpeckleView {
  Volume volume;                         ///< levels 0..255 span kSpeckledRange_db
  std::vector<std::uint8_t> confidence;  ///< 255, in the shadow 0, with an edge of 1 mm
};

inline constexpr double kSpeckledRange_db = 60.0;
inline constexpr double kEvenScene_db = -24.0;  ///< of the mean power, 0 dB being white

/// Mean echo power of the scene at a point of the world, dB. Speckle adds a random number of mean -2.5 dB and deviation 5.6 dB to it.
[[nodiscard]] double speckledScene_db(const glm::dvec3& p_world_mm);

/// The same voxels for any number of threads; 0: all cores.
[[nodiscard]] SpeckleView speckledView(const SpeckleViewRecipe& recipe, int threads);

}  // namespace ew
