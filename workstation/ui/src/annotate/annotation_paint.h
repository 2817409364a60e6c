#pragma once

#include <QColor>
#include <QPointF>
#include <QSizeF>
#include <functional>
#include <vector>

#include "ew/annotation/annotation.h"

class QFont;
class QPainter;

namespace ew::ui {

/// What annotations are painted with. A dark edge lies below all of it, so that it is read on bright tissue too.
struct AnnotationColours {
  QColor line;
  QColor chosen;
};

/// Texts to the right of their places, arrows to theirs. @param pixelOf where a point of the image's plane lies
void paintAnnotations(QPainter& painter, const std::vector<annotation::Annotation>& all, int selected,
                      const std::function<QPointF(const glm::dvec2&)>& pixelOf, const AnnotationColours& colours);
/// An arrow that is being drawn.
void paintArrow(QPainter& painter, const QPointF& tail, const QPointF& tip, const QColor& colour);

[[nodiscard]] QFont annotationFont();
/// How large a text is painted, in pixels of the painter.
[[nodiscard]] QSizeF annotationSize(const std::string& text);

}  // namespace ew::ui
