#include "panel/case_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QSpinBox>
#include <QStackedWidget>

#include "ew/imaging/effect_info.h"
#include "logic/edits.h"
#include "panel/fields.h"

namespace ew::case_authoring {
namespace {

using sdk::kGap_px;

constexpr int kAgeUnknown = -1;
constexpr const char* kPlacePath = "volume.file_to_world";

/// Like NumberField: scrolling the form past it must not change it.
class AgeField final : public sdk::WithHostUndo<QSpinBox> {
 public:
  using WithHostUndo::WithHostUndo;

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (hasFocus())
      QSpinBox::wheelEvent(event);
    else
      event->ignore();
  }
};
}  // namespace

CasePanel::CasePanel(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  setObjectName(QStringLiteral("casePanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget(this);
  pages_->addWidget(
      sdk::emptyState(tr("No case is open"), tr("Open a case from the start page, from the File menu, or by dropping its folder on the "
                                                "window. Then its patient, texts and volume can be edited here.")));
  pages_->addWidget(makeForm());
  column->addWidget(pages_, 1);
  ticket_ = host_.cases().onChanged([this] { showCase(); });
  showCase();
}

QWidget* CasePanel::makeForm() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* body = new QWidget;
  auto* form = new QFormLayout(body);
  form->setContentsMargins(2 * kGap_px, 2 * kGap_px, 2 * kGap_px, 2 * kGap_px);
  form->setSpacing(kGap_px);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);

  form->addRow(sdk::headingLabel(tr("Case")));
  addLine(form, "title", tr("Title"), tr("Change the title"));
  addLine(form, "title_for_trainees", tr("For trainees"), tr("Change the title for trainees"));
  addLine(form, "region", tr("Region"), tr("Change the region"));
  addDifficulty(form);
  addLines(form, "tags", tr("Tags"), tr("Change the tags"));
  form->addRow(sdk::headingLabel(tr("Patient")));
  addLine(form, "patient.name", tr("Name"), tr("Change the patient's name"));
  addSex(form);
  addAge(form);
  form->addRow(sdk::headingLabel(tr("Before the examination")));
  addText(form, "complaint", tr("Complaint"), tr("Change the complaint"));
  addText(form, "history", tr("History"), tr("Change the history"));
  addText(form, "indication", tr("Indication"), tr("Change the indication"));
  addExaminations(form);
  addLaboratory(form);
  form->addRow(sdk::headingLabel(tr("Findings")));
  addLines(form, "findings", tr("Findings"), tr("Change the findings"));
  addText(form, "diagnosis", tr("Diagnosis"), tr("Change the diagnosis"));
  addLines(form, "differential", tr("Differential"), tr("Change the differential diagnoses"));
  form->addRow(sdk::headingLabel(tr("Scan")));
  addStartPose(form);
  addProbes(form);
  addMannequin(form);
  form->addRow(sdk::headingLabel(tr("Scene")));
  addScene(form);
  form->addRow(sdk::headingLabel(tr("Volume in the body")));
  addPlace(form);
  form->addRow(sdk::headingLabel(tr("Recording")));
  addLine(form, "volume.attribution", tr("Attribution"), tr("Change the attribution"));
  addLine(form, "volume.licence", tr("Licence"), tr("Change the licence"));

  scroll->setWidget(body);
  column->addWidget(scroll, 1);
  column->addWidget(makeSaveRow());
  return page;
}

QWidget* CasePanel::makeSaveRow() {
  auto* row = new QWidget;
  auto* column = new QVBoxLayout(row);
  column->setContentsMargins(2 * kGap_px, kGap_px, 2 * kGap_px, 2 * kGap_px);
  column->setSpacing(kGap_px);
  problem_ = sdk::problemLabel();
  problem_->setObjectName(QStringLiteral("problem"));
  column->addWidget(problem_);
  checked_ = sdk::quietLabel({});
  checked_->setObjectName(QStringLiteral("checked"));
  checked_->hide();
  column->addWidget(checked_);
  where_ = sdk::quietLabel({});
  where_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(where_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGap_px);
  saved_ = new QLabel;
  saved_->setObjectName(QStringLiteral("savedMark"));
  buttons->addWidget(saved_, 1);
  auto* check = new QPushButton(tr("Check"));
  check->setObjectName(QStringLiteral("checkCase"));
  check->setToolTip(tr("Look for everything that is wrong with this case"));
  connect(check, &QPushButton::clicked, this, &CasePanel::checkCase);
  buttons->addWidget(check);
  auto* saveAs = new QPushButton(tr("Save as…"));
  saveAs->setObjectName(QStringLiteral("saveAs"));
  saveAs->setToolTip(tr("Copy the whole case into a new folder and go on there"));
  connect(saveAs, &QPushButton::clicked, this, [this] {
    const QString folder =
        QFileDialog::getSaveFileName(this, tr("New folder for the case"), sdk::words(host_.cases().currentFolder().string()) + tr("-copy"),
                                     tr("Case folders (*)"), nullptr, QFileDialog::ShowDirsOnly);
    if (!folder.isEmpty()) save(folder.toStdString());
  });
  buttons->addWidget(saveAs);
  auto* saveHere = new QPushButton(tr("Save"));
  saveHere->setObjectName(QStringLiteral("save"));
  saveHere->setProperty("primary", true);
  connect(saveHere, &QPushButton::clicked, this, [this] { save(); });
  buttons->addWidget(saveHere);
  column->addLayout(buttons);
  return row;
}

