#pragma once

#include <glm/glm.hpp>

#include "ew/bridge/scene3d.h"
#include "ew/core/volume.h"

namespace ew::bridge {

/// A viewer on a sphere around a focal point, upright (superior is up). Plain arithmetic; the scene copies it into VTK's camera.
class OrbitCamera {
 public:
  static constexpr double kOpening_rad = 0.5235987755982988;  ///< 30 degrees from top to bottom

  /// What the image shows at least, measured in the plane through the focal point.
  struct Framing {
    glm::dvec3 focal_mm{0.0};
    double width_mm = 0.0;
    double height_mm = 0.0;
  };

  void setWindow(int width_px, int height_px);
  void look(CameraPreset preset, const Framing& framing);
  /// From the front and above, from whichever side faces a plane with this normal best.
  void overlook(const glm::dvec3& planeNormal, const Framing& framing);
  void frame(const Framing& framing);  ///< keeps the direction
  void orbit(double right_rad, double up_rad);
  void pan(glm::dvec2 by_px, const Bounds& within);
  void zoom(double factor);

  [[nodiscard]] glm::dvec3 focal_mm() const { return focal_mm_; }
  [[nodiscard]] glm::dvec3 eye_mm() const { return focal_mm_ + distance_mm_ * toViewer(); }
  [[nodiscard]] double distance_mm() const { return distance_mm_; }
  [[nodiscard]] glm::dvec3 forward() const { return -toViewer(); }
  [[nodiscard]] glm::dvec3 right() const;
  [[nodiscard]] glm::dvec3 up() const;

  [[nodiscard]] Ray rayAt(glm::dvec2 at_px) const;
  [[nodiscard]] Sight sight() const;
  [[nodiscard]] glm::dvec2 pixelOf(const glm::dvec3& p_mm) const { return sight().pixelOf(p_mm); }
  [[nodiscard]] double mmPerPixelAt(const glm::dvec3& p_mm) const { return sight().mmPerPixelAt(p_mm); }

 private:
  [[nodiscard]] glm::dvec3 toViewer() const;
  void refit();

  int width_px_ = 1;
  int height_px_ = 1;
  glm::dvec3 focal_mm_{0.0};
  double distance_mm_ = 1800.0;
  double azimuth_rad_ = 0.0;
  double elevation_rad_ = 0.0;
  Framing framing_;
  bool framed_ = false;  ///< nobody has moved the camera since: a new window size keeps the framing
};

}  // namespace ew::bridge
