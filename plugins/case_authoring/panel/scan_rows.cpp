// The rows of the case panel that say what was examined before, what is found, and how a scan begins.
#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <map>
#include <memory>

#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/case_panel.h"
#include "panel/fields.h"

namespace ew::case_authoring {

void CasePanel::addLines(QFormLayout* form, const std::string& path, const CaseTexts& texts, const QString& label, const QString& what) {
  auto* text = new QPlainTextEdit;
  text->setObjectName(nameOf(path));
  text->setPlaceholderText(tr("one a line"));
  text->setTabChangesFocus(true);
  text->setMinimumHeight(8 * kGrid_px);
  text->setMaximumHeight(14 * kGrid_px);
  text->setUndoRedoEnabled(false);  // undo is the host's, for the whole case
  connect(text, &QPlainTextEdit::textChanged, this, [this, text, path, what, texts] {
    change(path, what, [&](Case edited) { return texts.with(std::move(edited), textsIn(text->toPlainText().toStdString())); });
  });
  fields_[path] = {[text, texts](const Case& shown) {
                     // Lines without words are on their way to have some: only another list replaces what is being typed.
                     const auto next = texts.of(shown);
                     if (textsIn(text->toPlainText().toStdString()) == next) return;
                     const QSignalBlocker quiet(text);
                     text->setPlainText(words(linesOf(next)));
                   },
                   addRow(form, label, text, path)};
}

void CasePanel::addExaminations(QFormLayout* form) {
  const std::string path = "previous_examinations";
  auto* field = new ExaminationsField;
  field->onImagesAsked = [this, field](std::size_t number) { addImagesTo(*field, number); };
  field->onChanged = [this, path](const std::vector<CaseExamination>& list) {
    change(path, tr("Change the earlier examinations"), [&](Case edited) {
      edited.previousExaminations = list;
      return edited;
    });
  };
  fields_[path] = {[this, field](const Case& shown) {
                     field->setFolder(host_.cases().currentFolder());
                     field->setValue(shown.previousExaminations);
                   },
                   addRow(form, tr("Earlier"), field, path)};
}

void CasePanel::addLaboratory(QFormLayout* form) {
  const std::string path = "laboratory";
  auto* field = new ExaminationsField(ExaminationsField::Of::laboratory);
  field->onChanged = [this, path](const std::vector<CaseExamination>& list) {
    change(path, tr("Change the laboratory values"), [&](Case edited) {
      edited.laboratory.clear();
      for (const CaseExamination& each : list) edited.laboratory.push_back({each.when, each.findings, each.otherFields});
      return edited;
    });
  };
  fields_[path] = {[field](const Case& shown) {
                     std::vector<CaseExamination> list;
                     for (const CaseLaboratory& each : shown.laboratory)
                       list.push_back({each.when, {}, each.findings, {}, each.otherFields});
                     field->setValue(list);
                   },
                   addRow(form, tr("Laboratory"), field, path)};
}

void CasePanel::addDifficulty(QFormLayout* form) {
  const std::string path = "difficulty";
  auto* choice = new ChoiceField;
  choice->setObjectName(nameOf(path));
  choice->setFocusPolicy(Qt::StrongFocus);
  const std::array<QString, 6> names = {tr("not stated"),      tr("1, first steps"), tr("2, basic"),
                                        tr("3, intermediate"), tr("4, advanced"),    tr("5, examination")};
  for (std::size_t level = 0; level < names.size(); ++level) choice->addItem(names[level], static_cast<int>(level));
  connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, path](int level) {
    change(path, tr("Change the difficulty"), [level](Case edited) {
      edited.difficulty = level == 0 ? std::nullopt : std::optional(level);
      return edited;
    });
  });
  fields_[path] = {[choice](const Case& shown) {
                     const QSignalBlocker quiet(choice);
                     choice->setCurrentIndex(std::clamp(shown.difficulty.value_or(0), 0, 5));
                   },
                   addRow(form, tr("Difficulty"), choice, path)};
}

void CasePanel::addStartPose(QFormLayout* form) {
  const std::string path = "start_pose";
  auto* cell = new QWidget;
  auto* column = new QVBoxLayout(cell);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  auto* place = new QLabel;
  place->setObjectName(nameOf(path));
  place->setWordWrap(true);
  column->addWidget(place);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  auto* take = new QPushButton(tr("Use the present one"));
  take->setObjectName(QStringLiteral("takeStartPose"));
  take->setToolTip(tr("The probe begins where it is held now"));
  auto* leave = new QPushButton(tr("Remove"));
  leave->setObjectName(QStringLiteral("removeStartPose"));
  leave->setToolTip(tr("The probe begins on the skin before the volume"));
  buttons->addWidget(take);
  buttons->addWidget(leave);
  buttons->addStretch(1);
  column->addLayout(buttons);
  startRemark_ = problemLabel();
  startRemark_->setObjectName(QStringLiteral("startRemark"));
  column->addWidget(startRemark_);
  const auto set = [this, path](const QString& what, const std::optional<Transform<frame::World, frame::Probe>>& pose) {
    // Taken and removed again are two steps: who undoes the second wants the first back.
    change(
        path, what, [&](Case edited) { return withStartPose(std::move(edited), pose); }, pose ? " taken" : " removed");
    if (const auto now = host_.cases().current()) fields_[path].show(*now);
  };
  connect(take, &QPushButton::clicked, this, [this, set] {
    const auto scan = host_.cases().scan();
    if (!scan) {
      setProblem(problem_, tr("The volume of this case is not what is scanned at the moment; choose View, Scan the case's volume."));
      return;
    }
    set(tr("Set the start pose"), scan->probeToWorld);
  });
  connect(leave, &QPushButton::clicked, this, [set] { set(tr("Remove the start pose"), std::nullopt); });
  fields_[path] = {[place, leave](const Case& shown) {
                     const auto& pose = shown.startPose;
                     leave->setEnabled(pose.has_value());
                     if (!pose) return place->setText(tr("on the skin before the volume's middle"));
                     const auto mm = [](double value) { return QLocale().toString(value, 'f', 1); };
                     const glm::dvec4& at_mm = pose->probeToWorld.matrix[3];
                     place->setText(tr("x %1  y %2  z %3 mm").arg(mm(at_mm.x), mm(at_mm.y), mm(at_mm.z)));
                   },
                   addRow(form, tr("Start pose"), cell, path)};
}

