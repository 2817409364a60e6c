#include "saved_picture.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "annotated_pictures.h"
#include "annotation_paint.h"
#include "caliper_paint.h"
#include "caliper_words.h"
#include "ew/scanning/picture_file.h"
#include "ew/ui/main_window.h"
#include "figures.h"
#include "picture_image.h"
#include "session.h"
#include "shown_mark.h"
#include "theme.h"
#include "words.h"

namespace ew::ui {
namespace {

constexpr int kLine_px = 20;
constexpr int kHead_px = 2 * kLine_px + 8;
constexpr int kScale_px = 56;
constexpr int kFoot_px = 32;    // the warning
constexpr int kLeast_px = 480;  // the words need as much
const QColor kWords(150, 150, 150);
const QColor kMeasured(220, 220, 220);

QString settingsOf(const Session& session) {
  const Knobs& knobs = session.pictureKnobs();
  const QString probe = words(session.pictureProbe().name), depth_cm = figure(session.geometry().depth_mm / 10.0, 1);
  QString line =
      resolvedGainLaw(knobs, session.pictureScene()) == GainLaw::decibel
          ? MainWindow::tr("%1   depth %2 cm   gain %3 dB").arg(probe, depth_cm, signedFigure(knobs.gain_db, 1))
          : MainWindow::tr("%1   depth %2 cm   gain %3 %").arg(probe, depth_cm).arg(static_cast<int>(std::lround(knobs.gain * 100.0)));
  if (knobs.zoom > 1.0) line += MainWindow::tr("   zoom %1").arg(figure(knobs.zoom, 1));
  return line;
}

void paintScale(QPainter& painter, const DisplayGeometry& geometry, const QRect& picture) {
  const double down = geometry.upsideDown ? -1.0 : 1.0;
  constexpr int kTick_mm = 10;
  for (int at_mm = 0; at_mm <= static_cast<int>(geometry.depth_mm + 1e-9); at_mm += kTick_mm) {
    const double y = picture.top() + geometry.face_px.y + down * at_mm / geometry.pixel_mm;
    if (y < picture.top() || y > picture.bottom()) continue;
    const bool isLabelled = at_mm % (5 * kTick_mm) == 0;
    const int x = picture.right() + 12;
    painter.drawLine(QPointF(x, y), QPointF(x + (isLabelled ? 10 : 5), y));
    if (isLabelled) drawFigures(painter, QRect(x + 12, static_cast<int>(y) - 10, 24, 20), Qt::AlignLeft, QString::number(at_mm / 10));
  }
  drawFigures(painter, QRect(picture.right() + 24, picture.bottom() - 8, 30, 20), Qt::AlignLeft, MainWindow::tr("cm"));
}

/// One line each: number, what it is, all results.
void paintMeasured(QPainter& painter, const Calipers& calipers, const QRect& room) {
  painter.setFont(smallFont());
  painter.setPen(kMeasured);
  int top = room.top();
  for (const Calipers::Line& line : calipers.lines()) {
    QString text = QStringLiteral("%1   %2   %3")
                       .arg(QString::number(line.measurement.number), CaliperWords::titleOf(line.measurement),
                            CaliperWords::mainResult(line.measured));
    if (const QString others = CaliperWords::otherResults(line.measured, QStringLiteral("   ")); !others.isEmpty())
      text += QStringLiteral("   ") + others;
    painter.drawText(QRect(room.left(), top, room.width(), kLine_px), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, room.width()));
    top += kLine_px;
  }
}

/// What lies on the picture itself. @param picture where it is on the saved one
void paintOn(QPainter& painter, const Session& session, const OnPicture& on, const QRect& picture) {
  const DisplayGeometry& geometry = session.geometry();
  const auto pixelOf = [&](const glm::dvec2& at_mm) {  // the middle of a pixel
    return QPointF(picture.left() + 0.5 + geometry.face_px.x + (geometry.markerLeft ? -1.0 : 1.0) * at_mm.x / geometry.pixel_mm,
                   picture.top() + 0.5 + geometry.face_px.y + (geometry.upsideDown ? -1.0 : 1.0) * at_mm.y / geometry.pixel_mm);
  };
  painter.save();
  painter.setClipRect(picture);
  if (on.calipers != nullptr && !on.calipers->lines().empty()) paintCalipers(painter, *on.calipers, pixelOf, {Qt::white, Qt::white});
  if (on.annotations != nullptr) paintAnnotations(painter, on.annotations->all(), 0, pixelOf, {Qt::white, Qt::white});
  if (on.mark != nullptr && std::min(picture.width(), picture.height()) >= 3 * kMark_px)
    paintMark(painter, *on.mark, QRectF(picture.left() + 4, picture.bottom() - kMark_px - 3, kMark_px, kMark_px));
  painter.restore();
}

}  // namespace

