#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "ew/core/image.h"
#include "ew/trackers/camera_model.h"
#include "ew/trackers/marker_body.h"

namespace ew::camera_truth {

/// A cube of paper with a marker on four sides and the lid; x to the marker side, y down to the face, origin in the middle.
[[nodiscard]] MarkerBody boxBody(double side_mm = 60.0, double marker_mm = 44.0, double faceBelow_mm = 85.0, int firstId = 0);
/// A flat board of columns x rows markers; x right, y down, z away from whoever sees it, origin in the middle.
[[nodiscard]] MarkerBody boardBody(int columns = 3, int rows = 4, double pitch_mm = 54.0, double marker_mm = 44.0, int firstId = 30);

struct PaperCameraOptions {
  int superSampling = 2;        ///< pixels of the rendered image per pixel of the camera, 1 or 2
  double lensBlur_px = 0.6;     ///< standard deviation of a point, camera pixels
  double gamma = 1.0;           ///< the camera encodes light to this inverse power; 2.2: as webcams do
  double noise_grey = 2.0;      ///< standard deviation
  double curl_mm = 0.0;         ///< by how much the middle of a face bulges out
  double readout_frames = 0.0;  ///< rolling shutter: from the first row to the last, as a part of the time the given poses span
  double paperMargin_mm = 8.0;  ///< white around a marker
  std::uint64_t seed = 1;       ///< of noise and background
  /// A room of rectangles behind, noise everywhere; else only the surroundings of the bodies are drawn, on an even grey without noise: a
  /// tenth of the time.
  bool room = true;
};

/// One exposure.
struct PaperShot {
  /// Poses of all bodies at even times through the exposure (and the readout), bodyToCamera; one: nothing moves.
  std::vector<std::vector<glm::dmat4>> poses;
  double unevenLight = 0.0;  ///< how much darker the darker side is, 0..1
  double lightAngle_rad = 0.0;
  double exposure = 1.0;  ///< of all light
  struct Cover {
    glm::dvec3 at_camera{0.0};
    double radius_mm = 10.0;
  };
  std::optional<Cover> cover;  ///< a thumb
  std::uint64_t seed = 1;      ///< of the noise
};

/// Images of paper bodies by a camera that is known exactly: textured squares drawn by VTK through a pinhole, blurred and bent by the
/// lens, lit unevenly, encoded and noisy.
class PaperCamera {
 public:
  PaperCamera(const CameraModel& model, const std::vector<MarkerBody>& bodies, const PaperCameraOptions& options);
  ~PaperCamera();
  [[nodiscard]] GreyImage image(const PaperShot& shot);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ew::camera_truth
