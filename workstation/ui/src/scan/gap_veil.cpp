#include "scan/gap_veil.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ew/widgets/theme.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

/// The tint one cell further to all sides, so that it reaches the rim of the fan, where cells are cut.
void spread(QImage& cells, QRgb tint) {
  const QImage before = cells;
  for (int row = 0; row < cells.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(cells.scanLine(row));
    for (int near = std::max(0, row - 1); near <= std::min(cells.height() - 1, row + 1); ++near) {
      const auto* from = reinterpret_cast<const QRgb*>(before.constScanLine(near));
      for (int column = 0; column < cells.width(); ++column) {
        const bool beside = (column > 0 && from[column - 1] != 0) || (column + 1 < cells.width() && from[column + 1] != 0);
        if (beside || from[column] != 0) line[column] = tint;
      }
    }
  }
}

/// Leaves only what lies in the fan. @param at_px where the image lies on the widget
void cutToFan(QImage& image, const QPoint& at_px, const Spans& fan) {
  for (int y = 0; y < image.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    const int row = y + at_px.y();
    int done = 0;
    if (row >= 0 && row < static_cast<int>(fan.size())) {
      for (const RowSpan& run : fan[static_cast<std::size_t>(row)]) {
        std::fill(line + done, line + std::clamp(run.begin - at_px.x(), done, image.width()), 0U);
        done = std::clamp(run.end - at_px.x(), done, image.width());
      }
    }
    std::fill(line + done, line + image.width(), 0U);
  }
}

}  // namespace

void GapVeil::follow(const Session& session, double ratio) {
  const Seen seen{session.shownState().pose, session.geometry(), session.subject()->placedGrid};
  if (seen == seen_) return;
  *this = {};
  seen_ = seen;
  const RecordingGap part = session.unrecorded();
  end_mm_ = part.end_mm;
  share_ = part.share;
  if (!(part.share > 0.0)) return;
  // A tint that no tissue has, under lines that no beam follows: plain darkness would be taken for a shadow.
  const QRgb tint = qPremultiply(qRgba(34, 44, 58, 215));
  QImage cells(part.columns, part.rows, QImage::Format_ARGB32_Premultiplied);
  cells.fill(Qt::transparent);
  const int every = part.every_px;
  QRect used;
  int widest = 0;
  for (int row = 0; row < part.rows; ++row) {
    const std::uint8_t* outside = part.outside.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(part.columns);
    auto* line = reinterpret_cast<QRgb*>(cells.scanLine(row));
    int run = 0;
    for (int column = 0; column < part.columns; ++column) {
      run = outside[column] != 0 ? run + 1 : 0;
      if (run == 0) continue;
      line[column] = tint;
      used |= QRect(column, row, 1, 1);
      if (run <= widest) continue;
      widest = run;
      widest_px_ = QRect((column - run + 1) * every, row * every, run * every, every);
    }
  }
  // The border to the data moves by a cell as well, about a millimetre: what lies there is torn anyway.
  spread(cells, tint);
  used = used.adjusted(-1, -1, 1, 1).intersected(cells.rect());
  at_px_ = used.topLeft() * every - QPoint(every / 2, every / 2);
  image_ = cells.copy(used).scaled(used.size() * every, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  cutToFan(image_, at_px_, session.seen().spans());
  QPainter hatch(&image_);
  hatch.setRenderHint(QPainter::Antialiasing);
  hatch.setCompositionMode(QPainter::CompositionMode_SourceAtop);
  hatch.setPen(QPen(QColor(112, 136, 164, 120), ratio));
  // Anchored to the image and not to the veil: lines that swim while the probe moves would draw the eye.
  const double apart = 9.0 * ratio, height = image_.height();
  const double phase = std::fmod(at_px_.x() + at_px_.y() + height, apart);
  for (double x = -height - phase; x < image_.width(); x += apart) hatch.drawLine(QPointF(x + height, 0.0), QPointF(x, height));
}

void GapVeil::paint(QPainter& painter, const QRect& box, const Session& session, const QString& word) const {
  if (image_.isNull()) return;
  const double ratio = painter.device()->devicePixelRatioF();
  QImage image = image_;
  image.setDevicePixelRatio(ratio);
  painter.save();
  painter.setClipRect(box);
  painter.drawImage(QPointF(box.topLeft()) + QPointF(at_px_) / ratio, image);
  constexpr double kWorthWords = 0.12;
  painter.setFont(smallFont());
  const QSize room = painter.fontMetrics().boundingRect(word).size() + QSize(16, 6);
  const QRectF widest(QPointF(box.topLeft()) + QPointF(widest_px_.topLeft()) / ratio, QSizeF(widest_px_.size()) / ratio);
  if (share_ >= kWorthWords && widest.width() >= room.width() + 8 && session.seesVolume()) {
    QRectF label(QPointF(0.0, 0.0), QSizeF(room));
    label.moveCenter(widest.center());
    label.moveBottom(std::min(label.bottom(), box.bottom() - 4.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(34, 44, 58));
    painter.drawRoundedRect(label, 4.0, 4.0);
    painter.setPen(QColor(176, 194, 214));
    painter.drawText(label, Qt::AlignCenter, word);
  }
  painter.restore();
}

}  // namespace ew::ui
