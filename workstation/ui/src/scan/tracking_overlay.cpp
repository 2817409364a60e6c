#include "scan/tracking_overlay.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ew/widgets/icons.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "scan/tracking_look.h"

namespace ew::ui {
namespace {

constexpr double kLight = 0.4;       // of a pale image
constexpr int kBorder_px = 14;       // of the hatching
constexpr int kMostOfNote_px = 420;  // longer sentences are broken

QString lossText(const char* text) { return QCoreApplication::translate("ew::ui::TrackingOverlay", text); }

void hatchBorder(QPainter& painter, const QRect& shown, const QColor& colour) {
  painter.save();
  QPainterPath border;
  border.addRect(shown);
  QPainterPath inner;
  inner.addRect(shown.adjusted(kBorder_px, kBorder_px, -kBorder_px, -kBorder_px));
  painter.setClipPath(border - inner, Qt::IntersectClip);
  painter.fillRect(shown, QColor(0, 0, 0, 190));
  painter.setPen(QPen(colour, 3.0));
  constexpr int kApart_px = 12;
  for (int x = shown.left() - shown.height(); x < shown.right(); x += kApart_px)
    painter.drawLine(x, shown.bottom() + 1, x + shown.height(), shown.top());
  painter.restore();
  painter.setPen(QPen(colour, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(shown.adjusted(0, 0, -1, -1));
  painter.drawRect(shown.adjusted(kBorder_px, kBorder_px, -kBorder_px - 1, -kBorder_px - 1));
}

/// Room for words, with what they are about at its edge.
void paintPlate(QPainter& painter, const QRect& plate, const QColor& colour) {
  painter.setPen(QPen(colour, 2.0));
  painter.setBrush(QColor(12, 14, 17, 235));
  painter.drawRoundedRect(plate, 4.0, 4.0);
  painter.setBrush(Qt::NoBrush);
}

}  // namespace

QColor lossColour(TrackingState state) {
  switch (state) {
    case TrackingState::outOfView:
      return {0xe3, 0xa9, 0x45};  // amber
    case TrackingState::outOfRange:
      return {0xb4, 0x95, 0xf0};  // violet
    case TrackingState::invalid:
      return {0xf0, 0x82, 0x3c};  // orange
    case TrackingState::duplicate:
      return {0xe8, 0x8f, 0xc4};  // pink
    case TrackingState::stale:
      return {0xd6, 0xdb, 0x7a};  // pale yellow
    case TrackingState::lost:
      return scanTheme().danger;
    case TrackingState::live:
    case TrackingState::off:
      break;
  }
  return scanTheme().quiet;
}

QImage paled(const QImage& image) {
  const QImage grey = image.convertToFormat(QImage::Format_Grayscale8);
  QImage pale(grey.size(), QImage::Format_RGB32);
  pale.setDevicePixelRatio(image.devicePixelRatio());
  pale.fill(Qt::black);
  QPainter painter(&pale);
  painter.setOpacity(kLight);
  painter.drawImage(0, 0, grey);
  return pale;
}

QString lossLength(double seconds) {
  const int whole_s = static_cast<int>(std::max(0.0, seconds));
  return whole_s < 120 ? lossText(QT_TRANSLATE_NOOP("ew::ui::TrackingOverlay", "for %1 s")).arg(whole_s)
                       : lossText(QT_TRANSLATE_NOOP("ew::ui::TrackingOverlay", "for %1 min")).arg(whole_s / 60);
}

void paintLoss(QPainter& painter, const QRect& shown, const TrackingReport& report, bool mayMove) {
  const QColor colour = lossColour(report.state);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  hatchBorder(painter, shown, colour);

  const QString word = lookOf(report.state, scanTheme()).word;
  const QString head = lossText(QT_TRANSLATE_NOOP("ew::ui::TrackingOverlay", "Not live: %1"))
                           .arg(report.since_s < 1.0 ? word : word + QStringLiteral(", ") + lossLength(report.since_s));
  QString body = words(report.sentence);
  if (mayMove)
    body += QLatin1Char('\n') +
            lossText(QT_TRANSLATE_NOOP("ew::ui::TrackingOverlay", "Or go on with the mouse: drag the probe in the image or on the body."));
  const QFont strong = bold(textFont());
  const int icon_px = scaled(28), gap_px = kGrid_px;
  const int room_px = std::min(scaled(kMostOfNote_px), shown.width() - 2 * (kBorder_px + 4 * gap_px));
  const int words_px = room_px - icon_px - gap_px;
  const auto wrapped = [&](const QFont& font, const QString& text) {
    return QFontMetrics(font).boundingRect(QRect(0, 0, words_px, shown.height()), Qt::AlignLeft | Qt::TextWordWrap, text);
  };
  const QRect headBox = wrapped(strong, head), bodyBox = wrapped(textFont(), body);
  const int height_px = std::max(icon_px, headBox.height() + gap_px / 2 + bodyBox.height());
  QRect plate(0, 0, room_px + 4 * gap_px, height_px + 4 * gap_px);
  plate.moveCenter(shown.center());
  paintPlate(painter, plate, colour);
  const QRect inside = plate.adjusted(2 * gap_px, 2 * gap_px, -2 * gap_px, -2 * gap_px);
  icon(lookOf(report.state, scanTheme()).icon, colour).paint(&painter, QRect(inside.topLeft(), QSize(icon_px, icon_px)));
  const int left = inside.left() + icon_px + gap_px;
  painter.setFont(strong);
  painter.setPen(colour);
  painter.drawText(QRect(left, inside.top(), words_px, headBox.height()), Qt::AlignLeft | Qt::TextWordWrap, head);
  painter.setFont(textFont());
  painter.setPen(scanTheme().text);
  painter.drawText(QRect(left, inside.top() + headBox.height() + gap_px / 2, words_px, bodyBox.height()), Qt::AlignLeft | Qt::TextWordWrap,
                   body);
  painter.restore();
}

void paintTrackingNote(QPainter& painter, const QRect& shown, const QString& iconName, const QColor& colour, const QString& words) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(smallFont());
  const int icon_px = scaled(16), gap_px = kGrid_px;
  const int words_px = std::min(scaled(kMostOfNote_px), shown.width() - icon_px - 6 * gap_px);
  const QRect wrapped = painter.fontMetrics().boundingRect(QRect(0, 0, words_px, shown.height()), Qt::AlignLeft | Qt::TextWordWrap, words);
  QRect plate(0, 0, wrapped.width() + icon_px + 3 * gap_px, std::max(wrapped.height(), icon_px) + gap_px);
  plate.moveCenter(shown.center());
  plate.moveBottom(shown.top() - gap_px / 2);
  if (plate.top() < gap_px / 2) plate.moveTop(gap_px / 2);
  paintPlate(painter, plate, colour);
  const QRect inside = plate.adjusted(gap_px, gap_px / 2, -gap_px, -gap_px / 2);
  icon(iconName, colour).paint(&painter, QRect(inside.left(), inside.center().y() - icon_px / 2, icon_px, icon_px));
  painter.setPen(scanTheme().text);
  painter.drawText(inside.adjusted(icon_px + gap_px, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, words);
  painter.restore();
}

}  // namespace ew::ui