void CasePanel::addProbes(QFormLayout* form) {
  const std::string path = "probes";
  auto* cell = new QWidget;
  auto* column = new QVBoxLayout(cell);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px / 2);
  auto* hint = quietLabel({});
  hint->setObjectName(QStringLiteral("probesHint"));
  column->addWidget(hint);
  // The program's own, and those of the case that it does not know: one that cannot be seen cannot be taken out.
  auto boxes = std::make_shared<std::map<std::string, QCheckBox*>>();
  const auto names = host_.cases().choices().probes;
  const auto box = [this, path, boxes, column](const std::string& id, const QString& name) {
    auto* made = new QCheckBox(name);
    made->setObjectName(QStringLiteral("probe_") + words(id));
    connect(made, &QCheckBox::toggled, this, [this, path, id, name](bool on) {
      change(path, on ? tr("Allow: %1").arg(name) : tr("Take out: %1").arg(name), [&](Case edited) {
        edited.probes = withListed(std::move(edited.probes), id, on);
        return edited;
      });
      if (const auto now = host_.cases().current()) fields_[path].show(*now);
    });
    column->addWidget(made);
    (*boxes)[id] = made;
  };
  for (const auto& [id, name] : names) box(id, nameOfProbe(name));
  fields_[path] = {[boxes, box, names, hint](const Case& shown) {
                     const auto& listed = shown.probes;
                     for (const std::string& id : listed)
                       if (boxes->count(id) == 0) box(id, tr("%1 (unknown)").arg(words(id)));
                     for (const auto& [id, one] : *boxes) {
                       const QSignalBlocker quiet(one);
                       one->setChecked(std::find(listed.begin(), listed.end(), id) != listed.end());
                     }
                     const auto first = std::find_if(names.begin(), names.end(),
                                                     [&](const auto& one) { return !listed.empty() && one.first == listed.front(); });
                     hint->setText(listed.empty()         ? tr("None is ticked: all may be used.")
                                   : first == names.end() ? QString()
                                                          : tr("At the start: %1").arg(nameOfProbe(first->second)));
                     hint->setVisible(!hint->text().isEmpty());
                   },
                   addRow(form, tr("Probes"), cell, path)};
}

void CasePanel::addMannequin(QFormLayout* form) {
  const std::string path = "mannequin";
  auto* choice = new ChoiceField;
  choice->setObjectName(nameOf(path));
  choice->setFocusPolicy(Qt::StrongFocus);
  choice->addItem(tr("the usual one"), QString());
  for (const auto& [file, name] : host_.cases().choices().mannequins) choice->addItem(words(name), words(file));
  connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, choice, path] {
    change(path, tr("Change the mannequin"), [file = choice->currentData().toString().toStdString()](Case edited) {
      edited.mannequin = file;
      return edited;
    });
  });
  fields_[path] = {[choice](const Case& shown) {
                     const QString file = words(shown.mannequin);
                     const QSignalBlocker quiet(choice);
                     if (choice->findData(file) < 0) choice->addItem(file, file);  // one of the case's own folder
                     choice->setCurrentIndex(choice->findData(file));
                   },
                   addRow(form, tr("Mannequin"), choice, path)};
  choice->setToolTip(tr("Another one is shown when the case is opened again"));
}

void CasePanel::showStartRemark() {
  const auto now = host_.cases().current();
  const auto scan = host_.cases().scan();
  const bool beside = scan && now && now->startPose && !seesVolume(*scan, now->startPose->probeToWorld);
  setProblem(startRemark_, beside ? tr("From here the probe does not see the volume; use another place, or move the volume.") : QString());
}

void CasePanel::checkCase() {
  const auto now = host_.cases().current();
  if (!now) return;
  QStringList found;
  for (const Error& problem : host_.cases().check(*now)) found << words(problem.message);
  const auto known = host_.cases().choices().probes;
  for (const std::string& id : now->probes)
    if (!known.empty() && found.filter(words(id)).isEmpty() &&
        std::none_of(known.begin(), known.end(), [&](const auto& one) { return one.first == id; }))
      found << tr("There is no probe '%1'; take it out.").arg(words(id));
  if (!startRemark_->text().isEmpty()) found << startRemark_->text();
  checked_->setText(tr("Nothing is wrong with this case."));
  checked_->setVisible(found.isEmpty());
  setProblem(problem_, found.join(QLatin1Char('\n')));
}

}  // namespace ew::case_authoring
