#include "panel/case_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/imaging/effect_info.h"
#include "ew/library/case_start.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/scroll_rows.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/fields.h"
#include "panel/section.h"

namespace ew::case_authoring {
namespace {

constexpr int kAgeUnknown = -1;
constexpr int kMissingAfter_ms = 300;  // of rest: what is typed is not looked through letter by letter

/// Whether somebody else has the folder of the case: such an error names who.
bool isHeldByOther(const Error& problem) {
  return std::any_of(problem.context.begin(), problem.context.end(), [](const auto& each) { return each.first == "user"; });
}

using AgeField = WheelWithFocus<WithHostUndo<QSpinBox>>;

}  // namespace

CasePanel::CasePanel(sdk::Host& host, std::function<void()> begin, QWidget* parent) : QWidget(parent), host_(host) {
  setObjectName(QStringLiteral("casePanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget(this);
  auto* newCase = new QPushButton(tr("New case…"));
  newCase->setObjectName(QStringLiteral("newCaseHere"));
  connect(newCase, &QPushButton::clicked, this, std::move(begin));
  pages_->addWidget(emptyState(tr("No case is open"),
                               tr("Open a case from the start page, from the File menu, or by dropping its folder on the window, or "
                                  "make a new one, of what is on screen as well. Then its patient, texts and volume can be edited here."),
                               newCase));
  pages_->widget(0)->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);  // its sentence must not make the form taller
  pages_->addWidget(makeForm());
  column->addWidget(pages_, 1);
  missingSoon_.setSingleShot(true);
  missingSoon_.setInterval(kMissingAfter_ms);
  connect(&missingSoon_, &QTimer::timeout, this, &CasePanel::showMissing);
  ticket_ = host_.cases().onChanged([this] { showCase(); });
  showCase();
}

QWidget* CasePanel::makeForm() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeTakenRow());
  column->addWidget(makeNoVolumeRow());
  auto* rows = new ScrollRows(2 * kGrid_px);
  rows->setObjectName(QStringLiteral("caseFormRows"));
  scroll_ = rows;
  sectionColumn_ = rows->rows();
  addCaseSection();
  addPatientSection();
  addBeforeSection();
  addFindingsSection();
  addMeasurements();
  addScanSection();
  addScene(&addSection(QStringLiteral("scene"), tr("Scene"))->form());
  addVolumeSection();
  sectionColumn_->addStretch(1);
  column->addWidget(scroll_, 1);
  column->addWidget(makeSaveRow());
  return page;
}

QWidget* CasePanel::makeTakenRow() {
  takenRow_ = new QWidget;
  takenRow_->setObjectName(QStringLiteral("takenRow"));
  auto* column = new QVBoxLayout(takenRow_);
  column->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 0);
  column->setSpacing(kGrid_px);
  takenWhy_ = problemLabel();
  takenWhy_->setObjectName(QStringLiteral("takenWhy"));
  takenWhy_->setMinimumWidth(30 * kGrid_px);  // else its height is reckoned for a word a line
  column->addWidget(takenWhy_);
  auto* copy = new QPushButton(tr("Open a copy…"));
  copy->setObjectName(QStringLiteral("openCopy"));
  copy->setToolTip(tr("Save the case as a case of your own, and go on there"));
  column->addWidget(copy, 0, Qt::AlignLeft);
  connect(copy, &QPushButton::clicked, this, [this] {
    const auto own = host_.cases().makeOwn();
    if (!own && own.error().code != ErrorCode::cancelled) say(own.error());
    if (own) takenRow_->hide();
  });
  takenRow_->hide();
  return takenRow_;
}

QWidget* CasePanel::makeNoVolumeRow() {
  noVolumeRow_ = new QWidget;
  noVolumeRow_->setObjectName(QStringLiteral("noVolumeRow"));
  auto* column = new QVBoxLayout(noVolumeRow_);
  column->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 0);
  column->setSpacing(kGrid_px);
  auto* sentence = new QLabel(tr("This case has no volume yet, so nothing can be scanned."));
  sentence->setWordWrap(true);
  sentence->setMinimumWidth(30 * kGrid_px);
  column->addWidget(sentence);
  auto* give = new QPushButton(tr("Give the case a volume…"));
  give->setObjectName(QStringLiteral("giveVolumeFirst"));
  setLook(give, Look::primary);
  connect(give, &QPushButton::clicked, this, &CasePanel::giveVolume);
  column->addWidget(give, 0, Qt::AlignLeft);
  noVolumeRow_->hide();
  return noVolumeRow_;
}

