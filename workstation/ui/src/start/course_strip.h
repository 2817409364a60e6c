#pragma once

#include <QFrame>

#include "start/learning.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace ew::ui {

/// The way through the lessons, above the cases: what was stopped in the middle, how far the course has got and what comes next, and on
/// request all its lessons. Not there when there is nothing to say.
class CourseStrip final : public QFrame {
  Q_OBJECT

 public:
  explicit CourseStrip(QWidget* parent = nullptr);
  void show(const Learning::Known& known);
  /// From the first to the last in the order of the tab key.
  [[nodiscard]] std::vector<QWidget*> inOrder() const;

 Q_SIGNALS:
  void lessonChosen(const QString& caseFolder, const QString& lessonId);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showStopped(const std::optional<ResumableLesson>& stopped);
  void showCourse(const std::optional<CourseProgress>& course);
  void listLessons(const CourseProgress& course);
  void fitList();
  QWidget* lessonRow(const CourseStep& step, int number, bool isNext);

  std::optional<ResumableLesson> stoppedLesson_;
  std::optional<CourseStep> next_;
  QWidget* stopped_ = nullptr;
  QLabel* stoppedText_ = nullptr;
  QPushButton* stoppedGoOn_ = nullptr;
  QWidget* course_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* progressText_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* goOn_ = nullptr;
  QToolButton* all_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  QVBoxLayout* lessons_ = nullptr;
};

}  // namespace ew::ui
