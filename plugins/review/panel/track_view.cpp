#include "panel/track_view.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/review_words.h"
#include "panel/session/attempt_comments.h"
#include "panel/session/playback.h"
#include "panel/session/scan_pair.h"

namespace ew::review {

namespace {

constexpr double kNear_px = 5.0;
constexpr double kMark_px = 3.0;

/// 1, 2, 5, 10, 15, 30, 60 … seconds, so that labels keep apart.
double tickOf(double length_s, double room_px) {
  constexpr double kLabel_px = 72.0;
  for (const double step : {0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0})
    if (step / std::max(1e-9, length_s) * room_px >= kLabel_px) return step;
  return 1200.0;
}

}  // namespace

TrackView::TrackView(Playback& playback, const ScanPair& scans, const AttemptComments& comments, QWidget* parent)
    : QWidget(parent), playback_(playback) {
  setObjectName(QStringLiteral("reviewTracks"));
  setAccessibleName(tr("Both scans along the time"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setLayoutDirection(Qt::LeftToRight);
  const auto look = [this] {
    updateGeometry();
    update();
  };
  connect(&scans, &ScanPair::changed, this, look);
  connect(&comments, &AttemptComments::changed, this, look);
  connect(&playback_, &Playback::timeChanged, this, [this] { update(); });
  connect(&playback_, &Playback::clockChanged, this, [this] { update(); });
}

std::vector<TrackKind> TrackView::shownKinds() const {
  std::vector<TrackKind> kinds;
  for (int n = 0; n < kTrackKinds; ++n)
    for (const Side side : kSides) {
      const auto& tracks = playback_.tracks(side);
      if (tracks.empty()) continue;
      const Track& track = tracks[static_cast<std::size_t>(n)];
      if (track.spans.empty() && track.marks.empty()) continue;
      kinds.push_back(static_cast<TrackKind>(n));
      break;
    }
  return kinds;
}

int TrackView::rowHeight() const { return scaled(20); }
int TrackView::rulerHeight() const { return scaled(18); }

int TrackView::labelWidth() const {
  const QFontMetrics metrics(smallFont());
  int widest = 0;
  for (int n = 0; n < kTrackKinds; ++n) widest = std::max(widest, metrics.horizontalAdvance(titleOf(static_cast<TrackKind>(n))));
  return widest + 2 * kGrid_px;
}

QSize TrackView::sizeHint() const {
  return {60 * kGrid_px, rulerHeight() + static_cast<int>(std::max<std::size_t>(shownKinds().size(), 3)) * rowHeight() + kGrid_px};
}
QSize TrackView::minimumSizeHint() const { return {30 * kGrid_px, sizeHint().height()}; }

double TrackView::xOf(double clock_s) const {
  const double first = playback_.clock().first_s(), length = std::max(1e-3, playback_.clock().last_s() - first);
  const double left = labelWidth(), room = std::max(1.0, width() - left - 2.0 * kGrid_px);
  return left + room * (clock_s - first) / length;
}

double TrackView::timeAt(double x_px) const {
  const double first = playback_.clock().first_s(), length = playback_.clock().last_s() - first;
  const double left = labelWidth(), room = std::max(1.0, width() - left - 2.0 * kGrid_px);
  return first + std::clamp((x_px - left) / room, 0.0, 1.0) * length;
}

QRectF TrackView::laneOf(std::size_t row, Side side) const {
  const double top = rulerHeight() + static_cast<double>(row) * rowHeight() + 1.0;
  const double high = 0.5 * (rowHeight() - 3.0);
  return {static_cast<double>(labelWidth()), top + (side == kCompared ? 0.0 : high), width() - labelWidth() - 2.0 * kGrid_px, high - 1.0};
}

void TrackView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(smallFont());
  paintRuler(painter);
  const auto kinds = shownKinds();
  for (std::size_t row = 0; row < kinds.size(); ++row) {
    const QRectF above = laneOf(row, kCompared), below = laneOf(row, kReviewed);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(kGrid_px, above.top(), labelWidth() - kGrid_px, 2.0 * above.height() + 1.0), Qt::AlignLeft | Qt::AlignVCenter,
                     titleOf(kinds[row]));
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(above.united(below), 2.0, 2.0);
    for (const Side side : kSides)
      if (!playback_.tracks(side).empty())
        paintTrack(painter, playback_.tracks(side)[static_cast<std::size_t>(kinds[row])], side, side == kReviewed ? below : above);
  }
  paintLoop(painter);
  const double x = xOf(playback_.clock().at_s());
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5));
  painter.drawLine(QPointF(x, 2.0), QPointF(x, height() - 4.0));
  painter.setBrush(palette().color(QPalette::WindowText));
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(QPolygonF({QPointF(x - 5, 1), QPointF(x + 5, 1), QPointF(x, 8)}));
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
}

