#pragma once

// As panel.h not part of the library ew_sdk: a plugin that includes this links Qt5::Widgets itself.

#include <QLayout>
#include <QStyle>
#include <QWidget>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace ew::sdk {

/// Widgets one after another from the left (from the right where people read so), in as many lines as it takes. What wants to expand along
/// a line (a text field, addStretch()) shares what its line leaves. No narrower than its widest widget may be.
class FlowLayout final : public QLayout {
 public:
  /// @param gap_px between widgets and between lines
  explicit FlowLayout(int gap_px) : gap_px_(gap_px) { setContentsMargins(0, 0, 0, 0); }
  ~FlowLayout() override {
    for (QLayoutItem* item : items_) delete item;
  }
  void addItem(QLayoutItem* item) override { items_.push_back(item); }
  /// What follows stands at the other end of the line.
  void addStretch() { addItem(new QSpacerItem(0, 0, QSizePolicy::Expanding)); }
  [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override {
    return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
  }
  QLayoutItem* takeAt(int index) override {
    QLayoutItem* taken = itemAt(index);
    if (taken != nullptr) items_.erase(items_.begin() + index);
    return taken;
  }
  [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return arrange(QRect(0, 0, width, 0), false); }
  [[nodiscard]] QSize sizeHint() const override { return minimumSize(); }
  [[nodiscard]] QSize minimumSize() const override {
    QSize size;
    for (const QLayoutItem* item : items_)
      if (!item->isEmpty()) size = size.expandedTo(item->minimumSize());
    const QMargins margins = contentsMargins();
    return size + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
  }
  void setGeometry(const QRect& rect) override {
    QLayout::setGeometry(rect);
    arrange(rect, true);
  }

 private:
  using Line = std::vector<std::pair<QLayoutItem*, QSize>>;

  /// @return the height of all lines and margins
  int arrange(const QRect& outside, bool moves) const {
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

  void place(const Line& line, const QRect& rect, int y, int left_px) const {
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

  std::vector<QLayoutItem*> items_;
  int gap_px_;
};

}  // namespace ew::sdk
