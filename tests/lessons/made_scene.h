#pragma once

#include "ew/imaging/probe.h"
#include "logic/step_scene.h"

namespace ew::lessons::test {

/// A labelled ball of 20 mm about (0, 0, 0) in a box of 80 mm, number 7.
inline sdk::Scanned ball() {
  Volume labels;
  labels.grid.dims = glm::ivec3(81);
  labels.grid.spacing_mm = glm::dvec3(1.0);
  labels.grid.origin_mm = glm::dvec3(-40.0);
  labels.echo.assign(labels.grid.voxelCount(), 0);
  for (int k = 0; k < 81; ++k)
    for (int j = 0; j < 81; ++j)
      for (int i = 0; i < 81; ++i)
        if (glm::length(glm::dvec3(i, j, k) - 40.0) <= 20.0) labels.echo[labels.grid.indexOf(i, j, k)] = 7;
  sdk::Scanned scanned;
  scanned.volume = scanned.placedLabels = labels.grid;
  scanned.labels = std::make_shared<const Volume>(std::move(labels));
  return scanned;
}

/// A probe of 60 mm that looks along the world's +y from y = -40, moved and turned about its own axes.
inline Transform<frame::World, frame::Probe> held(double z_mm = 0.0, double tilt_deg = 0.0) {
  glm::dmat4 turn(1.0);
  const double c = std::cos(glm::radians(tilt_deg)), s = std::sin(glm::radians(tilt_deg));
  turn[1] = {0.0, c, s, 0.0};
  turn[2] = {0.0, -s, c, 0.0};
  turn[3] = {0.0, -40.0, z_mm, 1.0};
  return {turn};
}

inline ScanState image(const Transform<frame::World, frame::Probe>& at, double time_s = 0.0) {
  ScanState state;
  state.probe.id = "linear-7.5";
  state.probe.name = "Linear";
  state.probe.kind = ProbeKind::linear;
  state.probe.width_mm = 60.0;

  state.probe.maxDepth_mm = 120.0;
  state.knobs.depth_mm = 80.0;
  state.pose.probeToWorld = at;
  state.time_s = time_s;
  return state;
}

inline StepScene scene() {
  auto truth = std::make_shared<CaseTruth>();
  truth->planes.push_back({.name = "middle", .probeToWorld = held(), .positionTolerance_mm = 5.0, .angleTolerance_deg = 10.0, .shows = {}});
  truth->structures.push_back({"ball", "", 7});
  truth->points.push_back({"middle of the ball", glm::dvec3(0.0), 4.0});
  truth->measurements.push_back({"ball, across", "distance", 40.0, "mm", 2.0, {}, ""});
  return {truth, ball()};
}

inline LessonStep step(LessonTask task) {
  LessonStep made;
  made.id = "one";
  made.title = "One";
  made.task = std::move(task);
  return made;
}

inline MeasurementSubmission length(double value_mm) {
  MeasurementSubmission made;
  made.kind = "distance";
  made.figures.push_back({"length", value_mm, "mm"});
  return made;
}

}  // namespace ew::lessons::test
