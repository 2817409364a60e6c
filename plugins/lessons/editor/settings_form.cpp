#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "editor/order_list.h"
#include "editor/task_form.h"
#include "ew/assessment/step_work.h"
#include "ew/sdk/scan.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::lessons {

namespace {

class SettingsForm final : public TaskForm {
 public:
  SettingsForm(const StepEdit& edited, QWidget* parent) : TaskForm(edited, parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid_px);
    auto* take = smallButton(tr("Take the present settings"), "takeSettings",
                             tr("The transducer and the settings of the console, each within what still gives a good image"));
    column->addWidget(take, 0, Qt::AlignLeft);
    column->addWidget(quietLabel(tr("Right transducers; none chosen: any")));
    probes_ = new QVBoxLayout;
    probes_->setSpacing(kGrid_px / 2);
    column->addLayout(probes_);
    addBands(*column);
    problem_ = problemLabel();
    problem_->setObjectName(QStringLiteral("settings_problem"));
    column->addWidget(problem_);
    connect(take, &QPushButton::clicked, this, &SettingsForm::takePresent);
  }

  void showTask(bool typed) override {
    if (typed) return;
    showProbes();
    const SettingsTask task = edited().task<SettingsTask>();
    for (auto& [setting, row] : bands_) {
      const auto band =
          std::find_if(task.bands.begin(), task.bands.end(), [&, name = setting](const auto& one) { return one.setting == name; });
      const bool isAsked = band != task.bands.end();
      const QSignalBlocker quiet1(row.asked), quiet2(row.lowest), quiet3(row.highest);
      row.asked->setChecked(isAsked);
      row.lowest->setEnabled(isAsked);
      row.highest->setEnabled(isAsked);
      if (!isAsked) continue;
      row.lowest->setValue(band->lowest);
      row.highest->setValue(band->highest);
    }
  }

 private:
  struct Band {
    QCheckBox* asked = nullptr;
    NumberField* lowest = nullptr;
    NumberField* highest = nullptr;
  };

  static QString tr(const char* text) { return QCoreApplication::translate("ew::lessons::SettingsForm", text); }
  static QString nameOf(std::string_view setting) {
    if (setting == "depth_mm") return tr("Depth");
    if (setting == "gain_db") return tr("Gain");
    if (setting == "dynamic_range_db") return tr("Dynamic range");
    return tr("Focus");
  }
  static QString unitOf(std::string_view setting) { return setting.ends_with("_mm") ? QStringLiteral("mm") : QStringLiteral("dB"); }

  void addBands(QVBoxLayout& column) {
    auto* grid = new QGridLayout;
    grid->setSpacing(kGrid_px);
    grid->addWidget(quietLabel(tr("Settings that are right")), 0, 0, 1, 2);
    int row = 1;
    for (const std::string_view setting : kLessonSettings) {
      Band band;
      const QString name = nameOf(setting);
      band.asked = new QCheckBox(name);
      band.asked->setObjectName(QStringLiteral("band_") + words(std::string(setting)));
      const auto field = [&](const QString& end, const QString& meaning) {
        auto* made = new NumberField(-200.0, 500.0, 0, unitOf(setting));
        made->setObjectName(band.asked->objectName() + end);
        made->setAccessibleName(QStringLiteral("%1, %2").arg(name, meaning));
        made->setToolTip(made->accessibleName());
        connect(made, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this, setting] { take(setting); });
        return made;
      };
      band.lowest = field(QStringLiteral("_lowest"), tr("lowest that is right"));
      band.highest = field(QStringLiteral("_highest"), tr("highest that is right"));
      grid->addWidget(band.asked, row, 0, 1, 2);
      grid->addWidget(band.lowest, row + 1, 0);
      grid->addWidget(band.highest, row + 1, 1);
      row += 2;
      bands_[setting] = band;
      connect(band.asked, &QCheckBox::toggled, this, [this, setting](bool on) { ask(setting, on); });
    }
    column.addLayout(grid);
  }

  void showProbes() {
    while (QLayoutItem* item = probes_->takeAt(0)) {
      item->widget()->deleteLater();
      delete item;
    }
    const SettingsTask task = edited().task<SettingsTask>();
    auto known = edited().document.host().cases().choices().probes;
    for (const std::string& id : task.probes)
      if (std::none_of(known.begin(), known.end(), [&](const auto& one) { return one.first == id; }))
        known.emplace_back(id, tr("%1 (not there any more)").arg(words(id)).toStdString());
    for (const auto& [id, name] : known) {
      auto* box = new QCheckBox(nameOfProbe(name));
      box->setObjectName(QStringLiteral("settingsProbe"));
      box->setChecked(std::find(task.probes.begin(), task.probes.end(), id) != task.probes.end());
      probes_->addWidget(box);
      connect(box, &QCheckBox::toggled, this, [this, id = id](bool on) {
        say(edited().changeTask<SettingsTask>(tr("Choose the right transducers"), {}, [&](SettingsTask& wanted) {
          std::erase(wanted.probes, id);
          if (on) wanted.probes.push_back(id);
        }));
      });
    }
  }

  void ask(std::string_view setting, bool on) {
    SettingBand band = bandAround(setting, setting == "gain_db" ? 0.0 : 60.0);
    if (const auto state = edited().document.host().scan().state())
      if (const auto value = settingOf(*state, std::string(setting))) band = bandAround(setting, *value);
    say(edited().changeTask<SettingsTask>(tr("Choose a setting"), {}, [&](SettingsTask& task) {
      std::erase_if(task.bands, [&](const SettingBand& one) { return one.setting == setting; });
      if (on) task.bands.push_back(band);
    }));
    showTask(false);
  }

  void take(std::string_view setting) {
    const Band& row = bands_[setting];
    say(edited().changeTask<SettingsTask>(tr("Change a range of settings"), "band " + std::string(setting), [&](SettingsTask& task) {
      for (SettingBand& band : task.bands)
        if (band.setting == setting) band = {std::string(setting), row.lowest->value(), row.highest->value()};
    }));
  }

  void takePresent() {
    const auto state = edited().document.host().scan().state();
    if (!state) return setProblem(problem_, tr("Nothing is scanned; open a case that has a volume first."));
    say(edited().changeTask<SettingsTask>(tr("Take the present settings"), {}, [&](SettingsTask& task) {
      task.probes = {state->probe.id};
      task.bands.clear();
      for (const std::string_view setting : kLessonSettings)
        if (const auto value = settingOf(*state, std::string(setting))) task.bands.push_back(bandAround(setting, *value));
    }));
    showTask(false);
  }

  void say(const Result<void>& done) { setProblem(problem_, done ? QString() : words(done.error())); }

  QVBoxLayout* probes_ = nullptr;
  std::map<std::string_view, Band> bands_;
  QLabel* problem_ = nullptr;
};

}  // namespace

TaskForm* makeSettingsForm(const StepEdit& edited, QWidget* parent) { return new SettingsForm(edited, parent); }

}  // namespace ew::lessons
