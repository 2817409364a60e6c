#include "editor/step_editor.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "editor/expert_take.h"
#include "editor/field_form.h"
#include "editor/order_list.h"
#include "editor/task_form.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/scroll_rows.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/aid_words.h"
#include "panel/step_kinds.h"

namespace ew::lessons {

TaskForm* makeTaskForm(const StepEdit& edited, ExpertTake& take, QWidget* parent) {
  const LessonStep* step = edited.step();
  if (step == nullptr) return nullptr;
  struct Make {
    const StepEdit& edited;
    ExpertTake& take;
    QWidget* parent;
    TaskForm* operator()(const ReadingTask&) const { return makeReadForm(edited, parent); }
    TaskForm* operator()(const WatchTask&) const { return makeWatchForm(edited, take, parent); }
    TaskForm* operator()(const PlaneTask&) const { return makePlaneForm(edited, parent); }
    TaskForm* operator()(const SweepTask&) const { return makeSweepForm(edited, parent); }
    TaskForm* operator()(const MeasureTask&) const { return makeMeasureForm(edited, parent); }
    TaskForm* operator()(const PointTask&) const { return makePointForm(edited, parent); }
    TaskForm* operator()(const SettingsTask&) const { return makeSettingsForm(edited, parent); }
    TaskForm* operator()(const AnswerTask&) const { return makeAnswerForm(edited, parent); }
    TaskForm* operator()(const FreeTask&) const { return makeFreeForm(edited, parent); }
  };
  return std::visit(Make{edited, take, parent}, step->task);
}

StepEditor::StepEditor(LessonDocument& document, ExpertTake& take, QWidget* parent) : QWidget(parent), document_(document), take_(take) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* top = new QHBoxLayout;
  top->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, kGrid_px);
  top->setSpacing(kGrid_px);
  auto* back = smallButton(tr("Steps"), "backToSteps", tr("Back to the steps of the lesson"));
  connect(back, &QPushButton::clicked, this, &StepEditor::backAsked);
  earlier_ = smallButton(QStringLiteral("\u2039"), "earlierStep", tr("The step before"));
  later_ = smallButton(QStringLiteral("\u203a"), "laterStep", tr("The step after"));
  connect(earlier_, &QPushButton::clicked, this, [this] { step(-1); });
  connect(later_, &QPushButton::clicked, this, [this] { step(1); });
  number_ = quietLabel({});
  number_->setObjectName(QStringLiteral("editedStepNumber"));
  number_->setWordWrap(false);
  auto* tryIt = smallButton(tr("Try this step"), "tryStep", tr("Work through it as a trainee does; no attempt is kept"));
  connect(tryIt, &QPushButton::clicked, this, &StepEditor::tryAsked);
  top->addWidget(back);
  top->addWidget(earlier_);
  top->addWidget(number_);
  top->addWidget(later_);
  top->addStretch(1);
  top->addWidget(tryIt);
  column->addLayout(top);
  scrolled_ = new ScrollRows(2 * kGrid_px);
  column->addWidget(scrolled_, 1);
}

void StepEditor::showStep(const std::string& lessonId, const std::string& stepId) {
  if (lessonId != lessonId_ || stepId != stepId_) kind_.reset();
  lessonId_ = lessonId;
  stepId_ = stepId;
  refresh();
}

void StepEditor::close() {
  kind_.reset();
  scrolled_->clear();
  task_ = nullptr;
  texts_ = rest_ = nullptr;
}

void StepEditor::refresh() {
  const Lesson* lesson = lessonIn(document_.lessons(), lessonId_);
  const LessonStep* now = lesson == nullptr ? nullptr : stepIn(*lesson, stepId_);
  if (now == nullptr) return;
  const bool typed = document_.isEditing() && kind_ == now->task.index();
  if (kind_ != now->task.index()) build();
  const auto place = static_cast<std::size_t>(now - lesson->steps.data());
  number_->setText(tr("%1 of %2").arg(place + 1).arg(lesson->steps.size()));
  earlier_->setEnabled(place > 0);
  later_->setEnabled(place + 1 < lesson->steps.size());
  kindName_->setText(kindTitle(taskWord(now->task)));
  QStringList missing;
  for (const LessonProblem& problem : document_.problemsOf(*lesson))
    if (problem.stepId == stepId_) missing << words(problem.text);
  setProblem(missing_, missing.join(QLatin1Char('\n')));
  if (!typed) {
    texts_->showValues();
    rest_->showValues();
  }
  task_->showTask(typed);
}

void StepEditor::build() {
  close();
  const StepEdit edited{document_, lessonId_, stepId_};
  kind_ = edited.step()->task.index();
  QVBoxLayout* rows = scrolled_->rows();
  kindName_ = headingLabel({});
  kindName_->setObjectName(QStringLiteral("editedKind"));
  rows->addWidget(kindName_);
  missing_ = problemLabel();
  missing_->setObjectName(QStringLiteral("stepMissingParts"));
  rows->addWidget(missing_);
  texts_ = new FieldForm;
  addTexts(edited);
  rows->addWidget(texts_);
  task_ = makeTaskForm(edited, take_, nullptr);
  task_->setObjectName(QStringLiteral("taskForm"));
  rows->addWidget(task_);
  rest_ = new FieldForm;
  addRest(edited);
  rows->addWidget(rest_);
  rows->addStretch(1);
}

