#include "annotate/annotation_paint.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

const QColor kTextEdge(0, 0, 0, 200);
constexpr double kArrowHead_px = 11.0, kArrowHalf_px = 4.5;

void paintText(QPainter& painter, const QPointF& at, const std::string& text, const QColor& colour) {
  const QFontMetricsF metrics(annotationFont());
  QPainterPath letters;
  letters.addText(at + QPointF(0.0, 0.5 * (metrics.ascent() - metrics.descent())), annotationFont(), QString::fromStdString(text));
  painter.strokePath(letters, QPen(kTextEdge, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.fillPath(letters, colour);
}

}  // namespace

QFont annotationFont() { return bold(textFont()); }

QSizeF annotationSize(const std::string& text) {
  const QFontMetricsF metrics(annotationFont());
  return {metrics.horizontalAdvance(QString::fromStdString(text)), metrics.height()};
}

void paintArrow(QPainter& painter, const QPointF& tail, const QPointF& tip, const QColor& colour) {
  const QPointF along = tip - tail;
  const double length = std::hypot(along.x(), along.y());
  if (!(length > 0.0)) return;
  const QPointF forth = along / length, aside(-forth.y(), forth.x());
  const QPointF neck = tip - std::min(kArrowHead_px, length) * forth;
  QPainterPath head(tip);
  head.lineTo(neck + kArrowHalf_px * aside);
  head.lineTo(neck - kArrowHalf_px * aside);
  head.closeSubpath();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const bool isEdge : {true, false}) {
    const QColor ink = isEdge ? kTextEdge : colour;
    painter.setPen(QPen(ink, isEdge ? 4.5 : 1.8, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(tail, neck);
    if (isEdge)
      painter.strokePath(head, QPen(ink, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    else
      painter.fillPath(head, ink);
  }
}

void paintAnnotations(QPainter& painter, const std::vector<annotation::Annotation>& all, int selected,
                      const std::function<QPointF(const glm::dvec2&)>& pixelOf, const AnnotationColours& colours) {
  painter.setRenderHint(QPainter::Antialiasing);
  for (const annotation::Annotation& each : all) {
    const QColor& colour = each.number == selected ? colours.chosen : colours.line;
    if (each.kind == annotation::AnnotationKind::arrow)
      paintArrow(painter, pixelOf(each.tail_mm), pixelOf(each.at_mm), colour);
    else
      paintText(painter, pixelOf(each.at_mm), each.text, colour);
  }
}

}  // namespace ew::ui
