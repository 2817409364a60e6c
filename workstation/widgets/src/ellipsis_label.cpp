#include "ew/widgets/ellipsis_label.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

namespace ew {

QSize EllipsisLabel::minimumSizeHint() const {
  const QSize whole = QLabel::sizeHint();
  return {std::min(whole.width(), fontMetrics().horizontalAdvance(QStringLiteral("……"))), whole.height()};
}

bool EllipsisLabel::isCut() const { return fontMetrics().horizontalAdvance(text()) > contentsRect().width(); }

bool EllipsisLabel::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && isCut() && toolTip().isEmpty()) {
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text(), this);
    return true;
  }
  return QLabel::event(event);
}

void EllipsisLabel::paintEvent(QPaintEvent* event) {
  if (!isCut()) return QLabel::paintEvent(event);
  QPainter painter(this);
  painter.setPen(palette().color(foregroundRole()));
  painter.drawText(contentsRect(), static_cast<int>(alignment()), fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()));
}

}  // namespace ew
