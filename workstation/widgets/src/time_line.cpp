#include "ew/widgets/time_line.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "ew/widgets/theme.h"
#include "time_line_access.h"

namespace ew {
namespace {

constexpr double kAtEnds_px = 8.0;  // free at both ends, so that the handle stays whole
constexpr double kHandle_px = 7.0;

}  // namespace

TimeLine::TimeLine(QWidget* parent) : QWidget(parent) {
  describeTimeLines();
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setLayoutDirection(Qt::LeftToRight);  // time runs to the right in every language, as it does on the strip of an M-mode
  setAccessibleName(tr("Time line of the recording"));
  setToolTip(tr("Click or drag to another moment (arrows: a second, with Shift five; Home and End)"));
}

void TimeLine::setLength(double length_s, std::vector<Span> frozen, std::vector<double> marks_s) {
  length_s_ = length_s;
  frozen_ = std::move(frozen);
  marks_s_ = std::move(marks_s);
  setRange({}, {});
  setPosition(0.0);
}

void TimeLine::setPosition(double position_s) {
  position_s_ = std::clamp(position_s, 0.0, length_s_);
  update();
}

void TimeLine::setRange(std::optional<double> in_s, std::optional<double> out_s) {
  if (in_s == in_s_ && out_s == out_s_) return;
  in_s_ = in_s;
  out_s_ = out_s;
  update();
}

double TimeLine::xOf(double position_s) const {
  const double share = length_s_ > 0.0 ? position_s / length_s_ : 0.0;
  return kAtEnds_px + share * (width() - 2.0 * kAtEnds_px);
}

double TimeLine::positionAt(double x) const {
  return length_s_ * std::clamp((x - kAtEnds_px) / std::max(1.0, width() - 2.0 * kAtEnds_px), 0.0, 1.0);
}

void TimeLine::goTo(double position_s) {
  setPosition(position_s);
  QAccessibleValueChangeEvent told(this, position_s_);
  QAccessible::updateAccessibility(&told);
  Q_EMIT moved(position_s_);
}

void TimeLine::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) goTo(positionAt(event->localPos().x()));
}

void TimeLine::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) goTo(positionAt(event->localPos().x()));
}

void TimeLine::keyPressEvent(QKeyEvent* event) {
  const double step_s = (event->modifiers() & Qt::ShiftModifier) != 0 ? 5.0 : 1.0;
  switch (event->key()) {
    case Qt::Key_Left:
      return goTo(position_s_ - step_s);
    case Qt::Key_Right:
      return goTo(position_s_ + step_s);
    case Qt::Key_Home:
      return goTo(0.0);
    case Qt::Key_End:
      return goTo(length_s_);
    default:
      return QWidget::keyPressEvent(event);
  }
}

void TimeLine::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme theme = currentTheme();
  const double y = height() / 2.0;
  const auto stroke = [&](double from_s, double to_s, const QColor& colour, double width_px) {
    painter.setPen(QPen(colour, width_px, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(xOf(from_s), y), QPointF(xOf(to_s), y));
  };
  stroke(0.0, length_s_, theme.edge, 2.0);
  for (const Span& span : frozen_) stroke(span.begin_s, span.end_s, theme.quiet, 6.0);
  if (in_s_ || out_s_) stroke(in_s_.value_or(0.0), out_s_.value_or(length_s_), theme.quiet, 6.0);
  stroke(in_s_.value_or(0.0), std::max(position_s_, in_s_.value_or(0.0)), theme.accent, 2.0);
  // Brackets that open towards the part between them.
  painter.setPen(QPen(theme.text, 1.5));
  const auto bracket = [&](double at_s, double towards) {
    const double x = xOf(at_s);
    const QPointF points[] = {{x + 4.0 * towards, y - 11.0}, {x, y - 11.0}, {x, y + 11.0}, {x + 4.0 * towards, y + 11.0}};
    painter.drawPolyline(points, 4);
  };
  if (in_s_) bracket(*in_s_, 1.0);
  if (out_s_) bracket(*out_s_, -1.0);
  painter.setPen(QPen(theme.text, 1.5));
  for (const double mark_s : marks_s_) painter.drawLine(QPointF(xOf(mark_s), y - 9.0), QPointF(xOf(mark_s), y - 4.0));
  painter.setPen(hasFocus() ? QPen(theme.text, 1.5) : QPen(Qt::NoPen));
  painter.setBrush(theme.accent);
  painter.drawEllipse(QPointF(xOf(position_s_), y), kHandle_px, kHandle_px);
}

}  // namespace ew
