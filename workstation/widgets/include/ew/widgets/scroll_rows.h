#pragma once

#include <QScrollArea>

class QVBoxLayout;

namespace ew {

/// Rows one below the other, as wide as their place and scrolled where they are higher.
class ScrollRows final : public QScrollArea {
 public:
  explicit ScrollRows(int margin_px = 0, QWidget* parent = nullptr);

  /// Its rows ask for no height: what is around them stays in sight, and they are scrolled.
  [[nodiscard]] QSize sizeHint() const override { return {QScrollArea::sizeHint().width(), minimumSizeHint().height()}; }
  [[nodiscard]] QVBoxLayout* rows() const { return rows_; }
  /// Takes away all of them; the one whose button asked for it goes when its event has ended.
  void clear();

 private:
  QVBoxLayout* rows_ = nullptr;
};

}  // namespace ew
