#include "scan/colour_on_image.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "scan/lines_on_image.h"
#include "scan/scan_view.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr int kBar_px = 14;
constexpr int kFromFan_px = 6;
constexpr int kLeastBar_px = 48;

int lineOfNumbers_px() { return scaled(16); }
int widthOfNumbers_px() { return scaled(38); }

/// In cm/s, without a decimal where nobody reads it.
QString numberOf(double velocity_mmPerS) { return signedFigure(velocity_mmPerS / 10.0, std::abs(velocity_mmPerS) < 995.0 ? 1 : 0); }

}  // namespace

std::optional<Knobs> knobsWithBox(const Session& session) {
  const Knobs& knobs = session.imageKnobs();
  if (!knobs.colour || !session.subject() || !session.subject()->showsColour()) return std::nullopt;
  if (knobs.mode == DisplayMode::mMode || session.wide() != nullptr) return std::nullopt;
  return knobs;
}

BoxOutline outlineOfBox(const Probe& probe, const Knobs& knobs, const std::function<QPointF(const glm::dvec2&)>& placeOf) {
  QPolygonF points;
  for (const glm::dvec2& p_mm : colourBoxOutline_mm(probe, knobs)) points << placeOf(p_mm);
  // Closed: down the left edge, along the lower one, up the right one, back along the upper one, as many points on both arcs.
  const int last = points.size() - 1, arc = last / 2;
  return {points.mid(0, 2), points.mid(1, arc), points.mid(arc, 2), points.mid(arc + 1, last - arc)};
}

BoxOutline outlineOfBox(const ScanView& scan, const Probe& probe, const Knobs& knobs) {
  return outlineOfBox(probe, knobs, [&scan](const glm::dvec2& p_mm) { return scan.positionOf({{p_mm.x, p_mm.y, 0.0}}); });
}

void paintColourBox(QPainter& painter, const BoxOutline& outline) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QPolygonF all = outline.all();
  drawOnImage(painter, kLineOnImage, 1.0, [&] { painter.drawPolyline(all); });
  painter.restore();
}

QSize sizeOfColourBar(int imageHeight_px, bool hasNumbers) {
  const int bar_px = std::max(kLeastBar_px, imageHeight_px / 3);
  return hasNumbers ? QSize(widthOfNumbers_px(), bar_px + 3 * lineOfNumbers_px()) : QSize(kBar_px, bar_px);
}

QRect placeOfColourBar(const QRect& room, const std::vector<QRect>& taken, const QSize& size) {
  if (size.width() > room.width() || size.height() > room.height()) return {};
  for (const bool isLow : {false, true}) {
    for (const bool isLeft : {false, true}) {
      QRect there(room.topLeft(), size);
      if (!isLeft) there.moveRight(room.right());
      if (isLow) there.moveBottom(room.bottom());
      const QRect apart = there.adjusted(-kFromFan_px, -kFromFan_px, kFromFan_px, kFromFan_px);
      if (std::none_of(taken.begin(), taken.end(), [&](const QRect& each) { return each.intersects(apart); })) return there;
    }
  }
  return {};
}

void paintColourBar(QPainter& painter, const QRect& place, const Probe& probe, const Knobs& knobs, bool hasNumbers, bool isOverImage) {
  const ColourBox box = colourBoxOf(probe, knobs);
  const ColourDoppler& colour = *knobs.colour;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  if (isOverImage) painter.fillRect(place.adjusted(-2, -2, 2, 2), QColor(0, 0, 0, 170));
  const int line_px = hasNumbers ? lineOfNumbers_px() : 0;
  const QRect bar(place.right() + 1 - kBar_px, place.top() + line_px, kBar_px, place.height() - (hasNumbers ? 3 : 0) * line_px);
  const RgbImage colours = colourBar(colour, bar.width(), bar.height());
  painter.drawImage(bar, QImage(reinterpret_cast<const uchar*>(colours.pixels.data()), colours.width, colours.height, 3 * colours.width,
                                QImage::Format_RGB888));
  const bool isOfVelocity = colour.shows == ColourShows::velocity || colour.shows == ColourShows::variance;
  const auto [lowest_mmPerS, highest_mmPerS] = box.shown_mmPerS;
  painter.setPen(QPen(kLineOnImage, 1.0));
  if (isOfVelocity || colour.shows == ColourShows::directionalPower) {
    const double share = isOfVelocity ? highest_mmPerS / (highest_mmPerS - lowest_mmPerS) : 0.5;
    const int y = bar.top() + static_cast<int>(std::lround(share * (bar.height() - 1)));
    painter.drawLine(bar.left() - 4, y, bar.right(), y);
  }
  if (hasNumbers) {
    painter.setFont(smallFont());
    painter.setPen(scanTheme().quiet);
    const auto say = [&](int top, const QString& text) {
      drawFigures(painter, QRect(place.left(), top, place.width(), line_px), Qt::AlignRight, text);
    };
    if (isOfVelocity) {
      say(place.top(), numberOf(highest_mmPerS));
      say(bar.bottom() + 1, numberOf(lowest_mmPerS));
      say(bar.bottom() + 1 + line_px, ScanView::tr("cm/s"));
    } else if (colour.shows == ColourShows::power) {
      say(place.top(), ScanView::tr("high", "power"));
      say(bar.bottom() + 1, ScanView::tr("low", "power"));
    }
  }
  painter.restore();
}

QStringList colourFigures(const Probe& probe, const Knobs& knobs) {
  const ColourBox box = colourBoxOf(probe, knobs);
  return {ScanView::tr("   colour %1 cm/s").arg(figure(box.nyquist_mmPerS / 10.0, 1)),
          ScanView::tr("   filter %1 cm/s").arg(figure(box.wallEdge_mmPerS / 10.0, 1)),
          ScanView::tr("   %1 images/s", "colour").arg(figure(1.0 / box.frame_s, 1))};
}

QString figuresThatFit(const QPainter& painter, QStringList figures, int room_px) {
  while (!figures.isEmpty() && figuresWidth_px(painter.fontMetrics(), figures.join(QString())) > room_px) figures.removeLast();
  return figures.join(QString());
}

}  // namespace ew::ui
