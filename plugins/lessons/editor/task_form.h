#pragma once

#include <QWidget>

#include "editor/field_form.h"
#include "editor/lesson_document.h"

namespace ew::lessons {

class ExpertTake;

/// The part of a step's form that only its kind has.
class TaskForm : public QWidget {
 public:
  explicit TaskForm(StepEdit edited, QWidget* parent = nullptr) : QWidget(parent), edited_(std::move(edited)) {}
  /// The step as it is now. @param typed the edit came from this form: what is being typed stays
  virtual void showTask(bool typed) = 0;

 protected:
  [[nodiscard]] const StepEdit& edited() const { return edited_; }

 private:
  StepEdit edited_;
};

/// For the kind that the step has now.
/// @param take the expert's scan that is being recorded, if any
[[nodiscard]] TaskForm* makeTaskForm(const StepEdit& edited, ExpertTake& take, QWidget* parent);

// One each (target_forms.cpp, settings_form.cpp, answer_form.cpp, reading_form.cpp, watch_form.cpp).
[[nodiscard]] TaskForm* makeReadForm(const StepEdit& edited, QWidget* parent);
[[nodiscard]] TaskForm* makeWatchForm(const StepEdit& edited, ExpertTake& take, QWidget* parent);
[[nodiscard]] TaskForm* makePlaneForm(const StepEdit& edited, QWidget* parent);
[[nodiscard]] TaskForm* makeSweepForm(const StepEdit& edited, QWidget* parent);
[[nodiscard]] TaskForm* makeMeasureForm(const StepEdit& edited, QWidget* parent);
[[nodiscard]] TaskForm* makePointForm(const StepEdit& edited, QWidget* parent);
[[nodiscard]] TaskForm* makeSettingsForm(const StepEdit& edited, QWidget* parent);
[[nodiscard]] TaskForm* makeAnswerForm(const StepEdit& edited, QWidget* parent);
/// What a question begins with.
[[nodiscard]] std::vector<AnswerOption> twoAnswers();
[[nodiscard]] TaskForm* makeFreeForm(const StepEdit& edited, QWidget* parent);

}  // namespace ew::lessons
