#pragma once

#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

#include "ew/core/image.h"

namespace ew {

/// An image on which a person sees and chooses what is kept of it: a click chooses one of its parts, a drag draws a rectangle that is made
/// black, a right click takes one away. Rectangles count pixels of the image.
class ImageChooser final : public QWidget {
  Q_OBJECT

 public:
  explicit ImageChooser(QWidget* parent = nullptr);

  /// @param coloured like level.pixels: 1 where the source is coloured, which is shown in orange; may be empty
  void setImage(const GreyImage& level, const std::vector<std::uint8_t>& coloured);
  void setParts(std::vector<PixelRect> parts);
  void setChosenPart(std::optional<std::size_t> part);  ///< what lies around it is dimmed; empty: nothing is
  void setBlanked(std::vector<PixelRect> rects);

  /// Where a pixel of the image is drawn, in the widget.
  [[nodiscard]] QRectF placeOf(const PixelRect& rect) const;
  [[nodiscard]] QSize sizeHint() const override { return {480, 360}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 180}; }

 Q_SIGNALS:
  void partClicked(int part);             ///< from 0
  void drawn(const ew::PixelRect& rect);  ///< a rectangle, not empty
  void blankRemoved(int number);          ///< of the blanked rectangles, from 0

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] double scale() const;
  [[nodiscard]] QPointF origin() const;  ///< of the image in the widget
  [[nodiscard]] QPointF pixelAt(const QPointF& at) const;
  [[nodiscard]] PixelRect between(const QPointF& a, const QPointF& b) const;

  QImage image_;
  std::vector<PixelRect> parts_;
  std::vector<PixelRect> blanked_;
  std::optional<std::size_t> chosen_;
  std::optional<QPointF> from_, to_;  ///< of the drag, in the widget
};

}  // namespace ew
