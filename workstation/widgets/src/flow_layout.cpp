#include "ew/widgets/flow_layout.h"

#include <QStyle>
#include <QWidget>
#include <algorithm>

namespace ew {

QSize FlowLayout::minimumSize() const {
  QSize size;
  for (const QLayoutItem* item : items_)
    if (!item->isEmpty()) size = size.expandedTo(item->minimumSize());
  const QMargins margins = contentsMargins();
  return size + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

int FlowLayout::arrange(const QRect& outside, bool moves) const {
  const QRect rect = outside.marginsRemoved(contentsMargins());
  int y = rect.y(), used_px = 0, height_px = 0;
  Line line;
  const auto endLine = [&] {
    if (moves) place(line, rect, y, rect.width() - used_px);
    y += height_px;
    line.clear();
    used_px = height_px = 0;
  };
  for (QLayoutItem* item : items_) {
    const bool isStretch = item->spacerItem() != nullptr;
    if (item->isEmpty() && !isStretch) continue;
    const QSize size =
        isStretch ? QSize() : item->sizeHint().boundedTo(QSize(std::max(rect.width(), item->minimumSize().width()), QWIDGETSIZE_MAX));
    const int width_px = isStretch ? 0 : size.width();
    if (height_px > 0 && used_px + gap_px_ + width_px > rect.width()) {
      endLine();
      y += gap_px_;
    }
    used_px += width_px + (line.empty() || isStretch ? 0 : gap_px_);
    height_px = std::max(height_px, size.height());
    line.emplace_back(item, QSize(width_px, size.height()));
  }
  endLine();
  return y - outside.y() + contentsMargins().bottom();
}

void FlowLayout::place(const Line& line, const QRect& rect, int y, int left_px) const {
  const QWidget* parent = parentWidget();
  const Qt::LayoutDirection direction = parent != nullptr ? parent->layoutDirection() : Qt::LeftToRight;
  const auto grows = [](const QLayoutItem* item) { return item->expandingDirections().testFlag(Qt::Horizontal); };
  auto growing = static_cast<int>(std::count_if(line.begin(), line.end(), [&](const auto& each) { return grows(each.first); }));
  int x = rect.x(), height_px = 0;
  for (const auto& [item, size] : line) height_px = std::max(height_px, size.height());
  for (auto [item, size] : line) {
    if (grows(item)) {
      const int more_px = left_px / growing--;
      size.rwidth() += more_px;
      left_px -= more_px;
    }
    if (item->spacerItem() != nullptr) {
      x += size.width();
      continue;
    }
    if (item != line.front().first) x += gap_px_;
    item->setGeometry(QStyle::visualRect(direction, rect, QRect(QPoint(x, y + (height_px - size.height()) / 2), size)));
    x += size.width();
  }
}

}  // namespace ew
