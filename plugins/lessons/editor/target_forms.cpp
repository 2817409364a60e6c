// Kinds of steps that ask for something the case has: a plane, a structure, a measurement, a point.
#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>

#include "editor/task_form.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::lessons {

namespace {

QString tr_(const char* text) { return QCoreApplication::translate("ew::lessons::TargetForm", text); }

/// A form that is fields alone.
class TargetForm final : public TaskForm {
 public:
  TargetForm(const StepEdit& edited, QWidget* parent) : TaskForm(edited, parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    form_ = new FieldForm;
    column->addWidget(form_);
  }
  void showTask(bool typed) override {
    if (!typed) form_->showValues();
  }
  [[nodiscard]] FieldForm& form() { return *form_; }

 private:
  FieldForm* form_ = nullptr;
};

using Kinds = std::initializer_list<CaseTarget::Kind>;

std::vector<std::string> targetsOf(const StepEdit& edited, const std::vector<CaseTarget::Kind>& kinds) {
  std::vector<std::string> names;
  const LessonStep* step = edited.step();
  const Case* scanned = step == nullptr ? nullptr : edited.document.scannedBy(*step);
  if (scanned == nullptr) return names;
  for (const CaseTarget& target : scanned->targets)
    if (std::find(kinds.begin(), kinds.end(), target.kind) != kinds.end()) names.push_back(target.name);
  return names;
}

FieldForm::Options optionsOf(const std::vector<std::string>& names, const QString& none) {
  FieldForm::Options options = {{std::string(), names.empty() ? none : tr_("Choose…")}};
  for (const std::string& name : names) options.emplace_back(name, words(name));
  return options;
}

template <class Task>
void addTarget(FieldForm& form, const StepEdit& edited, const QString& label, const QString& none, Kinds kinds) {
  form.addChoice("stepTarget", label, [edited, none, kinds = std::vector(kinds)] { return optionsOf(targetsOf(edited, kinds), none); },
                 {[edited] { return edited.task<Task>().target; },
                  [edited](const std::string& target) {
                    return edited.changeTask<Task>(tr_("Choose a target"), {}, [&](Task& task) { task.target = target; });
                  }});
}

template <class Task>
FieldForm::Access<std::optional<double>> tolerance(const StepEdit& edited, const char* field, std::optional<double> Task::*member) {
  return {[edited, member] { return edited.task<Task>().*member; },
          [edited, field, member](const std::optional<double>& value) {
            return edited.changeTask<Task>(tr_("Change a tolerance"), field, [&](Task& task) { task.*member = value; });
          }};
}

/// Planes and structures of which a free scan is to show some.
class FreeForm final : public TaskForm {
 public:
  FreeForm(const StepEdit& edited, QWidget* parent) : TaskForm(edited, parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid_px);
    form_ = new FieldForm;
    form_->addNumber("freeShortest", tr_("At least"), {.lowest = 0, .highest = 7200, .unit = tr_("s"), .step = 10},
                     {[edited] { return std::optional<double>(edited.task<FreeTask>().shortest_s); },
                      [edited](const std::optional<double>& seconds) {
                        return edited.changeTask<FreeTask>(tr_("Change how long is scanned"), "shortest",
                                                           [&](FreeTask& task) { task.shortest_s = seconds.value_or(0.0); });
                      }});
    column->addWidget(form_);
    column->addWidget(quietLabel(tr_("To be shown meanwhile:")));
    targets_ = new QVBoxLayout;
    targets_->setSpacing(kGrid_px / 2);
    column->addLayout(targets_);
    none_ = quietLabel(tr_("The case has neither planes nor structures; make them on the page Targets."));
    column->addWidget(none_);
  }

