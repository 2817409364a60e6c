#pragma once

#include <QLayout>
#include <vector>

namespace ew::ui {

/// Widgets one after another from the left (from the right where people read so), in as many lines as it takes.
class FlowLayout final : public QLayout {
 public:
  explicit FlowLayout(int gap_px) : gap_px_(gap_px) { setContentsMargins(0, 0, 0, 0); }
  ~FlowLayout() override;
  void addItem(QLayoutItem* item) override { items_.push_back(item); }
  [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return arrange(QRect(0, 0, width, 0), false); }
  [[nodiscard]] QSize sizeHint() const override { return minimumSize(); }
  [[nodiscard]] QSize minimumSize() const override;
  void setGeometry(const QRect& rect) override;

 private:
  int arrange(const QRect& rect, bool moves) const;
  std::vector<QLayoutItem*> items_;
  int gap_px_;
};

}  // namespace ew::ui
