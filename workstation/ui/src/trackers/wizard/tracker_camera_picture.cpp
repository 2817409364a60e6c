#include "trackers/wizard/tracker_camera_picture.h"

#include <QPainter>
#include <algorithm>

#include "ew/widgets/theme.h"

namespace ew::ui {

TrackerCameraPicture::TrackerCameraPicture(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("trackerCamera"));
  setAccessibleName(tr("What the camera sees"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize TrackerCameraPicture::sizeHint() const { return {scaled(480), scaled(270)}; }
QSize TrackerCameraPicture::minimumSizeHint() const { return {scaled(240), scaled(135)}; }

void TrackerCameraPicture::setPicture(const QImage& picture, std::vector<Outline> outlines) {
  picture_ = picture;
  outlines_ = std::move(outlines);
  update();
}

void TrackerCameraPicture::setCoverage(Coverage coverage) {
  coverage_ = std::move(coverage);
  update();
}

void TrackerCameraPicture::setEmptySentence(const QString& sentence) {
  if (empty_ == sentence) return;
  empty_ = sentence;
  setAccessibleDescription(sentence);
  update();
}

void TrackerCameraPicture::setMirrored(bool mirrored) {
  mirrored_ = mirrored;
  update();
}

QRectF TrackerCameraPicture::place() const {
  const QSizeF size = QSizeF(picture_.size()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
  return {(width() - size.width()) / 2.0, (height() - size.height()) / 2.0, size.width(), size.height()};
}

QPointF TrackerCameraPicture::shown(const QPointF& pixel, const QRectF& at) const {
  const double x = pixel.x() / picture_.width();
  return {at.left() + (mirrored_ ? 1.0 - x : x) * at.width(), at.top() + pixel.y() / picture_.height() * at.height()};
}

void TrackerCameraPicture::paintCoverage(QPainter& painter, const QRectF& at) const {
  const Theme look = scanTheme();
  for (int n = 0; n < static_cast<int>(coverage_.shares.size()); ++n) {
    const int column = n % coverage_.columns;
    const int shownColumn = mirrored_ ? coverage_.columns - 1 - column : column;
    const double w = at.width() / coverage_.columns;
    const double h = at.height() / coverage_.rows;
    const QRectF cell(at.left() + shownColumn * w, at.top() + n / coverage_.columns * h, w, h);
    QColor fill = look.accent;
    fill.setAlphaF(0.28 * std::clamp(coverage_.shares[static_cast<std::size_t>(n)], 0.0, 1.0));
    painter.fillRect(cell, fill);
    if (n != coverage_.next) continue;
    painter.setPen(QPen(look.accent, 3.0, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(cell.adjusted(4.0, 4.0, -4.0, -4.0), 4.0, 4.0);
  }
}

void TrackerCameraPicture::paintOutlines(QPainter& painter, const QRectF& at) const {
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

void TrackerCameraPicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.fillRect(rect(), Qt::black);
  if (picture_.isNull()) {
    painter.setPen(scanTheme().quiet);
    painter.setFont(textFont());
    painter.drawText(rect().adjusted(24, 16, -24, -16), Qt::AlignCenter | Qt::TextWordWrap, empty_);
    return;
  }
  const QRectF at = place();
  painter.drawImage(at, mirrored_ ? picture_.mirrored(true, false) : picture_);
  paintCoverage(painter, at);
  paintOutlines(painter, at);
}

}  // namespace ew::ui
