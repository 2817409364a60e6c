#pragma once

#include <array>
#include <span>
#include <vector>

#include "echo_layout.h"
#include "echo_motion.h"
#include "ew/imaging/bands.h"
#include "ew/imaging/slice_source.h"

namespace ew::detail {

/// What lines lose on their way, from the labels of the tissue: attenuation beyond what the machine expects, reflections, the shadows they
/// throw and the enhancement behind fluid. Labels are blended between voxels; three planes of the slice are walked. With t the share of the
/// amplitude that is left one way,
///   t(z + dz) = G(t(z)) 10^(-L / 40),  L = 2 (a - expected) f dz + reflections that were entered, both ways, dB
///   gain = mean over the planes of t^2
/// G spreads a shadow over its lines as the aperture sees around what throws it: a ray bundle from an aperture A that is focused at z has
/// at z0 the standard deviation 0.29 A (1 - z0 / z) (Szabo, Diagnostic Ultrasound Imaging, the chapter on arrays); the running blur of
/// variance 0.27 (0.29 A)^2 dz / z agrees with it within a quarter from z = 1.3 z0 to 3 z0.
/// A reflection comes in behind its surface, over a wavelength (1/e), so that the surface's own echo stays bright.
class EchoLosses {
 public:
  void configure(const EchoLayout& layout, const Probe& probe, const Scene& scene, double carrier_hz);
  /// @param labels on a grid of their own
  /// @param motion of what they name
  void walk(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, const EchoMotion& motion, Bands& bands);
  /// Of the amplitudes of a line, at each column.
  /// @param ofSteps scratch memory
  void gainsOf(int line, std::vector<float>& ofSteps, std::span<float> gains) const;

 private:
  static constexpr int kPlanes = 3;
  static constexpr std::array<float, kPlanes> kWeights{0.5F, 0.25F, 0.25F};
  static constexpr std::array<float, kPlanes> kAside{0.0F, -0.75F, 0.75F};  ///< standard deviations of the elevational beam

  [[nodiscard]] std::size_t indexOf(int plane, int step) const {
    return (static_cast<std::size_t>(plane) * static_cast<std::size_t>(steps_) + static_cast<std::size_t>(step)) *
           static_cast<std::size_t>(lines_);
  }

  /// A line in voxels of the labels.
  struct Way {
    glm::vec3 start;
    glm::vec3 perMm;
  };

  const EchoLayout* layout_ = nullptr;
  int lines_ = 0;
  int steps_ = 0;
  double step_mm_ = 0.5;
  float release_ = 1.0F;
  float most_ = 1.0F;
  std::array<float, 256> perStep_db_{};
  std::array<float, 256> reflection_db_{};
  std::vector<float> aside_;         ///< by step: what the blur gives each neighbour
  std::vector<float> elevation_mm_;  ///< by step: one standard deviation
  std::vector<float> own_db_;        ///< by plane, step, line
  std::vector<float> reflection_;    ///< likewise
  std::vector<float> gains_;         ///< by step, line
  std::vector<Way> ways_;
  std::array<std::vector<glm::vec3>, kPlanes> back_;  ///< by plane: EchoMotion::rowsOf, in voxels
  std::vector<float> amplitude_, waiting_, scratch_, loss_;
};

}  // namespace ew::detail
