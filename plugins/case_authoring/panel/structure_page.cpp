#include "panel/structure_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/sdk/scan.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/targets.h"
#include "logic/tissues.h"
#include "panel/fields.h"
#include "panel/paint_work.h"

namespace ew::case_authoring {
namespace {

QPushButton* structureButton(const QString& text, const QString& tip, const char* name) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  return button;
}

QVBoxLayout* structureColumn(QWidget* owner) {
  auto* column = new QVBoxLayout(owner);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  return column;
}

}  // namespace

StructurePage::StructurePage(sdk::Host& host, PaintWork& work, QWidget* parent) : QWidget(parent), host_(host), work_(work) {
  auto* column = structureColumn(this);
  organPart_ = new QWidget;
  auto* organs = structureColumn(organPart_);
  organs->addWidget(quietLabel(tr("An organ of the virtual patient:")));
  organ_ = new ChoiceField;
  organ_->setObjectName(QStringLiteral("structureOrgan"));
  organ_->setAccessibleName(tr("Organ"));
  organ_->setFocusPolicy(Qt::StrongFocus);
  organs->addWidget(organ_);
  connect(organ_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    const std::string organ = organ_->currentData().toString().toStdString();
    if (!organ.empty())
      change(tr("Choose the organ"), "organ", [organ](Case edited, std::size_t n) {
        return withTarget(std::move(edited), n, [&](CaseTarget& target) { target.organ = organ; });
      });
  });
  column->addWidget(organPart_);

  labelPart_ = new QWidget;
  auto* parts = structureColumn(labelPart_);
  label_ = quietLabel({});
  label_->setObjectName(QStringLiteral("structureLabel"));
  parts->addWidget(label_);
  parts->addWidget(makeTools());
  parts->addWidget(makeSettings());
  parts->addWidget(makeShaping());
  parts->addWidget(makeKeeping());
  column->addWidget(labelPart_);
}

QPushButton* StructurePage::addTool(PaintTool tool, const QString& text, const QString& tip, const char* name) {
  auto* button = new QPushButton;
  button->setText(text);
  button->setToolTip(tip);
  button->setObjectName(QLatin1String(name));
  button->setCheckable(true);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(button, &QPushButton::clicked, this, [this, tool](bool on) { takeTool(tool, on); });
  tools_[static_cast<std::size_t>(tool)] = button;
  return button;
}

QWidget* StructurePage::makeTools() {
  auto* row = new QWidget;
  auto* grid = new QGridLayout(row);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(kGrid_px);
  grid->addWidget(addTool(PaintTool::paint, tr("Paint"), tr("Paint the structure into the scan with the button held"), "toolPaint"), 0, 0);
  grid->addWidget(addTool(PaintTool::erase, tr("Erase"), tr("Take voxels out of the structure"), "toolErase"), 0, 1);
  grid->addWidget(addTool(PaintTool::trace, tr("Trace"),
                          tr("Draw around the structure in several image planes; what lies between is filled"), "toolTrace"),
                  1, 0);
  grid->addWidget(addTool(PaintTool::grow, tr("Grow"), tr("Click inside; the structure grows to where its echoes end"), "toolGrow"), 1, 1);
  return row;
}

QWidget* StructurePage::addSetting(QFormLayout* form, const QString& text, QWidget* field, const char* name) {
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(text);
  auto* label = quietLabel(text);
  label->setBuddy(field);
  form->addRow(label, field);
  return field;
}

QWidget* StructurePage::makeSettings() {
  auto* box = new QWidget;
  settingRows_ = new QFormLayout(box);
  settingRows_->setContentsMargins(0, 0, 0, 0);
  settingRows_->setSpacing(kGrid_px);
  const auto number = [this](double lowest, double highest, double value, const QString& unit) {
    auto* field = new NumberField(lowest, highest, 1, unit);
    field->setValue(value);
    connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] {
      if (work_.tool()) work_.take(settings());
    });
    return field;
  };
  radius_ = number(0.2, 50.0, 3.0, tr("mm"));
  addSetting(settingRows_, tr("Radius"), radius_, "paintRadius");
  shape_ = new ChoiceField;
  shape_->setFocusPolicy(Qt::StrongFocus);
  shape_->addItem(tr("a ball"));
  shape_->addItem(tr("flat, in the image plane"));
  addSetting(settingRows_, tr("Shape"), shape_, "paintShape");
  connect(shape_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    if (work_.tool()) work_.take(settings());
    showSettings();
  });
  thickness_ = number(0.2, 50.0, 2.0, tr("mm"));
  addSetting(settingRows_, tr("Thickness"), thickness_, "paintThickness");
  reach_ = number(2.0, 100.0, 40.0, tr("mm"));
  reach_->setToolTip(tr("How far from the click it may grow"));
  addSetting(settingRows_, tr("Reach"), reach_, "growReach");
  largest_ = number(0.1, 2000.0, 60.0, tr("ml"));
  largest_->setToolTip(tr("More than this is taken for a leak, and nothing is labelled"));
  addSetting(settingRows_, tr("Largest volume"), largest_, "growLargest");
  onlyUnlabelled_ = new QCheckBox(tr("Leave other structures as they are"));
  onlyUnlabelled_->setObjectName(QStringLiteral("paintOnlyUnlabelled"));
  onlyUnlabelled_->setChecked(true);
  settingRows_->addRow(onlyUnlabelled_);
  connect(onlyUnlabelled_, &QCheckBox::toggled, this, [this] {
    if (work_.tool()) work_.take(settings());
  });
  tissue_ = new ChoiceField;
  tissue_->setFocusPolicy(Qt::StrongFocus);
  tissue_->addItem(tr("not stated"), -1);
  for (std::size_t n = 0; n < namedTissues().size(); ++n)
    tissue_->addItem(QCoreApplication::translate(kTissueTexts, namedTissues()[n].name), static_cast<int>(n));
  tissue_->setToolTip(tr("What the structure consists of: stone, bone and gas throw shadows, fluid brightens what lies behind it"));
  addSetting(settingRows_, tr("Tissue"), tissue_, "structureTissue");
  connect(tissue_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    const int chosen = tissue_->currentData().toInt();
    if (chosen < -1) return;
    change(tr("Choose the tissue"), "tissue", [chosen](Case edited, std::size_t n) {
      const CaseTarget target = edited.targets[n];
      return withTissue(std::move(edited), target.label.value_or(0), target.name,
                        chosen < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(chosen)));
    });
  });
  return box;
}

