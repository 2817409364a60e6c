#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/order_list.h"
#include "editor/task_form.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::lessons {

namespace {

/// A question's answers: options of which some are right, each with what is said to whoever chose it; or a number.
class AnswerForm final : public TaskForm {
 public:
  AnswerForm(const StepEdit& edited, QWidget* parent) : TaskForm(edited, parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid_px);
    auto* kind = new FieldForm;
    kind->addChoice("answerKind", tr("Answered by"),
                    [] {
                      return FieldForm::Options{{"options", tr("choosing")}, {"number", tr("a number")}};
                    },
                    {[this] { return std::string(asksForNumber() ? "number" : "options"); },
                     [this](const std::string& chosen) {
                       auto done =
                           this->edited().changeTask<AnswerTask>(tr("Change how a question is answered"), {}, [&](AnswerTask& task) {
                             task = {};
                             if (chosen == "number")
                               task.number = 0.0;
                             else
                               task.options = twoAnswers();
                           });
                       showTask(false);
                       return done;
                     }});
    forms_.push_back(kind);
    column->addWidget(kind);

    optionsPart_ = new QWidget;
    auto* optionsColumn = new QVBoxLayout(optionsPart_);
    optionsColumn->setContentsMargins(0, 0, 0, 0);
    optionsColumn->setSpacing(kGrid_px);
    optionRows_ = new QVBoxLayout;
    optionRows_->setSpacing(kGrid_px);
    optionsColumn->addLayout(optionRows_);
    auto* add = smallButton(tr("Add an answer"), "addAnswer", {});
    optionsColumn->addWidget(add, 0, Qt::AlignLeft);
    connect(add, &QPushButton::clicked, this, [this] {
      say(this->edited().changeTask<AnswerTask>(tr("Add an answer"), {},
                                                [](AnswerTask& task) { task.options.push_back(newAnswer(task.options.size())); }));
      showTask(false);
    });
    column->addWidget(optionsPart_);
    numberPart_ = makeNumberPart();
    column->addWidget(numberPart_);
    problem_ = problemLabel();
    problem_->setObjectName(QStringLiteral("answer_problem"));
    column->addWidget(problem_);
  }

  static AnswerOption newAnswer(std::size_t number) { return {tr("Answer %1").arg(number + 1).toStdString(), false, {}}; }

  void showTask(bool typed) override {
    if (typed) return;
    for (FieldForm* each : forms_) each->showValues();
    optionsPart_->setVisible(!asksForNumber());
    numberPart_->setVisible(asksForNumber());
    while (QLayoutItem* item = optionRows_->takeAt(0)) {
      item->widget()->hide();
      item->widget()->deleteLater();
      delete item;
    }
    const AnswerTask task = edited().task<AnswerTask>();
    for (std::size_t n = 0; n < task.options.size(); ++n) optionRows_->addWidget(makeOption(n, task.options[n]));
  }

 private:
  static QString tr(const char* text) { return QCoreApplication::translate("ew::lessons::AnswerForm", text); }

  [[nodiscard]] bool asksForNumber() const { return edited().task<AnswerTask>().number.has_value(); }

  QWidget* makeNumberPart() {
    auto* form = new FieldForm;
    const StepEdit at = edited();
    form->addNumber("answerNumberRight", tr("Right is"), {.lowest = -1e9, .highest = 1e9, .decimals = 2},
                    {[at] { return at.task<AnswerTask>().number; },
                     [at](const std::optional<double>& value) {
                       return at.changeTask<AnswerTask>(tr("Change the right number"), "number",
                                                        [&](AnswerTask& task) { task.number = value.value_or(0.0); });
                     }});
    form->addNumber("answerTolerance", tr("Off by at most"), {.lowest = 0, .highest = 1e9, .decimals = 2},
                    {[at] { return std::optional<double>(at.task<AnswerTask>().tolerance); },
                     [at](const std::optional<double>& value) {
                       return at.changeTask<AnswerTask>(tr("Change how far a number may be off"), "tolerance",
                                                        [&](AnswerTask& task) { task.tolerance = value.value_or(0.0); });
                     }});
    form->addLine("answerUnit", tr("Unit"),
                  {[at] { return words(at.task<AnswerTask>().unit); },
                   [at](const QString& unit) {
                     return at.changeTask<AnswerTask>(tr("Change the unit of a number"), "unit",
                                                      [&](AnswerTask& task) { task.unit = unit.toStdString(); });
                   }});
    forms_.push_back(form);
    return form;
  }

