#include "images/saved_picture.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "annotate/annotated_pictures.h"
#include "annotate/annotation_paint.h"
#include "annotate/shown_mark.h"
#include "ew/core/contract.h"
#include "ew/core/ending.h"
#include "ew/imaging/orientation_marker.h"
#include "ew/scanning/picture_file.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/picture_image.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "measure/calipers/caliper_paint.h"
#include "measure/words/caliper_words.h"
#include "measure/words/finding_words.h"
#include "scan/session.h"
#include "window/layout/window_text.h"

namespace ew::ui {
namespace {

constexpr int kLine_px = 20;
constexpr int kMarkerRow_px = 14;  // above the picture, whose pixels stay as they are
constexpr int kHead_px = 2 * kLine_px + 4 + kMarkerRow_px;
constexpr int kScale_px = 56;
constexpr int kBetween_px = 8;  // picture and strip
constexpr int kFoot_px = 32;    // the warning
constexpr int kLeast_px = 480;  // the words need as much
constexpr double kMarkerRadius_px = 5.0;
const QColor kWords(150, 150, 150);
const QColor kMeasured(220, 220, 220);

QString settingsOf(const Session& session) {
  const Knobs& knobs = session.pictureKnobs();
  const QString probe = nameOfProbe(session.pictureProbe().name), depth_cm = figure(session.geometry().depth_mm / 10.0, 1);
  QString line =
      resolvedGainLaw(knobs, session.pictureScene()) == GainLaw::decibel
          ? WindowText::tr("%1   depth %2 cm   gain %3 dB").arg(probe, depth_cm, signedFigure(knobs.gain_db, 1))
          : WindowText::tr("%1   depth %2 cm   gain %3 %").arg(probe, depth_cm).arg(static_cast<int>(std::lround(knobs.gain * 100.0)));
  if (knobs.zoom > 1.0) line += WindowText::tr("   zoom %1").arg(figure(knobs.zoom, 1));
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
  drawFigures(painter, QRect(picture.right() + 24, picture.bottom() - 8, 30, 20), Qt::AlignLeft, WindowText::tr("cm"));
}

int linesOf(const Calipers& calipers) { return static_cast<int>(calipers.lines().size() + calipers.findings().combinations().size()); }

/// One line each: number, what it is, all results; below them results over several.
void paintMeasured(QPainter& painter, const Calipers& calipers, const QRect& room) {
  painter.setFont(smallFont());
  painter.setPen(kMeasured);
  int top = room.top();
  for (const Calipers::Line& line : calipers.lines()) {
    QString text = QStringLiteral("%1   %2   %3")
                       .arg(CaliperWords::numberOf(line.where, line.measurement.number), CaliperWords::titleOf(line.measurement),
                            CaliperWords::mainResult(line.measured));
    if (const QString others = CaliperWords::otherResults(line.measured, QStringLiteral("   ")); !others.isEmpty())
      text += QStringLiteral("   ") + others;
    painter.drawText(QRect(room.left(), top, room.width(), kLine_px), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, room.width()));
    top += kLine_px;
  }
  for (const measurement::Combination& each : calipers.findings().combinations()) {
    const QString text =
        QStringLiteral("%1   %2   %3")
            .arg(FindingWords::numberOf(each), FindingWords::nameOf(each.kind), FindingWords::valueOf(calipers.findings(), each));
    painter.drawText(QRect(room.left(), top, room.width(), kLine_px), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, room.width()));
    top += kLine_px;
  }
}

/// The orientation marker, above the picture at the side to which the probe's own points.
void paintMarkerAbove(QPainter& painter, const Session& session, const QRect& picture) {
  const double x = markerPlace_px(session.pictureProbe(), session.geometry(), 0.0, kMarkerRadius_px).x;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(Qt::white);
  painter.drawEllipse(QPointF(picture.left() + 0.5 + x, picture.top() - 0.5 * kMarkerRow_px), kMarkerRadius_px, kMarkerRadius_px);
  painter.setBrush(Qt::NoBrush);
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
  if (on.calipers != nullptr && !on.calipers->lines().empty())
    paintCalipers(painter, *on.calipers, Where::picture, pixelOf, {Qt::white, Qt::white});
  if (on.annotations != nullptr) paintAnnotations(painter, on.annotations->all(), 0, pixelOf, {Qt::white, Qt::white});
  if (on.mark != nullptr && std::min(picture.width(), picture.height()) >= 3 * kMark_px)
    paintMark(painter, *on.mark, QRectF(picture.left() + 4, picture.bottom() - kMark_px - 3, kMark_px, kMark_px));
  painter.restore();
}