QWidget* StructurePage::makeShaping() {
  auto* row = new QWidget;
  auto* column = structureColumn(row);
  between_ = structureButton({}, {}, "fillBetween");
  connect(between_, &QPushButton::clicked, this, [this] { work_.fillBetween(); });
  column->addWidget(between_);
  auto* pair = new QHBoxLayout;
  pair->setSpacing(kGrid_px);
  largestPiece_ = structureButton(tr("Largest piece"), tr("Keep the largest connected piece of the structure alone"), "largestPiece");
  connect(largestPiece_, &QPushButton::clicked, this, [this] { work_.keepLargest(); });
  smooth_ = structureButton(tr("Smooth"), tr("Round the structure off"), "smoothLabel");
  connect(smooth_, &QPushButton::clicked, this, [this] { work_.smooth(); });
  pair->addWidget(largestPiece_);
  pair->addWidget(smooth_);
  column->addLayout(pair);
  return row;
}

QWidget* StructurePage::makeKeeping() {
  auto* row = new QWidget;
  auto* column = structureColumn(row);
  auto* steps = new QHBoxLayout;
  steps->setSpacing(kGrid_px);
  undo_ = structureButton(tr("Undo"), {}, "paintUndo");
  connect(undo_, &QPushButton::clicked, this, [this] { work_.undo(); });
  redo_ = structureButton(tr("Redo"), {}, "paintRedo");
  connect(redo_, &QPushButton::clicked, this, [this] { work_.redo(); });
  steps->addWidget(undo_);
  steps->addWidget(redo_);
  column->addLayout(steps);
  state_ = quietLabel({});
  state_->setObjectName(QStringLiteral("paintState"));
  column->addWidget(state_);
  cancel_ = structureButton(tr("Cancel"), tr("Stop growing; nothing is labelled"), "growCancel");
  connect(cancel_, &QPushButton::clicked, this, [this] { work_.cancelGrowing(); });
  column->addWidget(cancel_);
  auto* decisions = new QHBoxLayout;
  decisions->setSpacing(kGrid_px);
  discard_ = structureButton(tr("Discard"), tr("Give up everything that was painted since it was kept last"), "paintDiscard");
  connect(discard_, &QPushButton::clicked, this, [this] { work_.discard(); });
  keep_ = structureButton(tr("Keep in the case"), tr("Put what was painted into the case, as one step that can be undone"), "paintKeep");
  setLook(keep_, Look::primary);
  connect(keep_, &QPushButton::clicked, this, [this] { work_.keep(); });
  decisions->addWidget(discard_);
  decisions->addWidget(keep_);
  column->addLayout(decisions);
  return row;
}

PaintSettings StructurePage::settings() const {
  PaintSettings settings;
  settings.tool = shownTool_;
  settings.radius_mm = radius_->value();
  settings.inPlane = shape_->currentIndex() == 1;
  settings.onlyUnlabelled = onlyUnlabelled_->isChecked();
  settings.thickness_mm = thickness_->value();
  settings.grow.reach_mm = reach_->value();
  settings.grow.largest_ml = largest_->value();
  return settings;
}

void StructurePage::takeTool(PaintTool tool, bool on) {
  shownTool_ = tool;
  work_.take(on ? std::optional(settings()) : std::nullopt);
  showSettings();
}

