#include "editor/time_line.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ew/core/figures.h"
#include "ew/widgets/theme.h"

namespace ew::lessons {

namespace {

constexpr double kMargin_px = 8.0;
constexpr double kReach_px = 7.0;  // as far from a handle as it can still be taken
constexpr double kTrack_px = 6.0;
constexpr double kStep_s = 0.5;

}  // namespace

TimeLine::TimeLine(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setToolTip(tr("Drag the ends to show a part, drag marks to move them, click to look. Keys: arrows, Home, End, [ and ]"));
  setAccessibleName(tr("The recording along its time"));
}

QSize TimeLine::sizeHint() const { return {25 * kGrid_px, 5 * kGrid_px}; }

void TimeLine::setRecording(double first_s, double last_s) {
  first_s_ = first_s;
  last_s_ = std::max(last_s, first_s + 1e-3);
  at_s_ = std::clamp(at_s_, first_s_, last_s_);
  update();
}

void TimeLine::setPart(double begin_s, double end_s) {
  begin_s_ = begin_s;
  end_s_ = end_s;
  update();
}

void TimeLine::setMarks(const std::vector<double>& marks_s) {
  marks_s_ = marks_s;
  update();
}

void TimeLine::setAt(double time_s) {
  at_s_ = std::clamp(time_s, first_s_, last_s_);
  update();
}

double TimeLine::xOf(double time_s) const { return kMargin_px + (width() - 2.0 * kMargin_px) * (time_s - first_s_) / (last_s_ - first_s_); }

double TimeLine::timeAt(double x_px) const {
  const double share = (x_px - kMargin_px) / std::max(1.0, width() - 2.0 * kMargin_px);
  return first_s_ + std::clamp(share, 0.0, 1.0) * (last_s_ - first_s_);
}

void TimeLine::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette colours = palette();
  const double middle = 0.5 * height();
  const auto bar = [&](double from_s, double to_s, const QColor& colour) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(xOf(from_s), middle - 0.5 * kTrack_px, std::max(1.0, xOf(to_s) - xOf(from_s)), kTrack_px), 2.0, 2.0);
  };
  QColor away = colours.color(QPalette::PlaceholderText);
  away.setAlphaF(0.4);
  bar(first_s_, last_s_, away);
  bar(begin_s_, end_s_, colours.color(QPalette::Highlight));
  painter.setPen(Qt::NoPen);
  painter.setBrush(colours.color(QPalette::Text));
  for (const double mark_s : marks_s_) {  // a small flag above the line
    const double x = xOf(mark_s);
    QPainterPath flag;
    flag.moveTo(x, middle - 0.5 * kTrack_px);
    flag.lineTo(x - 4.0, middle - kTrack_px - 6.0);
    flag.lineTo(x + 4.0, middle - kTrack_px - 6.0);
    flag.closeSubpath();
    painter.drawPath(flag);
  }
  for (const double end_s : {begin_s_, end_s_}) {
    painter.setBrush(colours.color(QPalette::Text));
    painter.drawRoundedRect(QRectF(xOf(end_s) - 2.0, middle - 8.0, 4.0, 16.0), 2.0, 2.0);
  }
  painter.setPen(QPen(colours.color(QPalette::Text), 1.0));
  painter.drawLine(QPointF(xOf(at_s_), middle), QPointF(xOf(at_s_), height() - 1.0));
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.color(QPalette::Highlight), 1.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
  }
}

void TimeLine::mousePressEvent(QMouseEvent* event) {
  const double x = event->localPos().x();
  held_ = Held::place;
  double nearest = kReach_px;
  const auto take = [&](double time_s, Held what, int mark) {
    const double distance = std::abs(xOf(time_s) - x);
    if (distance >= nearest) return;
    nearest = distance;
    held_ = what;
    heldMark_ = mark;
  };
  take(begin_s_, Held::begin, -1);
  take(end_s_, Held::end, -1);
  if (event->localPos().y() < 0.5 * height())  // flags stand above the line
    for (std::size_t n = 0; n < marks_s_.size(); ++n) take(marks_s_[n], Held::mark, static_cast<int>(n));
  if (held_ == Held::place) dragTo(x);
}

void TimeLine::mouseMoveEvent(QMouseEvent* event) {
  if (held_ != Held::nothing) dragTo(event->localPos().x());
}

void TimeLine::mouseReleaseEvent(QMouseEvent*) {
  const bool wasDragged = held_ == Held::begin || held_ == Held::end || held_ == Held::mark;
  held_ = Held::nothing;
  if (wasDragged) Q_EMIT released();
}

void TimeLine::dragTo(double x_px) {
  const double time_s = std::round(20.0 * timeAt(x_px)) / 20.0;
  switch (held_) {
    case Held::begin:
      Q_EMIT partAsked(time_s, end_s_);
      break;
    case Held::end:
      Q_EMIT partAsked(begin_s_, time_s);
      break;
    case Held::mark:
      Q_EMIT markAsked(heldMark_, time_s);
      break;
    case Held::place:
      Q_EMIT lookAsked(time_s);
      break;
    case Held::nothing:
      break;
  }
}

void TimeLine::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      Q_EMIT lookAsked(std::max(first_s_, at_s_ - kStep_s));
      return;
    case Qt::Key_Right:
      Q_EMIT lookAsked(std::min(last_s_, at_s_ + kStep_s));
      return;
    case Qt::Key_Home:
      Q_EMIT lookAsked(begin_s_);
      return;
    case Qt::Key_End:
      Q_EMIT lookAsked(end_s_);
      return;
    case Qt::Key_BracketLeft:
      Q_EMIT partAsked(at_s_, end_s_);
      Q_EMIT released();
      return;
    case Qt::Key_BracketRight:
      Q_EMIT partAsked(begin_s_, at_s_);
      Q_EMIT released();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace ew::lessons
