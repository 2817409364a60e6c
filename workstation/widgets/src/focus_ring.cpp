#include "ew/widgets/focus_ring.h"

#include <QFocusEvent>

namespace ew {

bool isReachedByKeys(Qt::FocusReason reason) {
  return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason;
}

FocusRing::FocusRing(QWidget& around, QWidget& watched) : QWidget(&around), around_(around), watched_(watched) {
  setObjectName(QStringLiteral("focusRing"));
  setAttribute(Qt::WA_StyledBackground);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
  around_.installEventFilter(this);
  if (&watched_ != &around_) watched_.installEventFilter(this);
}

void FocusRing::place() {
  constexpr int kRing_px = 2;
  setGeometry(around_.rect());
  setMask(QRegion(rect()).subtracted(rect().adjusted(kRing_px, kRing_px, -kRing_px, -kRing_px)));
  raise();
}

bool FocusRing::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &around_ && event->type() == QEvent::Resize && !isHidden()) place();
  if (watched != &watched_) return false;
  if (event->type() == QEvent::FocusOut) {
    // Another window may take the keys for a while; the view has them again afterwards.
    if (static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason) hide();
  } else if (event->type() == QEvent::FocusIn && isReachedByKeys(static_cast<QFocusEvent*>(event)->reason())) {
    place();
    show();
  }
  return false;
}

}  // namespace ew
