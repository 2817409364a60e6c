#include "flow_layout.h"

#include <QStyle>
#include <QWidget>
#include <algorithm>

namespace ew::ui {

FlowLayout::~FlowLayout() {
  for (QLayoutItem* item : items_) delete item;
}

QLayoutItem* FlowLayout::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
  QLayoutItem* taken = itemAt(index);
  if (taken != nullptr) items_.erase(items_.begin() + index);
  return taken;
}

QSize FlowLayout::minimumSize() const {
  QSize size;
  for (const QLayoutItem* item : items_)
    if (!item->isEmpty()) size = size.expandedTo(item->minimumSize());
  return size;
}

void FlowLayout::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  arrange(rect, true);
}

int FlowLayout::arrange(const QRect& rect, bool moves) const {
  const QWidget* parent = parentWidget();
  const Qt::LayoutDirection direction = parent != nullptr ? parent->layoutDirection() : Qt::LeftToRight;
  int x = rect.x(), y = rect.y(), line_px = 0;
  for (QLayoutItem* item : items_) {
    if (item->isEmpty()) continue;
    const QSize size = item->sizeHint().boundedTo(QSize(std::max(rect.width(), item->minimumSize().width()), QWIDGETSIZE_MAX));
    if (x > rect.x() && x + size.width() > rect.right() + 1) {
      x = rect.x();
      y += line_px + gap_px_;
      line_px = 0;
    }
    if (moves) item->setGeometry(QStyle::visualRect(direction, rect, QRect(QPoint(x, y), size)));
    x += size.width() + gap_px_;
    line_px = std::max(line_px, size.height());
  }
  return y + line_px - rect.y();
}

}  // namespace ew::ui
