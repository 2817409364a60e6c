#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/result.h"
#include "ew/tracking/tool_reading.h"

namespace ew {

/// A square marker of a body: its four outer black corners in the body's frame, mm, in the order top left, top right, bottom right, bottom
/// left as one sees the marker upright from outside.
struct Marker {
  int id = 0;
  std::array<glm::dvec3, 4> corners_mm{};
  bool operator==(const Marker&) const = default;
};

/// What a camera looks for: markers on a rigid body (a folded box of paper, a sleeve around a real probe, a flat board at the mannequin).
/// The data files are resources/marker_bodies/*.json; a school adds its own to the library's folder trackers/bodies.
struct MarkerBody {
  std::string id;                                      ///< file name without ending: "box-60"
  std::string name;                                    ///< as shown
  bool isBoard = false;                                ///< stands at the mannequin; else it is held
  std::string dictionary = "apriltag_36h11";           ///< "apriltag_36h11", "apriltag_16h5", "aruco_4x4_50", "aruco_5x5_100", ...
  std::vector<Marker> markers;                         ///< no two bodies that are used together share an id
  Transform<frame::Tool, frame::Probe> probeToTool{};  ///< where the transducer face lies when it was folded exactly; of a board: unused
  bool faceIsExact = true;  ///< false: probeToTool is a guess, since the body sits on a probe of its own; find the face by touching
  bool operator==(const MarkerBody&) const = default;
};

/// The body as a printer made it. @param factor what the printed scale of 100 mm measures, over 100 mm; > 0
[[nodiscard]] MarkerBody scaled(MarkerBody body, double factor);

}  // namespace ew
