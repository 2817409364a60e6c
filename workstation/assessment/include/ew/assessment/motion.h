#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "ew/core/pose.h"
#include "ew/scanning/events.h"

namespace ew {

// How a hand moved the probe, as figures that do not depend on how often poses came: each moment of the motion is read off a polynomial
// through the poses around it, so that 20 and 100 poses a second give the same (how nearly: teaching-measures.md).

struct MotionOptions {
  double window_s = 0.5;       ///< poses so far around a moment, half on either side, decide its motion
  double step_s = 0.02;        ///< between two moments at most
  double longestGap_s = 0.25;  ///< between two valid poses; where more is missing, nothing is said of the way between them
  double still_mmPerS = 2.0;   ///< slower than this, and
  double still_degPerS = 2.0;  ///< turning slower than this, the probe rests
};

/// The motion of the middle of the face, and of the probe about it, at one moment.
struct MotionMoment {
  double time_s = 0.0;
  glm::dvec3 velocity_mmPerS{0.0};          ///< world
  glm::dvec3 jerk_mmPerS3{0.0};             ///< third derivative of the position, world
  glm::dvec3 angularVelocity_radPerS{0.0};  ///< about the probe's own axes
};

/// A stretch without a gap, at even moments from its first valid pose to its last.
struct MotionStretch {
  double step_s = 0.0;
  std::vector<MotionMoment> moments;  ///< at least two
  [[nodiscard]] double seconds() const { return step_s * static_cast<double>(moments.size() - 1); }
};

struct Motion {
  std::vector<MotionStretch> stretches;
  double seconds = 0.0;     ///< from the first pose to the last, valid or not
  double validShare = 0.0;  ///< of the poses
};

/// @param poses times do not fall; poses that are not `ok` are left out and counted; of poses of one time the first counts
/// @param options all above 0
[[nodiscard]] Motion motionOf(std::span<const Pose> poses, const MotionOptions& options = {});

/// The poses of the images that were made from one moment to another, with the times of the scan's clock.
[[nodiscard]] std::vector<Pose> posesOf(const ScanLog& log, double from_s, double to_s);

struct MotionFigures {
  double seconds = 0.0;          ///< as Motion
  double validShare = 0.0;       ///< as Motion
  double known_s = 0.0;          ///< of the stretches together; all figures below are of these
  double path_mm = 0.0;          ///< of the middle of the face
  double angularPath_deg = 0.0;  ///< sum of all turns about any axis
  double idleShare = 0.0;        ///< of known_s, 0..1: at rest by MotionOptions
  /// Spectral arc length of the speed, below 0, nearer to 0 is smoother; of stretches from 1 s on, by their length. Empty: there is none.
  std::optional<double> spectralArcLength;
  /// Of each movement between two rests that lasts 0.3 s or more, by its length. Empty: there is none.
  std::optional<double> logDimensionlessJerk;
};
[[nodiscard]] MotionFigures figuresOf(const Motion& motion, const MotionOptions& options = {});

/// Length of the curve of the speed's normalised amplitude spectrum up to 10 Hz, ended at the last frequency with an amplitude of 5 %;
/// negative. Balasubramanian, Melendez-Calderon, Roby-Brami, Burdet: On the analysis of movement smoothness, J NeuroEng Rehabil 12:112,
/// 2015, eq. 9 (zero padding by 16).
/// @param speed at even moments, of any unit; nothing when there are fewer than 4 or all are 0
[[nodiscard]] std::optional<double> spectralArcLength(std::span<const double> speed, double step_s);

/// -ln(T^3 / v^2 * integral of |jerk|^2), v the highest speed; a movement of minimum jerk has -ln(204.8) = -5.322. Same paper, eq. 3, with
/// the jerk as a vector, so that it does not depend on axes.
/// @return nothing when it does not move
[[nodiscard]] std::optional<double> logDimensionlessJerk(std::span<const MotionMoment> movement, double step_s);

}  // namespace ew
