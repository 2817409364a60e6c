#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "ew/library/learning_progress.h"
#include "ew/library/lesson.h"

class QVBoxLayout;

namespace ew {
class ScrollRows;
}

namespace ew::lessons {

/// "Level 2, about 10 min".
[[nodiscard]] QString levelText(int level);

/// The lessons of a case as cards: title, aim, how far one got, and one button each. The one that comes next tells what its steps are, too:
/// by their kind, since their titles may give an answer away.
class LessonList final : public QWidget {
  Q_OBJECT

 public:
  explicit LessonList(QWidget* parent = nullptr);
  void showLessons(const std::vector<Lesson>& lessons, const std::vector<LessonStanding>& standings);

 Q_SIGNALS:
  void startAsked(const QString& lessonId);
  void goOnAsked(const QString& lessonId);

 private:
  void addSteps(const Lesson& lesson, QVBoxLayout& rows);

  ScrollRows* rows_ = nullptr;
};

}  // namespace ew::lessons
