#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "editor/lesson_document.h"

class QLabel;
class QPushButton;

namespace ew {
class ScrollRows;
}

namespace ew::lessons {

class ExpertTake;
class FieldForm;
class TaskForm;

/// One step: what every step has, and what only its kind has; what is missing is said at the top.
class StepEditor final : public QWidget {
  Q_OBJECT

 public:
  StepEditor(LessonDocument& document, ExpertTake& take, QWidget* parent = nullptr);

  void showStep(const std::string& lessonId, const std::string& stepId);
  void refresh();  ///< the step may have changed
  void close();    ///< it is not looked at any more: the probe is given back
  [[nodiscard]] const std::string& stepId() const { return stepId_; }

 Q_SIGNALS:
  void backAsked();
  void tryAsked();
  void stepAsked(const QString& stepId);

 private:
  void build();
  void addTexts(const StepEdit& edited);
  void addRest(const StepEdit& edited);
  void addCase(const StepEdit& edited);
  void addAids(const StepEdit& edited);
  void step(int by);

  LessonDocument& document_;
  ExpertTake& take_;
  std::string lessonId_, stepId_;
  std::optional<std::size_t> kind_;  ///< that the form was built for
  QLabel* number_ = nullptr;
  QLabel* kindName_ = nullptr;
  QPushButton* earlier_ = nullptr;
  QPushButton* later_ = nullptr;
  QLabel* missing_ = nullptr;
  ScrollRows* scrolled_ = nullptr;
  FieldForm* texts_ = nullptr;
  FieldForm* rest_ = nullptr;
  TaskForm* task_ = nullptr;
};

}  // namespace ew::lessons
