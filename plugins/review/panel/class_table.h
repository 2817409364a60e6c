#pragma once

#include <QHeaderView>
#include <QTreeWidget>

namespace ew::review {

inline constexpr int kSortRole = Qt::UserRole + 1;
enum AttemptColumn { kWho, kScore, kVerdict, kStanding };

/// Rows sort by numbers where they have them.
class SortableItem final : public QTreeWidgetItem {
 public:
  using QTreeWidgetItem::QTreeWidgetItem;
  bool operator<(const QTreeWidgetItem& other) const override {
    const int column = treeWidget() != nullptr ? treeWidget()->sortColumn() : 0;
    const QVariant a = data(column, kSortRole), b = other.data(column, kSortRole);
    if (a.isValid() && b.isValid()) return a.toDouble() < b.toDouble();
    return QString::localeAwareCompare(text(column), other.text(column)) < 0;
  }
  void set(int column, const QString& text, double value) {
    setText(column, text);
    setData(column, kSortRole, value);
    setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
};

inline QTreeWidget* table(const char* name, const QString& spoken, const QStringList& heads) {
  auto* made = new QTreeWidget;
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(spoken);
  made->setHeaderLabels(heads);
  made->setRootIsDecorated(false);
  made->setUniformRowHeights(true);
  made->setSortingEnabled(true);
  made->setAllColumnsShowFocus(true);
  made->header()->setStretchLastSection(false);
  made->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  made->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int column = 1; column < heads.size(); ++column) made->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  return made;
}

}  // namespace ew::review
