#include "panel/targets_panel.h"

#include <QApplication>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/targets.h"
#include "logic/tissues.h"
#include "panel/paint_work.h"
#include "panel/place_pages.h"
#include "panel/structure_page.h"

namespace ew::case_authoring {
namespace {

QPushButton* targetButton(const QString& text, const QString& tip, const char* name, QHBoxLayout* row) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  row->addWidget(button);
  return button;
}

}  // namespace

TargetsPanel::TargetsPanel(sdk::Host& host, QWidget* parent)
    : QWidget(parent), host_(host), work_(new PaintWork(host, this)), drawer_(host) {
  setObjectName(QStringLiteral("targetsPanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(makeUnkept());
  pages_ = new QStackedWidget;
  pages_->addWidget(emptyState(tr("No case is open"), tr("Open a case from the start page or the File menu. Then what a trainee is to "
                                                         "find in it can be pointed out here.")));
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  auto* body = new QWidget;
  auto* parts = new QVBoxLayout(body);
  parts->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  parts->setSpacing(kGrid_px);
  parts->addWidget(makeLeft());
  parts->addWidget(makeList());
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("targetsProblem"));
  parts->addWidget(problem_);
  parts->addWidget(makeEditor());
  parts->addStretch(1);
  scroll->setWidget(body);
  pages_->addWidget(scroll);
  column->addWidget(pages_);

  work_->onChanged = [this] { followWork(); };
  work_->onSaid = [this](const QString& sentence) { say(sentence); };
  changed_ = host_.cases().onChanged([this] { showCase(); });
  // What is scanned changes right after the case does.
  opened_ =
      host_.caseParts().onOpened([this](const std::filesystem::path&) { QTimer::singleShot(0, work_, [this] { work_->followCase(); }); });
  qApp->installEventFilter(this);
  showCase();
  work_->followCase();
}

TargetsPanel::~TargetsPanel() {
  work_->onChanged = {};
  work_->onSaid = {};
}

QWidget* TargetsPanel::makeLeft() {
  left_ = new QWidget;
  left_->setObjectName(QStringLiteral("paintLeft"));
  auto* column = new QVBoxLayout(left_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(quietLabel(tr("Something was painted in this case before, and not kept in it.")));
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  connect(targetButton(tr("Go on with it"), tr("Show what was painted; it is kept in the case when you say so"), "paintGoOn", row),
          &QPushButton::clicked, this, [this] { work_->goOnWithLeft(); });
  connect(targetButton(tr("Discard"), tr("Give up what was painted then"), "paintDiscardLeft", row), &QPushButton::clicked, this,
          [this] { work_->discardLeft(); });
  column->addLayout(row);
  return left_;
}

QWidget* TargetsPanel::makeUnkept() {
  unkept_ = new QWidget;
  unkept_->setObjectName(QStringLiteral("paintUnkept"));
  auto* column = new QVBoxLayout(unkept_);
  column->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 0);
  unkeptText_ = new QLabel;
  unkeptText_->setObjectName(QStringLiteral("paintUnkeptText"));
  unkeptText_->setTextFormat(Qt::PlainText);
  unkeptText_->setWordWrap(true);
  column->addWidget(unkeptText_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  connect(targetButton(tr("Try again"), tr("Keep it aside, for whoever opens that case again"), "paintKeepElsewhere", row),
          &QPushButton::clicked, this, [this] { work_->keepUnkept(); });
  connect(targetButton(tr("Discard"), tr("Give up what was painted there"), "paintDiscardElsewhere", row), &QPushButton::clicked, this,
          [this] { work_->discardElsewhere(); });
  column->addLayout(row);
  unkept_->hide();
  return unkept_;
}

QWidget* TargetsPanel::makeList() {
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  column->addWidget(headingLabel(tr("What is to be found")));
  empty_ = quietLabel(tr("Nothing yet. Put the probe where something is to be seen, then add a point, a plane or a structure."));
  empty_->setObjectName(QStringLiteral("targetsEmpty"));
  column->addWidget(empty_);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("targetsList"));
  list_->setAccessibleName(tr("Targets"));
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0) choose(static_cast<std::size_t>(row));
  });
  column->addWidget(list_);
  auto* adding = new QHBoxLayout;
  adding->setSpacing(kGrid_px);
  connect(targetButton(tr("+ Point"), tr("Add a point, in the middle of the image"), "addPoint", adding), &QPushButton::clicked, this,
          &TargetsPanel::addPoint);
  connect(targetButton(tr("+ Plane"), tr("Add the present image plane"), "addPlane", adding), &QPushButton::clicked, this,
          &TargetsPanel::addPlane);
  connect(targetButton(tr("+ Structure"), tr("Add a structure, which is painted or grown in the scan"), "addStructure", adding),
          &QPushButton::clicked, this, &TargetsPanel::addStructure);
  column->addLayout(adding);
  auto* order = new QHBoxLayout;
  order->setSpacing(kGrid_px);
  up_ = targetButton(tr("Up"), tr("Move the target up"), "targetUp", order);
  connect(up_, &QPushButton::clicked, this, [this] { move(-1); });
  down_ = targetButton(tr("Down"), tr("Move the target down"), "targetDown", order);
  connect(down_, &QPushButton::clicked, this, [this] { move(1); });
  remove_ = targetButton(tr("Remove"), tr("Remove the target"), "removeTarget", order);
  connect(remove_, &QPushButton::clicked, this, &TargetsPanel::remove);
  column->addLayout(order);
  return part;
}

