#pragma once

#include <string>
#include <vector>

#include "ew/core/pose.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"
#include "ew/imaging/slice_source.h"

namespace ew {

/// What one setting costs on this machine, and how far its images are from the exact ones.
struct CostPoint {
  Knobs knobs;              ///< the setting: as asked for, but for what is varied
  double frame_ms = 0.0;    ///< median of whole frames, every effect of the scene included
  double rms_grey = 0.0;    ///< root mean square of the differences, grey levels
  double worst_grey = 0.0;  ///< the largest difference
  double psnr_db = 0.0;     ///< 20 log10(255 / rms_grey); kExact_db when nothing differs
};

struct CostOfAccuracy {
  static constexpr double kExact_db = 99.0;
  /// Whether these are qualities of live echoes (measureCostOfEchoes) or of slices.
  bool ofEchoes = false;
  /// Quality::weave, linear, cubic; against sampledExactly at the same points, of live echoes against the finest frames.
  std::vector<CostPoint> qualities;
  /// Planes of the slice thickness, 3..9; whole frames against the frames with 9 planes. Empty when the scene has no slice thickness.
  std::vector<CostPoint> planes;
  int poses = 0;
  std::size_t comparedPixels = 0;  ///< per quality; those whose whole neighbourhood lies within the volume
};

struct CostOptions {
  int poses = 5;    ///< around the one given: turned and tipped by up to 12 degrees, the same ones every time
  int repeats = 3;  ///< frames timed for each pose; one more before them warms up
  int threads = 1;
  bool operator==(const CostOptions&) const = default;
};

/// Measures on the machine it runs on. Times are wall-clock time of FrameMaker, errors are of the slice alone: gain, effects and display
/// act behind it and would hide or magnify them.
/// @param echo  rows, perhaps with bricks beside them, which frames then read as elsewhere
/// @param knobs, scene what is in use; noise, persistence and M-mode are left out, because with them frames of one pose differ
/// @param width, height of the image, >= 1
/// @error cancelled (within 0.1 s, or the time of one frame), notRigid or badField for a pose that gives no image, emptyVolume when the
///        probe does not see enough of the volume to compare
[[nodiscard]] Result<CostOfAccuracy> measureCostOfAccuracy(const SliceSource& echo, const Probe& probe, const Knobs& knobs,
                                                           const Scene& scene, const Pose& pose, int width, int height,
                                                           const CostOptions& options, Progress& progress);

/// What the reference of live echoes is formed with: the ends of the ranges of LiveEchoesEffect.
inline constexpr double kFinestSamplesPerPulse = 10.0;
inline constexpr double kFinestReach = 3.0;

/// The same for live echoes (echo_quality.h): whole frames against frames of the same scatterers, formed as finely as the settings go
/// (kFinestSamplesPerPulse, kFinestReach). How far those are from the forward model says `echoweave bench echoes`, where the whole patient
/// is known; here tissue maps are enough.
/// @param subject what frames are formed from: maps of tissue (expected), labels, volume; its pose is not used
/// @param scene   with live echoes (expected)
/// @error as measureCostOfAccuracy; emptyVolume when hardly a pixel is lit
[[nodiscard]] Result<CostOfAccuracy> measureCostOfEchoes(const FrameInput& subject, const Probe& probe, const Knobs& knobs,
                                                         const Scene& scene, const Pose& pose, int width, int height,
                                                         const CostOptions& options, Progress& progress);

/// The reference: a band-limited interpolation of the voxels with double precision, Lanczos-windowed sinc with five lobes either side
/// and weights that add up to 1, so that constants are kept exactly.
/// @return the level at a point in voxels, not rounded; -1 when the ten voxels around it along an axis do not all lie within the volume
[[nodiscard]] double sampledExactly(const SliceSource& echo, const glm::dvec3& p_voxel);

/// The fastest point whose PSNR is at least `psnr_db`; null when none is.
[[nodiscard]] const CostPoint* fastestWithin(const std::vector<CostPoint>& points, double psnr_db);

}  // namespace ew
