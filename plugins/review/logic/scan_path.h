#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "ew/core/frames.h"
#include "ew/imaging/probe.h"
#include "ew/scanning/events.h"
#include "logic/review_clock.h"

namespace ew::review {

/// Where the middle of the face was while the probe touched: a line is broken where nobody knows the pose, where nothing touches, and
/// where no frame was made for a while.
struct PathPoint {
  glm::dvec3 at_mm{0.0};  ///< world
  double time_s = 0.0;    ///< on the recording's clock
};
using SkinPath = std::vector<std::vector<PathPoint>>;

/// @param least_mm between two points of a line; the first and the last of it are kept @param longestGap_s between two frames of a line
[[nodiscard]] SkinPath skinPathOf(const ScanLog& log, const Part& part, double least_mm = 1.0, double longestGap_s = 0.5);

/// A plane that was looked at: the probe rested, or the image was frozen.
struct PlaneVisit {
  Transform<frame::World, frame::Probe> probeToWorld;
  Probe probe;
  double depth_mm = 0.0;
  double begin_s = 0.0, end_s = 0.0;  ///< on the recording's clock
  bool isFrozen = false;
};

struct VisitOptions {
  double least_s = 1.0;    ///< so long the probe stays within
  double reach_mm = 2.0;   ///< of the face's middle, and
  double reach_deg = 3.0;  ///< of where it was when it came to rest
};
/// In the order they were looked at. A frozen image is one plane however long it was frozen.
[[nodiscard]] std::vector<PlaneVisit> planeVisitsOf(const ScanLog& log, const Part& part, const VisitOptions& options = {});

}  // namespace ew::review
