#include "measure/calipers/caliper_paint.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "measure/words/caliper_words.h"

namespace ew::ui {
namespace {

using measurement::CaliperKind;

constexpr std::size_t kMostCrosses = 24;  // an outline with more points is taken anywhere
constexpr double kCross_px = 5.0;
constexpr double kLabel_px = 12.0;  // from a point to its number
constexpr int kLine_px = 18;
const QColor kEdge(0, 0, 0, 150);

class Brush {
 public:
  Brush(QPainter& painter, const std::function<QPointF(const glm::dvec2&)>& pixelOf, QColor colour)
      : painter_(painter), pixelOf_(pixelOf), colour_(std::move(colour)) {}

  void stroke(const QPainterPath& path, Qt::PenStyle style) {
    painter_.strokePath(path, QPen(kEdge, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPen pen(colour_, 1.2, style, Qt::FlatCap, Qt::RoundJoin);
    if (style == Qt::CustomDashLine) pen.setDashPattern({2.0, 3.0});
    painter_.strokePath(path, pen);
  }
  void line(const std::vector<glm::dvec2>& points, bool isClosed, Qt::PenStyle style) {
    if (points.size() < 2) return;
    QPainterPath path(pixelOf_(points.front()));
    for (std::size_t n = 1; n < points.size(); ++n) path.lineTo(pixelOf_(points[n]));
    if (isClosed) path.closeSubpath();
    stroke(path, style);
  }
  /// Of a strip: from a moment to a later one, around its right border where the beam has begun anew at the left between them.
  void span(const glm::dvec2& from, const glm::dvec2& to) {
    QPointF a = pixelOf_(from), b = pixelOf_(to);
    if (a.x() < 0.0 || b.x() < 0.0) return;
    if (from.x > to.x) std::swap(a, b);
    const double width = room().width();
    const double around = b.x() < a.x() ? width : 0.0;
    for (const double shift : around > 0.0 ? std::vector{0.0, -around} : std::vector{0.0}) {
      QPainterPath path(a + QPointF(shift, 0.0));
      path.lineTo(b + QPointF(shift + around, 0.0));
      stroke(path, Qt::CustomDashLine);
    }
  }
  /// A cursor over the whole strip at a moment.
  void moment(const glm::dvec2& at) {
    const double x = pixelOf_(at).x();
    if (x < 0.0) return;
    QPainterPath path(QPointF(x, room().top()));
    path.lineTo(x, room().bottom());
    stroke(path, Qt::SolidLine);
  }
  void level(const glm::dvec2& at) {
    constexpr double kHalf_px = 14.0;
    const QPointF middle = pixelOf_(at);
    if (middle.x() < 0.0) return;
    QPainterPath path(middle - QPointF(kHalf_px, 0.0));
    path.lineTo(middle + QPointF(kHalf_px, 0.0));
    stroke(path, Qt::SolidLine);
  }
  [[nodiscard]] QRectF room() const { return painter_.hasClipping() ? painter_.clipBoundingRect() : QRectF(painter_.viewport()); }
  void crosses(const std::vector<glm::dvec2>& points) {
    if (points.size() > kMostCrosses) return;
    QPainterPath path;
    for (const glm::dvec2& point : points) {
      const QPointF at = pixelOf_(point);
      if (at.x() < -kCross_px) continue;
      path.moveTo(at - QPointF(kCross_px, 0.0));
      path.lineTo(at + QPointF(kCross_px, 0.0));
      path.moveTo(at - QPointF(0.0, kCross_px));
      path.lineTo(at + QPointF(0.0, kCross_px));
    }
    stroke(path, Qt::SolidLine);
  }
  void arc(const std::vector<glm::dvec2>& points) {
    if (points.size() != 3) return;
    const QPointF vertex = pixelOf_(points[1]), a = pixelOf_(points[0]) - vertex, b = pixelOf_(points[2]) - vertex;
    const double radius = std::min({28.0, 0.6 * std::hypot(a.x(), a.y()), 0.6 * std::hypot(b.x(), b.y())});
    if (!(radius > 4.0)) return;
    const double from = std::atan2(-a.y(), a.x()) * 180.0 / std::numbers::pi;
    double sweep = std::atan2(-b.y(), b.x()) * 180.0 / std::numbers::pi - from;
    sweep -= 360.0 * std::round(sweep / 360.0);
    const QRectF box(vertex - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
    QPainterPath path;
    path.arcMoveTo(box, from);
    path.arcTo(box, from, sweep);
    stroke(path, Qt::SolidLine);
  }
  /// Beside the rightmost point, where most calipers leave room; at the border of what is painted on the other side of the leftmost one.
  void label(const std::vector<glm::dvec2>& points, const QString& text) {
    if (points.empty()) return;
    const auto byX = [this](const glm::dvec2& a, const glm::dvec2& b) { return pixelOf_(a).x() < pixelOf_(b).x(); };
    const auto [left, right] = std::minmax_element(points.begin(), points.end(), byX);
    const QFontMetrics metrics(painter_.font());
    const double width = figuresWidth_px(metrics, text), height = metrics.height();
    const QPointF at = pixelOf_(*right);
    QRectF box(at.x() + kLabel_px, at.y() - 0.5 * height, width, height);
    if (at.x() < 0.0) return;
    const QRectF within = room();
    if (box.right() + 6.0 > within.right()) box.moveRight(pixelOf_(*left).x() - kLabel_px);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(QColor(0, 0, 0, 170));
    painter_.drawRoundedRect(box.adjusted(-4.0, -1.0, 4.0, 1.0), 3.0, 3.0);
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(colour_);
    drawFigures(painter_, box.toAlignedRect(), Qt::AlignLeft, text);
  }

 private:
  QPainter& painter_;
  const std::function<QPointF(const glm::dvec2&)>& pixelOf_;
  QColor colour_;
};

void paintLine(Brush& brush, const Calipers::Line& line, const QString& label) {
  const auto& points = line.measurement.caliper.parts[0].points;
  std::vector<glm::dvec2> outline = points;
  switch (line.measurement.caliper.kind) {
    case CaliperKind::ellipse:
    case CaliperKind::fittedEllipse:
      if (line.measured.ellipse) {
        outline = pointsOn(*line.measured.ellipse, 128);
        brush.line(outline, true, Qt::SolidLine);
      } else {
        brush.line(points, false, Qt::CustomDashLine);
      }
      break;
    case CaliperKind::trace:
      brush.line(points, true, Qt::SolidLine);
      break;
    case CaliperKind::polyLine:
      brush.line(points, false, Qt::SolidLine);
      break;
    case CaliperKind::discs:
      brush.line({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(2, points.size()))}, false,
                 Qt::CustomDashLine);
      if (points.size() > 2) brush.line({points.begin() + 2, points.end()}, points.size() > 4, Qt::SolidLine);
      break;
    case CaliperKind::interval:
    case CaliperKind::heartRate:
      for (const glm::dvec2& point : points) brush.moment(point);
      if (points.size() == 2) brush.span(points[0], {points[1].x, points[0].y});
      break;
    case CaliperKind::depthDistance:
      for (const glm::dvec2& point : points) brush.level(point);
      if (points.size() == 2) brush.line({points[0], {points[0].x, points[1].y}}, false, Qt::CustomDashLine);
      break;
    case CaliperKind::slope:
      if (points.size() == 2) brush.span(points[0], points[1]);
      break;
    default:  // dots let the tissue be seen that is measured
      brush.line(points, false, Qt::CustomDashLine);
  }
  if (line.measurement.caliper.kind == CaliperKind::angle) brush.arc(points);
  brush.crosses(points);
  brush.label(outline, label);
}

}  // namespace

void paintCaliper(QPainter& painter, const Calipers::Line& line, const QString& label,
                  const std::function<QPointF(const glm::dvec2&)>& pixelOf, const QColor& colour) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(smallFont());
  Brush brush(painter, pixelOf, colour);
  paintLine(brush, line, label);
}

void paintCalipers(QPainter& painter, const Calipers& calipers, Where where, const std::function<QPointF(const glm::dvec2&)>& pixelOf,
                   const CaliperColours& colours) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(smallFont());
  const int selected = calipers.drawingIn(where).selected();
  for (const Calipers::Line& line : calipers.lines()) {
    if (line.where != where) continue;
    Brush brush(painter, pixelOf, line.measurement.number == selected ? colours.chosen : colours.line);
    paintLine(brush, line, CaliperWords::numberOf(where, line.measurement.number));
  }
  if (const auto& line = calipers.unfinished(); line && line->where == where) {
    Brush brush(painter, pixelOf, colours.chosen);
    const QString result = CaliperWords::mainResult(line->measured);
    paintLine(brush, *line, result.isEmpty() ? CaliperWords::numberOf(where, line->measurement.number) : result);
  }
}

namespace {

/// What stands beside a number on the image: the result, behind the item it was measured for.
QString resultOf(const Calipers::Line& line) {
  const QString result = CaliperWords::mainResult(line.measured);
  return line.measurement.item.empty() ? result : CaliperWords::titleOf(line.measurement) + QStringLiteral("  ") + result;
}

/// The column of numbers and results, newest last.
struct ResultColumn {
  std::vector<Calipers::Line> lines;
  int number_px = 0, value_px = 0;
  QRect box;
};

ResultColumn columnOf(const Calipers& calipers, Where where, const QRect& room) {
  ResultColumn made;
  std::copy_if(calipers.lines().begin(), calipers.lines().end(), std::back_inserter(made.lines),
               [where](const Calipers::Line& line) { return line.where == where; });
  if (made.lines.empty()) return made;
  const std::size_t most = static_cast<std::size_t>(std::max(1, (room.height() - 12) / kLine_px));
  if (made.lines.size() > most) made.lines.erase(made.lines.begin(), made.lines.end() - static_cast<std::ptrdiff_t>(most));
  const QFontMetrics metrics(smallFont());
  for (const Calipers::Line& line : made.lines) {
    made.number_px = std::max(made.number_px, figuresWidth_px(metrics, CaliperWords::numberOf(where, line.measurement.number)));
    made.value_px = std::max(made.value_px, figuresWidth_px(metrics, resultOf(line)));
  }
  made.box = {room.topLeft(), QSize(made.number_px + made.value_px + 8 + 16, static_cast<int>(made.lines.size()) * kLine_px + 8)};
  return made;
}

}  // namespace

QRect rectOfResults(const Calipers& calipers, Where where, const QRect& room) { return columnOf(calipers, where, room).box; }

void paintResults(QPainter& painter, const Calipers& calipers, Where where, const QRect& room, const CaliperColours& colours) {
  const ResultColumn column = columnOf(calipers, where, room);
  if (column.lines.empty()) return;
  painter.setFont(smallFont());
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 170));
  painter.drawRoundedRect(column.box, 4.0, 4.0);
  painter.setBrush(Qt::NoBrush);
  int top = column.box.top() + 4;
  for (const Calipers::Line& line : column.lines) {
    painter.setPen(line.measurement.number == calipers.drawingIn(where).selected() ? colours.chosen : colours.line);
    drawFigures(painter, QRect(column.box.left() + 8, top, column.number_px, kLine_px), Qt::AlignRight,
                CaliperWords::numberOf(where, line.measurement.number));
    drawFigures(painter, QRect(column.box.left() + 16 + column.number_px, top, column.value_px, kLine_px), Qt::AlignRight, resultOf(line));
    top += kLine_px;
  }
}

}  // namespace ew::ui
