#include "import/screen_view.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/widgets/theme.h"
#include "measure/calipers/caliper_paint.h"

namespace ew::ui {
namespace {

constexpr double kReach_px = 9.0;
constexpr double kGrip_px = 5.0;
constexpr double kAroundGrip_px = 12.0;
constexpr int kFramesFar = 10;
constexpr double kFar_px = 10.0;

}  // namespace

ScreenView::ScreenView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("screenView"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("A frame of the recording, with the outline of the scan and boxes of text"));
}

void ScreenView::setImage(const QImage& image, const QPoint& at, const QSize& screen_px) {
  image_ = image;
  at_ = at;
  if (std::exchange(screen_px_, screen_px) != screen_px) makeRoom();
  update();
}

void ScreenView::setEdit(ScreenEdit* edit) {
  edit_ = edit;
  held_.reset();
  chosen_.reset();
  makeRoom();
  update();
}

void ScreenView::setMarksShown(bool shown) {
  marksShown_ = shown;
  held_.reset();
  from_.reset();
  update();
}

void ScreenView::setDrawing(measurement::CaliperDrawing* drawing) {
  drawing_ = drawing;
  update();
}

void ScreenView::setMeasuring(bool measuring) {
  measuring_ = measuring;
  held_.reset();
  from_.reset();
  update();
}

void ScreenView::setLabels(std::vector<Label> labels) {
  labels_ = std::move(labels);
  update();
}

double ScreenView::scale() const {
  if (room_px_.isEmpty()) return 1.0;
  return std::min(width() / room_px_.width(), height() / room_px_.height());
}

QPointF ScreenView::origin() const { return QPointF(0.5 * width(), 0.5 * height()) - scale() * room_px_.center(); }

void ScreenView::makeRoom() {
  const QRectF screen(QPointF(0.0, 0.0), QSizeF(screen_px_));
  room_px_ = screen;
  if (edit_ == nullptr || !edit_->outline()) return;
  QRectF grips;
  for (const GripPosition& grip : gripsOf(*edit_->outline()))
    grips |= QRectF(grip.at_px.x - kAroundGrip_px, grip.at_px.y - kAroundGrip_px, 2.0 * kAroundGrip_px, 2.0 * kAroundGrip_px);
  // The scan stays large: what lies far out is reached by keys.
  const double across = 0.5 * screen.width(), down = 0.5 * screen.height();
  room_px_ |= grips & screen.adjusted(-across, -down, across, down);
}

QPointF ScreenView::placeOf(glm::dvec2 p_px) const { return origin() + scale() * QPointF(p_px.x + 0.5, p_px.y + 0.5); }

glm::dvec2 ScreenView::pixelAt(const QPointF& at) const {
  const QPointF p = (at - origin()) / scale();
  return {p.x() - 0.5, p.y() - 0.5};
}

PixelRect ScreenView::between(const QPointF& a, const QPointF& b) const {
  const QPointF p = (a - origin()) / scale(), q = (b - origin()) / scale();
  const auto within = [](double at, int most) { return std::clamp(static_cast<int>(std::lround(at)), 0, most); };
  const int left = within(std::min(p.x(), q.x()), screen_px_.width()), right = within(std::max(p.x(), q.x()), screen_px_.width());
  const int top = within(std::min(p.y(), q.y()), screen_px_.height()), bottom = within(std::max(p.y(), q.y()), screen_px_.height());
  return {left, top, right - left, bottom - top};
}

std::optional<OutlineGrip> ScreenView::gripAt(const QPointF& at) const {
  if (!corrects() || !edit_->outline()) return std::nullopt;
  std::optional<OutlineGrip> nearest;
  double least = kReach_px;
  for (const GripPosition& grip : gripsOf(*edit_->outline())) {
    const QPointF d = placeOf(grip.at_px) - at;
    if (const double away = std::hypot(d.x(), d.y()); away < least) {
      least = away;
      nearest = grip.grip;
    }
  }
  return nearest;
}