namespace {

FieldForm::TextAccess textOf(const StepEdit& edited, const QString& what, const char* field, std::string LessonStep::*member) {
  return {[edited, member] { return edited.step() == nullptr ? QString() : words(edited.step()->*member); },
          [edited, what, field, member](const QString& typed) {
            return edited.change(what, field, [&](LessonStep& step) { step.*member = typed.toStdString(); });
          }};
}

}  // namespace

void StepEditor::addTexts(const StepEdit& edited) {
  const bool isQuestion = std::holds_alternative<AnswerTask>(edited.step()->task);
  texts_->addLine("stepTitle", tr("Title"), textOf(edited, tr("Change a step's title"), "title", &LessonStep::title));
  texts_->addText("stepText", isQuestion ? tr("Question") : tr("What to do"),
                  textOf(edited, tr("Change what a step says"), "text", &LessonStep::text), 5);
}

void StepEditor::addRest(const StepEdit& edited) {
  rest_->addHeading(tr("Help"));
  rest_->addText("stepLookFor", tr("Look for"), textOf(edited, tr("Change what to look for"), "lookFor", &LessonStep::lookFor), 2);
  rest_->addText("stepHints", tr("Hints"),
                 {[edited] { return edited.step() == nullptr ? QString() : words(linesOfList(edited.step()->hints)); },
                  [edited](const QString& typed) {
                    return edited.change(tr("Change the hints"), "hints",
                                         [&](LessonStep& step) { step.hints = listOfLines(typed.toStdString()); });
                  }},
                 3, tr("one a line, in the order in which they are asked for"));
  addAids(edited);
  rest_->addHeading(tr("Judging"));
  rest_->addNumber(
      "stepPass", tr("Passed from"), {.lowest = 0, .highest = 100, .unit = QStringLiteral("%"), .step = 5},
      {[edited] { return std::optional<double>(edited.step() == nullptr ? 70.0 : std::round(100.0 * edited.step()->passLevel)); },
       [edited](const std::optional<double>& percent) {
         return edited.change(tr("Change from when on a step is passed"), "pass",
                              [&](LessonStep& step) { step.passLevel = percent.value_or(70.0) / 100.0; });
       }});
  rest_->addNumber("stepTime", tr("Time for the step"),
                   {.lowest = 5, .highest = 7200, .unit = tr("s"), .noneText = tr("any time"), .step = 5},
                   {[edited] { return edited.step() == nullptr ? std::nullopt : edited.step()->time_s; },
                    [edited](const std::optional<double>& seconds) {
                      return edited.change(tr("Change the time of a step"), "time", [&](LessonStep& step) { step.time_s = seconds; });
                    }});
  rest_->addText("stepAfter", tr("Said after"), textOf(edited, tr("Change what is said after a step"), "after", &LessonStep::after), 2);
  addCase(edited);
}

void StepEditor::addAids(const StepEdit& edited) {
  rest_->addRemark(tr("May be switched on:"));
  for (const AidWords& aid : kAidWords)
    rest_->addFlag(aid.name, aidText(aid),
                   {[edited, member = aid.aid] { return edited.step() != nullptr && edited.step()->aids.*member; },
                    [edited, member = aid.aid](bool on) {
                      return edited.change(tr("Choose the aids of a step"), {}, [&](LessonStep& step) { step.aids.*member = on; });
                    }});
  rest_->addFlag("stepFeedback", tr("Say while scanning how far off one is"),
                 {[edited] { return edited.step() != nullptr && edited.step()->feedback; },
                  [edited](bool on) {
                    return edited.change(tr("Choose whether a step gives feedback"), {}, [&](LessonStep& step) { step.feedback = on; });
                  }});
}

void StepEditor::addCase(const StepEdit& edited) {
  rest_->addChoice("stepCase", tr("Scans"),
                   [this] {
                     FieldForm::Options cases = {{std::string(), tr("this case")}};
                     for (const Case& each : document_.library()) cases.emplace_back(each.id, words(each.title));
                     return cases;
                   },
                   {[this, edited] {
                      const LessonStep* step = edited.step();
                      return step == nullptr || (document_.home() && step->caseId == document_.home()->id) ? std::string() : step->caseId;
                    },
                    [this, edited](const std::string& id) {
                      auto done = edited.change(tr("Choose which case a step scans"), {}, [&](LessonStep& step) { step.caseId = id; });
                      if (task_ != nullptr) task_->showTask(false);  // targets are those of that case
                      return done;
                    }});
}

void StepEditor::step(int by) {
  const Lesson* lesson = lessonIn(document_.lessons(), lessonId_);
  const LessonStep* now = lesson == nullptr ? nullptr : stepIn(*lesson, stepId_);
  if (now == nullptr) return;
  const auto to = (now - lesson->steps.data()) + by;
  if (to >= 0 && to < static_cast<std::ptrdiff_t>(lesson->steps.size()))
    Q_EMIT stepAsked(words(lesson->steps[static_cast<std::size_t>(to)].id));
}

}  // namespace ew::lessons