  QWidget* makeOption(std::size_t n, const AnswerOption& option) {
    auto* row = new QWidget;
    auto* column = new QVBoxLayout(row);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid_px / 2);
    auto* head = new QHBoxLayout;
    head->setSpacing(kGrid_px);
    auto* right = new QCheckBox(tr("right"));
    right->setObjectName(QStringLiteral("optionRight_%1").arg(n));
    right->setAccessibleName(tr("Answer %1 is right").arg(n + 1));
    right->setChecked(option.right);
    auto* remove = smallButton(tr("Remove"), "", tr("Remove answer %1").arg(n + 1));
    remove->setObjectName(QStringLiteral("removeOption_%1").arg(n));
    head->addWidget(quietLabel(tr("Answer %1").arg(n + 1)), 1);
    head->addWidget(right);
    head->addWidget(remove);
    column->addLayout(head);
    const auto line = [&](const char* name, const QString& hint, const std::string& value, std::string AnswerOption::*member) {
      auto* made = new WithHostUndo<QLineEdit>;
      made->setObjectName(QStringLiteral("%1_%2").arg(QLatin1String(name)).arg(n));
      made->setPlaceholderText(hint);
      made->setAccessibleName(QStringLiteral("%1, %2").arg(tr("Answer %1").arg(n + 1), hint));
      made->setText(words(value));
      made->setCursorPosition(0);
      column->addWidget(made);
      connect(made, &QLineEdit::textEdited, this, [this, n, member, key = std::string(name) + std::to_string(n)](const QString& typed) {
        change(n, tr("Change an answer"), key, [&](AnswerOption& one) { one.*member = typed.toStdString(); });
      });
    };
    line("optionText", tr("what can be chosen"), option.text, &AnswerOption::text);
    line("optionWhy", tr("why it is right or wrong"), option.why, &AnswerOption::why);
    connect(right, &QCheckBox::toggled, this,
            [this, n](bool on) { change(n, tr("Mark a right answer"), {}, [&](AnswerOption& one) { one.right = on; }); });
    connect(remove, &QPushButton::clicked, this, [this, n] {
      say(edited().changeTask<AnswerTask>(tr("Remove an answer"), {}, [&](AnswerTask& task) {
        if (n < task.options.size()) task.options.erase(task.options.begin() + static_cast<std::ptrdiff_t>(n));
      }));
      showTask(false);
    });
    return row;
  }

  void change(std::size_t n, const QString& what, const std::string& field, const std::function<void(AnswerOption&)>& edit) {
    say(edited().changeTask<AnswerTask>(what, field, [&](AnswerTask& task) {
      if (n < task.options.size()) edit(task.options[n]);
    }));
  }

  void say(const Result<void>& done) { setProblem(problem_, done ? QString() : words(done.error())); }

  std::vector<FieldForm*> forms_;
  QWidget* optionsPart_ = nullptr;
  QWidget* numberPart_ = nullptr;
  QVBoxLayout* optionRows_ = nullptr;
  QLabel* problem_ = nullptr;
};

}  // namespace

std::vector<AnswerOption> twoAnswers() { return {AnswerForm::newAnswer(0), AnswerForm::newAnswer(1)}; }

TaskForm* makeAnswerForm(const StepEdit& edited, QWidget* parent) { return new AnswerForm(edited, parent); }

}  // namespace ew::lessons
