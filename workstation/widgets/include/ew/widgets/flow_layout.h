#pragma once

#include <QLayout>
#include <cstddef>
#include <utility>
#include <vector>

namespace ew {

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
  [[nodiscard]] QSize minimumSize() const override;
  void setGeometry(const QRect& rect) override {
    QLayout::setGeometry(rect);
    arrange(rect, true);
  }

 private:
  using Line = std::vector<std::pair<QLayoutItem*, QSize>>;

  /// @return the height of all lines and margins
  int arrange(const QRect& outside, bool moves) const;
  void place(const Line& line, const QRect& rect, int y, int left_px) const;

  std::vector<QLayoutItem*> items_;
  int gap_px_;
};

}  // namespace ew