void TrackView::paintRuler(QPainter& painter) const {
  const double first = playback_.clock().first_s(), last = playback_.clock().last_s();
  if (last <= first) return;
  const double step = tickOf(last - first, width() - labelWidth());
  painter.setPen(palette().color(QPalette::PlaceholderText));
  for (double at = std::ceil(first / step) * step; at <= last + 1e-9; at += step) {
    const double x = xOf(at);
    painter.drawLine(QPointF(x, rulerHeight() - 5.0), QPointF(x, rulerHeight() - 1.0));
    const QString word = step < 1.0 ? clockText(at) : clockSeconds(at);
    const QRectF room(x - 40.0, 0.0, 80.0, rulerHeight() - 4.0);
    if (room.right() - 20.0 <= width()) painter.drawText(room, Qt::AlignHCenter | Qt::AlignVCenter, word);
  }
}

void TrackView::paintTrack(QPainter& painter, const Track& track, Side side, const QRectF& lane) const {
  const Who who = whoOf(side);
  const QColor colour = colourOf(who, currentTheme().dark);
  painter.setPen(Qt::NoPen);
  for (const TrackSpan& span : track.spans) {
    QColor level = colour;
    level.setAlphaF(0.25 + 0.75 * span.level);
    painter.setBrush(level);
    const double left = xOf(playback_.onClock_s(side, span.begin_s)), right = xOf(playback_.onClock_s(side, span.end_s));
    // How much of the face touches is how high the bar is: colours alone would not tell.
    const double high = std::max(1.5, lane.height() * span.level);
    painter.drawRect(QRectF(left, lane.bottom() - high, std::max(0.6, right - left), high));
  }
  painter.setPen(QPen(palette().color(QPalette::Base), 1.0));
  painter.setBrush(colour);
  for (const TrackMark& mark : track.marks)
    drawMarkOf(painter, who, QPointF(xOf(playback_.onClock_s(side, mark.time_s)), lane.center().y()), kMark_px);
}

void TrackView::paintLoop(QPainter& painter) const {
  const ReviewClock& clock = playback_.clock();
  const QColor accent = palette().color(QPalette::Highlight);
  if (clock.isLooping()) {
    QColor veil = accent;
    veil.setAlpha(45);
    painter.setPen(Qt::NoPen);
    painter.setBrush(veil);
    const double left = xOf(*clock.loopBegin_s());
    painter.drawRect(QRectF(left, 0.0, xOf(*clock.loopEnd_s()) - left, height() - 4.0));
  }
  painter.setPen(QPen(accent, 2.0));
  const auto bracket = [&](double time_s, double way) {
    const double x = xOf(time_s);
    painter.drawLine(QPointF(x, 1.0), QPointF(x, height() - 4.0));
    painter.drawLine(QPointF(x, 1.0), QPointF(x + way * 5.0, 1.0));
    painter.drawLine(QPointF(x, height() - 4.0), QPointF(x + way * 5.0, height() - 4.0));
  };
  if (clock.loopBegin_s()) bracket(*clock.loopBegin_s(), 1.0);
  if (clock.loopEnd_s()) bracket(*clock.loopEnd_s(), -1.0);
}

void TrackView::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  if (event->button() == Qt::LeftButton && event->localPos().x() >= labelWidth() - kGrid_px) playback_.seek(timeAt(event->localPos().x()));
}

void TrackView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) playback_.seek(timeAt(event->localPos().x()));
}

QString TrackView::wordsAt(const QPoint& at) const {
  const auto kinds = shownKinds();
  for (std::size_t row = 0; row < kinds.size(); ++row)
    for (const Side side : kSides) {
      if (playback_.tracks(side).empty() || !laneOf(row, side).adjusted(0, -1, 0, 1).contains(at)) continue;
      const Track& track = playback_.tracks(side)[static_cast<std::size_t>(kinds[row])];
      const QString who = wordOf(whoOf(side));
      for (const TrackMark& mark : track.marks)
        if (std::abs(xOf(playback_.onClock_s(side, mark.time_s)) - at.x()) <= kNear_px)
          return tr("%1, %2: %3", "who, when: what").arg(who, clockText(playback_.onClock_s(side, mark.time_s)), words(mark.what));
      for (const TrackSpan& span : track.spans)
        if (xOf(playback_.onClock_s(side, span.begin_s)) <= at.x() && at.x() <= xOf(playback_.onClock_s(side, span.end_s)))
          return kinds[row] == TrackKind::contact ? tr("%1: %2 % of the face touches").arg(who).arg(std::lround(100.0 * span.level))
                                                  : tr("%1, %2: from %3 to %4", "who, what")
                                                        .arg(who, titleOf(kinds[row]), clockText(playback_.onClock_s(side, span.begin_s)),
                                                             clockText(playback_.onClock_s(side, span.end_s)));
      return tr("%1: %2", "who: what track").arg(who, titleOf(kinds[row]));
    }
  return {};
}

bool TrackView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), wordsAt(help->pos()), this);
    return true;
  }
  return QWidget::event(event);
}

}  // namespace ew::review
