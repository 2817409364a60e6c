#pragma once

#include <QWidget>

#include "editor/field_form.h"
#include "editor/lesson_document.h"

namespace ew::lessons {

class ExpertTake;

/// The part of a step's form that only its kind has.
class TaskForm : public QWidget {
 public:
  explicit TaskForm(EditedStep edited, QWidget* parent = nullptr) : QWidget(parent), edited_(std::move(edited)) {}
  /// The step as it is now. @param typed the edit came from this form: what is being typed stays
  virtual void showTask(bool typed) = 0;

 protected:
  [[nodiscard]] const EditedStep& edited() const { return edited_; }

 private:
  EditedStep edited_;
};

/// For the kind that the step has now.
/// @param take the expert's scan that is being recorded, if any
[[nodiscard]] TaskForm* makeTaskForm(const EditedStep& edited, ExpertTake& take, QWidget* parent);

// One each (target_forms.cpp, settings_form.cpp, answer_form.cpp, read_form.cpp, watch_form.cpp).
[[nodiscard]] TaskForm* makeReadForm(const EditedStep& edited, QWidget* parent);
[[nodiscard]] TaskForm* makeWatchForm(const EditedStep& edited, ExpertTake& take, QWidget* parent);
[[nodiscard]] TaskForm* makePlaneForm(const EditedStep& edited, QWidget* parent);
[[nodiscard]] TaskForm* makeSweepForm(const EditedStep& edited, QWidget* parent);
[[nodiscard]] TaskForm* makeMeasureForm(const EditedStep& edited, QWidget* parent);
[[nodiscard]] TaskForm* makePointForm(const EditedStep& edited, QWidget* parent);
[[nodiscard]] TaskForm* makeSettingsForm(const EditedStep& edited, QWidget* parent);
[[nodiscard]] TaskForm* makeAnswerForm(const EditedStep& edited, QWidget* parent);
/// What a question begins with.
[[nodiscard]] std::vector<AnswerOption> twoAnswers();
[[nodiscard]] TaskForm* makeFreeForm(const EditedStep& edited, QWidget* parent);

}  // namespace ew::lessons
