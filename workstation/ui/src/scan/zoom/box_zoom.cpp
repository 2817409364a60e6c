#include "scan/zoom/box_zoom.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ew/imaging/box_zoom.h"
#include "ew/widgets/theme.h"
#include "scan/scan_view.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr double kLeastBox_px = 12.0;  // less is a click

}  // namespace

BoxZoom::BoxZoom(Session& session, ScanView& scan) : QWidget(&scan), session_(session), scan_(scan) {
  setObjectName(QStringLiteral("boxZoom"));
  setAccessibleName(tr("Box to be magnified"));
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::CrossCursor);
  hide();
  connect(&session_, &Session::subjectReplaced, this, &BoxZoom::end);
  connect(&session_.console(), &ScanConsole::knobsChanged, this, [this] {
    if (isDrawing() && session_.imageKnobs().mode != DisplayMode::bMode) end();
  });
}

bool BoxZoom::toggle() {
  if (isDrawing() || !session_.subject() || session_.image().isEmpty()) {
    end();
    return false;
  }
  if (session_.isPlaying()) {
    Q_EMIT said(tr("A recording shows what it showed. Close it (Escape), then zoom."));
    return false;
  }
  if (session_.imageKnobs().mode == DisplayMode::mMode) {
    Q_EMIT said(tr("A box is drawn in the image. Switch to B or B + M (M)."));
    return false;
  }
  setGeometry(scan_.imageRect());
  show();
  raise();
  setFocus(Qt::OtherFocusReason);
  Q_EMIT changed();
  return true;
}

void BoxZoom::end() {
  from_.reset();
  if (!isDrawing()) return;
  const bool hadFocus = hasFocus();
  hide();
  if (hadFocus) scan_.setFocus(Qt::OtherFocusReason);
  Q_EMIT changed();
}

bool BoxZoom::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void BoxZoom::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return event->ignore();
  end();
}

void BoxZoom::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return end();
  from_ = to_ = event->localPos();
  update();
}

void BoxZoom::mouseMoveEvent(QMouseEvent* event) {
  if (!from_) return;
  to_ = event->localPos();
  update();
}

void BoxZoom::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !from_) return;
  to_ = event->localPos();
  const QRectF box = QRectF(*from_, to_).normalized().intersected(QRectF(rect()));
  if (std::max(box.width(), box.height()) < kLeastBox_px) {
    from_.reset();
    update();
    Q_EMIT said(tr("Drag from one corner of the box to the other; Escape leaves the image as it is."));
    return;
  }
  end();
  zoomTo(box);
}

void BoxZoom::zoomTo(const QRectF& drawn) {
  // One that is nearly a line is as wide as a click.
  QRectF box(0.0, 0.0, std::max(drawn.width(), kLeastBox_px), std::max(drawn.height(), kLeastBox_px));
  box.moveCenter(drawn.center());
  const double ratio = devicePixelRatioF();
  const QPointF a = box.topLeft() * ratio, b = box.bottomRight() * ratio;
  const Detail detail = detailOfBox(session_.geometry(), session_.console().detail(), {a.x(), a.y()}, {b.x(), b.y()});
  session_.console().setDetail(detail.zoom, detail.pan);
}

void BoxZoom::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Theme theme = scanTheme();
  if (!from_) {
    painter.setFont(textFont());
    const QString hint = tr("Drag a box around what is to be magnified");
    QRect box = painter.fontMetrics().boundingRect(hint).adjusted(-12, -6, 12, 6);
    box.moveCenter(QPoint(width() / 2, height() - 28));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 200));
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.setPen(theme.text);
    painter.drawText(box, Qt::AlignCenter, hint);
    return;
  }
  const QRectF box = QRectF(*from_, to_).normalized();
  for (const auto& [colour, thick] : {std::pair{QColor(Qt::black), 3.0}, std::pair{theme.accent, 1.5}}) {
    painter.setPen(QPen(colour, thick));
    painter.drawRect(box);
  }
}

}  // namespace ew::ui
