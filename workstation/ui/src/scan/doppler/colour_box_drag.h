#pragma once

#include "ew/imaging/colour_doppler.h"
#include "scan/doppler/drag_on_image.h"

namespace ew::ui {

/// The colour box under the mouse: a drag within it moves it, one at an edge or a corner makes it smaller or larger.
class ColourBoxDrag final : public DragOnImage {
 public:
  using DragOnImage::DragOnImage;

 protected:
  [[nodiscard]] bool hasAny() const override;
  [[nodiscard]] std::optional<Grip> gripAt(const QPointF& at) const override;
  void begin(int part, const QPointF& at) override;
  void moveTo(int part, const QPointF& at) override;

 private:
  [[nodiscard]] ColourPlace placeAt(const QPointF& at) const;

  ColourPlace from_;  ///< of what is held, from the pointer
};

}  // namespace ew::ui
