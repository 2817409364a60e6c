#include "editor/order_list.h"

#include <QDropEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <algorithm>

#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::lessons {

namespace {

enum Role { kIdRole = Qt::UserRole, kRemarkRole, kIncompleteRole };

/// Title, and the remark below it in the quiet colour; both are cut at the right where they are too long.
class EntryDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {10 * kGrid_px, 2 * option.fontMetrics.lineSpacing() + kGrid_px};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem whole = option;
    initStyleOption(&whole, index);
    const QString title = whole.text;
    whole.text.clear();
    const QWidget* widget = option.widget;
    widget->style()->drawControl(QStyle::CE_ItemViewItem, &whole, painter, widget);
    const bool chosen = (option.state & QStyle::State_Selected) != 0;
    const QRect inside = option.rect.adjusted(kGrid_px, kGrid_px / 2, -kGrid_px, -kGrid_px / 2);
    const int line = option.fontMetrics.lineSpacing();
    const QPalette& palette = option.palette;
    painter->save();
    painter->setPen(palette.color(chosen ? QPalette::HighlightedText : QPalette::Text));
    painter->drawText(QRect(inside.left(), inside.top(), inside.width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                      option.fontMetrics.elidedText(title, Qt::ElideRight, inside.width()));
    const bool incomplete = index.data(kIncompleteRole).toBool();
    QColor quiet = palette.color(chosen ? QPalette::HighlightedText : incomplete ? QPalette::BrightText : QPalette::PlaceholderText);
    if (!incomplete && chosen) quiet.setAlphaF(0.8);
    painter->setPen(quiet);
    painter->drawText(QRect(inside.left(), inside.top() + line, inside.width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                      option.fontMetrics.elidedText(index.data(kRemarkRole).toString(), Qt::ElideRight, inside.width()));
    painter->restore();
  }
};

}  // namespace

OrderList::OrderList(QWidget* parent) : QListWidget(parent) {
  setItemDelegate(new EntryDelegate(this));
  setSelectionMode(QAbstractItemView::SingleSelection);
  setDragDropMode(QAbstractItemView::InternalMove);
  setDropIndicatorShown(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setUniformItemSizes(true);
  connect(this, &QListWidget::itemDoubleClicked, this, [this](QListWidgetItem* item) { Q_EMIT openAsked(item->data(kIdRole).toString()); });
}

void OrderList::showEntries(const std::vector<OrderEntry>& entries) {
  const std::string kept = chosen();
  const QSignalBlocker quiet(this);
  clear();
  for (const OrderEntry& entry : entries) {
    auto* item = new QListWidgetItem(entry.title, this);
    item->setData(kIdRole, words(entry.id));
    item->setData(kRemarkRole, entry.remark);
    item->setData(kIncompleteRole, entry.isIncomplete);
    item->setToolTip(entry.title + QStringLiteral("\n") + entry.remark);
    item->setData(Qt::AccessibleTextRole, entry.title + QStringLiteral(", ") + entry.remark);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
  }
  choose(kept);
  if (currentRow() < 0 && count() > 0) setCurrentRow(0);
  updateGeometry();
}

std::string OrderList::chosen() const {
  const QListWidgetItem* item = currentItem();
  return item == nullptr ? std::string() : item->data(kIdRole).toString().toStdString();
}

void OrderList::choose(const std::string& id) {
  for (int row = 0; row < count(); ++row)
    if (item(row)->data(kIdRole).toString().toStdString() == id) setCurrentRow(row);
}

void OrderList::moveChosen(int by) {
  const int to = currentRow() + by;
  if (currentRow() < 0 || to < 0 || to >= count()) return;
  Q_EMIT moveAsked(words(chosen()), to);
}

void OrderList::dropEvent(QDropEvent* event) {
  const int from = currentRow();
  const QModelIndex over = indexAt(event->pos());
  int to = over.isValid() ? over.row() : count() - 1;
  if (over.isValid() && event->source() == this) {
    // Dropped on the lower half of an entry, it stands behind that one.
    const bool below = event->pos().y() > visualRect(over).center().y();
    to = over.row() + (below ? 1 : 0);
    if (to > from) --to;
  }
  event->setDropAction(Qt::CopyAction);  // the view must not move it by itself: the new order comes back from the case
  event->accept();
  if (from >= 0 && to != from) Q_EMIT moveAsked(words(chosen()), to);
}

bool OrderList::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->modifiers() == Qt::AltModifier && (key->key() == Qt::Key_Up || key->key() == Qt::Key_Down)) {
      event->accept();
      return true;
    }
  }
  return QListWidget::event(event);
}

void OrderList::keyPressEvent(QKeyEvent* event) {
  const QString id = words(chosen());
  if (event->modifiers() == Qt::AltModifier && (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down))
    return moveChosen(event->key() == Qt::Key_Up ? -1 : 1);
  if (!id.isEmpty() && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)) {
    Q_EMIT openAsked(id);
    return;
  }
  if (!id.isEmpty() && event->key() == Qt::Key_Delete) {
    Q_EMIT removeAsked(id);
    return;
  }
  QListWidget::keyPressEvent(event);
}

QSize OrderList::sizeHint() const {
  const int row = count() > 0 ? sizeHintForRow(0) : 5 * kGrid_px;
  return {20 * kGrid_px, std::clamp(count(), 3, 9) * row + 2 * frameWidth()};
}

QPushButton* smallButton(const QString& text, const char* name, const QString& tip) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  button->setAccessibleName(tip.isEmpty() ? text : tip);
  button->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  return button;
}

}  // namespace ew::lessons
