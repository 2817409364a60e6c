#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/class_figures.h"
#include "ew/library/lesson.h"
#include "logic/class_overview.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace ew {
class NumberField;
}

namespace ew::review {

class LessonScores;
class ReviewSelection;
class ReviewSession;
class Reviewer;

/// The values of a class along an axis: how many lie where, the box of the middle half with the median, and a level that has to be reached.
class DistributionChart final : public QWidget {
  Q_OBJECT

 public:
  explicit DistributionChart(QWidget* parent = nullptr);
  /// @param level is marked; empty: none
  void show(const Distribution& values, const QString& unit, double lowest, double highest, std::optional<double> level);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintBars(QPainter& painter, const QRectF& box) const;
  void paintBox(QPainter& painter, const QRectF& box) const;
  [[nodiscard]] double xOf(double value, const QRectF& box) const;

  Distribution values_;
  QString unit_;
  double lowest_ = 0.0, highest_ = 1.0;
  std::optional<double> level_;
};

/// The overview of everybody who tried a lesson, as classFiguresOf has it: each step with how many passed, and the distribution of its
/// score and figures; the step that most fail is marked. Beside it the pass level, what is said of those who tried, and what these two
/// groups suggest.
class ClassPage final : public QWidget {
  Q_OBJECT

 public:
  explicit ClassPage(ReviewSession& session, QWidget* parent = nullptr);

 private:
  QWidget* makeSteps();
  QWidget* makeDetails();
  void refresh();
  void workOut();
  void showHardest();
  void showSteps();
  void showStep();
  void showAttempts();
  void showSuggestion();
  void keepLevel(double level);
  [[nodiscard]] QComboBox* standingBox(std::size_t attempt);
  [[nodiscard]] QString wordByRaters(std::size_t attempt) const;
  void keepStanding(QComboBox& box, std::size_t attempt);
  [[nodiscard]] const ClassStep* shownStep() const;
  [[nodiscard]] const LessonStep* lessonStep(const std::string& id) const;
  [[nodiscard]] QString titleOfStep(const ClassStep& step) const;

  ReviewSession& session_;
  const ReviewSelection& selection_;
  const Reviewer& reviewer_;
  LessonScores& scores_;
  std::vector<ClassAttempt> class_;  ///< of the lesson's attempts, in the shelf's order
  ClassFigures figures_;             ///< of these
  std::vector<ClassStep> rows_;      ///< of the list of steps
  std::string stepId_;
  QLabel* heading_ = nullptr;
  QLabel* hardest_ = nullptr;
  QTreeWidget* steps_ = nullptr;
  QLabel* stepTitle_ = nullptr;
  QComboBox* figure_ = nullptr;
  DistributionChart* chart_ = nullptr;
  QLabel* numbers_ = nullptr;
  NumberField* level_ = nullptr;
  QTreeWidget* attempts_ = nullptr;
  QLabel* suggestion_ = nullptr;
  QPushButton* take_ = nullptr;
  QPushButton* back_ = nullptr;
  std::optional<double> suggested_;
  bool showing_ = false;
};

}  // namespace ew::review