/// What lies on the strip of the M-mode, and seconds below it.
void paintOnStrip(QPainter& painter, const Session& session, const OnPicture& on, const QRect& strip) {
  constexpr int kTick_px = 5;
  const double second_px = 1.0 / session.seen().mMode().columnTime_s();
  painter.setFont(smallFont());
  painter.setPen(kWords);
  for (int second = 0; second * second_px < strip.width(); ++second) {
    const int x = strip.left() + static_cast<int>(std::lround(second * second_px));
    painter.drawLine(x, strip.bottom() + 1, x, strip.bottom() + 1 + kTick_px);
    if (second > 0 && second_px >= 2.0 * kLine_px)
      drawFigures(painter, QRect(x - 40, strip.bottom() + kTick_px, 44, kLine_px), Qt::AlignRight, WindowText::tr("%1 s").arg(second));
  }
  if (on.calipers == nullptr || !on.calipers->hasStrip()) return;
  const measurement::StripPlane plane = on.calipers->stripPlane();
  const auto pixelOf = [&](const glm::dvec2& at) {
    const auto pixel = plane.pixelOf(at);
    return pixel ? QPointF(pixel->x + 0.5, pixel->y + 0.5) : QPointF(-1000.0, at.y / plane.rowDepth_mm());
  };
  painter.save();
  painter.translate(strip.topLeft());
  painter.setClipRect(QRect(QPoint(0, 0), strip.size()));
  paintCalipers(painter, *on.calipers, Where::strip, pixelOf, {Qt::white, Qt::white});
  painter.restore();
}

/// The images that are on the screen, one below the other.
struct Shown {
  QImage picture, strip;  ///< null: not shown
  [[nodiscard]] int width() const { return std::max(picture.width(), strip.width()); }
  [[nodiscard]] int stripTop_px() const { return picture.isNull() ? 0 : picture.height() + kBetween_px; }
  [[nodiscard]] int height() const { return strip.isNull() ? picture.height() : stripTop_px() + strip.height() + kLine_px + kBetween_px; }
};
Shown shownBy(const Session& session) {
  const DisplayMode mode = session.pictureKnobs().mode;
  Shown shown;
  const QImage picture = imageOf(session.picture());
  if (mode != DisplayMode::bMode && session.seen().strip().width > 0)
    shown.strip = imageOf(session.seen().strip()).convertToFormat(picture.format());
  if (mode != DisplayMode::mMode || shown.strip.isNull()) shown.picture = picture;
  return shown;
}

/// Of a picture that is saved by itself. @param width_px of all of it
SavedPlace placeOf(const Session& session, const Shown& shown, int width_px) {
  const UsualTextSize usual;
  const QPoint corner((width_px - kScale_px - shown.width()) / 2, kHead_px);
  return {&session, QRect(corner, shown.picture.size()), QRect(corner + QPoint(0, shown.stripTop_px()), shown.strip.size())};
}

}  // namespace