void ScreenView::showCursor(const QPointF& at) {
  const bool takes = held_ || gripAt(at) || (measuring_ && drawing_ != nullptr && drawing_->isNearHandle(pixelAt(at), kReach_px / scale()));
  setCursor(held_ ? Qt::ClosedHandCursor : takes ? Qt::OpenHandCursor : corrects() || measuring_ ? Qt::CrossCursor : Qt::ArrowCursor);
}

void ScreenView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || image_.isNull()) return;
  const QPointF at = event->localPos();
  if (measuring_) {
    if (drawing_ == nullptr) return;
    Q_EMIT pauseAsked();
    drawing_->press(pixelAt(at), kReach_px / scale());
    Q_EMIT measured();
  } else if (const auto grip = gripAt(at)) {
    held_ = chosen_ = grip;
    for (const GripPosition& each : gripsOf(*edit_->outline()))
      if (each.grip == *grip) grabbed_ = placeOf(each.at_px) - at;
  } else if (corrects()) {
    from_ = to_ = at;
  }
  showCursor(at);
  update();
}

void ScreenView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->localPos();
  if (measuring_ && drawing_ != nullptr) {
    drawing_->moveTo(pixelAt(at), kReach_px / scale());
    Q_EMIT measured();
  } else if (held_ && edit_ != nullptr && edit_->outline()) {
    edit_->setOutline(withGripAt(*edit_->outline(), *held_, pixelAt(at + grabbed_)));
    Q_EMIT edited();
  } else if (from_) {
    to_ = at;
  }
  showCursor(at);
  update();
}

void ScreenView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QPointF at = event->localPos();
  if (measuring_ && drawing_ != nullptr) {
    drawing_->release(pixelAt(at), kReach_px / scale());
    Q_EMIT measured();
  } else if (from_ && edit_ != nullptr) {
    const QPointF from = *from_;
    if ((at - from).manhattanLength() >= QApplication::startDragDistance())
      edit_->addBox(between(from, at));
    else
      edit_->toggleBoxAt(pixelAt(at));
    Q_EMIT edited();
  }
  if (held_) makeRoom();  // not before: nothing moves below the pointer
  held_.reset();
  from_.reset();
  to_.reset();
  showCursor(at);
  update();
}

void ScreenView::moveGripBy(glm::dvec2 by_px) {
  if (!corrects() || !chosen_ || !edit_->outline()) return;
  for (const GripPosition& each : gripsOf(*edit_->outline())) {
    if (each.grip != *chosen_) continue;
    edit_->setOutline(withGripAt(*edit_->outline(), *chosen_, each.at_px + by_px));
    makeRoom();
    Q_EMIT edited();
    update();
    return;
  }
}

