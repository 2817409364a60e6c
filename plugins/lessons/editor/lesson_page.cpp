#include "editor/lesson_page.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/field_form.h"
#include "editor/order_list.h"
#include "editor/task_form.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/scroll_rows.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/lesson_list.h"
#include "panel/step_kinds.h"

namespace ew::lessons {

LessonPage::LessonPage(LessonDocument& document, QWidget* parent) : QWidget(parent), document_(document) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* top = new QHBoxLayout;
  top->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, kGrid_px);
  auto* back = smallButton(tr("Lessons"), "backToLessons", tr("Back to the lessons of the case"));
  connect(back, &QPushButton::clicked, this, &LessonPage::backAsked);
  top->addWidget(back);
  top->addStretch(1);
  try_ = smallButton(tr("Try this lesson"), "tryLesson", tr("Work through it as a trainee does; no attempt is kept"));
  connect(try_, &QPushButton::clicked, this, &LessonPage::tryAsked);
  top->addWidget(try_);
  column->addLayout(top);
  auto* scrolled = new ScrollRows(2 * kGrid_px);
  head_ = headingLabel({});
  head_->setWordWrap(true);
  scrolled->rows()->addWidget(head_);
  scrolled->rows()->addWidget(headingLabel(tr("Steps")));
  noSteps_ = quietLabel(tr("A lesson is a list of steps. Add the first one."));
  scrolled->rows()->addWidget(noSteps_);
  steps_ = new OrderList;
  steps_->setObjectName(QStringLiteral("editedSteps"));
  steps_->setAccessibleName(tr("Steps"));
  steps_->setToolTip(tr("Enter edits a step, Alt+Up and Alt+Down move it, Del removes it"));
  scrolled->rows()->addWidget(steps_);
  scrolled->rows()->addWidget(makeStepButtons());
  form_ = new FieldForm;
  addFields();
  scrolled->rows()->addWidget(form_);
  scrolled->rows()->addStretch(1);
  column->addWidget(scrolled, 1);
}

QWidget* LessonPage::makeStepButtons() {
  auto* all = new QWidget;
  auto* column = new QVBoxLayout(all);
  column->setContentsMargins(0, 0, 0, kGrid_px);
  column->setSpacing(kGrid_px);
  auto* first = new QHBoxLayout;
  auto* second = new QHBoxLayout;
  for (QHBoxLayout* each : {first, second}) {
    each->setSpacing(kGrid_px);
    column->addLayout(each);
  }
  auto* add = smallButton(tr("Add a step"), "addStep", tr("Behind the chosen one; choose what the trainee does"));
  auto* menu = new QMenu(add);
  menu->setToolTipsVisible(true);
  for (const std::string_view kind : kindWords()) {
    auto* action = menu->addAction(kindTitle(kind), this, [this, kind] { addStep(kind); });
    action->setToolTip(kindTip(kind));
    action->setObjectName(QStringLiteral("addStep_") + QString::fromUtf8(kind.data(), static_cast<int>(kind.size())));
  }
  add->setMenu(menu);
  auto* open = smallButton(tr("Edit"), "editStep", tr("Edit the chosen step"));
  setLook(open, Look::primary);
  auto* copy = smallButton(tr("Duplicate"), "copyStep", tr("Put a copy behind the chosen step"));
  auto* remove = smallButton(tr("Remove"), "removeStep", tr("Remove the chosen step; undo brings it back"));
  auto* up = smallButton(QStringLiteral("\u2191"), "stepUp", tr("Move the chosen step up (Alt+Up)"));
  auto* down = smallButton(QStringLiteral("\u2193"), "stepDown", tr("Move the chosen step down (Alt+Down)"));
  first->addWidget(add);
  first->addWidget(open);
  first->addStretch(1);
  first->addWidget(up);
  first->addWidget(down);
  second->addWidget(copy);
  second->addWidget(remove);
  second->addStretch(1);

  const auto removeOne = [this](const std::string& id) {
    edit(tr("Remove a step"), [id](Lesson one) { return withoutStep(std::move(one), id); });
  };
  connect(open, &QPushButton::clicked, this, [this] { Q_EMIT openAsked(words(steps_->chosen())); });
  connect(copy, &QPushButton::clicked, this, [this] {
    const LessonStep* step = lesson() == nullptr ? nullptr : stepIn(*lesson(), steps_->chosen());
    if (step == nullptr) return;
    const std::string title = tr("%1 (copy)").arg(words(step->title)).left(200).toStdString();
    edit(tr("Duplicate a step"), [id = step->id, title](Lesson one) { return withCopyOfStep(std::move(one), id, title); });
  });
  connect(remove, &QPushButton::clicked, this, [this, removeOne] { removeOne(steps_->chosen()); });
  connect(up, &QPushButton::clicked, this, [this] { steps_->moveChosen(-1); });
  connect(down, &QPushButton::clicked, this, [this] { steps_->moveChosen(1); });
  connect(steps_, &OrderList::openAsked, this, &LessonPage::openAsked);
  connect(steps_, &OrderList::removeAsked, this, [removeOne](const QString& id) { removeOne(id.toStdString()); });
  connect(steps_, &OrderList::moveAsked, this, [this](const QString& id, int place) {
    edit(tr("Move a step"),
         [id = id.toStdString(), place](Lesson one) { return withStepMoved(std::move(one), id, static_cast<std::size_t>(place)); });
  });
  return all;
}

