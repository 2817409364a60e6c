#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "ew/core/pose.h"
#include "ew/trackers/camera_calibration.h"
#include "ew/trackers/camera_model.h"
#include "ew/trackers/marker_body.h"

namespace ew::ui::testing {

/// Films of a camera that looks at a mannequin from in front of it: the printed board lies beside it, the folded body is held on its skin.
/// Made of rendered paper (tests/camera_truth) and of chess boards seen through the same lens.
class TrackerFilms {
 public:
  TrackerFilms(MarkerBody probe, MarkerBody board, CharucoBoard chess);

  [[nodiscard]] const CameraModel& lens() const { return lens_; }
  /// The chess board in many places, a second in each. @return whether it was written
  [[nodiscard]] bool writeChess(const std::string& file) const;
  /// The probe in these places one after another, a second in each.
  [[nodiscard]] bool writePaper(const std::string& file, const std::vector<Transform<frame::World, frame::Probe>>& probes) const;
  /// Nobody holds the probe; the board is there.
  [[nodiscard]] bool writeEmpty(const std::string& file) const;

  /// What an alignment is to find: the board is the tracker's frame.
  [[nodiscard]] const glm::dmat4& boardToWorld() const { return boardToWorld_; }

 private:
  CameraModel lens_;
  MarkerBody probe_, board_;
  CharucoBoard chess_;
  glm::dmat4 worldToCamera_{1.0}, boardToWorld_{1.0};
};

}  // namespace ew::ui::testing
