#include "ew/widgets/scroll_rows.h"

#include <QVBoxLayout>

#include "ew/widgets/theme.h"

namespace ew {

ScrollRows::ScrollRows(int margin_px, QWidget* parent) : QScrollArea(parent) {
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

void ScrollRows::clear() {
  while (QLayoutItem* item = rows_->takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
}

}  // namespace ew
