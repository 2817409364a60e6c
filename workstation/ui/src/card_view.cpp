#include "card_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStyle>
#include <algorithm>

#include "case_card.h"
#include "theme.h"
#include "words.h"

namespace ew::ui {
namespace {

constexpr int kLeastCardWidth_px = 280;
constexpr int kMostCardWidth_px = 440;
constexpr int kGap_px = 16;

}  // namespace

CardView::CardView(CaseCatalogue& list, QWidget* parent) : QListView(parent), list_(list) {
  setObjectName(QStringLiteral("caseCards"));
  setAccessibleName(tr("Cases"));
  setFrameShape(QFrame::NoFrame);
  setSelectionMode(SingleSelection);
  setEditTriggers(NoEditTriggers);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setViewportMargins(0, 0, kGap_px / 2, 0);  // between the cards and the bar
  setMouseTracking(true);
  setTabKeyNavigation(false);
  connect(&list, &QAbstractItemModel::modelAboutToBeReset, this, &CardView::keepPlace);
  connect(&list, &CaseCatalogue::looksChanged, viewport(), QOverload<>::of(&QWidget::update));
  setModel(&list);
}

int CardView::columns() const { return std::max(1, (viewport()->width() + kGap_px) / (kLeastCardWidth_px + kGap_px)); }

int CardView::cardWidth_px() const {
  const int columns = this->columns();
  return std::min(kMostCardWidth_px, (viewport()->width() - (columns - 1) * kGap_px) / columns);
}

int CardView::headHeight_px() const { return list_.sections().size() < 2 ? 0 : fontMetrics().lineSpacing() + kGap_px; }

/// Rows of cards above a section.
int CardView::rowsBefore(std::size_t section) const {
  int rows = 0;
  for (std::size_t n = 0; n < section; ++n) rows += (list_.sections()[n].count + columns() - 1) / columns();
  return rows;
}

int CardView::contentHeight_px() const {
  const std::size_t sections = list_.sections().size();
  return static_cast<int>(sections) * headHeight_px() + rowsBefore(sections) * (cardHeight_px() + kGap_px);
}

QRect CardView::contentRect(int row) const {
  const auto& sections = list_.sections();
  for (std::size_t n = 0; n < sections.size(); ++n) {
    const int within = row - sections[n].first;
    if (within >= sections[n].count) continue;
    const int y = static_cast<int>(n + 1) * headHeight_px() + (rowsBefore(n) + within / columns()) * (cardHeight_px() + kGap_px);
    return {(within % columns()) * (cardWidth_px() + kGap_px), y, cardWidth_px(), cardHeight_px()};
  }
  return {};
}

QRect CardView::visualRect(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  return QStyle::visualRect(layoutDirection(), viewport()->rect(), contentRect(index.row()).translated(0, -verticalOffset()));
}

QModelIndex CardView::indexAt(const QPoint& point) const {
  const QPoint at = QStyle::visualPos(layoutDirection(), viewport()->rect(), point) + QPoint(0, verticalOffset());
  const int column = at.x() / (cardWidth_px() + kGap_px);
  if (at.x() < 0 || column >= columns()) return {};
  const auto& sections = list_.sections();
  for (std::size_t n = 0; n < sections.size(); ++n) {
    const int top = static_cast<int>(n + 1) * headHeight_px() + rowsBefore(n) * (cardHeight_px() + kGap_px);
    const int within = at.y() < top ? -1 : (at.y() - top) / (cardHeight_px() + kGap_px) * columns() + column;
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
  else if (card.bottom() + kGap_px > bar.value() + seen)
    bar.setValue(std::min(top, card.bottom() + kGap_px - seen));
}

void CardView::doItemsLayout() { QAbstractItemView::doItemsLayout(); }

void CardView::updateGeometries() {
  QScrollBar& bar = *verticalScrollBar();
  bar.setPageStep(viewport()->height());
  bar.setSingleStep(std::max(1, (cardHeight_px() + kGap_px) / 6));
  bar.setRange(0, std::max(0, contentHeight_px() - viewport()->height()));
  QAbstractItemView::updateGeometries();
}

void CardView::keepPlace() {
  topNumber_ = currentNumber_ = -1;
  if (currentIndex().isValid() && currentIndex().row() < list_.rowCount()) currentNumber_ = list_.numberOf(currentIndex().row());
  if (verticalOffset() == 0) return;
  for (const QPoint& at : {QPoint(1, 1), QPoint(1, kGap_px + 1), QPoint(1, kGap_px + headHeight_px() + 1)}) {
    const QModelIndex top = indexAt(at);
    if (!top.isValid()) continue;
    topNumber_ = list_.numberOf(top.row());
    topOffset_px_ = contentRect(top.row()).top() - verticalOffset();
    return;
  }
}

void CardView::reset() {
  QAbstractItemView::reset();
  underMouse_ = pressed_ = -1;
  updateGeometries();
  if (const int top = topNumber_ < 0 ? -1 : list_.rowOf(topNumber_); top >= 0)
    verticalScrollBar()->setValue(contentRect(top).top() - topOffset_px_);
  else
    verticalScrollBar()->setValue(0);
  if (const int current = currentNumber_ < 0 ? -1 : list_.rowOf(currentNumber_); current >= 0)
    selectionModel()->setCurrentIndex(list_.index(current), QItemSelectionModel::ClearAndSelect);
  viewport()->update();
  Q_EMIT sightChanged();
}

void CardView::dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight, const QVector<int>& roles) {
  QAbstractItemView::dataChanged(topLeft, bottomRight, roles);
  viewport()->update();
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
  const int pageRows = std::max(1, viewport()->height() / (cardHeight_px() + kGap_px));
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

void CardView::paintEvent(QPaintEvent* event) {
  QPainter painter(viewport());
  const int top = verticalOffset();
  const auto& sections = list_.sections();
  const int step = cardHeight_px() + kGap_px;
  for (std::size_t n = 0; n < sections.size(); ++n) {
    const int y = static_cast<int>(n) * headHeight_px() + rowsBefore(n) * step - top;
    const int first_y = y + headHeight_px();
    if (headHeight_px() > 0 && QRect(0, y, viewport()->width(), headHeight_px()).intersects(event->rect())) {
      QFont bold = font();
      bold.setWeight(QFont::DemiBold);
      painter.setFont(bold);
      painter.setPen(currentTheme().text);
      painter.drawText(QRect(0, y, viewport()->width(), headHeight_px()), static_cast<int>(Qt::AlignVCenter | Qt::AlignLeading),
                       tr("%1 (%2)").arg(kindWords(sections[n].kind), locale().toString(sections[n].count)));
    }
    const int rows = (sections[n].count + columns() - 1) / columns();
    const int begin = std::clamp((event->rect().top() - first_y) / step, 0, rows);
    const int end = std::clamp((event->rect().bottom() - first_y) / step + 1, 0, rows);
    for (int within = begin * columns(); within < std::min(end * columns(), sections[n].count); ++within) {
      const int row = sections[n].first + within;
      CardLook look;
      look.row = list_.row(row);
      if (look.row != nullptr) {
        look.picture = list_.picture(*look.row);
        look.state = list_.state(*look.row);
      }
      look.isCurrent = hasFocus() && currentIndex().row() == row;
      look.isUnderMouse = row == underMouse_;
      look.direction = layoutDirection();
      paintCard(painter, visualRect(list_.index(row)), look);
    }
  }
}

QStringList CardView::foldersInSight() const {
  QStringList folders;
  const int count = list_.rowCount();
  const QRect seen = viewport()->rect();
  // The first in sight by halving: cards lie below each other in the order of their rows.
  int low = 0, high = count;
  while (low < high) {
    const int middle = (low + high) / 2;
    (contentRect(middle).bottom() < verticalOffset() ? low : high) = contentRect(middle).bottom() < verticalOffset() ? middle + 1 : middle;
  }
  for (int row = low; row < count && visualRect(list_.index(row)).top() < seen.bottom(); ++row)
    if (const CaseRow* shown = list_.row(row)) folders << wordsOf(shown->folder);
  return folders;
}

void CardView::choose(const QModelIndex& index) {
  if (!index.isValid()) return;
  if (const CaseRow* row = list_.row(index.row())) Q_EMIT chosen(wordsOf(row->folder));
}

void CardView::resizeEvent(QResizeEvent* event) {
  QAbstractItemView::resizeEvent(event);
  updateGeometries();
  Q_EMIT sightChanged();
}

void CardView::scrollContentsBy(int, int) {
  viewport()->update();
  Q_EMIT sightChanged();
}

void CardView::mouseMoveEvent(QMouseEvent* event) {
  const QModelIndex under = indexAt(event->pos());
  viewport()->setCursor(under.isValid() ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (std::exchange(underMouse_, under.row()) != under.row()) viewport()->update();
}

void CardView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pressed_ = indexAt(event->pos()).row();
  if (pressed_ >= 0) selectionModel()->setCurrentIndex(list_.index(pressed_), QItemSelectionModel::ClearAndSelect);
}

void CardView::mouseReleaseEvent(QMouseEvent* event) {
  const QModelIndex released = indexAt(event->pos());
  if (event->button() == Qt::LeftButton && released.isValid() && std::exchange(pressed_, -1) == released.row()) choose(released);
}

/// Letters, digits and the keys that move mean this list while it has the focus, not the console.
bool CardView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool isPlain = (key->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
    const bool moves =
        (key->key() >= Qt::Key_Home && key->key() <= Qt::Key_PageDown) || key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    if (isPlain && (moves || (!key->text().isEmpty() && key->text().front().isPrint()))) {
      event->accept();
      return true;
    }
  }
  return QListView::event(event);
}

void CardView::keyPressEvent(QKeyEvent* event) {
  const bool isPlain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  if (isPlain && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space))
    return choose(currentIndex());
  if (isPlain && event->key() == Qt::Key_Up && (!currentIndex().isValid() || currentIndex().row() < columns())) return Q_EMIT leftUpwards();
  QAbstractItemView::keyPressEvent(event);
}

void CardView::keyboardSearch(const QString& text) {
  if (!text.trimmed().isEmpty()) Q_EMIT typed(text);
}

void CardView::focusInEvent(QFocusEvent* event) {
  QAbstractItemView::focusInEvent(event);
  if (!currentIndex().isValid() && list_.rowCount() > 0 && event->reason() != Qt::MouseFocusReason) {
    const QModelIndex first = indexAt(QPoint(kGap_px, headHeight_px() + kGap_px));
    selectionModel()->setCurrentIndex(first.isValid() ? first : list_.index(0), QItemSelectionModel::ClearAndSelect);
  }
  viewport()->update();
}

void CardView::leaveEvent(QEvent* event) {
  underMouse_ = -1;
  viewport()->update();
  QAbstractItemView::leaveEvent(event);
}

void CardView::changeEvent(QEvent* event) {
  QListView::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) updateGeometries();
}

}  // namespace ew::ui
