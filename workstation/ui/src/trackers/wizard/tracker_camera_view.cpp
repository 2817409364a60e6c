#include "trackers/wizard/tracker_camera_view.h"

#include <QPainter>
#include <algorithm>

#include "ew/widgets/theme.h"

namespace ew::ui {

TrackerCameraView::TrackerCameraView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("trackerCamera"));
  setAccessibleName(tr("What the camera sees"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize TrackerCameraView::sizeHint() const { return {scaled(480), scaled(270)}; }
QSize TrackerCameraView::minimumSizeHint() const { return {scaled(240), scaled(135)}; }

void TrackerCameraView::setImage(const QImage& image, std::vector<Outline> outlines) {
  image_ = image;
  outlines_ = std::move(outlines);
  update();
}

void TrackerCameraView::setCoverage(Coverage coverage) {
  coverage_ = std::move(coverage);
  update();
}

void TrackerCameraView::setEmptySentence(const QString& sentence) {
  if (empty_ == sentence) return;
  empty_ = sentence;
  setAccessibleDescription(sentence);
  update();
}

void TrackerCameraView::setMirrored(bool mirrored) {
  mirrored_ = mirrored;
  update();
}

QRectF TrackerCameraView::place() const {
  const QSizeF size = QSizeF(image_.size()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
  return {(width() - size.width()) / 2.0, (height() - size.height()) / 2.0, size.width(), size.height()};
}

QPointF TrackerCameraView::shown(const QPointF& pixel, const QRectF& at) const {
  const double x = pixel.x() / image_.width();
  return {at.left() + (mirrored_ ? 1.0 - x : x) * at.width(), at.top() + pixel.y() / image_.height() * at.height()};
}

void TrackerCameraView::paintCoverage(QPainter& painter, const QRectF& at) const {
  const Theme look = scanTheme();
  for (int n = 0; n < static_cast<int>(coverage_.shares.size()); ++n) {
    const int column = n % coverage_.columns, row = n / coverage_.columns;
    const int shownColumn = mirrored_ ? coverage_.columns - 1 - column : column;
    const double w = at.width() / coverage_.columns;
    const double h = at.height() / coverage_.rows;
    const QRectF cell(at.left() + shownColumn * w, at.top() + row * h, w, h);
    QColor fill = look.accent;
    fill.setAlphaF(0.28 * std::clamp(coverage_.shares[static_cast<std::size_t>(n)], 0.0, 1.0));
    painter.fillRect(cell, fill);
    if (n != coverage_.next) continue;
    painter.setPen(QPen(look.accent, 3.0, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(cell.adjusted(4.0, 4.0, -4.0, -4.0), 4.0, 4.0);
  }
}

void TrackerCameraView::paintOutlines(QPainter& painter, const QRectF& at) const {
  painter.setFont(smallFont());
  for (const Outline& each : outlines_) {
    QPolygonF corners;
    for (const QPointF& corner : each.corners) corners << shown(corner, at);
    painter.setPen(QPen(Qt::black, 4.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(corners);
    painter.setPen(QPen(each.colour, 2.0));
    painter.drawPolygon(corners);
    if (each.word.isEmpty()) continue;
    const QRectF word = QRectF(painter.boundingRect(QRect(), Qt::AlignLeft, each.word)).adjusted(-4.0, -2.0, 4.0, 2.0);
    QRectF box(corners.boundingRect().topLeft() - QPointF(0.0, word.height() + 2.0), word.size());
    box.moveLeft(std::clamp(box.left(), at.left(), std::max(at.left(), at.right() - box.width())));
    box.moveTop(std::max(box.top(), at.top()));
    painter.fillRect(box, QColor(0, 0, 0, 190));
    painter.setPen(each.colour);
    painter.drawText(box, Qt::AlignCenter, each.word);
  }
}

void TrackerCameraView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.fillRect(rect(), Qt::black);
  if (image_.isNull()) {
    painter.setPen(scanTheme().quiet);
    painter.setFont(textFont());
    painter.drawText(rect().adjusted(24, 16, -24, -16), Qt::AlignCenter | Qt::TextWordWrap, empty_);
    return;
  }
  const QRectF at = place();
  painter.drawImage(at, mirrored_ ? image_.mirrored(true, false) : image_);
  paintCoverage(painter, at);
  paintOutlines(painter, at);
}

}  // namespace ew::ui