QLabel* CasePanel::addRow(QFormLayout* form, const QString& label, QWidget* editor, const std::string& path) {
  auto* cell = new QWidget;
  auto* column = new QVBoxLayout(cell);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap_px / 2);
  column->addWidget(editor);
  auto* problem = sdk::problemLabel();
  problem->setObjectName(nameOf(path) + QStringLiteral("_problem"));
  column->addWidget(problem);
  if (label.isEmpty()) {
    form->addRow(cell);
  } else {
    auto* name = sdk::quietLabel(label);
    name->setWordWrap(false);
    name->setMinimumWidth(9 * kGap_px);
    name->setBuddy(editor);
    form->addRow(name, cell);
  }
  editor->setAccessibleName(label);
  return problem;
}

void CasePanel::addLine(QFormLayout* form, const std::string& path, const QString& label, const QString& what) {
  auto* line = new sdk::WithHostUndo<QLineEdit>;
  line->setObjectName(nameOf(path));
  connect(line, &QLineEdit::textEdited, this, [this, path, what](const QString& text) {
    change(path, what, [&](nlohmann::json manifest) { return withText(std::move(manifest), path, text.toStdString()); });
  });
  fields_[path] = {[line, path](const nlohmann::json& manifest) {
                     const QString text = sdk::words(textOf(manifest, path));
                     if (line->text() != text) line->setText(text);
                   },
                   addRow(form, label, line, path)};
}

void CasePanel::addText(QFormLayout* form, const std::string& path, const QString& label, const QString& what) {
  auto* text = new QPlainTextEdit;
  text->setObjectName(nameOf(path));
  text->setTabChangesFocus(true);
  text->setMinimumHeight(8 * kGap_px);
  text->setMaximumHeight(14 * kGap_px);
  text->setUndoRedoEnabled(false);  // undo is the host's, for the whole case
  connect(text, &QPlainTextEdit::textChanged, this, [this, text, path, what] {
    change(path, what, [&](nlohmann::json manifest) { return withText(std::move(manifest), path, text->toPlainText().toStdString()); });
  });
  fields_[path] = {[text, path](const nlohmann::json& manifest) {
                     const QString next = sdk::words(textOf(manifest, path));
                     if (text->toPlainText() == next) return;
                     const QSignalBlocker quiet(text);
                     text->setPlainText(next);
                   },
                   addRow(form, label, text, path)};
}

void CasePanel::addSex(QFormLayout* form) {
  const std::string path = "patient.sex";
  auto* choice = new ChoiceField;
  choice->setObjectName(nameOf(path));
  choice->setFocusPolicy(Qt::StrongFocus);
  choice->addItem(tr("not stated"), QString());
  choice->addItem(tr("female"), QStringLiteral("female"));
  choice->addItem(tr("male"), QStringLiteral("male"));
  choice->addItem(tr("other"), QStringLiteral("other"));
  connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, choice, path] {
    change(path, tr("Change the patient's sex"),
           [&](nlohmann::json manifest) { return withText(std::move(manifest), path, choice->currentData().toString().toStdString()); });
  });
  fields_[path] = {[choice, path](const nlohmann::json& manifest) {
                     const QSignalBlocker quiet(choice);
                     choice->setCurrentIndex(std::max(0, choice->findData(sdk::words(textOf(manifest, path)))));
                   },
                   addRow(form, tr("Sex"), choice, path)};
}

void CasePanel::addAge(QFormLayout* form) {
  const std::string path = "patient.age_years";
  auto* age = new AgeField;
  age->setObjectName(nameOf(path));
  // Wider than the schema allows, so that a slip is explained instead of silently cut off.
  age->setRange(kAgeUnknown, 999);
  age->setSpecialValueText(tr("not stated"));
  age->setSuffix(tr(" years"));
  age->setFocusPolicy(Qt::StrongFocus);
  connect(age, QOverload<int>::of(&QSpinBox::valueChanged), this, [this, path](int years) {
    change(path, tr("Change the patient's age"), [&](nlohmann::json manifest) {
      return withField(std::move(manifest), path, years == kAgeUnknown ? std::nullopt : std::optional<nlohmann::json>(years));
    });
  });
  fields_[path] = {[age, path](const nlohmann::json& manifest) {
                     const auto value = fieldOf(manifest, path);
                     const QSignalBlocker quiet(age);
                     age->setValue(value.is_number_integer() ? value.get<int>() : kAgeUnknown);
                   },
                   addRow(form, tr("Age"), age, path)};
}

