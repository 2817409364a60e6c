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
  bool flipLeftRight = false;
  double depth_mm = 0.0;  ///< resolved: never 0
  bool operator==(const DisplayGeometry&) const = default;
  [[nodiscard]] Transform<frame::Probe, frame::Image> imageToProbe() const;
};

/// The largest scale at which the whole fan of `probe` down to the knobs' depth fits width x height with a small margin, then zoomed
/// about the picture's middle.
[[nodiscard]] DisplayGeometry fitDisplay(const Probe& probe, const Knobs& knobs, int width, int height);

/// First and one-past-last pixel of each row inside the fan; both 0 in a row the fan does not touch.
struct RowSpan {
  int begin = 0;
  int end = 0;
  bool operator==(const RowSpan&) const = default;
};
[[nodiscard]] std::vector<std::vector<RowSpan>> fanSpans(const Probe& probe,
                                                         const DisplayGeometry& geometry);  // a convex fan's top rows have two spans

/// Outline of the fan in the probe's x-y plane, closed, mm: what the 3D view draws.
[[nodiscard]] std::vector<glm::dvec2> fanOutline_mm(const Probe& probe, double depth_mm, int pointsPerArc = 48);

/// One thing a frame has to do.
enum class StepKind { sampleWeave, sampleLinear, zoomStretch, table };
const char* nameOf(StepKind kind);
struct Step {
  StepKind kind = StepKind::sampleLinear;
  double estimated_us = 0.0;  ///< from the pixel count; not part of comparison
  bool operator==(const Step& other) const { return kind == other.kind; }
};

/// What a frame runs, in order. Neutral steps are not in it. Printable, comparable.
struct Plan {
  std::vector<Step> steps;
  bool operator==(const Plan&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Plan& plan);

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
  /// A pose that is not PoseStatus::ok gives a black picture.
  ImageView<const std::uint8_t> make(const VolumeView<const std::uint8_t>& volume, const Pose& pose);

  [[nodiscard]] const Plan& plan() const { return plan_; }
  [[nodiscard]] const DisplayGeometry& geometry() const { return geometry_; }
  [[nodiscard]] const std::vector<StepTime>& lastTimes() const { return times_; }

 private:
  Probe probe_;
  Knobs knobs_;
  Scene scene_;
  Grid grid_;
  DisplayGeometry geometry_;
  Plan plan_;
  std::vector<std::vector<RowSpan>> spans_;
  std::vector<std::uint8_t> table_;  ///< 256 x rows of Eq. 5, empty when neutral
  SliceScratch scratch_;
  GreyImage picture_;
  std::vector<StepTime> times_;
};

}  // namespace ew
