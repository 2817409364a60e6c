#include "start/card_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStyle>
#include <algorithm>

#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "start/case_card.h"

namespace ew::ui {
// A QListView for those who listen to the screen alone: they hear a list of so many entries. Its own layout is left out everywhere, for the
// cards lie where they are reckoned to lie.
// NOLINTBEGIN(bugprone-parent-virtual-call)
CardView::CardView(CaseCatalogue& list, QWidget* parent) : QListView(parent), list_(list) {
  setObjectName(QStringLiteral("caseCards"));
  setAccessibleName(tr("Cases"));
  setFrameShape(QFrame::NoFrame);
  setSelectionMode(SingleSelection);
  setEditTriggers(NoEditTriggers);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setViewportMargins(0, 0, kCardGap_px / 2, 0);  // between the cards and the bar
  setMouseTracking(true);
  setTabKeyNavigation(false);
  connect(&list, &QAbstractItemModel::modelAboutToBeReset, this, &CardView::keepPlace);
  connect(&list, &CaseCatalogue::looksChanged, viewport(), QOverload<>::of(&QWidget::update));
  setModel(&list);
}

void CardView::doItemsLayout() { QAbstractItemView::doItemsLayout(); }

void CardView::updateGeometries() {
  QScrollBar& bar = *verticalScrollBar();
  bar.setPageStep(viewport()->height());
  bar.setSingleStep(std::max(1, (cardHeight_px() + kCardGap_px) / 6));
  bar.setRange(0, std::max(0, contentHeight_px() - viewport()->height()));
  QAbstractItemView::updateGeometries();
}

void CardView::keepPlace() {
  topNumber_ = currentNumber_ = -1;
  if (currentIndex().isValid() && currentIndex().row() < list_.rowCount()) currentNumber_ = list_.numberOf(currentIndex().row());
  if (verticalOffset() == 0) return;
  for (const QPoint& at : {QPoint(1, 1), QPoint(1, kCardGap_px + 1), QPoint(1, kCardGap_px + headHeight_px() + 1)}) {
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

void CardView::paintEvent(QPaintEvent* event) {
  QPainter painter(viewport());
  const int top = verticalOffset();
  const auto& sections = list_.sections();
  const int step = cardHeight_px() + kCardGap_px;
  for (std::size_t n = 0; n < sections.size(); ++n) {
    const int y = static_cast<int>(n) * headHeight_px() + rowsBefore(n) * step - top;
    const int first_y = y + headHeight_px();
    if (headHeight_px() > 0 && QRect(0, y, viewport()->width(), headHeight_px()).intersects(event->rect())) {
      painter.setFont(bold(font()));
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
        look.image = list_.image(*look.row);
        look.state = list_.state(*look.row);
      }
      look.isCurrent = hasFocus() && currentIndex().row() == row;
      look.isUnderMouse = row == underMouse_;
      look.isLessonsUnderMouse = look.isUnderMouse && lessonsUnderMouse_;
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
  const bool isOther = std::exchange(underMouse_, under.row()) != under.row();
  const bool onLessons = isOnLessons(event->pos());
  if (std::exchange(lessonsUnderMouse_, onLessons) != onLessons || isOther) viewport()->update();
}

void CardView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pressed_ = indexAt(event->pos()).row();
  pressedLessons_ = isOnLessons(event->pos());
  if (pressed_ >= 0) selectionModel()->setCurrentIndex(list_.index(pressed_), QItemSelectionModel::ClearAndSelect);
}

void CardView::mouseReleaseEvent(QMouseEvent* event) {
  const QModelIndex released = indexAt(event->pos());
  if (event->button() != Qt::LeftButton || !released.isValid() || std::exchange(pressed_, -1) != released.row()) return;
  const bool onLessons = isOnLessons(event->pos());
  if (onLessons && pressedLessons_) return askForLessons(released);
  if (!onLessons && !pressedLessons_) choose(released);
}

void CardView::contextMenuEvent(QContextMenuEvent* event) {
  const QModelIndex index = event->reason() == QContextMenuEvent::Keyboard ? currentIndex() : indexAt(event->pos());
  if (!index.isValid() || list_.row(index.row()) == nullptr) return;
  const QRect card = visualRect(index);
  Q_EMIT menuAsked(index.row(), QRect(viewport()->mapToGlobal(card.topLeft()), card.size()), event->globalPos());
}

bool CardView::isOnLessons(const QPoint& point) const {
  const QModelIndex index = indexAt(point);
  const CaseRow* row = index.isValid() ? list_.row(index.row()) : nullptr;
  return row != nullptr && lessonsRect(visualRect(index), *row, layoutDirection()).contains(point);
}

void CardView::askForLessons(const QModelIndex& index) {
  const CaseRow* row = index.isValid() ? list_.row(index.row()) : nullptr;
  if (row == nullptr || row->lessons.empty()) return;
  const QRect card = visualRect(index);
  Q_EMIT lessonsAsked(index.row(), QRect(viewport()->mapToGlobal(card.topLeft()), card.size()));
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
  // Enter opens the case, with Shift what it teaches.
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && event->modifiers().testFlag(Qt::ShiftModifier))
    return askForLessons(currentIndex());
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
    const QModelIndex first = indexAt(QPoint(kCardGap_px, headHeight_px() + kCardGap_px));
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

// NOLINTEND(bugprone-parent-virtual-call)
}  // namespace ew::ui
