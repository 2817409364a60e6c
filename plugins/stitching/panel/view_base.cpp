#include "panel/view_base.h"

#include <QKeyEvent>
#include <QPainter>

#include "ew/widgets/theme.h"
#include "panel/marks.h"
#include "panel/stitch_session.h"

namespace ew::stitching {

ViewBase::ViewBase(StitchSession& session, QWidget* parent)
    : QWidget(parent), document_(session.document()), inputs_(session.inputs()), results_(session.results()), look_(session.look()) {
  setMinimumSize(160, 120);
  setFocusPolicy(Qt::StrongFocus);
  setLayoutDirection(Qt::LeftToRight);  // an image has its sides, whatever is read
  setAttribute(Qt::WA_OpaquePaintEvent);
}

bool ViewBase::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && wantsKey(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void ViewBase::beginPainting(QPainter& painter, const QColor& ground) const {
  painter.fillRect(rect(), ground);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(smallFont());
}

void ViewBase::drawFocus(QPainter& painter) const {
  if (!hasFocus()) return;
  painter.setPen(QPen(kViewAccent, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

}  // namespace ew::stitching