void CasePanel::addScene(QFormLayout* form) {
  form->addRow(sdk::quietLabel(tr("What a scan of this case has to show; nothing else is computed.")));
  const auto text = [](const char* source) { return QCoreApplication::translate(kEffectTexts, source); };
  for (const EffectInfo& effect : sceneEffects()) {
    const std::string path = std::string("scene.") + effect.key;
    const QString name = text(effect.name);
    auto* box = new QCheckBox(name);
    box->setObjectName(nameOf(path));
    box->setToolTip(text(effect.tip));
    connect(box, &QCheckBox::toggled, this, [this, path, name](bool on) {
      change(path, on ? tr("Switch on: %1").arg(name) : tr("Switch off: %1").arg(name),
             [&](nlohmann::json manifest) { return withEffect(std::move(manifest), path, on); });
    });
    fields_[path] = {[box, path](const nlohmann::json& manifest) {
                       const QSignalBlocker quiet(box);
                       box->setChecked(hasEffect(manifest, path));
                     },
                     addRow(form, {}, box, path)};
    box->setAccessibleName(name);
  }
}

void CasePanel::addPlace(QFormLayout* form) {
  auto* place = new sdk::PlacementFields<frame::World, frame::File>;
  place->setObjectName(QStringLiteral("placement"));
  place->onChanged = [this](const Transform<frame::World, frame::File>& fileToWorld, const std::string& axis) {
    change(
        kPlacePath, tr("Move the volume, %1").arg(sdk::words(axis)),
        [&](nlohmann::json manifest) { return withPlace(std::move(manifest), fileToWorld); }, axis);
  };
  fields_[kPlacePath] = {[place](const nlohmann::json& manifest) {
                           if (const auto fileToWorld = placeOf(manifest)) place->setTransform(*fileToWorld);
                         },
                         addRow(form, {}, place, kPlacePath)};
}

void CasePanel::change(const std::string& path, const QString& what, const std::function<nlohmann::json(nlohmann::json)>& edit,
                       const std::string& part) {
  auto manifest = host_.cases().current();
  if (!manifest) return;
  const nlohmann::json next = edit(*manifest);
  if (path != typedIn_) {
    typedIn_ = path;
    beforeTyping_ = fieldOf(*manifest, path);
  }
  sdk::setProblem(problem_, {});
  checked_->hide();
  sdk::setProblem(fields_[path].problem, {});
  if (next == *manifest) return;
  changing_ = true;
  const auto done = host_.cases().edit(next, what.toStdString(), path + part);
  if (!done && fieldOf(*manifest, path) != beforeTyping_) {
    // 9 and 99 are fit to be ages on the way to 999, which is not: what nobody meant must not stay in the case and be saved.
    const auto back = beforeTyping_.is_null() ? std::nullopt : std::optional<nlohmann::json>(beforeTyping_);
    [[maybe_unused]] const auto restored = host_.cases().edit(withField(*manifest, path, back), what.toStdString(), path);
  }
  changing_ = false;
  showSaved();
  showStartRemark();
  if (done) return;
  if (fieldOf(done.error()) == path)
    sdk::setProblem(fields_[path].problem, sdk::words(done.error().message));
  else
    say(done.error());
}

void CasePanel::save(const std::filesystem::path& folder) {
  for (auto& [path, field] : fields_) {
    if (field.problem->text().isEmpty()) continue;
    sdk::setProblem(problem_, tr("A marked field cannot be used as it is; correct it first, or undo."));
    return;
  }
  const auto saved = host_.cases().save(folder);
  sdk::setProblem(problem_, {});
  if (!saved) return say(saved.error());
  showCase();
}

void CasePanel::say(const Error& problem) {
  host_.log().warn(problem.sentence());
  sdk::setProblem(problem_, sdk::words(problem.message));
}

void CasePanel::showCase() {
  if (changing_) return;
  typedIn_.clear();
  const auto manifest = host_.cases().current();
  pages_->setCurrentIndex(manifest ? 1 : 0);
  sdk::setProblem(problem_, {});
  checked_->hide();
  if (!manifest) return;
  const auto problems = host_.cases().check(*manifest);
  for (auto& [path, field] : fields_) {
    field.show(*manifest);
    QString sentence;
    for (const auto& problem : problems)
      if (fieldOf(problem) == path) sentence = sdk::words(problem.message);
    sdk::setProblem(field.problem, sentence);
  }
  showSaved();
  showStartRemark();
}

void CasePanel::showSaved() {
  const bool unsaved = host_.cases().hasUnsavedChanges();
  saved_->setText(unsaved ? tr("● unsaved changes") : tr("saved"));
  saved_->setProperty("quiet", !unsaved);
  saved_->setToolTip(unsaved ? tr("The case has changes that are not in its folder yet") : tr("The folder holds the case as it is shown"));
  where_->setText(sdk::words(host_.cases().currentFolder().string()));
}

}  // namespace ew::case_authoring