QWidget* TargetsPanel::makeEditor() {
  editor_ = new QWidget;
  auto* column = new QVBoxLayout(editor_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  name_ = new WithHostUndo<QLineEdit>;
  name_->setObjectName(QStringLiteral("targetName"));
  name_->setAccessibleName(tr("Name of the target"));
  name_->setPlaceholderText(tr("Name"));
  connect(name_, &QLineEdit::textEdited, this, &TargetsPanel::rename);
  column->addWidget(name_);
  lessons_ = quietLabel({});
  lessons_->setObjectName(QStringLiteral("targetLessons"));
  column->addWidget(lessons_);
  reveals_ = new QCheckBox(tr("Its name gives the finding away"));
  reveals_->setObjectName(QStringLiteral("targetReveals"));
  reveals_->setToolTip(tr("A trainee sees it with the findings, not before"));
  connect(reveals_, &QCheckBox::toggled, this, [this](bool on) {
    change(tr("Change what gives the finding away"), "reveals", [on](Case edited, std::size_t n) {
      return withTarget(std::move(edited), n, [on](CaseTarget& target) { target.revealsFinding = on; });
    });
  });
  column->addWidget(reveals_);
  point_ = new PointPage(host_);
  plane_ = new PlanePage(host_);
  structure_ = new StructurePage(host_, *work_);
  const auto changing = [this](const auto& what, const auto& part, const auto& edit) { change(what, part, edit); };
  point_->change = plane_->change = structure_->change = changing;
  plane_->onSaid = [this](const QString& sentence) { say(sentence); };
  for (QWidget* page : std::initializer_list<QWidget*>{point_, plane_, structure_}) column->addWidget(page);
  return editor_;
}

void TargetsPanel::say(const QString& sentence) { setProblem(problem_, sentence); }

void TargetsPanel::change(const QString& what, const std::string& part, const std::function<Case(Case edited, std::size_t number)>& edit) {
  const auto now = host_.cases().current();
  if (!now || targetAt(*now, chosen_) == nullptr) return;
  const auto done = host_.cases().edit(edit(*now, chosen_), what.toStdString(), "targets " + std::to_string(chosen_) + " " + part);
  say(done ? QString() : words(done.error().message));
}

void TargetsPanel::add(const QString& what, const CaseTarget& target) {
  const auto now = host_.cases().current();
  if (!now) return;
  const auto done = host_.cases().edit(withTargetAdded(*now, target), what.toStdString(), {});
  say(done ? QString() : words(done.error().message));
  if (!done) return;
  choose(now->targets.size());
  name_->setFocus();
  name_->selectAll();
}

void TargetsPanel::addPoint() {
  const auto now = host_.cases().current();
  const auto image = host_.scan().state();
  if (!now || !image || !host_.cases().scan())
    return say(tr("The volume of this case is not what is scanned at the moment; choose View, Scan the case's volume."));
  const glm::dvec3 middle_mm = carried(planeInFile(*now, *image), {0.0, 0.5 * seenSize_mm(*image).y, 0.0});
  add(tr("Add a point"), pointTarget(freeTargetName(*now, tr("Point").toStdString()), middle_mm));
}

void TargetsPanel::addPlane() {
  const auto now = host_.cases().current();
  const auto image = host_.scan().state();
  if (!now || !image || !host_.cases().scan())
    return say(tr("The volume of this case is not what is scanned at the moment; choose View, Scan the case's volume."));
  add(tr("Add a plane"), planeTarget(freeTargetName(*now, tr("Plane").toStdString()), planeInFile(*now, *image)));
}

void TargetsPanel::addStructure() {
  const auto present = host_.cases().current();
  if (!present) return;
  if (hasPatient(*present)) {
    std::string organ;
    if (const auto image = host_.scan().state())
      for (const TissueAcoustics& tissue : image->scene.tissues)
        if (organ.empty() && tissue.label > 0) organ = tissue.name;
    if (organ.empty()) return say(tr("The patient's organs are known once the volume is scanned; choose View, Scan the case's volume."));
    return add(tr("Add a structure"), organTarget(freeTargetName(*present, tr("Structure").toStdString()), organ));
  }
  work_->withLabelFile([this](const std::string& file) {
    auto now = host_.cases().current();
    if (!now) return;
    const auto scanned = host_.scan().scanned();
    const Volume* labels = work_->painting() != nullptr ? &work_->painting()->labels() : scanned ? scanned->labels.get() : nullptr;
    const int label = freeLabel(*now, labels);
    if (label == 0) return say(tr("All 255 labels are taken; remove a structure first."));
    const std::size_t number = now->targets.size();
    now->targets.push_back(structureTarget(freeTargetName(*now, tr("Structure").toStdString()), label));
    now->volume.labels = file;
    const auto done = host_.cases().edit(*now, tr("Add a structure").toStdString(), {});
    say(done ? QString() : words(done.error().message));
    if (done) choose(number);
  });
}

void TargetsPanel::remove() {
  const auto present = host_.cases().current();
  const CaseTarget* chosen = present ? targetAt(*present, chosen_) : nullptr;
  if (chosen == nullptr) return;
  const int label = chosen->label.value_or(0);
  const auto edit = [this](const Case& edited) {
    const auto done = host_.cases().edit(edited, tr("Remove the target").toStdString(), {});
    say(done ? QString() : words(done.error().message));
  };
  const Case without = withoutTarget(*present, chosen_);
  if (label == 0 || isLabelled(without, label)) return edit(without);
  // Its voxels and its tissue go with it: what nobody can see or name any more must not throw a shadow.
  work_->withoutLabel(label, [this, target = *chosen, label, edit](const std::string& file) {
    const auto now = host_.cases().current();
    for (std::size_t n = 0; now && n < now->targets.size(); ++n) {
      if (!(now->targets[n] == target)) continue;
      Case edited = withTissue(withoutTarget(*now, n), label, {}, {});
      edited.volume.labels = file;
      return edit(edited);
    }
  });
}

void TargetsPanel::move(int by) {
  const auto now = host_.cases().current();
  const std::size_t to = chosen_ + static_cast<std::size_t>(by);  // below 0 it is past the end
  if (!now || to >= now->targets.size()) return;
  const std::size_t from = std::exchange(chosen_, to);
  const auto done = host_.cases().edit(withTargetMoved(*now, from, to), tr("Move the target").toStdString(), "targets order");
  if (!done) chosen_ = from;
  say(done ? QString() : words(done.error().message));
}

void TargetsPanel::rename(const QString& name) {
  // A field without words is on its way to have some.
  if (name.trimmed().isEmpty()) return say(tr("A target needs a name."));
  change(tr("Rename the target"), "name",
         [text = name.toStdString()](Case edited, std::size_t n) { return withTargetRenamed(std::move(edited), n, text); });
}

void TargetsPanel::choose(std::size_t number) {
  if (number != chosen_) {
    point_->rest();
    work_->take({});
    say({});
  }
  chosen_ = number;
  showChosen();
}

QString TargetsPanel::lineOf(const CaseTarget& target) const {
  const auto word = [&] {
    switch (target.kind) {
      case CaseTarget::Kind::point:
        return tr("point");
      case CaseTarget::Kind::plane:
        return tr("plane");
      case CaseTarget::Kind::structure:
        return tr("structure");
    }
    return QString();
  };
  return QStringLiteral("%1 · %2").arg(words(target.name), word());
}

void TargetsPanel::showCase() {
  const auto now = host_.cases().current();
  case_ = now.value_or(Case{});
  pages_->setCurrentIndex(now ? 1 : 0);
  const std::size_t count = case_.targets.size();
  chosen_ = count == 0 ? 0 : std::min(chosen_, count - 1);
  {
    const QSignalBlocker quiet(list_);
    while (list_->count() > static_cast<int>(count)) delete list_->takeItem(list_->count() - 1);
    for (std::size_t n = 0; n < count; ++n) {
      if (static_cast<int>(n) >= list_->count()) list_->addItem(QString());
      list_->item(static_cast<int>(n))->setText(lineOf(case_.targets[n]));
    }
  }
  list_->setVisible(count > 0);
  const int rows = std::clamp(static_cast<int>(count), 1, 6);
  list_->setFixedHeight(count == 0 ? 0 : rows * list_->sizeHintForRow(0) + 2 * list_->frameWidth() + kGrid_px);
  empty_->setVisible(count == 0);
  showChosen();
}

void TargetsPanel::showChosen() {
  const CaseTarget* target = targetAt(case_, chosen_);
  const std::size_t count = case_.targets.size();
  editor_->setVisible(target != nullptr);
  for (QPushButton* each : {up_, down_, remove_}) each->setVisible(count > 0);
  up_->setEnabled(count > 1 && chosen_ > 0);
  down_->setEnabled(count > 1 && chosen_ + 1 < count);
  remove_->setEnabled(count > 0);
  drawer_.setTargets(case_, chosen_);
  if (target == nullptr) return work_->setLabel(0);
  {
    const QSignalBlocker quietList(list_), quietReveals(reveals_);
    list_->setCurrentRow(static_cast<int>(chosen_));
    reveals_->setChecked(target->revealsFinding);
  }
  const QString name = words(target->name);
  if (name_->text() != name && !(name_->hasFocus() && name_->text().trimmed().isEmpty())) name_->setText(name);
  const std::size_t steps = stepsNaming(case_, target->name);
  lessons_->setText(tr("Steps of lessons that ask for it: %1. They follow when it is renamed.").arg(steps));
  lessons_->setVisible(steps > 0);
  using Kind = CaseTarget::Kind;
  point_->setVisible(target->kind == Kind::point);
  plane_->setVisible(target->kind == Kind::plane);
  structure_->setVisible(target->kind == Kind::structure);
  if (target->kind == Kind::point) point_->setTarget(*target);
  if (target->kind == Kind::plane) plane_->setTarget(case_, *target);
  if (target->kind == Kind::structure)
    structure_->setTarget(case_, *target);
  else
    work_->setLabel(0);
}

void TargetsPanel::followWork() {
  left_->setVisible(work_->hasLeft());
  const QString unkept = work_->unkeptElsewhere();
  unkept_->setVisible(!unkept.isEmpty());
  unkeptText_->setText(tr("What was painted in '%1' lies in this window alone.").arg(unkept));
  drawer_.setPainting(work_->painting());
  const CaseTarget* target = targetAt(case_, chosen_);
  if (target != nullptr && target->kind == CaseTarget::Kind::structure) structure_->followWork();
  if (const auto image = host_.scan().state()) drawer_.see(*image);
}

void TargetsPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  images_ = host_.scan().onEvent([this](const ScanEvent& told) {
    if (!std::holds_alternative<FrameMade>(told.what)) return;
    const auto image = host_.scan().state();
    if (!image) return;
    drawer_.see(*image);
    plane_->see(*image);
  });
  drawer_.setShown(true);
  showCase();
  followWork();
}

void TargetsPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  images_.reset();
  point_->rest();
  work_->take({});
  drawer_.setShown(false);
}

bool TargetsPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (!isKey || !isVisible() || work_->painting() == nullptr) return QWidget::eventFilter(watched, event);
  auto* key = static_cast<QKeyEvent*>(event);
  const bool isUndo = key->matches(QKeySequence::Undo) && !work_->undoText().isEmpty();
  const bool isRedo = key->matches(QKeySequence::Redo) && !work_->redoText().isEmpty();
  if (!isUndo && !isRedo) return QWidget::eventFilter(watched, event);
  key->accept();
  if (event->type() == QEvent::KeyPress) isUndo ? work_->undo() : work_->redo();
  return true;
}

}  // namespace ew::case_authoring
