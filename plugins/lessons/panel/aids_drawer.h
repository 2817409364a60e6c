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
  std::optional<ExpectedPlane> plane_;
  int label_ = 0;
};

/// The outline of a structure in an image plane, as short lines of the image plane's mm: where its label ends between neighbours of a grid
/// of `step_mm`.
[[nodiscard]] std::vector<sdk::OverlayLine<frame::Probe>> outlineOf(const sdk::Scanned& scanned, int label, const ScanState& image,
                                                                    double step_mm);

}  // namespace ew::lessons