Section* CasePanel::addSection(const QString& id, const QString& title) {
  auto* section = new Section(id, title);
  sections_.push_back(section);
  sectionColumn_->addWidget(section);
  return section;
}

void CasePanel::addCaseSection() {
  QFormLayout* form = &addSection(QStringLiteral("case"), tr("Case"))->form();
  addLine(form, "title", fieldAt(&Case::title), tr("Title"), tr("Change the title"));
  addLine(form, "title_for_trainees", fieldAt(&Case::titleForTrainees), tr("For trainees"), tr("Change the title for trainees"));
  addLine(form, "region", fieldAt(&Case::region), tr("Region"), tr("Change the region"));
  addDifficulty(form);
  addLines(form, "tags", fieldAt(&Case::tags), tr("Tags"), tr("Change the tags"));
}

void CasePanel::addPatientSection() {
  QFormLayout* form = &addSection(QStringLiteral("patient"), tr("Patient"))->form();
  addName(form);
  addSex(form);
  addAge(form);
}

void CasePanel::addBeforeSection() {
  QFormLayout* form = &addSection(QStringLiteral("before"), tr("Before the examination"))->form();
  addText(form, "complaint", fieldAt(&Case::complaint), tr("Complaint"), tr("Change the complaint"));
  addText(form, "history", fieldAt(&Case::history), tr("History"), tr("Change the history"));
  addText(form, "indication", fieldAt(&Case::indication), tr("Indication"), tr("Change the indication"));
  addExaminations(form);
  addLaboratory(form);
}

void CasePanel::addFindingsSection() {
  QFormLayout* form = &addSection(QStringLiteral("findings"), tr("Findings"))->form();
  addLines(form, "findings", fieldAt(&Case::findings), tr("Findings"), tr("Change the findings"));
  addText(form, "diagnosis", fieldAt(&Case::diagnosis), tr("Diagnosis"), tr("Change the diagnosis"));
  addLines(form, "differential", fieldAt(&Case::differential), tr("Differential"), tr("Change the differential diagnoses"));
}

void CasePanel::addScanSection() {
  QFormLayout* form = &addSection(QStringLiteral("scan"), tr("Scan"))->form();
  addStartPose(form);
  addProbes(form);
  const auto choices = host_.cases().choices();
  addIds(form, "presets", tr("Presets"), tr("None is ticked: the console stays as it is."), tr("At the start: %1"), choices.presets,
         {presetsOf, withPresets});
  addIds(form, "body_marks", tr("Body marks"), tr("None is ticked: those of the region come first."), {}, choices.bodyMarks,
         {bodyMarksOf, withBodyMarks});
  addMannequin(form);
}

void CasePanel::addVolumeSection() {
  QFormLayout* form = &addSection(QStringLiteral("volume"), tr("Volume"))->form();
  addVolume(form);
  addLine(form, "volume.attribution", fieldAt(&RecordingRights::attribution), tr("Attribution"), tr("Change the attribution"));
  addLine(form, "volume.licence", fieldAt(&RecordingRights::licence), tr("Licence"), tr("Change the licence"));
  auto* files = new QPushButton(tr("Files…"));
  files->setObjectName(QStringLiteral("caseFiles"));
  files->setToolTip(tr("See what lies in the case's folder, and take out what nothing uses"));
  connect(files, &QPushButton::clicked, this, &CasePanel::showFiles);
  files->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  form->addRow(files);
}

