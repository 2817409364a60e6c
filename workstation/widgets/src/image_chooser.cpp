#include "ew/widgets/image_chooser.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ew/widgets/theme.h"

namespace ew {
namespace {

bool holds(const PixelRect& rect, const QPointF& pixel) {
  return pixel.x() >= rect.x && pixel.y() >= rect.y && pixel.x() < rect.x + rect.width && pixel.y() < rect.y + rect.height;
}

std::int64_t areaOf(const PixelRect& rect) { return std::int64_t{rect.width} * rect.height; }

}  // namespace

ImageChooser::ImageChooser(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("pictureChooser"));
  setCursor(Qt::CrossCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("The image as the file holds it"));
}

void ImageChooser::setImage(const GreyImage& level, const std::vector<std::uint8_t>& coloured) {
  image_ = QImage(level.width, level.height, QImage::Format_RGB32);
  for (int y = 0; y < level.height; ++y) {
    auto* row = reinterpret_cast<QRgb*>(image_.scanLine(y));
    for (int x = 0; x < level.width; ++x) {
      const std::size_t n = static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x);
      const int grey = level.pixels[n];
      row[x] = !coloured.empty() && coloured[n] != 0 ? qRgb(std::max(grey, 160), grey * 3 / 5, 0) : qRgb(grey, grey, grey);
    }
  }
  update();
}

void ImageChooser::setParts(std::vector<PixelRect> parts) {
  parts_ = std::move(parts);
  update();
}

void ImageChooser::setChosenPart(std::optional<std::size_t> part) {
  chosen_ = part && *part < parts_.size() ? part : std::nullopt;
  update();
}

void ImageChooser::setBlanked(std::vector<PixelRect> rects) {
  blanked_ = std::move(rects);
  update();
}

double ImageChooser::scale() const {
  if (image_.isNull()) return 1.0;
  return std::min(static_cast<double>(width()) / image_.width(), static_cast<double>(height()) / image_.height());
}

QPointF ImageChooser::origin() const { return {0.5 * (width() - scale() * image_.width()), 0.5 * (height() - scale() * image_.height())}; }

QPointF ImageChooser::pixelAt(const QPointF& at) const { return (at - origin()) / scale(); }

QRectF ImageChooser::placeOf(const PixelRect& rect) const {
  return {origin() + scale() * QPointF(rect.x, rect.y), scale() * QSizeF(rect.width, rect.height)};
}

PixelRect ImageChooser::between(const QPointF& a, const QPointF& b) const {
  const QPointF p = pixelAt(a), q = pixelAt(b);
  const auto within = [](double at, int most) { return std::clamp(static_cast<int>(std::lround(at)), 0, most); };
  const int left = within(std::min(p.x(), q.x()), image_.width()), right = within(std::max(p.x(), q.x()), image_.width());
  const int top = within(std::min(p.y(), q.y()), image_.height()), bottom = within(std::max(p.y(), q.y()), image_.height());
  return {left, top, right - left, bottom - top};
}

void ImageChooser::mousePressEvent(QMouseEvent* event) {
  if (image_.isNull()) return;
  if (event->button() == Qt::RightButton) {
    const QPointF pixel = pixelAt(event->localPos());
    for (std::size_t n = blanked_.size(); n-- > 0;)
      if (holds(blanked_[n], pixel)) {
        Q_EMIT blankRemoved(static_cast<int>(n));
        return;
      }
  } else if (event->button() == Qt::LeftButton) {
    from_ = to_ = event->localPos();
  }
}

void ImageChooser::mouseMoveEvent(QMouseEvent* event) {
  if (!from_) return;
  to_ = event->localPos();
  update();
}

void ImageChooser::mouseReleaseEvent(QMouseEvent* event) {
  if (!from_ || event->button() != Qt::LeftButton) return;
  const QPointF from = *from_, to = event->localPos();
  from_.reset();
  to_.reset();
  update();
  if ((to - from).manhattanLength() >= QApplication::startDragDistance()) {
    const PixelRect rect = between(from, to);
    if (rect.width > 0 && rect.height > 0) Q_EMIT drawn(rect);
    return;
  }
  // Of parts within each other the smallest is meant.
  const QPointF pixel = pixelAt(to);
  std::optional<std::size_t> hit;
  for (std::size_t n = 0; n < parts_.size(); ++n)
    if (holds(parts_[n], pixel) && (!hit || areaOf(parts_[n]) < areaOf(parts_[*hit]))) hit = n;
  if (hit) Q_EMIT partClicked(static_cast<int>(*hit));
}

void ImageChooser::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  const Theme theme = scanTheme();
  if (image_.isNull()) {
    painter.setPen(theme.quiet);
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, tr("No image can be shown yet."));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF whole = placeOf({0, 0, image_.width(), image_.height()});
  painter.drawImage(whole, image_);
  QColor veil(Qt::black);
  veil.setAlpha(150);
  if (chosen_) {
    QPainterPath around, kept;
    around.addRect(whole);
    kept.addRect(placeOf(parts_[*chosen_]));
    painter.fillPath(around.subtracted(kept), veil);
  }
  for (std::size_t n = 0; n < parts_.size(); ++n) {
    const QRectF place = placeOf(parts_[n]);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(n == chosen_ ? theme.accent : theme.quiet, n == chosen_ ? 2.0 : 1.0));
    painter.drawRect(place);
    painter.drawText(place.adjusted(6, 4, -6, -4), Qt::AlignLeft | Qt::AlignTop, QString::number(n + 1));
  }
  std::vector<QRectF> black;
  for (const PixelRect& one : blanked_) black.push_back(placeOf(one));
  if (from_) black.push_back(placeOf(between(*from_, *to_)));
  painter.setBrush(Qt::black);
  painter.setPen(QPen(theme.text, 1.0, Qt::DashLine));
  for (const QRectF& one : black) painter.drawRect(one);
}

}  // namespace ew
