#pragma once

#include <memory>
#include <opencv2/core.hpp>

#include "ew/core/message.h"
#include "ew/trackers/camera_device.h"

namespace ew {

struct CameraFrame {
  cv::Mat grey;            ///< its own
  double stamp_s = 0.0;    ///< on the camera's clock: steadyNow_s() where it stamps by it, else arrival; of a film, from its beginning
  double arrival_s = 0.0;  ///< steadyNow_s()
  double taken_s = 0.0;    ///< when it was exposed, on steadyNow_s(), as well as that is known
};

/// Where images come from: a camera or a film, opened.
class CameraFrames {
 public:
  enum class Next { image, notYet, over, lost };
  virtual ~CameraFrames() = default;
  /// Waits a fifth of a second at most.
  [[nodiscard]] virtual Next next(CameraFrame& image) = 0;
};

/// Opens the camera or film; null with a sentence where that does not work now.
[[nodiscard]] std::unique_ptr<CameraFrames> openImages(const CameraSettings& settings, Message& why);
/// Whether it names a file rather than a camera.
[[nodiscard]] bool isFilm(const std::string& device);

}  // namespace ew
