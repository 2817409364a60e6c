#pragma once

#include <QListView>

#include "start/case_catalogue.h"

namespace ew::ui {

/// The cards of a list in columns that share the width, below headings where there are several sections. Where a card lies is reckoned, so
/// ten thousand take no longer than ten; only what is seen is painted. What is in sight stays there when the list becomes another one.
class CardView final : public QListView {
  Q_OBJECT

 public:
  explicit CardView(CaseCatalogue& list, QWidget* parent = nullptr);
  /// Folders of the cards in sight, from the top.
  [[nodiscard]] QStringList foldersInSight() const;
  [[nodiscard]] int columns() const;

  [[nodiscard]] QRect visualRect(const QModelIndex& index) const override;
  void scrollTo(const QModelIndex& index, ScrollHint hint = EnsureVisible) override;
  [[nodiscard]] QModelIndex indexAt(const QPoint& point) const override;
  void doItemsLayout() override;
  void reset() override;
  void keyboardSearch(const QString& typed) override;

 Q_SIGNALS:
  void chosen(const QString& folder);
  void lessonsAsked(int row, const QRect& card_global);                        ///< what the case of a row teaches
  void menuAsked(int row, const QRect& card_global, const QPoint& at_global);  ///< what can be done with the case of a row
  void sightChanged();                                                         ///< other cards are in sight
  void typed(const QString& text);                                             ///< letters, which mean the field of the search
  void leftUpwards();                                                          ///< the arrow up in the first row

 protected:
  bool event(QEvent* event) override;
  [[nodiscard]] int horizontalOffset() const override { return 0; }
  [[nodiscard]] int verticalOffset() const override;
  QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;
  void setSelection(const QRect& rect, QItemSelectionModel::SelectionFlags command) override;
  [[nodiscard]] QRegion visualRegionForSelection(const QItemSelection& selection) const override;
  void updateGeometries() override;
  void dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight, const QVector<int>& roles) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void changeEvent(QEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;

 private:
  [[nodiscard]] int cardWidth_px() const;
  [[nodiscard]] int headHeight_px() const;
  [[nodiscard]] int contentHeight_px() const;
  [[nodiscard]] QRect contentRect(int row) const;  ///< of a card, not scrolled
  [[nodiscard]] int rowsBefore(std::size_t section) const;
  void choose(const QModelIndex& index);
  void askForLessons(const QModelIndex& index);
  /// Whether a point of the viewport is where the lessons of its card are asked for.
  [[nodiscard]] bool isOnLessons(const QPoint& point) const;
  void keepPlace();
  CaseCatalogue& list_;
  int pressed_ = -1;
  int underMouse_ = -1;
  bool lessonsUnderMouse_ = false;
  bool pressedLessons_ = false;
  // Where the view stood before the list became another one.
  std::int64_t topNumber_ = -1, currentNumber_ = -1;
  int topOffset_px_ = 0;
};

}  // namespace ew::ui
