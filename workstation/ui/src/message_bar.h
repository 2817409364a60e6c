#pragma once

#include <QFrame>
#include <deque>

#include "ew/core/result.h"

class QLabel;
class QPushButton;

namespace ew::ui {

/// One sentence above the views that stays until it is dismissed: errors with a red edge, notes with the accent. Several wait in a row
/// and are counted; nothing is a dialog.
class MessageBar final : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent);

  void showError(const Error& error);
  void showError(const QString& sentence);
  void showNote(const QString& sentence);
  [[nodiscard]] QString text() const;  ///< of the message in sight; empty when there is none
  [[nodiscard]] bool isError() const;
  [[nodiscard]] int count() const { return static_cast<int>(waiting_.size()); }
  void dismiss();
  /// Keeps the bar at the top of `area` (in the parent's coordinates).
  void placeIn(const QRect& area);
  void refreshIcons();

 private:
  struct Message {
    QString kind, sentence, details;
  };
  void add(Message message);
  void refresh();

  std::deque<Message> waiting_;
  QRect area_;
  QLabel* sentence_ = nullptr;
  QLabel* more_ = nullptr;
  QPushButton* close_ = nullptr;
};

}  // namespace ew::ui