void ScreenView::keyPressEvent(QKeyEvent* event) {
  const bool far = (event->modifiers() & Qt::ShiftModifier) != 0, moves = (event->modifiers() & Qt::ControlModifier) != 0;
  const double pixels = far ? kFar_px : 1.0;
  const int frames = far ? kFramesFar : 1;
  switch (event->key()) {
    case Qt::Key_Left:
      return moves ? moveGripBy({-pixels, 0.0}) : Q_EMIT stepAsked(-frames);
    case Qt::Key_Right:
      return moves ? moveGripBy({pixels, 0.0}) : Q_EMIT stepAsked(frames);
    case Qt::Key_Up:
      return moves ? moveGripBy({0.0, -pixels}) : Q_EMIT stepAsked(-kFramesFar);
    case Qt::Key_Down:
      return moves ? moveGripBy({0.0, pixels}) : Q_EMIT stepAsked(kFramesFar);
    case Qt::Key_Home:
      return Q_EMIT endAsked(false);
    case Qt::Key_End:
      return Q_EMIT endAsked(true);
    case Qt::Key_Space:
      return Q_EMIT playAsked();
    case Qt::Key_H:
      if (corrects() && edit_->outline()) {
        const auto grips = gripsOf(*edit_->outline());
        std::size_t next = 0;
        for (std::size_t n = 0; n < grips.size(); ++n)
          if (chosen_ == grips[n].grip) next = (n + 1) % grips.size();
        chosen_ = grips[next].grip;
        update();
      }
      return;
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      if (measuring_ && drawing_ != nullptr && drawing_->takeBack()) Q_EMIT measured();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void ScreenView::paintMarks(QPainter& painter) {
  const Theme theme = scanTheme();
  const QRectF whole(origin(), QSizeF(screen_px_) * scale());
  if (const auto& outline = edit_->outline()) {
    QPainterPath fan;
    for (const glm::dvec2 point : outline->points_px()) fan.elementCount() == 0 ? fan.moveTo(placeOf(point)) : fan.lineTo(placeOf(point));
    fan.closeSubpath();
    QPainterPath around;
    around.addRect(whole);
    painter.fillPath(around.subtracted(fan), QColor(0, 0, 0, 130));
    painter.strokePath(fan, QPen(QColor(0, 0, 0, 160), 3.5));
    painter.strokePath(fan, QPen(theme.accent, 1.5));
    if (const auto& ticks = edit_->found().ticks) {
      painter.setPen(QPen(theme.accent, 1.0));
      for (int n = 0; n < ticks->count; ++n) {
        const QPointF at = placeOf({ticks->x_px, ticks->first_px + n * ticks->spacing_px});
        painter.drawLine(at - QPointF(6.0, 0.0), at + QPointF(6.0, 0.0));
      }
    }
  }
  const auto rectOf = [this](const PixelRect& rect) {
    return QRectF(origin() + scale() * QPointF(rect.x, rect.y), scale() * QSizeF(rect.width, rect.height));
  };
  for (const TextBox& box : edit_->boxes()) {
    painter.setPen(box.counts ? QPen(theme.text, 1.5) : QPen(theme.quiet, 1.0, Qt::DashLine));
    painter.setBrush(box.counts ? QBrush(QColor(255, 255, 255, 90), Qt::BDiagPattern) : QBrush(Qt::NoBrush));
    painter.drawRect(rectOf(box.rect));
  }
  if (from_) {
    painter.setPen(QPen(theme.text, 1.0, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rectOf(between(*from_, *to_)));
  }
  if (measuring_ || !edit_->outline()) return;
  for (const GripPosition& grip : gripsOf(*edit_->outline())) {
    const bool isChosen = chosen_ == grip.grip;
    painter.setPen(QPen(Qt::black, 1.5));
    painter.setBrush(isChosen ? theme.text : theme.accent);
    const QPointF at = placeOf(grip.at_px);
    if (grip.grip == OutlineGrip::whole)
      painter.drawRect(QRectF(at - QPointF(kGrip_px, kGrip_px), QSizeF(2.0 * kGrip_px, 2.0 * kGrip_px)));
    else
      painter.drawEllipse(at, kGrip_px, kGrip_px);
  }
}

void ScreenView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  const Theme theme = scanTheme();
  if (image_.isNull()) {
    painter.setPen(theme.quiet);
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, tr("No frame can be shown yet."));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.drawImage(QRectF(origin() + scale() * QPointF(at_), scale() * QSizeF(image_.size())), image_);
  if (edit_ != nullptr && marksShown_) paintMarks(painter);
  const std::function<QPointF(const glm::dvec2&)> pixelOf = [this](const glm::dvec2& p) { return placeOf(p); };
  for (const Label& label : labels_) paintCaliper(painter, label.line, label.text, pixelOf, label.isChosen ? theme.accent : theme.text);
  if (hasFocus()) {
    painter.setPen(QPen(theme.accent, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

}  // namespace ew::ui
