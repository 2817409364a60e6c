#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "ew/core/frames.h"
#include "ew/tracking/tool_reading.h"

namespace ew {

/// How one of the two parts of a calibration was found, for people and for the check that it still fits.
struct CalibrationQuality {
  std::string method;      ///< "pivot_and_flat", "body_file", "landmarks", "surface", "board" ...; "none": the identity, for a try
  std::string made;        ///< ISO 8601, UTC
  double residual_mm = 0;  ///< root mean square
  double expected_mm = 0;  ///< how far off it may be where it matters (one standard deviation); 0: not known
  int samples = 0;
  bool operator==(const CalibrationQuality&) const = default;
};

/// What makes a tool's readings a transducer on the mannequin: probeToWorld = trackerToWorld * toolToTracker * probeToTool.
struct TrackerCalibration {
  static constexpr int kFormat = 1;
  int revision = 0;       ///< counts up with every calibration that is kept
  std::string source;     ///< which tracker, as its settings name it
  std::string tool;       ///< that the transducer face was found for
  std::string reference;  ///< that the tracker frame is fixed to; empty: the tracker itself
  std::string body;       ///< id of the marker body, for a camera; empty otherwise
  std::string mannequin;  ///< that it was aligned to; empty: none
  Transform<frame::Tool, frame::Probe> probeToTool;
  CalibrationQuality face;
  Transform<frame::World, frame::Tracker> trackerToWorld;
  CalibrationQuality alignment;
  bool operator==(const TrackerCalibration&) const = default;
};

}  // namespace ew
