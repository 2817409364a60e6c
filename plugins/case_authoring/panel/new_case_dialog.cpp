#include "panel/new_case_dialog.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ew/library/folders.h"
#include "ew/sdk/window.h"
#include "ew/sdk/workspaces.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/fields.h"
#include "panel/rights_form.h"
#include "panel/source_field.h"

namespace ew::case_authoring {
namespace {

namespace fs = std::filesystem;

constexpr int kSteps = 3;
constexpr int kWidth_px = 640;
constexpr int kHeight_px = 560;  // of the tallest step: nothing jumps from one to the next

QString inLanguage(const Words& text) { return words(text.in(QLocale().name().toStdString())); }

/// "Liver, cyst" as a folder: "liver-cyst".
QString folderNameOf(const QString& title) {
  QString name = title.normalized(QString::NormalizationForm_KD).toLower();
  name.remove(QRegularExpression(QStringLiteral("\\p{M}")));
  name.replace(QRegularExpression(QStringLiteral("[^a-z0-9]+")), QStringLiteral("-"));
  name.remove(QRegularExpression(QStringLiteral("^-+|-+$")));
  return name.left(60);
}

QFormLayout* formOf(QWidget* page) {
  auto* form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(2 * kGrid_px);
  form->setVerticalSpacing(kGrid_px);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  return form;
}

/// Labels of one width, so that the fields of several forms of a page stand below each other.
void alignLabels(const std::vector<QFormLayout*>& forms) {
  int widest_px = 0;
  std::vector<QWidget*> labels;
  for (QFormLayout* form : forms)
    for (int row = 0; row < form->rowCount(); ++row)
      if (QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole); item != nullptr && item->widget() != nullptr)
        labels.push_back(item->widget());
  for (const QWidget* label : labels) widest_px = std::max(widest_px, label->sizeHint().width());
  for (QWidget* label : labels) label->setMinimumWidth(widest_px);
}

QString timeWords(double seconds) {
  if (seconds < 90.0) return NewCaseDialog::tr("about %1 s").arg(std::max(1, static_cast<int>(std::ceil(seconds))));
  return NewCaseDialog::tr("about %1 min").arg(static_cast<int>(std::ceil(seconds / 60.0)));
}

}  // namespace

NewCaseDialog::NewCaseDialog(sdk::Host& host, QWidget* parent) : QDialog(parent), host_(host) {
  setObjectName(QStringLiteral("newCaseDialog"));
  setWindowTitle(tr("New case"));
  TemplateList list = listTemplates();
  templates_ = std::move(list.templates);
  for (const Error& problem : list.problems) host_.log().warn(problem.sentence());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * kGrid_px, 3 * kGrid_px, 3 * kGrid_px, 3 * kGrid_px);
  column->setSpacing(2 * kGrid_px);
  stepName_ = headingLabel({});
  stepName_->setObjectName(QStringLiteral("newCaseStep"));
  column->addWidget(stepName_);
  steps_ = new QStackedWidget;
  steps_->addWidget(makeFrom());
  steps_->addWidget(makeAbout());
  steps_->addWidget(makeWhere());
  column->addWidget(steps_, 1);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("newCaseProblem"));
  column->addWidget(problem_);
  column->addWidget(makeButtons());
  setMinimumWidth(kWidth_px);
  resize(kWidth_px, kHeight_px);
  takeTemplate();
  goTo(from);
}

QWidget* NewCaseDialog::makeFrom() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  source_ = new SourceField(host_, true);
  column->addWidget(source_);
  column->addStretch(1);
  connect(source_, &SourceField::changed, this, &NewCaseDialog::look);
  return page;
}

QWidget* NewCaseDialog::makeAbout() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2 * kGrid_px);
  auto* fields = new QWidget;
  auto* form = formOf(fields);
  template_ = new ChoiceField;
  template_->setObjectName(QStringLiteral("newCaseTemplate"));
  template_->addItem(tr("none"), QString());
  for (const CaseTemplate& each : templates_) template_->addItem(inLanguage(each.title), words(each.id));
  form->addRow(tr("Template"), template_);
  templateText_ = quietLabel({});
  form->addRow(QString(), templateText_);
  title_ = new QLineEdit;
  title_->setObjectName(QStringLiteral("newCaseTitle"));
  title_->setMaxLength(200);
  title_->setPlaceholderText(tr("for authors; may name the finding"));
  form->addRow(tr("Title"), title_);
  titleForTrainees_ = new QLineEdit;
  titleForTrainees_->setObjectName(QStringLiteral("newCaseTraineeTitle"));
  titleForTrainees_->setMaxLength(200);
  titleForTrainees_->setPlaceholderText(tr("gives no finding away; can be written later"));
  form->addRow(tr("For trainees"), titleForTrainees_);
  region_ = new ChoiceField;
  region_->setObjectName(QStringLiteral("newCaseRegion"));
  region_->setEditable(true);
  region_->setInsertPolicy(QComboBox::NoInsert);
  for (const std::string& region : host_.cases().choices().regions) region_->addItem(words(region));
  region_->setCurrentText({});
  form->addRow(tr("Region"), region_);
  column->addWidget(fields);
  rights_ = new RightsForm;
  column->addWidget(rights_);
  alignLabels({form, rights_->form()});
  column->addStretch(1);
  connect(template_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &NewCaseDialog::takeTemplate);
  connect(title_, &QLineEdit::textChanged, this, [this](const QString& title) {
    if (!nameWasTyped_) name_->setText(folderNameOf(title));
    look();
  });
  return page;
}

