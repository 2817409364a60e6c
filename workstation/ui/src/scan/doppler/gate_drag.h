#pragma once

#include <glm/glm.hpp>

#include "scan/doppler/drag_on_image.h"

namespace ew::ui {

/// The sample volume under the mouse: a drag within it moves it, one at its ends makes it longer or shorter, one at an end of the flow line
/// turns that; so does the wheel, by a degree.
class GateDrag final : public DragOnImage {
 public:
  using DragOnImage::DragOnImage;

 protected:
  [[nodiscard]] bool hasAny() const override;
  [[nodiscard]] std::optional<Grip> gripAt(const QPointF& at) const override;
  void begin(int part, const QPointF& at) override;
  void moveTo(int part, const QPointF& at) override;
  bool turn(int steps) override;

 private:
  enum Part { gate, length, angle };
  [[nodiscard]] glm::dvec2 placeAt(const QPointF& at) const;  ///< in the image plane, mm

  glm::dvec2 from_{0.0};  ///< of the volume's middle, from the pointer
};

}  // namespace ew::ui