QWidget* CasePanel::makeSaveRow() {
  auto* row = new QWidget;
  auto* column = new QVBoxLayout(row);
  column->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  column->setSpacing(kGrid_px);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("problem"));
  column->addWidget(problem_);
  checked_ = quietLabel({});
  checked_->setObjectName(QStringLiteral("checked"));
  checked_->hide();
  column->addWidget(checked_);
  where_ = quietLabel({});
  where_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(where_);
  saved_ = new QLabel;
  saved_->setObjectName(QStringLiteral("savedMark"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  auto* check = new QPushButton(tr("Check"));
  check->setObjectName(QStringLiteral("checkCase"));
  check->setToolTip(tr("Look for everything that is wrong with this case"));
  connect(check, &QPushButton::clicked, this, &CasePanel::checkCase);
  buttons->addWidget(check);
  auto* publishing = new QPushButton(tr("Publish…"));
  publishing->setObjectName(QStringLiteral("publishCase"));
  publishing->setToolTip(tr("See what is missing, then hand the case to trainees or to another workstation"));
  connect(publishing, &QPushButton::clicked, this, &CasePanel::publish);
  buttons->addWidget(publishing);
  buttons->addStretch(1);
  column->addLayout(buttons);
  buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  buttons->addWidget(saved_, 1);
  auto* saveAs = new QPushButton(tr("Save as…"));
  saveAs->setObjectName(QStringLiteral("saveAs"));
  saveAs->setToolTip(tr("Copy the whole case into a new folder and go on there"));
  connect(saveAs, &QPushButton::clicked, this, [this] { save(true); });
  buttons->addWidget(saveAs);
  auto* saveHere = new QPushButton(tr("Save"));
  saveHere->setObjectName(QStringLiteral("save"));
  setLook(saveHere, Look::primary);
  connect(saveHere, &QPushButton::clicked, this, [this] { save(); });
  buttons->addWidget(saveHere);
  column->addLayout(buttons);
  return row;
}

QLabel* CasePanel::addRow(QFormLayout* form, const QString& label, QWidget* editor, const std::string& path) {
  auto* cell = new QWidget;
  auto* column = new QVBoxLayout(cell);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px / 2);
  column->addWidget(editor);
  auto* problem = problemLabel();
  problem->setObjectName(nameOf(path) + QStringLiteral("_problem"));
  column->addWidget(problem);
  auto* warning = quietLabel({});
  warning->setObjectName(nameOf(path) + QStringLiteral("_warning"));
  warning->hide();
  column->addWidget(warning);
  rows_[path] = {qobject_cast<Section*>(form->parentWidget()->parentWidget()), editor, label, warning};
  if (label.isEmpty()) {
    form->addRow(cell);
  } else {
    auto* name = quietLabel(label);
    name->setWordWrap(false);
    name->setMinimumWidth(9 * kGrid_px);
    name->setBuddy(editor);
    form->addRow(name, cell);
  }
  editor->setAccessibleName(label);
  return problem;
}

void CasePanel::addLine(QFormLayout* form, const std::string& path, const CaseText& text, const QString& label, const QString& what,
                        QWidget* beside) {
  auto* line = new WithHostUndo<QLineEdit>;
  QWidget* editor = line;
  if (beside != nullptr) {
    editor = new QWidget;
    auto* both = new QHBoxLayout(editor);
    both->setContentsMargins(0, 0, 0, 0);
    both->setSpacing(kGrid_px);
    both->addWidget(line, 1);
    both->addWidget(beside);
    editor->setFocusProxy(line);
    line->setAccessibleName(label);
  }
  line->setObjectName(nameOf(path));
  connect(line, &QLineEdit::textEdited, this, [this, path, what, text](const QString& typed) {
    change(path, what, [&](Case edited) { return text.with(std::move(edited), typed.toStdString()); });
  });
  fields_[path] = {[line, text](const Case& shown) {
                     const QString next = words(text.of(shown));
                     if (line->text() != next) line->setText(next);
                   },
                   addRow(form, label, editor, path)};
}

void CasePanel::addText(QFormLayout* form, const std::string& path, const CaseText& text, const QString& label, const QString& what) {
  auto* field = new QPlainTextEdit;
  field->setObjectName(nameOf(path));
  field->setTabChangesFocus(true);
  field->setMinimumHeight(8 * kGrid_px);
  field->setMaximumHeight(14 * kGrid_px);
  field->setUndoRedoEnabled(false);  // undo is the host's, for the whole case
  connect(field, &QPlainTextEdit::textChanged, this, [this, field, path, what, text] {
    change(path, what, [&](Case edited) { return text.with(std::move(edited), field->toPlainText().toStdString()); });
  });
  fields_[path] = {[field, text](const Case& shown) {
                     const QString next = words(text.of(shown));
                     if (field->toPlainText() == next) return;
                     const QSignalBlocker quiet(field);
                     field->setPlainText(next);
                   },
                   addRow(form, label, field, path)};
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
    change(path, tr("Change the patient's sex"), [sex = choice->currentData().toString().toStdString()](Case edited) {
      edited.patient.sex = sex;
      return edited;
    });
  });
  fields_[path] = {[choice](const Case& shown) {
                     const QSignalBlocker quiet(choice);
                     choice->setCurrentIndex(std::max(0, choice->findData(words(shown.patient.sex))));
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
    change(path, tr("Change the patient's age"), [years](Case edited) {
      edited.patient.age_years = years == kAgeUnknown ? std::nullopt : std::optional(years);
      return edited;
    });
  });
  fields_[path] = {[age](const Case& shown) {
                     const QSignalBlocker quiet(age);
                     age->setValue(shown.patient.age_years.value_or(kAgeUnknown));
                   },
                   addRow(form, tr("Age"), age, path)};
}