QWidget* NewCaseDialog::makeWhere() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2 * kGrid_px);
  auto* fields = new QWidget;
  auto* form = formOf(fields);
  library_ = new QLineEdit(words(host_.cases().choices().ownCases.string()));
  library_->setObjectName(QStringLiteral("newCaseLibrary"));
  auto* choose = new QPushButton(tr("Choose…"));
  choose->setAutoDefault(false);
  auto* place = new QHBoxLayout;
  place->setSpacing(kGrid_px);
  place->addWidget(library_, 1);
  place->addWidget(choose);
  form->addRow(tr("Folder of your own cases"), place);
  name_ = new QLineEdit;
  name_->setObjectName(QStringLiteral("newCaseFolder"));
  form->addRow(tr("Name of the new folder"), name_);
  column->addWidget(fields);
  column->addWidget(headingLabel(tr("What will be made")));
  summary_ = quietLabel({});
  summary_->setObjectName(QStringLiteral("newCaseSummary"));
  column->addWidget(summary_);
  needs_ = new QLabel;
  needs_->setObjectName(QStringLiteral("newCasePlan"));
  needs_->setWordWrap(true);
  column->addWidget(needs_);
  column->addStretch(1);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of your own cases"), library_->text());
    if (!folder.isEmpty()) library_->setText(folder);
  });
  connect(name_, &QLineEdit::textEdited, this, [this] { nameWasTyped_ = true; });
  for (QLineEdit* field : {library_, name_}) connect(field, &QLineEdit::textChanged, this, &NewCaseDialog::look);
  return page;
}

QWidget* NewCaseDialog::makeButtons() {
  auto* row = new QWidget;
  auto* buttons = new QHBoxLayout(row);
  buttons->setContentsMargins(0, 0, 0, 0);
  buttons->setSpacing(kGrid_px);
  buttons->addStretch(1);
  auto* cancel = new QPushButton(tr("Cancel"));
  cancel->setAutoDefault(false);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  buttons->addWidget(cancel);
  back_ = new QPushButton(tr("Back"));
  back_->setObjectName(QStringLiteral("newCaseBack"));
  back_->setAutoDefault(false);
  connect(back_, &QPushButton::clicked, this, [this] { goTo(steps_->currentIndex() - 1); });
  buttons->addWidget(back_);
  next_ = new QPushButton;
  next_->setObjectName(QStringLiteral("newCaseNext"));
  setLook(next_, Look::primary);
  next_->setDefault(true);
  connect(next_, &QPushButton::clicked, this, [this] {
    if (steps_->currentIndex() == where)
      make();
    else
      goTo(steps_->currentIndex() + 1);
  });
  buttons->addWidget(next_);
  return row;
}

void NewCaseDialog::goTo(int step) {
  steps_->setCurrentIndex(step);
  const QString names[kSteps] = {tr("What the case is made from"), tr("What it is about"), tr("Where it is kept")};
  stepName_->setText(tr("%1 of %2: %3").arg(step + 1).arg(kSteps).arg(names[step]));
  back_->setEnabled(step != from);
  next_->setText(step == where ? tr("Make the case") : tr("Next"));
  rights_->setVisible(source_->kind() != SourceField::Kind::nothing);
  if (step == about) title_->setFocus();
  if (step == where) {
    name_->setFocus();
    plan();
  }
  look();
}

QString NewCaseDialog::problemOf(int step) const {
  if (step == from) return source_->openQuestion();  // what is wrong with a file is said beside it
  if (step == about) return title_->text().trimmed().isEmpty() ? tr("Give the case a title.") : QString();
  const QString name = name_->text().trimmed();
  if (library_->text().trimmed().isEmpty() || fs::path(library_->text().trimmed().toStdString()).is_relative())
    return tr("Choose the folder of your own cases.");
  if (name.isEmpty() || name.contains(QLatin1Char('/')) || name.startsWith(QLatin1Char('.')))
    return tr("Type a name for the new folder, without '/' and not beginning with '.'.");
  if (isTaken(folder())) return tr("'%1' is there already, and nothing in it is replaced; type another name.").arg(name);
  return {};
}

