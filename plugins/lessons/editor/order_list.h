#pragma once

#include <QListWidget>
#include <QPushButton>
#include <string>
#include <vector>

namespace ew::lessons {

/// One entry of an OrderList.
struct OrderEntry {
  std::string id;
  QString title;
  QString remark;             ///< quiet, below the title
  bool isIncomplete = false;  ///< something is missing before it can be used; said in the remark, too
};

/// Entries in an order that the user changes: by dragging, by Alt+Up and Alt+Down, or by buttons beside it. It shows the order it is given,
/// and asks for another.
class OrderList final : public QListWidget {
  Q_OBJECT

 public:
  explicit OrderList(QWidget* parent = nullptr);

  void showEntries(const std::vector<OrderEntry>& entries);
  [[nodiscard]] std::string chosen() const;  ///< id; empty: none
  void choose(const std::string& id);
  /// Asks to move the chosen one up or down.
  void moveChosen(int by);

 Q_SIGNALS:
  void moveAsked(const QString& id, int place);
  void openAsked(const QString& id);  ///< double click or Enter
  void removeAsked(const QString& id);

 protected:
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  [[nodiscard]] QSize sizeHint() const override;
};

/// A button as wide as its text, with a tip.
[[nodiscard]] QPushButton* smallButton(const QString& text, const char* name, const QString& tip);

}  // namespace ew::lessons