void CasePanel::addScene(QFormLayout* form) {
  form->addRow(quietLabel(tr("What a scan of this case has to show; nothing else is computed.")));
  const auto text = [](const char* source) { return QCoreApplication::translate(kEffectTexts, source); };
  for (const EffectInfo& effect : sceneEffects()) {
    const std::string path = std::string("scene.") + effect.key;
    const QString name = text(effect.name);
    auto* box = new QCheckBox(name);
    box->setObjectName(nameOf(path));
    box->setToolTip(text(effect.tip));
    connect(box, &QCheckBox::toggled, this, [this, path, name, &effect](bool on) {
      change(path, on ? tr("Switch on: %1").arg(name) : tr("Switch off: %1").arg(name), [&](Case edited) {
        effect.switchTo(edited.scene, on);
        return edited;
      });
    });
    fields_[path] = {[box, &effect](const Case& shown) {
                       const QSignalBlocker quiet(box);
                       box->setChecked(effect.isOn(shown.scene));
                     },
                     addRow(form, {}, box, path)};
    box->setAccessibleName(name);
  }
}

void CasePanel::change(const std::string& path, const QString& what, const std::function<Case(Case)>& edit, const std::string& part) {
  const auto now = host_.cases().current();
  if (!now) return;
  const Case next = edit(*now);
  if (path != typedIn_) {
    typedIn_ = path;
    beforeTyping_ = *now;
  }
  setProblem(problem_, {});
  checked_->hide();
  setProblem(fields_[path].problem, {});
  if (next == *now) return;
  changing_ = true;
  const auto done = host_.cases().edit(next, what.toStdString(), path + part);
  // 9 and 99 are fit to be ages on the way to 999, which is not: what nobody meant must not stay in the case and be saved.
  if (!done && *now != beforeTyping_) static_cast<void>(host_.cases().edit(beforeTyping_, what.toStdString(), path));
  changing_ = false;
  showSaved();
  showStartRemark();
  showWarnings();
  missingSoon_.start();
  if (done) return;
  if (isHeldByOther(done.error())) {
    showCase();  // the fields are what the case is, not what could not be written
    takenRow_->show();
    return setProblem(takenWhy_, words(done.error()));
  }
  if (fieldOf(done.error()) == path)
    setProblem(fields_[path].problem, words(done.error().message));
  else
    say(done.error());
}

void CasePanel::save(bool elsewhere) {
  for (auto& [path, field] : fields_) {
    if (field.problem->text().isEmpty()) continue;
    setProblem(problem_, tr("A marked field cannot be used as it is; correct it first, or undo."));
    return;
  }
  const auto saved = elsewhere ? host_.cases().saveCopy() : host_.cases().save();
  setProblem(problem_, {});
  if (!saved) return say(saved.error());
  showCase();
}

void CasePanel::say(const Error& problem) {
  host_.log().warn(problem.sentence());
  setProblem(problem_, words(problem.message));
}

void CasePanel::showCase() {
  if (changing_) return;
  typedIn_.clear();
  const auto shown = host_.cases().current();
  pages_->setCurrentIndex(shown ? 1 : 0);
  setProblem(problem_, {});
  checked_->hide();
  if (host_.cases().currentFolder() != shownFolder_) takenRow_->hide();
  shownFolder_ = host_.cases().currentFolder();
  if (!shown) return;
  noVolumeRow_->setVisible(hasNoVolume(*shown));
  const auto problems = host_.cases().check(*shown);
  for (auto& [path, field] : fields_) {
    field.show(*shown);
    QString sentence;
    for (const auto& problem : problems)
      if (fieldOf(problem) == path) sentence = words(problem.message);
    setProblem(field.problem, sentence);
  }
  showSaved();
  showStartRemark();
  showWarnings();
  missingSoon_.start();
}

void CasePanel::showSaved() {
  const bool unsaved = host_.cases().hasUnsavedChanges();
  saved_->setText(unsaved ? tr("● unsaved changes") : tr("saved"));
  setLook(saved_, Look::quiet, !unsaved);
  saved_->setToolTip(unsaved ? tr("The case has changes that are not in its folder yet") : tr("The folder holds the case as it is shown"));
  where_->setText(words(host_.cases().currentFolder().string()));
}

}  // namespace ew::case_authoring
