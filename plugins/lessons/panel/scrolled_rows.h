#pragma once

#include <QScrollArea>
#include <QVBoxLayout>

#include "ew/widgets/theme.h"

namespace ew::lessons {

/// Rows one below the other, as wide as their place and scrolled where they are higher.
class ScrolledRows final : public QScrollArea {
 public:
  explicit ScrolledRows(int margin_px = 0, QWidget* parent = nullptr) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    auto* body = new QWidget;
    rows_ = new QVBoxLayout(body);
    rows_->setContentsMargins(margin_px, margin_px, margin_px, margin_px);
    rows_->setSpacing(kGrid_px);
    setWidget(body);
  }

  /// Its rows ask for no height: what is around them stays in sight, and they are scrolled.
  [[nodiscard]] QSize sizeHint() const override { return {QScrollArea::sizeHint().width(), minimumSizeHint().height()}; }
  [[nodiscard]] QVBoxLayout* rows() const { return rows_; }
  /// Takes away all of them; the one whose button asked for it goes when its event has ended.
  void clear() {
    while (QLayoutItem* item = rows_->takeAt(0)) {
      if (item->widget() != nullptr) {
        item->widget()->hide();
        item->widget()->deleteLater();
      }
      delete item;
    }
  }

 private:
  QVBoxLayout* rows_ = nullptr;
};

}  // namespace ew::lessons
