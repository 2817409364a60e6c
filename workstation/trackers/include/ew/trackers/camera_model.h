#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "ew/core/message.h"
#include "ew/core/result.h"

namespace ew {

namespace frame {
struct Camera {};  ///< pinhole of the lens; x to the right of the image, y down, z into the scene; mm
}  // namespace frame

/// How a camera maps the world to its image: a pinhole and a lens that bends rays. Pixels have their centres at whole numbers.
/// Source: D. C. Brown, Photogrammetric Engineering 37(8), 1971, in the coefficients OpenCV writes: with x = X/Z, y = Y/Z, r2 = x2 + y2,
/// x' = x (1 + k1 r2 + k2 r4 + k3 r6) + 2 p1 x y + p2 (r2 + 2 x2), y' likewise with p1 and p2 changed over; pixel = (fx x' + cx, fy y' +
/// cy).
struct CameraModel {
  static constexpr int kFormat = 1;
  std::string camera;                  ///< which camera, as the computer names it; may be empty
  int width = 0, height = 0;           ///< pixels of the images it was found from
  double fx = 0.0, fy = 0.0;           ///< focal lengths, pixel
  double cx = 0.0, cy = 0.0;           ///< where the optical axis meets the image, pixel
  std::array<double, 5> distortion{};  ///< k1, k2, p1, p2, k3
  double rms_px = 0.0;                 ///< of the corners it was found from; 0: it was not found but assumed
  int views = 0;                       ///< images it was found from
  std::string made;                    ///< ISO 8601, UTC; empty: assumed
  bool operator==(const CameraModel&) const = default;
};

/// Where a point in front of the camera (z > 0) appears, pixel.
[[nodiscard]] glm::dvec2 pixelOf(const CameraModel& model, const glm::dvec3& p_camera);
/// The ray through a pixel as (X/Z, Y/Z): the lens taken back by Newton's method, to 1e-10 wherever the lens maps one to one.
[[nodiscard]] glm::dvec2 rayThrough(const CameraModel& model, const glm::dvec2& p_px);

/// A model for a try without calibration: no distortion, the field of view of most webcams. Distances are wrong by as much as the guess.
/// @param fieldOfView_rad across the width
[[nodiscard]] CameraModel assumedCamera(int width, int height, double fieldOfView_rad = 1.13);

/// The same lens behind images of another size that show the same field: one scale in both directions.
/// @error badField where the aspect ratio is another (more than 1 % off): such an image is cropped, and by how much nobody knows
[[nodiscard]] Result<CameraModel> scaledTo(const CameraModel& model, int width, int height);

/// JSON, one line a field, with a format number.
[[nodiscard]] std::string cameraModelText(const CameraModel& model);
/// @param where how sentences name the document
/// @error badHeader (not JSON), badField (with field, found, expected), newerFormat
[[nodiscard]] Result<CameraModel> parseCameraModel(std::string_view text, const Message& where);

}  // namespace ew
