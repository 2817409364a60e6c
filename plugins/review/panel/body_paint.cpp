// What is painted over the body: regions, paths, planes, and where both probes are.
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ew/body/body_canvas.h"
#include "ew/imaging/display.h"
#include "ew/widgets/theme.h"
#include "panel/body_view.h"
#include "panel/review_words.h"
#include "panel/session/playback.h"
#include "panel/session/scan_pair.h"

namespace ew::review {

void BodyView::paintOver(QPainter& painter) {
  if (!still_) makeStill();
  painter.drawPixmap(0, 0, *still_);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Side side : {kCompared, kReviewed}) paintProbe(painter, side);
}

/// Thousands of regions are not painted again for every image.
void BodyView::makeStill() {
  const double ratio = devicePixelRatioF();
  QPixmap made(size() * ratio);
  made.setDevicePixelRatio(ratio);
  made.fill(Qt::transparent);
  QPainter painter(&made);
  painter.setRenderHint(QPainter::Antialiasing);
  paintRegions(painter);
  for (const Side side : {kCompared, kReviewed}) {
    if (showsPlanes_) paintPlanes(painter, side);
    paintPath(painter, side);
  }
  painter.setFont(smallFont());
  const QString text = heatWords();
  if (!text.isEmpty()) {
    const QRectF room = QRectF(rect()).adjusted(kGrid_px, 0, -kGrid_px, -kGrid_px);
    const QRectF box = painter.boundingRect(room, Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap, text);
    QColor veil = palette().color(QPalette::Window);
    veil.setAlpha(215);
    painter.setPen(Qt::NoPen);
    painter.setBrush(veil);
    painter.drawRoundedRect(box.adjusted(-4, -2, 4, 2), 3, 3);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(box, Qt::AlignLeft | Qt::TextWordWrap, text);
  }
  painter.end();
  still_ = std::move(made);
}

void BodyView::paintRegions(QPainter& painter) const {
  if (regions_.empty()) return;
  const ReviewScan* base = scans_.opened(heat_ == Heat::expert ? kCompared : kReviewed);
  const bridge::Sight sight = canvas_->sight();
  std::vector<std::pair<double, const Region*>> order;
  for (const Region& each : regions_) order.emplace_back(glm::distance(sight.eye_mm, each.middle_mm), &each);
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  const bool isTime = heat_ == Heat::trainee || heat_ == Heat::expert;
  QColor hue = isTime ? colour(heat_ == Heat::expert ? kCompared : kReviewed) : palette().color(QPalette::WindowText);
  for (const auto& [distance, region] : order) {
    const QPointF at = pixelOf(region->middle_mm);
    const double side = std::max(1.5, base->regions->side_mm() / sight.mmPerPixelAt(region->middle_mm));
    // Many lie behind each other: what is thin stays light.
    hue.setAlphaF(isTime ? 0.015 + 0.22 * region->share * region->share : 0.14);
    if (isTime) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(hue);
      painter.drawEllipse(at, 0.5 * side, 0.5 * side);
    } else {  // hollow: nothing was seen there
      painter.setPen(QPen(hue, 1.0));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(QRectF(at - QPointF(0.35 * side, 0.35 * side), QSizeF(0.7 * side, 0.7 * side)));
    }
  }
}

void BodyView::paintPath(QPainter& painter, Side side) const {
  const ReviewScan* scan = scans_.opened(side);
  if (scan == nullptr) return;
  for (const auto& line : scan->path) {
    QPainterPath path;
    bool isBegun = false;
    for (const PathPoint& point : line) {
      const QPointF at = pixelOf(point.at_mm);
      if (isBegun)
        path.lineTo(at);
      else
        path.moveTo(at);
      isBegun = true;
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, currentTheme().dark ? 120 : 50), 4.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    QPen pen(colour(side), 2.0, whoOf(side) == Who::expert ? Qt::SolidLine : Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    if (whoOf(side) == Who::trainee) pen.setDashPattern({4.0, 1.5});
    painter.setPen(pen);
    painter.drawPath(path);
  }
}

void BodyView::paintPlanes(QPainter& painter, Side side) const {
  const ReviewScan* scan = scans_.opened(side);
  if (scan == nullptr) return;
  for (const PlaneVisit& plane : scan->planes) {
    QPolygonF outline;
    for (const glm::dvec2& p : fanOutline_mm(plane.probe, {}, plane.depth_mm, 12))
      outline << pixelOf(carried(plane.probeToWorld, glm::dvec3(p, 0.0)));
    QColor line = colour(side);
    line.setAlpha(110);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(line, 1.0, plane.isFrozen ? Qt::SolidLine : Qt::DotLine));
    painter.drawPolygon(outline);
  }
}

/// Where the probe is now: its fan, the face as a thick line, and the sign of whose it is.
void BodyView::paintProbe(QPainter& painter, Side side) const {
  const ReviewScan* scan = scans_.opened(side);
  if (scan == nullptr) return;
  const ScanState state = scan->scan->recording.log.frame(playback_.frame(side));
  if (state.pose.status != PoseStatus::ok) return;
  const auto pixel = [&](const glm::dvec3& p) { return pixelOf(carried(state.pose.probeToWorld, p)); };
  QPolygonF outline;
  for (const glm::dvec2& p : fanOutline_mm(state.probe, state.knobs, resolvedDepth_mm(state.probe, state.knobs), 24))
    outline << pixel(glm::dvec3(p, 0.0));
  QColor inside = colour(side);
  inside.setAlpha(46);
  painter.setPen(QPen(colour(side), 1.5));
  painter.setBrush(inside);
  painter.drawPolygon(outline);
  QPolygonF face;
  for (const glm::dvec3& p : facePoints_mm(state.probe, 12)) face << pixel(p);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour(side), 4.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(face);
  painter.setPen(QPen(palette().color(QPalette::Window), 1.0));
  painter.setBrush(colour(side));
  drawMarkOf(painter, whoOf(side), pixel(glm::dvec3(0.0, -8.0, 0.0)), scaled(5));
}

}  // namespace ew::review
