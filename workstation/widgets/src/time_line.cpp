#include "ew/widgets/time_line.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/widgets/theme.h"
#include "time_line_access.h"

namespace ew {
namespace {

constexpr double kAtEnds_px = 8.0;  // free at both ends, so that the handle stays whole
constexpr double kHandle_px = 7.0;
constexpr double kReach_px = 7.0;  // as far from an end or a mark as it can still be taken
constexpr double kDragStep_s = 0.05;

}  // namespace

TimeLine::TimeLine(Use use, QWidget* parent) : QWidget(parent), use_(use) {
  describeTimeLines();
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setLayoutDirection(Qt::LeftToRight);  // time runs to the right in every language, as it does on the strip of an M-mode
  setAccessibleName(tr("Time line of the recording"));
  setToolTip(use_ == Use::edited
                 ? tr("Drag the ends to show a part, drag marks to move them, click to look. Keys: arrows, Home, End, [ and ]")
                 : tr("Click or drag to another moment (arrows: a second, with Shift five; Home and End)"));
}

void TimeLine::setLength(double length_s, std::vector<Span> frozen, std::vector<double> marks_s) {
  setSpan(0.0, length_s);
  frozen_ = std::move(frozen);
  setMarks(std::move(marks_s));
  setRange({}, {});
  setPosition(0.0);
}

void TimeLine::setSpan(double first_s, double last_s) {
  first_s_ = first_s;
  last_s_ = std::max(first_s, last_s);
  setPosition(position_s_);
}

void TimeLine::setMarks(std::vector<double> marks_s) {
  marks_s_ = std::move(marks_s);
  update();
}

void TimeLine::setPosition(double position_s) {
  position_s_ = std::clamp(position_s, first_s_, last_s_);
  update();
}

void TimeLine::setRange(std::optional<double> in_s, std::optional<double> out_s) {
  if (in_s == in_s_ && out_s == out_s_) return;
  in_s_ = in_s;
  out_s_ = out_s;
  update();
}

double TimeLine::xOf(double position_s) const {
  const double share = last_s_ > first_s_ ? (position_s - first_s_) / (last_s_ - first_s_) : 0.0;
  return kAtEnds_px + share * (width() - 2.0 * kAtEnds_px);
}

double TimeLine::positionAt(double x) const {
  return first_s_ + (last_s_ - first_s_) * std::clamp((x - kAtEnds_px) / std::max(1.0, width() - 2.0 * kAtEnds_px), 0.0, 1.0);
}

void TimeLine::goTo(double position_s) {
  setPosition(position_s);
  QAccessibleValueChangeEvent told(this, position_s_);
  QAccessible::updateAccessibility(&told);
  Q_EMIT moved(position_s_);
}

void TimeLine::takeHold(const QPointF& at) {
  held_ = Held::place;
  if (use_ != Use::edited) return;
  double nearest = kReach_px;
  const auto take = [&](double time_s, Held what, int mark) {
    const double distance = std::abs(xOf(time_s) - at.x());
    if (distance >= nearest) return;
    nearest = distance;
    held_ = what;
    heldMark_ = mark;
  };
  take(in(), Held::begin, -1);
  take(out(), Held::end, -1);
  if (at.y() < 0.5 * height())  // marks stand above the line
    for (std::size_t n = 0; n < marks_s_.size(); ++n) take(marks_s_[n], Held::mark, static_cast<int>(n));
}

void TimeLine::dragTo(double x) {
  const double time_s = use_ == Use::edited ? kDragStep_s * std::round(positionAt(x) / kDragStep_s) : positionAt(x);
  switch (held_) {
    case Held::place:
      return goTo(time_s);
    case Held::begin:
      Q_EMIT rangeAsked(time_s, out());
      return;
    case Held::end:
      Q_EMIT rangeAsked(in(), time_s);
      return;
    case Held::mark:
      Q_EMIT markAsked(heldMark_, time_s);
      return;
  }
}

void TimeLine::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  takeHold(event->localPos());
  if (held_ == Held::place) dragTo(event->localPos().x());
}

void TimeLine::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) dragTo(event->localPos().x());
}

void TimeLine::mouseReleaseEvent(QMouseEvent*) {
  if (std::exchange(held_, Held::place) != Held::place) Q_EMIT released();
}

void TimeLine::keyPressEvent(QKeyEvent* event) {
  const bool isEdited = use_ == Use::edited;
  const double step_s = isEdited ? 0.5 : (event->modifiers() & Qt::ShiftModifier) != 0 ? 5.0 : 1.0;
  const auto ask = [this](double in_s, double out_s) {
    Q_EMIT rangeAsked(in_s, out_s);
    Q_EMIT released();
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return goTo(position_s_ - step_s);
    case Qt::Key_Right:
      return goTo(position_s_ + step_s);
    case Qt::Key_Home:
      return goTo(isEdited ? in() : first_s_);
    case Qt::Key_End:
      return goTo(isEdited ? out() : last_s_);
    case Qt::Key_BracketLeft:
      return isEdited ? ask(position_s_, out()) : QWidget::keyPressEvent(event);
    case Qt::Key_BracketRight:
      return isEdited ? ask(in(), position_s_) : QWidget::keyPressEvent(event);
    default:
      return QWidget::keyPressEvent(event);
  }
}

void TimeLine::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = currentTheme();
  const double y = height() / 2.0;
  const auto stroke = [&](double from_s, double to_s, const QColor& colour, double width_px) {
    painter.setPen(QPen(colour, width_px, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(xOf(from_s), y), QPointF(xOf(to_s), y));
  };
  stroke(first_s_, last_s_, theme.edge, 2.0);
  for (const Span& span : frozen_) stroke(span.begin_s, span.end_s, theme.quiet, 6.0);
  if (in_s_ || out_s_) stroke(in(), out(), theme.quiet, 6.0);
  stroke(in(), std::max(position_s_, in()), theme.accent, 2.0);
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
