#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ew/library/attempt.h"
#include "ew/library/lesson.h"

class QVBoxLayout;

namespace ew::lessons {

/// What is known of a lesson's attempts.
struct LessonProgress {
  std::size_t attempts = 0;                          ///< finished
  std::size_t bestPassed = 0;                        ///< steps, of the best attempt that was finished
  std::optional<std::filesystem::path> interrupted;  ///< the latest attempt that was stopped in the middle
  std::size_t interruptedAt = 0;                     ///< steps ended in it
};
/// @param attempts the latest first
[[nodiscard]] LessonProgress progressOf(const Lesson& lesson, const std::string& caseId, const AttemptList& attempts);

/// "Level 2, about 10 min".
[[nodiscard]] QString levelText(int level);

/// The lessons of a case as cards: title, aim, how far one got, and one button each.
class LessonList final : public QWidget {
  Q_OBJECT

 public:
  explicit LessonList(QWidget* parent = nullptr);
  void showLessons(const std::vector<Lesson>& lessons, const std::vector<LessonProgress>& progress);

 Q_SIGNALS:
  void startAsked(const QString& lessonId);
  void goOnAsked(const QString& lessonId);

 private:
  QVBoxLayout* rows_ = nullptr;
  QWidget* body_ = nullptr;
};

}  // namespace ew::lessons
