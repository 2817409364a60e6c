#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <random>
#include <vector>

#include "camera_truth/paper_camera.h"

namespace ew::camera_truth {

/// A webcam with a usual lens: 68 degrees across, distortion of a few per cent at the edge, the axis off the middle.
[[nodiscard]] CameraModel webcam(int width = 1280, int height = 720);

struct MotionOptions {
  double near_mm = 400.0, far_mm = 700.0;
  double moves_mm = 0.0;  ///< amplitude of the probe's slow swing; 0: it is still
  double turns_rad = 0.0;
  double rate_hz = 0.4;     ///< of the swing
  double tipped_rad = 1.0;  ///< how far the probe's axis is tipped from upright at most; pi: it lies anyhow
  bool straightOn = false;  ///< one face almost straight on, as flips need it
};

/// Where a probe and a board are in front of a camera: begun at random, moved smoothly. Both lie wholly in the image at the start.
class TruthMotion {
 public:
  TruthMotion(const CameraModel& model, const std::vector<MarkerBody>& bodies, const MotionOptions& options, std::uint64_t seed);
  /// bodyToCamera of both: the probe, then the board (still).
  [[nodiscard]] std::vector<glm::dmat4> at(double time_s) const;

 private:
  glm::dmat4 probe_{1.0}, board_{1.0};
  MotionOptions options_;
  glm::dvec3 way_{0.0}, axis_{0.0};
  double phase_ = 0.0, turnPhase_ = 0.0;
};

/// An error against the truth, of the place of a point of the body and of the turn.
struct TruthError {
  double place_mm = 0.0, turn_rad = 0.0;
};
[[nodiscard]] TruthError errorOf(const glm::dmat4& found, const glm::dmat4& truth, const glm::dvec3& at_body);

/// The value below which a part of them lies. @param part 0..1
[[nodiscard]] double percentile(std::vector<double> values, double part);

}  // namespace ew::camera_truth
