#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/image.h"
#include "ew/trackers/camera_model.h"
#include "ew/trackers/camera_tracking.h"
#include "ew/trackers/marker_body.h"
#include "ew/tracking/tracker_device.h"

namespace ew {

/// A camera of this computer.
struct CameraHere {
  std::string device;  ///< "/dev/video0"
  std::string name;    ///< as it calls itself
  bool operator==(const CameraHere&) const = default;
};
/// The cameras that can deliver images now, by device.
[[nodiscard]] std::vector<CameraHere> camerasHere();

struct CameraSettings {
  std::string device;  ///< "/dev/video0", an index ("0"), or a film file
  int width = 1280, height = 720;
  double frames_hz = 30.0;
  /// Without one there are no poses: only the image, for a look and for calibrating.
  std::optional<CameraModel> model;
  std::optional<MarkerBody> probe, board;  ///< without a board the camera must stand still
  CameraTrackingOptions tracking;
  bool filmLoops = false;
  double filmSpeed = 1.0;  ///< 0: as fast as it can be worked on, without leaving an image out
  bool operator==(const CameraSettings&) const = default;
};

/// What the camera sees, for the page.
struct CameraView {
  GreyImage preview;               ///< the latest image, at most 640 pixels wide; empty before the first
  double scale = 1.0;              ///< pixels of the preview per pixel of the image
  std::uint64_t number = 0;        ///< of the image since the start
  CameraSight sight;               ///< in it; corners in pixels of the whole image. bodies: probe, then board, as far as they are given
  std::vector<std::string> names;  ///< of those bodies
  double light = 0.0;              ///< mean grey, 0..255
  double blur_px = 0.0;            ///< largest motion blur of a body
  double frames_hz = 0.0;          ///< images that came, over the last second
  double processing_ms = 0.0;      ///< median of the last images
  double latency_ms = 0.0;         ///< from the capture (as the camera stamps it, else from its arrival) to the reading, median
  std::uint64_t leftOut = 0;       ///< images that came while another was worked on
  int width = 0, height = 0;       ///< of the images
};

/// A camera as a tracker: one tool for each body, in the frame of the camera.
class CameraDevice : public TrackerDevice {
 public:
  [[nodiscard]] virtual CameraView view() const = 0;
  /// The latest image whole, for calibrating; empty before the first. Each call copies.
  [[nodiscard]] virtual GreyImage image() const = 0;
  /// Another model, bodies or options without closing the camera; device, size and rate stay as they were.
  virtual void setTracking(std::optional<CameraModel> model, std::optional<MarkerBody> probe, std::optional<MarkerBody> board,
                           const CameraTrackingOptions& options) = 0;
};

/// Readings are named after the bodies' ids. A camera that is missing, busy or pulled out is said in the status and tried again.
[[nodiscard]] std::unique_ptr<CameraDevice> makeCamera(const CameraSettings& settings);

}  // namespace ew
