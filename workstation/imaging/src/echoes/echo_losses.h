#pragma once

#include <array>
#include <vector>

#include "echo_layout.h"
#include "echo_motion.h"
#include "echo_rays.h"
#include "ew/imaging/bands.h"
#include "ew/imaging/slice_source.h"
#include "label_rows.h"
#include "line_kernels.h"

namespace ew::detail {

/// What echoes lose on their way, from the labels of the tissue: attenuation beyond what the machine expects, reflections, the shadows they
/// throw and the enhancement behind fluid. Labels are blended between voxels; three planes of the slice are walked, or its middle alone,
/// and each place is seen from all of the aperture (EchoRays). In a step of a line, both ways, dB,
///   loss = 2 (a - expected) f dz + reflections that were entered
///   gain = mean over the planes of left^2
/// A reflection comes in behind its surface, over a wavelength (1/e), so that the surface's own echo stays bright. A line that leaves what
/// reflected it and is back within 3 mm meets no second surface: it grazes the same one. Before the skin lies gel, which takes nothing.
class EchoLosses {
 public:
  void configure(const EchoLayout& layout, const Probe& probe, const Scene& scene, double carrier_hz);
  /// @param labels on a grid of their own
  /// @param level of the tissue (TissueMaps), which says where lines enter it, on a grid of its own
  /// @param motion of both
  void walk(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, const SliceSource& level,
            const Transform<frame::Voxel, frame::Probe>& probeToLevel, const EchoMotion& motion, Bands& bands);
  /// Of the amplitudes of a line.
  /// @param ofSteps memory of the result
  [[nodiscard]] GainSteps gainOf(int line, std::vector<float>& ofSteps) const;

 private:
  static constexpr int kPlanes = 3;  ///< at most
  static constexpr std::array<float, kPlanes> kWeights{0.5F, 0.25F, 0.25F};
  static constexpr std::array<float, kPlanes> kAside{0.0F, -0.75F, 0.75F};  ///< standard deviations of the elevational beam

  [[nodiscard]] std::size_t indexOf(int plane, int step) const {
    return (static_cast<std::size_t>(plane) * static_cast<std::size_t>(steps_) + static_cast<std::size_t>(step)) *
           static_cast<std::size_t>(lines_);
  }

  void findSkin(const SliceSource& level, const glm::mat4& labelToLevel, const EchoMotion& motion);
  void march(int plane);

  const EchoLayout* layout_ = nullptr;
  int planes_ = kPlanes;
  int lines_ = 0;
  int steps_ = 0;
  double step_mm_ = 0.5;
  float release_ = 1.0F;
  float most_ = 1.0F;
  float gelPerStep_db_ = 0.0F;
  std::array<float, 256> perStep_db_{};
  std::array<float, 256> reflection_db_{};
  std::vector<float> elevation_mm_;                   ///< by step: one standard deviation
  std::vector<float> own_db_;                         ///< by plane, step, line
  std::vector<float> reflection_;                     ///< likewise
  std::vector<float> gains_;                          ///< likewise; in the end the first plane has the sum
  LineWays ways_;                                     ///< in voxels of the labels
  std::array<std::vector<glm::vec3>, kPlanes> back_;  ///< by plane: EchoMotion::rowsOf, in voxels
  std::vector<float> skin_mm_;                        ///< by line: how much gel is before it
  EchoRays rays_;
  /// Of the march through a plane, by line.
  struct March {
    std::vector<float> waiting_db, loss_log2, reflection_log2;
    std::vector<float> met_db;    ///< the reflection of what the line is in or was in last
    std::vector<float> since_mm;  ///< for how long it has been out of that
    EchoRays::Scratch rays;
  };
  std::array<March, kPlanes> marches_;
};

}  // namespace ew::detail
