#pragma once

#include <QWidget>

#include "ew/assessment/attempt_result.h"
#include "ew/library/attempt.h"
#include "ew/library/lesson.h"
#include "panel/click_guard.h"

class QLabel;
class QPushButton;

namespace ew {
class ScrollRows;
}

namespace ew::lessons {

class LessonRun;

/// How a step went: passed or not, what was good, what was missed; and at the end of a lesson how all of it went. Its buttons wait a
/// moment, so that a double click on the page before does not reach them.
class OutcomePage final : public QWidget {
  Q_OBJECT

 public:
  explicit OutcomePage(QWidget* parent = nullptr);
  void showStep(const LessonStep& step, const StepOutcome& outcome, bool isLast);
  /// @param result of the run: what everybody else says of it
  void showLesson(const LessonRun& run, const AttemptResult& result);
  /// Of an exercise. @param then when it comes again
  void showExercise(const LessonStep& step, const StepOutcome& outcome, const QString& then);

 Q_SIGNALS:
  void againAsked();
  void nextAsked();
  void stepAsked(int step);  ///< of the lesson, to be tried once more

 private:
  void addRemark(bool good, const QString& text);
  void addStep(int number, bool good, const QString& title, bool canRepeat);
  void offer(bool nextFirst);

  QLabel* heading_ = nullptr;
  QLabel* figure_ = nullptr;
  QLabel* toSystem_ = nullptr;  ///< what a learning system is told instead
  ScrollRows* remarks_ = nullptr;
  QPushButton* again_ = nullptr;
  QPushButton* next_ = nullptr;
  ClickGuard guard_;
};

}  // namespace ew::lessons
