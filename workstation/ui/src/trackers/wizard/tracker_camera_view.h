#pragma once

#include <QColor>
#include <QImage>
#include <QPolygonF>
#include <QWidget>
#include <vector>

namespace ew::ui {

/// What a camera sees, with what was found in it outlined, and where it has been seen already. An empty image says why in its place.
class TrackerCameraView final : public QWidget {
  Q_OBJECT

 public:
  struct Outline {
    QPolygonF corners;  ///< in pixels of the image
    QColor colour;
    QString word;  ///< beside it; may be empty
  };
  /// How much of each part of the image is done, 0..1, row by row; nothing: not asked.
  struct Coverage {
    int columns = 0, rows = 0;
    std::vector<double> shares;
    int next = -1;  ///< the part that is wanted now; -1: none
  };

  explicit TrackerCameraView(QWidget* parent = nullptr);

  void setImage(const QImage& image, std::vector<Outline> outlines);
  void setCoverage(Coverage coverage);
  /// Where there is no image.
  void setEmptySentence(const QString& sentence);
  /// Left and right as in a mirror, which is how people know themselves.
  void setMirrored(bool mirrored);
  [[nodiscard]] bool hasImage() const { return !image_.isNull(); }
  [[nodiscard]] std::size_t outlineCount() const { return outlines_.size(); }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QRectF place() const;  ///< of the image in the widget
  [[nodiscard]] QPointF shown(const QPointF& pixel, const QRectF& at) const;
  void paintCoverage(QPainter& painter, const QRectF& at) const;
  void paintOutlines(QPainter& painter, const QRectF& at) const;

  QImage image_;
  std::vector<Outline> outlines_;
  Coverage coverage_;
  QString empty_;
  bool mirrored_ = false;
};

}  // namespace ew::ui