void LessonPage::addFields() {
  const auto text = [this](const QString& what, const char* field, std::string Lesson::*member) {
    return FieldForm::TextAccess{[this, member] { return lesson() == nullptr ? QString() : words(lesson()->*member); },
                                 [this, what, field, member](const QString& typed) {
                                   return change(what, field, [&](Lesson& one) { one.*member = typed.toStdString(); });
                                 }};
  };
  const auto list = [this](const QString& what, const char* field, std::vector<std::string> Lesson::*member) {
    return FieldForm::TextAccess{[this, member] { return lesson() == nullptr ? QString() : words(linesOfList(lesson()->*member)); },
                                 [this, what, field, member](const QString& typed) {
                                   return change(what, field, [&](Lesson& one) { one.*member = listOfLines(typed.toStdString()); });
                                 }};
  };
  form_->addHeading(tr("About the lesson"));
  form_->addLine("lessonTitle", tr("Title"), text(tr("Change a lesson's title"), "title", &Lesson::title));
  form_->addRemark(tr("It is read before the examination: name no finding in it."));
  form_->addText("lessonAim", tr("Aim"), text(tr("Change a lesson's aim"), "aim", &Lesson::aim), 3, tr("what one can do afterwards"));
  form_->addChoice("lessonLevel", tr("Level"),
                   [] {
                     FieldForm::Options levels;
                     for (int level = 1; level <= 5; ++level) levels.emplace_back(std::to_string(level), levelText(level));
                     return levels;
                   },
                   {[this] { return std::to_string(lesson() == nullptr ? 1 : lesson()->level); },
                    [this](const std::string& level) {
                      return change(tr("Change a lesson's level"), {},
                                    [&](Lesson& one) { one.level = std::clamp(level.front() - '0', 1, 5); });
                    }});
  form_->addNumber("lessonMinutes", tr("Takes about"), {.lowest = 1, .highest = 600, .unit = tr("min")},
                   {[this] { return std::optional<double>(lesson() == nullptr ? 10 : lesson()->minutes); },
                    [this](const std::optional<double>& minutes) {
                      return change(tr("Change how long a lesson takes"), "minutes",
                                    [&](Lesson& one) { one.minutes = static_cast<int>(minutes.value_or(10)); });
                    }});
  form_->addText("lessonTags", tr("Tags"), list(tr("Change a lesson's tags"), "tags", &Lesson::tags), 2, tr("one a line"));
  form_->addText("lessonSources", tr("Sources"), list(tr("Change a lesson's sources"), "sources", &Lesson::sources), 3,
                 tr("what it teaches after, one a line"));
  form_->addChoice("lessonLanguage", tr("Written in"),
                   [] {
                     return FieldForm::Options{{"en", tr("English")}, {"de", tr("German")}, {"fr", tr("French")}, {"es", tr("Spanish")}};
                   },
                   {[this] { return lesson() == nullptr ? std::string("en") : lesson()->language; },
                    [this](const std::string& language) {
                      return change(tr("Change a lesson's language"), {}, [&](Lesson& one) { one.language = language; });
                    }});
}

Result<void> LessonPage::change(const QString& what, const std::string& field, const std::function<void(Lesson&)>& change) {
  const std::string key = field.empty() ? std::string() : id_ + "/" + field;
  return document_.edit(what, key, [&](Lessons all) { return withChanged(std::move(all), id_, change); });
}

void LessonPage::edit(const QString& what, const std::function<Lesson(Lesson)>& edit) {
  const auto done = change(what, {}, [&](Lesson& one) { one = edit(std::move(one)); });
  Q_EMIT failed(done ? QString() : words(done.error()));
}

void LessonPage::addStep(std::string_view kind) {
  const Lesson* before = lesson();
  if (before == nullptr) return;
  std::vector<std::string> ids;
  for (const LessonStep& step : before->steps) ids.push_back(step.id);
  const std::string after = steps_->chosen();
  edit(tr("Add a step"), [&](Lesson one) {
    LessonStep fresh = newStep(kind, kindTitle(kind).toStdString());
    if (auto* question = std::get_if<AnswerTask>(&fresh.task)) question->options = twoAnswers();
    return withStep(std::move(one), std::move(fresh), after);
  });
  if (lesson() == nullptr) return;
  for (const LessonStep& step : lesson()->steps)
    if (std::find(ids.begin(), ids.end(), step.id) == ids.end()) {
      steps_->choose(step.id);
      Q_EMIT openAsked(words(step.id));
      return;
    }
}

void LessonPage::showLesson(const std::string& id) {
  id_ = id;
  refresh();
}

void LessonPage::chooseStep(const std::string& stepId) { steps_->choose(stepId); }

void LessonPage::refresh() {
  const Lesson* now = lesson();
  if (now == nullptr) return;
  head_->setText(words(now->title));
  if (!document_.isEditing()) form_->showValues();
  showSteps();
}

void LessonPage::showSteps() {
  const Lesson* now = lesson();
  const auto problems = document_.problemsOf(*now);
  std::vector<OrderEntry> entries;
  int number = 0;
  for (const LessonStep& step : now->steps) {
    const auto problem = std::find_if(problems.begin(), problems.end(), [&](const LessonProblem& one) { return one.stepId == step.id; });
    const bool isIncomplete = problem != problems.end();
    const QString kind = kindTitle(taskWord(step.task));
    entries.push_back({step.id, QStringLiteral("%1  %2").arg(++number).arg(words(step.title)),
                       isIncomplete ? QStringLiteral("%1: %2").arg(kind, words(problem->text)) : kind, isIncomplete});
  }
  steps_->showEntries(entries);
  steps_->setVisible(!entries.empty());
  noSteps_->setVisible(entries.empty());
  try_->setEnabled(!entries.empty());
  try_->setToolTip(entries.empty() ? tr("Add a step first") : tr("Work through it as a trainee does; no attempt is kept"));
  for (const char* name : {"editStep", "copyStep", "removeStep", "stepUp", "stepDown"})
    if (auto* button = findChild<QPushButton*>(QLatin1String(name))) button->setVisible(!entries.empty());
}

}  // namespace ew::lessons