  void showTask(bool typed) override {
    if (typed) return;
    form_->showValues();
    while (QLayoutItem* item = targets_->takeAt(0)) {
      item->widget()->deleteLater();
      delete item;
    }
    const FreeTask task = edited().task<FreeTask>();
    std::vector<std::string> names = targetsOf(edited(), {CaseTarget::Kind::plane, CaseTarget::Kind::structure});
    const auto known = names;
    for (const std::string& name : task.targets)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    for (const std::string& name : names) {
      const bool isThere = std::find(known.begin(), known.end(), name) != known.end();
      auto* box = new QCheckBox(isThere ? words(name) : tr_("%1 (not there any more)").arg(words(name)));
      box->setObjectName(QStringLiteral("freeTarget"));
      box->setToolTip(box->text());
      box->setChecked(std::find(task.targets.begin(), task.targets.end(), name) != task.targets.end());
      targets_->addWidget(box);
      connect(box, &QCheckBox::toggled, this, [this, name](bool on) {
        static_cast<void>(edited().changeTask<FreeTask>(tr_("Choose what is to be shown"), {}, [&](FreeTask& free) {
          std::erase(free.targets, name);
          if (on) free.targets.push_back(name);
        }));
      });
    }
    none_->setVisible(names.empty());
  }

 private:
  FieldForm* form_ = nullptr;
  QVBoxLayout* targets_ = nullptr;
  QLabel* none_ = nullptr;
};

std::vector<std::string> measurementsOf(const StepEdit& edited) {
  std::vector<std::string> names;
  const LessonStep* step = edited.step();
  if (const Case* scanned = step == nullptr ? nullptr : edited.document.scannedBy(*step))
    for (const CaseMeasurement& one : scanned->measurements) names.push_back(one.name);
  return names;
}

}  // namespace

TaskForm* makePlaneForm(const StepEdit& edited, QWidget* parent) {
  auto* made = new TargetForm(edited, parent);
  addTarget<PlaneTask>(made->form(), edited, tr_("Plane"), tr_("The case has no planes"), {CaseTarget::Kind::plane});
  const QString own = tr_("as the plane says");
  made->form().addNumber("planePosition", tr_("Place within"), {.lowest = 1, .highest = 200, .unit = tr_("mm"), .noneText = own},
                         tolerance<PlaneTask>(edited, "position", &PlaneTask::positionTolerance_mm));
  made->form().addNumber("planeAngle", tr_("Tilted at most"), {.lowest = 1, .highest = 180, .unit = QStringLiteral("°"), .noneText = own},
                         tolerance<PlaneTask>(edited, "angle", &PlaneTask::angleTolerance_deg));
  return made;
}

TaskForm* makeSweepForm(const StepEdit& edited, QWidget* parent) {
  auto* made = new TargetForm(edited, parent);
  addTarget<SweepTask>(made->form(), edited, tr_("Structure"), tr_("The case has no structures"), {CaseTarget::Kind::structure});
  made->form().addNumber("sweepShare", tr_("To be seen"), {.lowest = 5, .highest = 100, .unit = QStringLiteral("%"), .step = 5},
                         {[edited] { return std::optional<double>(100.0 * edited.task<SweepTask>().share); },
                          [edited](const std::optional<double>& percent) {
                            return edited.changeTask<SweepTask>(tr_("Change how much is to be seen"), "share",
                                                                [&](SweepTask& task) { task.share = percent.value_or(90.0) / 100.0; });
                          }});
  return made;
}

TaskForm* makeMeasureForm(const StepEdit& edited, QWidget* parent) {
  auto* made = new TargetForm(edited, parent);
  made->form().addChoice(
      "stepTarget", tr_("Measurement"), [edited] { return optionsOf(measurementsOf(edited), tr_("The case expects none")); },
      {[edited] { return edited.task<MeasureTask>().measurement; },
       [edited](const std::string& name) {
         return edited.changeTask<MeasureTask>(tr_("Choose a measurement"), {}, [&](MeasureTask& task) { task.measurement = name; });
       }});
  made->form().addNumber("measureTolerance", tr_("Off by at most"),
                         {.lowest = 0.1, .highest = 1e5, .decimals = 1, .noneText = tr_("as the case says"), .step = 0.1},
                         tolerance<MeasureTask>(edited, "tolerance", &MeasureTask::tolerance));
  made->form().addRemark(tr_("In the unit of the measurement."));
  return made;
}

TaskForm* makePointForm(const StepEdit& edited, QWidget* parent) {
  auto* made = new TargetForm(edited, parent);
  addTarget<PointTask>(made->form(), edited, tr_("Point or structure"), tr_("The case has neither"),
                       {CaseTarget::Kind::point, CaseTarget::Kind::structure});
  return made;
}

TaskForm* makeFreeForm(const StepEdit& edited, QWidget* parent) { return new FreeForm(edited, parent); }

}  // namespace ew::lessons
