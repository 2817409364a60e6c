#pragma once

#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "ew/scanning/events.h"
#include "logic/review_clock.h"

namespace ew::review::test {

/// A linear probe of 40 mm that looks along +y.
inline Probe straightProbe() {
  Probe probe;
  probe.id = "straight";
  probe.name = "Straight";
  probe.width_mm = 40.0;
  probe.defaultDepth_mm = 60.0;
  return probe;
}

inline Pose at(const glm::dvec3& face_mm) {
  Pose pose;
  pose.probeToWorld.matrix = glm::translate(glm::dmat4(1.0), face_mm);
  return pose;
}

inline Part allOf(const ScanLog& log) { return {log.begin_s(), log.end_s()}; }

/// `frames` images, `step_s` apart from `begin_s` on; `change` makes each what it is.
inline ScanLog logOf(int frames, double step_s, const std::function<void(int, ScanState&)>& change, double begin_s = 0.0) {
  ScanLog log;
  for (int n = 0; n < frames; ++n) {
    ScanState state;
    state.probe = straightProbe();
    state.time_s = begin_s + n * step_s;
    state.number = static_cast<std::uint64_t>(n);
    change(n, state);
    log.addFrame(state);
  }
  return log;
}

}  // namespace ew::review::test