void StructurePage::setTarget(const Case& shown, const CaseTarget& target) {
  case_ = shown;
  target_ = target;
  const bool isOrgan = hasPatient(shown);
  organPart_->setVisible(isOrgan);
  labelPart_->setVisible(!isOrgan);
  work_.setLabel(isOrgan ? 0 : target.label.value_or(0));
  if (isOrgan) return showOrgans();
  showTissue();
  followWork();
}

void StructurePage::showOrgans() {
  const QSignalBlocker quiet(organ_);
  organ_->clear();
  if (const auto image = host_.scan().state())
    for (const TissueAcoustics& tissue : image->scene.tissues)
      if (tissue.label > 0 && organ_->findData(words(tissue.name)) < 0) organ_->addItem(words(tissue.name), words(tissue.name));
  organ_->model()->sort(0);
  const QString organ = words(target_.organ);
  if (organ_->findData(organ) < 0) organ_->insertItem(0, organ.isEmpty() ? tr("Choose an organ") : organ, organ);
  organ_->setCurrentIndex(organ_->findData(organ));
}

void StructurePage::showTissue() {
  const int label = target_.label.value_or(0);
  const QSignalBlocker quiet(tissue_);
  const int own = tissue_->findData(-2);
  if (own >= 0) tissue_->removeItem(own);
  const auto named = tissueOf(case_, label);
  if (!named && hasTissue(case_, label)) tissue_->addItem(tr("numbers of its own"), -2);
  tissue_->setCurrentIndex(tissue_->findData(named ? static_cast<int>(*named) : hasTissue(case_, label) ? -2 : -1));
}

void StructurePage::showSettings() {
  const auto show = [this](QWidget* field, bool shown) {
    field->setVisible(shown);
    if (QWidget* label = settingRows_->labelForField(field)) label->setVisible(shown);
  };
  const bool isBrush = shownTool_ == PaintTool::paint || shownTool_ == PaintTool::erase, isGrow = shownTool_ == PaintTool::grow;
  show(radius_, isBrush);
  show(shape_, isBrush);
  show(thickness_, shownTool_ == PaintTool::trace || (isBrush && shape_->currentIndex() == 1));
  show(reach_, isGrow);
  show(largest_, isGrow);
  onlyUnlabelled_->setVisible(shownTool_ != PaintTool::erase);
  between_->setVisible(shownTool_ == PaintTool::trace);
}

void StructurePage::followWork() {
  const auto tool = work_.tool();
  for (std::size_t n = 0; n < tools_.size(); ++n) {
    tools_[n]->setChecked(tool && static_cast<std::size_t>(*tool) == n);
    tools_[n]->setEnabled(!work_.isBusy());
  }
  if (tool) shownTool_ = *tool;
  showSettings();
  const int label = target_.label.value_or(0);
  const auto scanned = host_.scan().scanned();
  const Volume* labels = work_.painting() != nullptr ? &work_.painting()->labels() : scanned ? scanned->labels.get() : nullptr;
  const double ml = labels != nullptr && label > 0 ? labelling::volume_ml(*labels, static_cast<std::uint8_t>(label)) : 0.0;
  label_->setText(ml > 0.0 ? tr("Label %1, %2 ml").arg(label).arg(QLocale().toString(ml, 'f', ml < 10.0 ? 2 : 1))
                           : tr("Label %1, nothing is labelled yet: choose a tool and work in the scan.").arg(label));
  const std::size_t outlines = work_.painting() != nullptr ? work_.painting()->traced().size() : 0;
  between_->setText(outlines < 2 ? tr("Fill between outlines") : tr("Fill between %1 outlines").arg(outlines));
  between_->setToolTip(outlines < 2
                           ? tr("Draw around the structure in two image planes at least; then the shape between them can be filled")
                           : tr("Fill between the outlines that were traced in several image planes"));
  between_->setEnabled(outlines >= 2 && !work_.isBusy());
  largestPiece_->setEnabled(ml > 0.0 && !work_.isBusy());
  smooth_->setEnabled(ml > 0.0 && !work_.isBusy());
  undo_->setEnabled(!work_.undoText().isEmpty() && !work_.isBusy());
  undo_->setToolTip(work_.undoText().isEmpty() ? tr("No stroke to take back") : tr("Take back: %1 (Ctrl+Z)").arg(work_.undoText()));
  redo_->setEnabled(!work_.redoText().isEmpty() && !work_.isBusy());
  redo_->setToolTip(work_.redoText().isEmpty() ? tr("No stroke to bring back") : tr("Bring back: %1 (Ctrl+Shift+Z)").arg(work_.redoText()));
  keep_->setEnabled(work_.hasUnkept() && !work_.isBusy());
  discard_->setEnabled(work_.hasUnkept() && !work_.isBusy());
  cancel_->setVisible(work_.isGrowing());
  state_->setText(work_.isBusy()      ? tr("Working…")
                  : work_.hasUnkept() ? tr("● painted, not kept in the case yet")
                                      : tr("The case holds what is shown."));
  setLook(state_, Look::quiet, !work_.hasUnkept());
}

}  // namespace ew::case_authoring
