#include "source_picker.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "scan_view.h"
#include "theme.h"

namespace ew::ui {
namespace {

constexpr int kStep_px = 4;
constexpr int kFarStep_px = 32;

}  // namespace

SourcePicker::SourcePicker(Session& session, ScanView& scan) : QWidget(&scan), session_(session), scan_(scan) {
  setObjectName(QStringLiteral("sourcePicker"));
  setFocusPolicy(Qt::ClickFocus);
  setAccessibleName(tr("Point whose source frame is asked for"));
  hide();
  scan.installEventFilter(this);
  connect(&session_, &Session::pictureChanged, this, &SourcePicker::follow);
  connect(&session_, &Session::knobsChanged, this, &SourcePicker::follow);
  connect(&session_, &Session::subjectChanged, this, [this] {
    clearMark();
    if (!session_.subject()) setAsking(false);
  });
}

void SourcePicker::follow() {
  if (isHidden()) return;
  setGeometry(scan_.pictureRect());
  if (mark_ && !(markGeometry_ == session_.geometry() && markPose_ == session_.picturePose())) clearMark();
}

void SourcePicker::setAsking(bool asking) {
  if (asking && !session_.subject()) asking = false;
  if (asking != asking_) {
    asking_ = asking;
    const Picture& picture = session_.picture();
    cross_ = mark_.value_or(QPoint(picture.width() / 2, picture.height() / 2));
    showOrHide();
    if (asking) {
      setFocus(Qt::OtherFocusReason);
    } else {
      scan_.setFocus(Qt::OtherFocusReason);
    }
  }
  Q_EMIT askingChanged(asking_);
}

void SourcePicker::clearMark() {
  mark_.reset();
  showOrHide();
}

void SourcePicker::showOrHide() {
  // A mark alone must not take the mouse from the probe.
  setAttribute(Qt::WA_TransparentForMouseEvents, !asking_);
  if (asking_) {
    setCursor(Qt::CrossCursor);
  } else {
    unsetCursor();
  }
  setGeometry(scan_.pictureRect());
  setVisible(asking_ || mark_);
  raise();
  update();
}

QPoint SourcePicker::pixelAt(const QPointF& at) const {
  return {static_cast<int>(std::floor(at.x() * devicePixelRatioF())), static_cast<int>(std::floor(at.y() * devicePixelRatioF()))};
}

QPointF SourcePicker::placeOf(const QPoint& pixel) const { return (QPointF(pixel) + QPointF(0.5, 0.5)) / devicePixelRatioF(); }

void SourcePicker::ask(const QPoint& pixel) {
  cross_ = pixel;
  mark_ = pixel;
  markPose_ = session_.picturePose();
  markGeometry_ = session_.geometry();
  showOrHide();
  Q_EMIT asked(pixel);
}

bool SourcePicker::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    follow();
  } else if (event->type() == QEvent::MouseButtonPress && session_.subject()) {
    const auto& mouse = *static_cast<QMouseEvent*>(event);
    const QRect box = scan_.pictureRect();
    if (mouse.button() == Qt::LeftButton && mouse.modifiers() == Qt::AltModifier && box.contains(mouse.pos())) {
      ask(pixelAt(mouse.localPos() - box.topLeft()));
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void SourcePicker::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  ask(pixelAt(event->localPos()));
}

void SourcePicker::keyPressEvent(QKeyEvent* event) {
  const int step_px = (event->modifiers() & Qt::ShiftModifier) != 0 ? kFarStep_px : kStep_px;
  QPoint by;
  const std::string command = keys_->meant(*event, kWithTool);
  if (command == "escape") return setAsking(false);
  if (command == "cross.set") return ask(cross_);
  if (command == "cross.left")
    by = {-step_px, 0};
  else if (command == "cross.right")
    by = {step_px, 0};
  else if (command == "cross.up")
    by = {0, -step_px};
  else if (command == "cross.down")
    by = {0, step_px};
  else
    return event->ignore();
  const Picture& picture = session_.picture();
  cross_ = {std::clamp(cross_.x() + by.x(), 0, std::max(0, picture.width() - 1)),
            std::clamp(cross_.y() + by.y(), 0, std::max(0, picture.height() - 1))};
  update();
}

void SourcePicker::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme theme = scanTheme();
  // A dark edge under the light line keeps the cross in sight on bright tissue.
  const auto paintCross = [&](const QPointF& at, bool ringed) {
    for (const auto& [colour, width] : {std::pair{QColor(Qt::black), 3.0}, std::pair{theme.accent, 1.5}}) {
      painter.setPen(QPen(colour, width));
      for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        painter.drawLine(at + 4.0 * way, at + 12.0 * way);
      }
      if (ringed) painter.drawEllipse(at, 8.0, 8.0);
    }
  };
  if (mark_) paintCross(placeOf(*mark_), true);
  if (!asking_) return;
  if (cross_ != mark_) paintCross(placeOf(cross_), false);
  painter.setFont(smallFont());
  const QString hint = tr("Click a point to see the frame it came from. Arrows and Enter do the same, Escape ends.");
  const QRect room = rect().adjusted(16, 16, -16, -16);
  QRect words = painter.boundingRect(room, Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, hint);
  QColor veil(Qt::black);
  veil.setAlpha(200);
  painter.setPen(Qt::NoPen);
  painter.setBrush(veil);
  painter.drawRoundedRect(words.adjusted(-8, -4, 8, 4), 4.0, 4.0);
  painter.setPen(theme.text);
  painter.drawText(room, Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, hint);
}

}  // namespace ew::ui
