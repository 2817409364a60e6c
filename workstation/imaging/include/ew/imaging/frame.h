#pragma once

#include <chrono>
#include <iosfwd>
#include <string>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/pose.h"
#include "ew/core/volume.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/slicing.h"

namespace ew {

/// What a case says its scene calls for; the plan runs nothing else.
struct Scene {
  bool gainAndDgc = true;
  bool operator==(const Scene&) const = default;
};

/// Where the fan of a probe lies in the picture.
struct DisplayGeometry {
  int width = 0;
  int height = 0;
  double pixel_mm = 0.0;    ///< size of a pixel, the same in both directions
  glm::dvec2 face_px{0.0};  ///< pixel coordinates of the probe frame's origin (may lie outside the picture when zoomed in)
  bool markerLeft = true;   ///< the probe's +x points to the left of the picture
  double depth_mm = 0.0;    ///< resolved: never 0
  bool operator==(const DisplayGeometry&) const = default;
  [[nodiscard]] Transform<frame::Probe, frame::Image> imageToProbe() const;
};

/// The largest scale at which the whole fan of `probe` down to the knobs' depth fits width x height with a small margin, then zoomed
/// about the picture's middle. A depth outside the probe's range is brought to the nearer end of it, a zoom to 1..8.
/// @param width, height pixels, >= 1
[[nodiscard]] DisplayGeometry fitDisplay(const Probe& probe, const Knobs& knobs, int width, int height);

/// The pixels of each row whose centres lie inside the fan: none in a row the fan does not touch, two runs beside the face of a convex
/// probe.
[[nodiscard]] Spans fanSpans(const Probe& probe, const DisplayGeometry& geometry);

/// Outline of the fan in the probe's x-y plane, mm: what the 3D view draws. Closed: the last point repeats the first. It runs along the
/// face from -x to +x, then back along the bottom; an arc has `pointsPerArc` points (>= 2), a straight edge its two ends.
[[nodiscard]] std::vector<glm::dvec2> fanOutline_mm(const Probe& probe, double depth_mm, int pointsPerArc = 48);

/// One thing a frame has to do.
enum class StepKind { sampleWeave, sampleLinear, zoomStretch, table };
const char* nameOf(StepKind kind);
struct Step {
  StepKind kind = StepKind::sampleLinear;
  double estimated_us = 0.0;  ///< from the pixel count, on a machine of 2023; not part of comparison
  bool operator==(const Step& other) const { return kind == other.kind; }
};

/// What a frame runs, in order. Neutral steps are not in it. Printable, comparable.
struct Plan {
  std::vector<Step> steps;
  bool operator==(const Plan&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Plan& plan);

/// The steps that this setting calls for. The table is left out when gain and all DGC factors are 1 or the scene has none; the zoom is
/// left out of a linear plan (interpolation needs none) and when a pixel is nowhere smaller than a voxel.
[[nodiscard]] Plan makePlan(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry, const Grid& grid);

/// Time of one step of one frame.
struct StepTime {
  StepKind kind = StepKind::sampleLinear;
  double measured_us = 0.0;
};

/// Makes frames of one probe and one setting after another; owns the tables and scratch memory, so that a frame allocates nothing.
class FrameMaker {
 public:
  /// Rebuilds what depends on these values, and only when they changed.
  void configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const Grid& grid, int width, int height);

  /// The picture for one pose: 0 outside the fan and outside the volume. The view stays valid until the next call.
  /// A pose that is not PoseStatus::ok, or whose matrix checkRigid refuses, gives a black picture; lastStatus() tells which happened.
  /// @param volume the grid's place in the world may differ from the one configured (a moved volume needs no new tables)
  ImageView<const std::uint8_t> make(const VolumeView<const std::uint8_t>& volume, const Pose& pose);

  [[nodiscard]] const Plan& plan() const { return plan_; }
  [[nodiscard]] const DisplayGeometry& geometry() const { return geometry_; }
  /// What the last frame's steps took, in the order of the plan; empty when the frame was black for want of a pose.
  [[nodiscard]] const std::vector<StepTime>& lastTimes() const { return times_; }
  /// The status of the last pose, PoseStatus::invalid when its matrix was refused, PoseStatus::missing before the first frame.
  [[nodiscard]] PoseStatus lastStatus() const { return status_; }
  [[nodiscard]] const Spans& spans() const { return spans_; }

 private:
  bool configured_ = false;
  Probe probe_;
  Knobs knobs_;
  Scene scene_;
  Grid grid_;
  DisplayGeometry geometry_;
  Plan plan_;
  Spans spans_;
  double spanPixels_ = 0.0;
  std::vector<double> rowPosition_;  ///< depth of each row, 0 at the face, 1 at the bottom
  std::vector<std::uint8_t> table_;  ///< 256 x rows of Eq. 5
  SliceScratch scratch_;
  GreyImage picture_;
  std::vector<StepTime> times_;
  PoseStatus status_ = PoseStatus::missing;
};

}  // namespace ew
