#pragma once

#include <QString>
#include <QWidget>
#include <memory>
#include <vector>

#include "ew/assessment/review_comment.h"

class QLabel;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace ew::review {

class AttemptComments;
class ReviewDocument;
class ReviewSession;
class Reviewer;
class ScanPair;

/// The comments on the attempt that is reviewed: one's own, which can be edited, and everybody else's. A click goes to the moment.
class CommentsPage final : public QWidget {
  Q_OBJECT

 public:
  explicit CommentsPage(ReviewSession& session, QWidget* parent = nullptr);

 private:
  void refresh();
  void showChosen();
  void goTo(int row);
  [[nodiscard]] const ReviewComment* chosen() const;

  struct Row {
    ReviewComment comment;
    QString author;  ///< empty: one's own
  };
  const ScanPair& scans_;
  const Reviewer& reviewer_;
  AttemptComments& comments_;
  ReviewDocument& document_;
  std::vector<Row> rows_;
  QListWidget* list_ = nullptr;
  QPlainTextEdit* text_ = nullptr;
  QPushButton* remove_ = nullptr;
  QPushButton* save_ = nullptr;
  QLabel* hint_ = nullptr;
  std::shared_ptr<void> ticket_;
  bool showing_ = false;
};

}  // namespace ew::review
