#pragma once

#include <memory>
#include <vector>

#include "ew/library/lesson.h"
#include "ew/sdk/host.h"
#include "ew/sdk/overlays.h"
#include "logic/step_scene.h"

namespace ew::lessons {

/// Draws the aids of a step into scan and body, as far as they are switched on. Everything goes when it is destroyed.
class AidsDrawer {
 public:
  AidsDrawer(sdk::Host& host, const LessonStep& step, StepScene scene);

  /// Which are on; those the step does not allow stay off.
  void setAids(const LessonAids& aids);
  void see(const ScanState& image);
  /// The outline is on, and nothing of what the step is about lies in the latest image.
  [[nodiscard]] bool isTargetElsewhere() const { return aids_.outline && isElsewhere_; }

 private:
  void drawBody();
  void drawScan(const ScanState& image);

  sdk::Host& host_;
  LessonStep step_;
  StepScene scene_;
  LessonAids aids_;
  std::shared_ptr<sdk::ScanOverlay> overScan_;
  std::shared_ptr<sdk::BodyOverlay> overBody_;
  sdk::Ticket inBody_;
  std::vector<Point<frame::World>> path_;
  std::optional<ReferencePlane> plane_;
  std::optional<ReferencePoint> point_;
  int label_ = 0;
  bool isElsewhere_ = false;
};

/// What was to be pointed at, with its outline and where the trainee pointed, once a step was judged. Follows the image.
class TargetShown {
 public:
  /// @param point where the trainee pointed; may be null
  TargetShown(sdk::Host& host, const LessonStep& step, const StepScene& scene, std::shared_ptr<sdk::ScanOverlay> point);

 private:
  void see();

  sdk::Host& host_;
  AidsDrawer drawer_;
  std::shared_ptr<sdk::ScanOverlay> point_;
  std::optional<Pose> pose_;  ///< that the point was set at
  sdk::Ticket events_;
};

}  // namespace ew::lessons
