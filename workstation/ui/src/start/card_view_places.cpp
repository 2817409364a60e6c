#include <QScrollBar>
#include <QStyle>
#include <algorithm>
#include <cstdlib>

#include "ew/widgets/theme.h"
#include "start/card_view.h"
#include "start/case_card.h"

// Where the cards of a list lie: reckoned from their rows.

namespace ew::ui {
namespace {

constexpr int kLeastCardWidth_px = 280;
constexpr int kMostCardWidth_px = 440;

}  // namespace

int CardView::columns() const { return std::max(1, (viewport()->width() + kCardGap_px) / (scaled(kLeastCardWidth_px) + kCardGap_px)); }

int CardView::cardWidth_px() const {
  const int columns = this->columns();
  return std::min(scaled(kMostCardWidth_px), (viewport()->width() - (columns - 1) * kCardGap_px) / columns);
}

int CardView::headHeight_px() const { return list_.sections().size() < 2 ? 0 : fontMetrics().lineSpacing() + kCardGap_px; }

/// Rows of cards above a section.
int CardView::rowsBefore(std::size_t section) const {
  int rows = 0;
  for (std::size_t n = 0; n < section; ++n) rows += (list_.sections()[n].count + columns() - 1) / columns();
  return rows;
}

int CardView::contentHeight_px() const {
  const std::size_t sections = list_.sections().size();
  return static_cast<int>(sections) * headHeight_px() + rowsBefore(sections) * (cardHeight_px() + kCardGap_px);
}

QRect CardView::contentRect(int row) const {
  const auto& sections = list_.sections();
  for (std::size_t n = 0; n < sections.size(); ++n) {
    const int within = row - sections[n].first;
    if (within >= sections[n].count) continue;
    const int y = static_cast<int>(n + 1) * headHeight_px() + (rowsBefore(n) + within / columns()) * (cardHeight_px() + kCardGap_px);
    return {(within % columns()) * (cardWidth_px() + kCardGap_px), y, cardWidth_px(), cardHeight_px()};
  }
  return {};
}

QRect CardView::visualRect(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  return QStyle::visualRect(layoutDirection(), viewport()->rect(), contentRect(index.row()).translated(0, -verticalOffset()));
}

QModelIndex CardView::indexAt(const QPoint& point) const {
  const QPoint at = QStyle::visualPos(layoutDirection(), viewport()->rect(), point) + QPoint(0, verticalOffset());
  const int column = at.x() / (cardWidth_px() + kCardGap_px);
  if (at.x() < 0 || column >= columns()) return {};
  const auto& sections = list_.sections();
  for (std::size_t n = 0; n < sections.size(); ++n) {
    const int top = static_cast<int>(n + 1) * headHeight_px() + rowsBefore(n) * (cardHeight_px() + kCardGap_px);
    const int within = at.y() < top ? -1 : (at.y() - top) / (cardHeight_px() + kCardGap_px) * columns() + column;
    if (within < 0 || within >= sections[n].count) continue;
    const int row = sections[n].first + within;
    return contentRect(row).contains(at) ? list_.index(row) : QModelIndex();
  }
  return {};
}

int CardView::verticalOffset() const { return verticalScrollBar()->value(); }

void CardView::scrollTo(const QModelIndex& index, ScrollHint hint) {
  if (!index.isValid()) return;
  const QRect card = contentRect(index.row());
  // The heading comes with the first row below it.
  const int top = card.top() - (headHeight_px() > 0 ? headHeight_px() : 0), seen = viewport()->height();
  QScrollBar& bar = *verticalScrollBar();
  if (hint == PositionAtTop || top < bar.value())
    bar.setValue(top);
  else if (card.bottom() + kCardGap_px > bar.value() + seen)
    bar.setValue(std::min(top, card.bottom() + kCardGap_px - seen));
}

QModelIndex CardView::moveCursor(CursorAction action, Qt::KeyboardModifiers) {
  const int count = list_.rowCount();
  if (count == 0) return {};
  const int row = currentIndex().isValid() ? currentIndex().row() : -1;
  if (row < 0) return list_.index(0);
  const bool isMirrored = layoutDirection() == Qt::RightToLeft;
  const auto to = [&](int wanted) { return list_.index(std::clamp(wanted, 0, count - 1)); };
  /// The card nearest below or above in the same column, across sections.
  const auto vertically = [&](int rows) {
    const QRect from = contentRect(row);
    QModelIndex best;
    for (int next = row + (rows > 0 ? 1 : -1), crossed = 0, line = from.top(); next >= 0 && next<count; next += rows> 0 ? 1 : -1) {
      const QRect card = contentRect(next);
      if (card.top() != line) {
        if (crossed == std::abs(rows)) break;
        line = card.top();
        ++crossed;
        best = {};
      }
      if (crossed == 0) continue;
      // The last of a shorter row stands for columns it does not have.
      if (!best.isValid() || std::abs(card.left() - from.left()) < std::abs(contentRect(best.row()).left() - from.left()))
        best = list_.index(next);
    }
    return best.isValid() ? best : list_.index(row);
  };
  const int pageRows = std::max(1, viewport()->height() / (cardHeight_px() + kCardGap_px));
  switch (action) {
    case MoveLeft:
      return to(row + (isMirrored ? 1 : -1));
    case MoveRight:
      return to(row + (isMirrored ? -1 : 1));
    case MovePrevious:
      return to(row - 1);
    case MoveNext:
      return to(row + 1);
    case MoveUp:
      return vertically(-1);
    case MoveDown:
      return vertically(1);
    case MovePageUp:
      return vertically(-pageRows);
    case MovePageDown:
      return vertically(pageRows);
    case MoveHome:
      return list_.index(0);
    case MoveEnd:
      return list_.index(count - 1);
  }
  return {};
}

void CardView::setSelection(const QRect& rect, QItemSelectionModel::SelectionFlags command) {
  const QModelIndex index = indexAt(rect.center());
  selectionModel()->select(index.isValid() ? QItemSelection(index, index) : QItemSelection(), command);
}

QRegion CardView::visualRegionForSelection(const QItemSelection& selection) const {
  QRegion region;
  for (const QModelIndex& index : selection.indexes()) region += visualRect(index);
  return region;
}

}  // namespace ew::ui