void NewCaseDialog::look() {
  if (next_ == nullptr) return;
  const int step = steps_->currentIndex();
  const QString problem = problemOf(step);
  next_->setEnabled(problem.isEmpty() && (step != where || planned_ == 0));
  next_->setToolTip(problem);
  // An empty field needs no red words: the page asks for it.
  const bool isJustEmpty = (step == from && source_->file().isEmpty()) || (step == about && title_->text().isEmpty());
  setProblem(problem_, isJustEmpty || step == from ? QString() : problem);
}

void NewCaseDialog::takeTemplate() {
  const std::string id = template_->currentData().toString().toStdString();
  const auto chosen = std::find_if(templates_.begin(), templates_.end(), [&](const CaseTemplate& each) { return each.id == id; });
  if (chosen == templates_.end()) {
    templateText_->setText(tr("An empty form."));
    return;
  }
  templateText_->setText(inLanguage(chosen->text));
  region_->setCurrentText(words(chosen->prefilled.region));
}

fs::path NewCaseDialog::folder() const {
  return fs::path(library_->text().trimmed().toStdString()) / name_->text().trimmed().toStdString();
}

NewCase NewCaseDialog::wanted() const {
  NewCase made;
  made.title = title_->text().trimmed().toStdString();
  made.titleForTrainees = titleForTrainees_->text().trimmed().toStdString();
  made.region = region_->currentText().trimmed().toStdString();
  made.templateId = template_->currentData().toString().toStdString();
  if (auto source = source_->source()) made.source = std::move(*source);
  if (source_->kind() != SourceField::Kind::nothing) {
    const RecordingRights rights = rights_->rights();
    made.attribution = rights.attribution;
    made.licence = rights.licence;
  }
  return made;
}

void NewCaseDialog::plan() {
  static int number = 0;
  const int mine = planned_ = ++number;
  summary_->setText(tr("The file is being looked at."));
  needs_->clear();
  auto found = std::make_shared<NewCasePlan>();
  host_.jobs().start(
      tr("Looking at what the case needs").toStdString(),
      [found, asked = wanted()](Progress& progress) -> Result<void> {
        auto planned = planCase(asked, progress);
        if (!planned) return passOn(planned.error());
        *found = std::move(*planned);
        return {};
      },
      [this, alive = QPointer<NewCaseDialog>(this), found, mine](const Result<void>& outcome) {
        if (!alive || planned_ != mine) return;
        planned_ = 0;
        look();
        if (outcome) return showPlan(*found);
        summary_->clear();
        next_->setEnabled(false);
        setProblem(problem_, words(outcome.error()));
      });
}

void NewCaseDialog::showPlan(const NewCasePlan& found) {
  const QLocale locale;
  if (source_->kind() == SourceField::Kind::nothing) {
    summary_->setText(tr("A case without a volume. It opens, and says how to give it one."));
    needs_->clear();
    return;
  }
  const bool isKnown = found.grid.voxelCount() > 0;
  const glm::ivec3 dims = found.grid.dims;
  const glm::dvec3 spacing_mm = found.grid.spacing_mm;
  QStringList lines;
  lines << (isKnown ? tr("A volume of %1 × %2 × %3 voxels, %4 × %5 × %6 mm each.")
                          .arg(dims.x)
                          .arg(dims.y)
                          .arg(dims.z)
                          .arg(locale.toString(spacing_mm.x, 'g', 3), locale.toString(spacing_mm.y, 'g', 3),
                               locale.toString(spacing_mm.z, 'g', 3))
                    : tr("A volume that is stitched first; its size shows then."));
  for (const Message& note : found.notes) lines << words(note);
  summary_->setText(lines.join(QLatin1Char('\n')));
  needs_->setText(
      tr("Memory: %1\nDisk: at most %2\nTime: %3").arg(sizeWords(found.bytes), sizeWords(found.disk_bytes), timeWords(found.seconds)));
}

void NewCaseDialog::make() {
  auto made = std::make_shared<CaseCreation>();
  const fs::path target = folder();
  const NewCase asked = wanted();
  hide();
  host_.jobs().start(
      tr("Making the case %1").arg(name_->text().trimmed()).toStdString(),
      [made, target, asked](Progress& progress) -> Result<void> {
        auto done = makeCase(asked, target, progress);
        if (!done) return passOn(done.error());
        *made = std::move(*done);
        return {};
      },
      [this, alive = QPointer<NewCaseDialog>(this), &host = host_, made, target, source = asked.source](const Result<void>& outcome) {
        if (outcome) {
          if (const auto* shown = std::get_if<VolumeAtHand>(&source)) host.volumes().wasKept(shown->volume);
          for (const Message& note : made->notes) host.window().info(words(note).toStdString());
          host.workspaces().show("author");
          if (const auto opened = host.cases().open(target); !opened) host.window().error(words(opened.error()).toStdString());
          if (alive) deleteLater();
          return;
        }
        if (!alive) return;
        open();
        look();
        if (outcome.error().code != ErrorCode::cancelled) setProblem(problem_, words(outcome.error()));
      });
}

}  // namespace ew::case_authoring
