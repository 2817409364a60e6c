#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "camera_truth/truth_motion.h"
#include "ew/trackers/camera_tracking.h"

namespace ew::camera_truth {

struct TrialOptions {
  MotionOptions motion;
  PaperCameraOptions paper;
  CameraTrackingOptions tracking;
  int sequences = 20;  ///< each begins anew, as if nothing had been seen before
  int framesEach = 10;
  double frames_hz = 30.0;
  double exposure_s = 0.0;  ///< that motion blurs; 0: none
  int subFrames = 1;        ///< poses through it
  double covered = 0.0;     ///< share of sequences in which a thumb covers a part of a marker
  double unevenLight = 0.3;
  bool board = true;
  int plainEvery = 0;  ///< every so many frames also OpenCV's estimatePoseBoard; 0: never
  std::uint64_t seed = 1;
};

struct TrialErrors {
  std::vector<double> place_mm, turn_deg;
  /// Poses shown that are turned by more than ten degrees against the truth: flips.
  int flipped = 0;
};

struct TrialResult {
  int frames = 0;
  int live = 0, outOfRange = 0, outOfView = 0, invalid = 0, ambiguous = 0;  ///< of the probe
  TrialErrors toCamera, toBoard, plain;                                     ///< at the transducer's face, of live poses
  TrialErrors boardToCamera;
  std::vector<double> track_ms;                 ///< processor time of each image
  std::vector<double> corners_px, outwards_px;  ///< corners of markers against the truth: distance, and that outwards
  int plainFrames = 0;
};

[[nodiscard]] TrialResult runTrial(const TrialOptions& options);
/// A few lines of figures.
[[nodiscard]] std::string textOf(const TrialResult& result);

}  // namespace ew::camera_truth
