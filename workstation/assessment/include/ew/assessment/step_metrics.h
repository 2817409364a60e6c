#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ew/assessment/metric.h"
#include "ew/assessment/motion.h"
#include "ew/assessment/step_work.h"
#include "ew/core/progress.h"
#include "ew/scanning/events.h"

namespace ew {

/// An image of a scan and how long it was what the scan showed, frozen and paused time left out.
struct FrameDwell {
  std::size_t frame = 0;
  double seconds = 0.0;
};
/// Every image of a log. A window makes an image only when something changed, so that an image holds until the next one, a freeze, a pause
/// (a note of kind "pause" until one of kind "resume") or the end of the log.
[[nodiscard]] std::vector<FrameDwell> heldFramesOf(const ScanLog& log);
/// The poses of a log for motionOf, each repeated every 40 ms for as long as it was held: a probe that rests makes no images.
[[nodiscard]] std::vector<Pose> heldPosesOf(const ScanLog& log);

struct ContactFigures {
  std::optional<double> first_s;   ///< when the face first touched, on the log's clock; empty: never
  double lossShare = 0.0;          ///< of the time from then on, 0..1: less than half of the face touches
  std::optional<double> press_mm;  ///< mean depth of the face's deepest point while it touches; empty: gaps were not kept
};
[[nodiscard]] ContactFigures contactOf(const ScanLog& log);

/// Volume of the convex hull of points, by the outermost of them in 1024 directions: exact for bodies with few corners, a little less for
/// round ones (a ball 1 %). 0: fewer than four points, or all in one plane.
[[nodiscard]] double hullVolume_mm3(std::span<const glm::dvec3> points_mm);

/// The expert's side of a step.
struct ExpertStep {
  const ScanLog* scan = nullptr;        ///< of the very step; null: none
  std::optional<ScanState> image = {};  ///< that the expert stored; empty: none is known
};

/// What a step of an attempt left behind.
struct StepRecord {
  const LessonStep& step;
  const StepOutcome& outcome;
  const ScanLog* scan = nullptr;         ///< null: nothing was scanned
  std::optional<VoxelPass> passed = {};  ///< by all of the scan's images, where it was judged by them: then they are not looked at again
};

/// Every metric of the step's kind that can be worked out, in the order of metrics(). Poses that are not `ok` are left out.
/// @error cancelled
[[nodiscard]] Result<std::vector<MetricValue>> metricsOf(const StepRecord& record, const CaseGround& ground, const ExpertStep& expert,
                                                         Progress& progress = noProgress());

/// Part of the images with a pose that can be used, 0..1; 1 of a log without images.
[[nodiscard]] double validShareOf(const ScanLog& log);

/// The image of an expert's scan that shows a plane best: where shareOfTolerance is least. Empty: no valid pose.
[[nodiscard]] std::optional<ScanState> bestImageOf(const ScanLog& scan, const ReferencePlane& plane, const CaseTruth& truth);

}  // namespace ew
