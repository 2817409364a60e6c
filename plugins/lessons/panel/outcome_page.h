#pragma once

#include <QWidget>

#include "ew/library/attempt.h"
#include "ew/library/lesson.h"

class QLabel;
class QPushButton;

namespace ew::lessons {

class LessonRun;
class ScrolledRows;

/// How a step went: passed or not, what was good, what was missed; and at the end of a lesson how all of it went.
class OutcomePage final : public QWidget {
  Q_OBJECT

 public:
  explicit OutcomePage(QWidget* parent = nullptr);
  void showStep(const LessonStep& step, const StepOutcome& outcome, bool isLast);
  void showLesson(const LessonRun& run);
  /// Of an exercise. @param then when it comes again
  void showExercise(const LessonStep& step, const StepOutcome& outcome, const QString& then);

 Q_SIGNALS:
  void againAsked();
  void nextAsked();

 private:
  void addRemark(bool good, const QString& text);

  QLabel* heading_ = nullptr;
  QLabel* figure_ = nullptr;
  ScrolledRows* remarks_ = nullptr;
  QPushButton* again_ = nullptr;
  QPushButton* next_ = nullptr;
};

}  // namespace ew::lessons