QImage savedPicture(const Session& session, const QDateTime& at, const OnPicture& on, const QString& name) {
  const UsualTextSize usual;
  if (!session.subject() || session.picture().isEmpty()) return {};
  const Shown shown = shownBy(session);
  const int measured_px = on.calipers != nullptr ? kLine_px * linesOf(*on.calipers) : 0;
  QImage saved(std::max(kLeast_px, shown.width() + kScale_px), kHead_px + shown.height() + measured_px + kFoot_px,
               (shown.picture.isNull() ? shown.strip : shown.picture).format());
  saved.fill(Qt::black);
  const auto [whose, picture, strip] = placeOf(session, shown, saved.width());
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
  const QString settings = name.isEmpty() ? settingsOf(session) : name + QStringLiteral("   ") + settingsOf(session);
  const QString person = painter.fontMetrics().elidedText(on.person, Qt::ElideRight, saved.width() / 3);
  const int person_px = person.isEmpty() ? 0 : painter.fontMetrics().horizontalAdvance(person) + 24;
  line(1, Qt::AlignLeft, painter.fontMetrics().elidedText(settings, Qt::ElideRight, saved.width() - 24 - person_px));
  line(1, Qt::AlignRight, person);
  if (!shown.picture.isNull()) paintScale(painter, session.geometry(), picture);
  if (!shown.picture.isNull() && session.wide() == nullptr) paintMarkerAbove(painter, session, picture);  // a wide one has no such side
  painter.end();
  for (const auto& [image, place] : {std::pair{shown.picture, picture}, std::pair{shown.strip, strip}}) {
    const int pixel_bytes = saved.depth() / 8;
    for (int y = 0; y < image.height(); ++y)
      std::copy_n(image.constScanLine(y), pixel_bytes * image.width(), saved.scanLine(place.top() + y) + pixel_bytes * place.left());
  }
  QPainter over(&saved);
  if (!shown.picture.isNull()) paintOn(over, session, on, picture);
  if (!shown.strip.isNull()) paintOnStrip(over, session, on, strip);
  if (measured_px > 0) paintMeasured(over, *on.calipers, QRect(12, kHead_px + shown.height() + 4, saved.width() - 24, measured_px));
  return saved;
}

SavedTogether savedPictures(const std::vector<SavedPart>& parts, int columns, const QDateTime& at) {
  const UsualTextSize usual;
  SavedTogether saved;
  std::vector<QImage> each;
  for (const SavedPart& part : parts)
    if (QImage image = savedPicture(*part.session, at, part.on, part.name); !image.isNull()) {
      saved.places.push_back(placeOf(*part.session, shownBy(*part.session), image.width()));
      each.push_back(std::move(image));
    }
  if (each.size() < 2) {
    if (!each.empty()) saved.image = each.front();
    return saved;
  }
  const auto across = static_cast<std::size_t>(std::clamp(columns, 1, static_cast<int>(each.size())));
  const std::size_t rows = (each.size() + across - 1) / across;
  bool isGrey = true;
  std::vector<int> widths(across, 0), heights(rows, 0);
  for (std::size_t n = 0; n < each.size(); ++n) {
    isGrey = isGrey && each[n].format() == QImage::Format_Grayscale8;
    widths[n % across] = std::max(widths[n % across], each[n].width());
    heights[n / across] = std::max(heights[n / across], each[n].height());
  }
  const QImage::Format format = isGrey ? QImage::Format_Grayscale8 : QImage::Format_RGB888;
  QImage& all = saved.image;
  all = QImage(std::accumulate(widths.begin(), widths.end(), 0), std::accumulate(heights.begin(), heights.end(), 0), format);
  all.fill(Qt::black);
  const auto pixel_bytes = static_cast<std::size_t>(all.depth() / 8);
  int top = 0, left = 0;
  for (std::size_t n = 0; n < each.size(); ++n) {
    const QImage image = each[n].convertToFormat(format);
    for (int y = 0; y < image.height(); ++y)
      std::copy_n(image.constScanLine(y), static_cast<std::size_t>(image.width()) * pixel_bytes,
                  all.scanLine(top + y) + static_cast<std::size_t>(left) * pixel_bytes);
    for (QRect* part : {&saved.places[n].picture, &saved.places[n].strip}) part->translate(left, top);
    left += widths[n % across];
    if ((n + 1) % across != 0) continue;
    top += heights[n / across];
    left = 0;
  }
  return saved;
}

Result<void> writeShownPictures(const std::vector<SavedPart>& parts, int columns, const QDateTime& at, const std::filesystem::path& file) {
  const auto inHand = std::find_if(parts.begin(), parts.end(), [](const SavedPart& part) { return part.isInHand; });
  EW_EXPECTS(inHand != parts.end());
  const double pixel_mm = inHand->session->geometry().pixel_mm;
  if (hasEnding(file, ".mha")) return writePicture(inHand->session->picture(), pixel_mm, file);
  const QImage saved = savedPictures(parts, columns, at).image;
  if (saved.format() == QImage::Format_Grayscale8)
    return writePicture(Picture{{saved.constBits(), saved.width(), saved.height(), saved.bytesPerLine()}}, pixel_mm, file);
  return writePicture(coloursOf(saved), pixel_mm, file);
}

}  // namespace ew::ui