QImage savedPicture(const Session& session, const QDateTime& at, const OnPicture& on) {
  if (!session.subject() || session.picture().isEmpty()) return {};
  const QImage shown = imageOf(session.picture());
  const int measured_px = on.calipers != nullptr ? kLine_px * static_cast<int>(on.calipers->lines().size()) : 0;
  QImage saved(std::max(kLeast_px, shown.width() + kScale_px), kHead_px + shown.height() + measured_px + kFoot_px, shown.format());
  saved.fill(Qt::black);
  const QRect picture((saved.width() - kScale_px - shown.width()) / 2, kHead_px, shown.width(), shown.height());
  QPainter painter(&saved);
  painter.setFont(smallFont());
  painter.setPen(kWords);
  const auto line = [&](int number, Qt::Alignment side, const QString& text) {
    const QRect room(12, 4 + number * kLine_px, saved.width() - 24, kLine_px);
    painter.drawText(room, side | Qt::AlignVCenter, painter.fontMetrics().elidedText(text, Qt::ElideRight, room.width()));
  };
  const QString when = QLocale().toString(at, QLocale::ShortFormat);
  const int when_px = painter.fontMetrics().horizontalAdvance(when) + 24;
  line(0, Qt::AlignLeft, painter.fontMetrics().elidedText(words(session.subject()->title), Qt::ElideRight, saved.width() - 24 - when_px));
  line(0, Qt::AlignRight, when);
  line(1, Qt::AlignLeft, settingsOf(session));
  paintScale(painter, session.geometry(), picture);
  painter.end();
  const int pixel_bytes = shown.depth() / 8;
  for (int y = 0; y < shown.height(); ++y)
    std::copy_n(shown.scanLine(y), pixel_bytes * shown.width(), saved.scanLine(kHead_px + y) + pixel_bytes * picture.left());
  QPainter over(&saved);
  paintOn(over, session, on, picture);
  if (measured_px > 0) paintMeasured(over, *on.calipers, QRect(12, kHead_px + shown.height() + 4, saved.width() - 24, measured_px));
  return saved;
}

Result<void> writeShownPicture(const Session& session, const QDateTime& at, const std::filesystem::path& file, const OnPicture& on) {
  const double pixel_mm = session.geometry().pixel_mm;
  if (file.extension() == ".mha") return writePicture(session.picture(), pixel_mm, file);
  const QImage saved = savedPicture(session, at, on);
  if (saved.format() == QImage::Format_Grayscale8)
    return writePicture(Picture{{saved.constBits(), saved.width(), saved.height(), saved.bytesPerLine()}}, pixel_mm, file);
  RgbImage colours(saved.width(), saved.height());
  for (int y = 0; y < saved.height(); ++y)
    std::copy_n(reinterpret_cast<const Rgb*>(saved.constScanLine(y)), saved.width(), viewOf(colours).row(y));
  return writePicture(colours, pixel_mm, file);
}

}  // namespace ew::ui
