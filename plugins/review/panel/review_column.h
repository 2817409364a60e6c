#pragma once

#include <QWidget>

#include "panel/session/review_scan.h"

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTabWidget;
class QVBoxLayout;

namespace ew::review {

class LessonScores;
class ReviewSelection;
class ReviewSession;
class Reviewer;

/// Which attempt and step is reviewed, and what it is compared with.
class ScansPage final : public QWidget {
  Q_OBJECT

 public:
  explicit ScansPage(ReviewSession& session, QWidget* parent = nullptr);

 private:
  void makeButtons(QVBoxLayout& rows);
  void refresh();
  void showAttempts();
  void showSteps();
  void showComparisons();
  void askForFile(Side side);

  ReviewSession& session_;
  const ReviewSelection& selection_;
  Reviewer& reviewer_;
  LessonScores& scores_;
  QComboBox* lesson_ = nullptr;
  QListWidget* attempts_ = nullptr;
  QComboBox* step_ = nullptr;
  QComboBox* compared_ = nullptr;
  QCheckBox* names_ = nullptr;
  QLabel* note_ = nullptr;
  QPushButton* class_ = nullptr;
  bool showing_ = false;
};

/// The column of the workspace Review: scans, comments, scores and ratings.
class ReviewColumn final : public QWidget {
  Q_OBJECT

 public:
  explicit ReviewColumn(ReviewSession& session, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  [[nodiscard]] QHBoxLayout* makeReviewer();

  ReviewSession& session_;
  QLineEdit* reviewer_ = nullptr;
  QTabWidget* tabs_ = nullptr;
};

}  // namespace ew::review
