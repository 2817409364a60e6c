#include "images/saved_image.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "annotate/annotation_paint.h"
#include "annotate/image_annotations.h"
#include "annotate/image_body_mark.h"
#include "ew/core/contract.h"
#include "ew/core/ending.h"
#include "ew/imaging/orientation_marker.h"
#include "ew/scanning/display_image_file.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/qt_image.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "measure/calipers/caliper_paint.h"
#include "measure/words/caliper_words.h"
#include "measure/words/finding_words.h"
#include "scan/colour_on_image.h"
#include "scan/fan_rects.h"
#include "scan/session.h"
#include "scan/spectrum_on_image.h"
#include "window/layout/window_text.h"

namespace ew::ui {
namespace {

constexpr int kLine_px = 20;
constexpr int kMarkerRow_px = 14;  // above the image, whose pixels stay as they are
constexpr int kHead_px = 2 * kLine_px + 4 + kMarkerRow_px;
constexpr int kScale_px = 56;
constexpr int kBetween_px = 8;  // image and strip
constexpr int kFoot_px = 32;    // the warning
constexpr int kLeast_px = 480;  // the words need as much
constexpr double kMarkerRadius_px = 5.0;
const QColor kWords(150, 150, 150);
const QColor kMeasured(220, 220, 220);

QString settingsOf(const Session& session) {
  const Knobs& knobs = session.imageKnobs();
  const QString probe = nameOfProbe(session.imageProbe().name), depth_cm = figure(session.geometry().depth_mm / 10.0, 1);
  QString line =
      resolvedGainLaw(knobs, session.imageScene()) == GainLaw::decibel
          ? WindowText::tr("%1   depth %2 cm   gain %3 dB").arg(probe, depth_cm, signedFigure(knobs.gain_db, 1))
          : WindowText::tr("%1   depth %2 cm   gain %3 %").arg(probe, depth_cm).arg(static_cast<int>(std::lround(knobs.gain * 100.0)));
  if (knobs.zoom > 1.0) line += WindowText::tr("   zoom %1").arg(figure(knobs.zoom, 1));
  if (const auto gated = knobsWithGate(session))
    line += spectralFigures(session.imageProbe(), *gated).join(QString());
  else if (knobsWithBox(session))
    line += colourFigures(session.imageProbe(), knobs).join(QString());
  return line;
}

void paintScale(QPainter& painter, const DisplayGeometry& geometry, const QRect& image) {
  const double down = geometry.upsideDown ? -1.0 : 1.0;
  constexpr int kTick_mm = 10;
  for (int at_mm = 0; at_mm <= static_cast<int>(geometry.depth_mm + 1e-9); at_mm += kTick_mm) {
    const double y = image.top() + geometry.face_px.y + down * at_mm / geometry.pixel_mm;
    if (y < image.top() || y > image.bottom()) continue;
    const bool isLabelled = at_mm % (5 * kTick_mm) == 0;
    const int x = image.right() + 12;
    painter.drawLine(QPointF(x, y), QPointF(x + (isLabelled ? 10 : 5), y));
    if (isLabelled) drawFigures(painter, QRect(x + 12, static_cast<int>(y) - 10, 24, 20), Qt::AlignLeft, QString::number(at_mm / 10));
  }
  drawFigures(painter, QRect(image.right() + 24, image.bottom() - 8, 30, 20), Qt::AlignLeft, WindowText::tr("cm"));
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

/// The orientation marker, above the image at the side to which the probe's own points.
void paintMarkerAbove(QPainter& painter, const Session& session, const QRect& image) {
  const double x = markerPlace_px(session.imageProbe(), session.geometry(), 0.0, kMarkerRadius_px).x;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(Qt::white);
  painter.drawEllipse(QPointF(image.left() + 0.5 + x, image.top() - 0.5 * kMarkerRow_px), kMarkerRadius_px, kMarkerRadius_px);
  painter.setBrush(Qt::NoBrush);
}

/// The box, and the bar of colours where the fan leaves room for it.
void paintColour(QPainter& painter, const Session& session, const std::function<QPointF(const glm::dvec2&)>& pixelOf, const QRect& image) {
  const std::optional<Knobs> knobs = knobsWithBox(session);
  if (!knobs) return;
  paintColourBox(painter, outlineOfBox(session.imageProbe(), *knobs, pixelOf));
  const QRect bar =
      placeOfColourBar(image, rectsOfFan(session.seen().spans(), image.topLeft(), 1.0), sizeOfColourBar(image.height(), true));
  if (!bar.isNull()) paintColourBar(painter, bar, session.imageProbe(), *knobs, true, false);
}

/// What lies on the image itself. @param image where it is on the saved one
void paintOn(QPainter& painter, const Session& session, const OnImage& on, const QRect& image) {
  const DisplayGeometry& geometry = session.geometry();
  const auto pixelOf = [&](const glm::dvec2& at_mm) {  // the middle of a pixel
    return QPointF(image.left() + 0.5 + geometry.face_px.x + (geometry.markerLeft ? -1.0 : 1.0) * at_mm.x / geometry.pixel_mm,
                   image.top() + 0.5 + geometry.face_px.y + (geometry.upsideDown ? -1.0 : 1.0) * at_mm.y / geometry.pixel_mm);
  };
  painter.save();
  painter.setClipRect(image);
  paintColour(painter, session, pixelOf, image);
  if (const auto gated = knobsWithGate(session)) {
    paintGate(painter, outlineOfGate(session.imageProbe(), *gated, pixelOf), *gated, image);
  }
  if (on.calipers != nullptr && !on.calipers->lines().empty())
    paintCalipers(painter, *on.calipers, Where::image, pixelOf, {Qt::white, Qt::white});
  if (on.annotations != nullptr) paintAnnotations(painter, on.annotations->all(), 0, pixelOf, {Qt::white, Qt::white});
  if (on.mark != nullptr && std::min(image.width(), image.height()) >= 3 * kMark_px)
    paintMark(painter, *on.mark, QRectF(image.left() + 4, image.bottom() - kMark_px - 3, kMark_px, kMark_px));
  painter.restore();
}

/// Scale, baseline and envelope of a spectrum, and its values below the seconds.
void paintOnSpectrum(QPainter& painter, const Session& session, const Knobs& knobs, const QRect& strip) {
  const Spectrogram* spectrogram = session.seen().spectrogram();
  if (spectrogram == nullptr) return;
  const Probe& probe = session.imageProbe();
  paintVelocityScale(painter, strip, strip.right() + kScale_px - 4, probe, knobs);
  paintBaseline(painter, strip, knobs);
  const SpectrumReading reading = readingOf(*spectrogram, knobs);
  if (session.spectrumTrace().isShown()) paintEnvelope(painter, strip, 1.0, session.seen().mMode(), knobs, reading);
  paintValues(painter,
              QRect(QPoint(strip.left(), strip.bottom() + kLine_px + kBetween_px), QSize(strip.width(), heightOfValues_px(strip.size()))),
              reading.values ? spectralValues(*reading.values, probe, knobs) : QStringList(), angleWarning(knobs.spectral->angle_rad));
}

/// What lies on the strip of the M-mode or the spectrum, and seconds below it.
void paintOnStrip(QPainter& painter, const Session& session, const OnImage& on, const QRect& strip) {
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
  if (const auto gated = knobsWithGate(session)) return paintOnSpectrum(painter, session, *gated, strip);
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
  QImage image, strip;  ///< null: not shown
  int values_px = 0;    ///< of a spectrum, below it
  [[nodiscard]] int width() const { return std::max(image.width(), strip.width()); }
  [[nodiscard]] int stripTop_px() const { return image.isNull() ? 0 : image.height() + kBetween_px; }
  [[nodiscard]] int height() const {
    return strip.isNull() ? image.height() : stripTop_px() + strip.height() + kLine_px + kBetween_px + values_px;
  }
};
Shown shownBy(const Session& session) {
  const DisplayMode mode = session.imageKnobs().mode;
  Shown shown;
  const bool isSpectrum = knobsWithGate(session).has_value();
  const bool hasBox = isSpectrum || knobsWithBox(session).has_value();  // bar, flow line and envelope have colours where no blood has
  const QImage image = hasBox ? imageOf(session.image()).convertToFormat(QImage::Format_RGB888) : imageOf(session.image());
  if (mode != DisplayMode::bMode && session.seen().strip().width > 0)
    shown.strip = imageOf(session.seen().strip()).convertToFormat(image.format());
  if (mode != DisplayMode::mMode || shown.strip.isNull()) shown.image = image;
  if (isSpectrum && !shown.strip.isNull()) shown.values_px = heightOfValues_px(shown.strip.size());
  return shown;
}

/// Of an image that is saved by itself. @param width_px of all of it
SnapshotPlace placeOf(const Session& session, const Shown& shown, int width_px) {
  const UsualTextSize usual;
  const QPoint corner((width_px - kScale_px - shown.width()) / 2, kHead_px);
  return {&session, QRect(corner, shown.image.size()), QRect(corner + QPoint(0, shown.stripTop_px()), shown.strip.size())};
}

}  // namespace

QImage savedImage(const Session& session, const QDateTime& at, const OnImage& on, const QString& name) {
  const UsualTextSize usual;
  if (!session.subject() || session.image().isEmpty()) return {};
  const Shown shown = shownBy(session);
  const int measured_px = on.calipers != nullptr ? kLine_px * linesOf(*on.calipers) : 0;
  QImage saved(std::max(kLeast_px, shown.width() + kScale_px), kHead_px + shown.height() + measured_px + kFoot_px,
               (shown.image.isNull() ? shown.strip : shown.image).format());
  saved.fill(Qt::black);
  const auto [whose, image, strip] = placeOf(session, shown, saved.width());
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
  if (!shown.image.isNull()) paintScale(painter, session.geometry(), image);
  if (!shown.image.isNull() && session.wide() == nullptr) paintMarkerAbove(painter, session, image);  // a wide one has no such side
  painter.end();
  for (const auto& [part, place] : {std::pair{shown.image, image}, std::pair{shown.strip, strip}}) {
    const std::ptrdiff_t pixel_bytes = saved.depth() / 8;
    for (int y = 0; y < part.height(); ++y)
      std::copy_n(part.constScanLine(y), pixel_bytes * part.width(), saved.scanLine(place.top() + y) + pixel_bytes * place.left());
  }
  QPainter over(&saved);
  if (!shown.image.isNull()) paintOn(over, session, on, image);
  if (!shown.strip.isNull()) paintOnStrip(over, session, on, strip);
  if (measured_px > 0) paintMeasured(over, *on.calipers, QRect(12, kHead_px + shown.height() + 4, saved.width() - 24, measured_px));
  return saved;
}

Snapshot savedImages(const std::vector<SnapshotPart>& parts, int columns, const QDateTime& at) {
  const UsualTextSize usual;
  Snapshot saved;
  std::vector<QImage> each;
  for (const SnapshotPart& part : parts)
    if (QImage image = savedImage(*part.session, at, part.on, part.name); !image.isNull()) {
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
    for (QRect* part : {&saved.places[n].image, &saved.places[n].strip}) part->translate(left, top);
    left += widths[n % across];
    if ((n + 1) % across != 0) continue;
    top += heights[n / across];
    left = 0;
  }
  return saved;
}

Result<void> writeShownImages(const std::vector<SnapshotPart>& parts, int columns, const QDateTime& at, const std::filesystem::path& file) {
  const auto inHand = std::find_if(parts.begin(), parts.end(), [](const SnapshotPart& part) { return part.isInHand; });
  EW_EXPECTS(inHand != parts.end());
  const double pixel_mm = inHand->session->geometry().pixel_mm;
  if (hasEnding(file, ".mha")) return writeDisplayImage(inHand->session->image(), pixel_mm, file);
  const QImage saved = savedImages(parts, columns, at).image;
  if (saved.format() == QImage::Format_Grayscale8)
    return writeDisplayImage(DisplayImage{{saved.constBits(), saved.width(), saved.height(), saved.bytesPerLine()}}, pixel_mm, file);
  return writeDisplayImage(coloursOf(saved), pixel_mm, file);
}

}  // namespace ew::ui
