#include "panel/stitch_panel.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/core/memory.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/question.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/charts.h"
#include "panel/folders.h"
#include "panel/marks.h"
#include "panel/stitch_session.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;

class LegendMark final : public QWidget {
 public:
  explicit LegendMark(StitchResults::Mark mark) : mark_(mark) { setFixedSize(40, 14); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPen pen(colourOfMark(mark_, palette()), 2.0);
    if (mark_ == StitchResults::Mark::byHand) pen.setDashPattern({8.0, 3.0});
    if (mark_ == StitchResults::Mark::cannotTell) pen.setDashPattern({4.0, 3.0});
    if (mark_ == StitchResults::Mark::notAligned) pen.setDashPattern({1.5, 2.0});
    painter.setPen(pen);
    painter.drawLine(QPointF(0, 7.5), QPointF(20, 7.5));
    drawMark(painter, QRectF(25, 1, 13, 13), mark_, palette());
  }

 private:
  StitchResults::Mark mark_;
};

}  // namespace

StitchPanel::StitchPanel(StitchSession& session, QWidget* parent)
    : QWidget(parent),
      document_(session.document()),
      inputs_(session.inputs()),
      results_(session.results()),
      mosaic_(session.mosaic()),
      look_(session.look()),
      runs_(session.runs()) {
  setObjectName(QStringLiteral("stitchPanel"));
  setAcceptDrops(true);
  setMinimumWidth(280);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* room = new PlainHeight;
  outer->addWidget(room);
  auto* column = new QVBoxLayout(room);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  offer_ = makeOffer();
  column->addWidget(offer_);
  pages_ = new QStackedWidget(this);
  auto* add = new QPushButton(tr("Add volumes…"));
  addFirst_ = add;
  add->setObjectName(QStringLiteral("addFirst"));
  connect(add, &QPushButton::clicked, this, &StitchPanel::askForFiles);
  pages_->addWidget(emptyState(
      tr("Stitch volumes"),
      tr("Add two or more volumes or sweeps that overlap, or drop their files or a stitch project here. No tracker is needed."), add));
  pages_->addWidget(makeWorkPage(session));
  column->addWidget(pages_, 1);
  problem_ = problemLabel(this);
  problem_->setObjectName(QStringLiteral("problem"));
  problem_->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, kGrid_px);
  column->addWidget(problem_);
  connect(&session, &StitchSession::changed, this, &StitchPanel::refresh);
  connect(&session.notices(), &Notices::problem, this, &StitchPanel::showProblem);
  connect(&session.notices(), &Notices::said, this, [this](const QString& sentence) {
    outcome_->say(sentence);
    outcome_->setVisible(!sentence.isEmpty());
  });
  caseTicket_ = session.host().cases().onChanged([this] { refresh(); });
  connect(&session.look(), &StitchLook::nextPairAsked, graph_, &PairGraph::chooseNext);
  refresh();
}

QWidget* StitchPanel::makeOffer() {
  auto* box = new QWidget;
  box->setObjectName(QStringLiteral("recoveryOffer"));
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, kGrid_px);
  offerWord_ = new QLabel;
  offerWord_->setWordWrap(true);
  column->addWidget(offerWord_);
  auto* row = new QHBoxLayout;
  auto* reopen = new QPushButton(tr("Reopen"));
  reopen->setObjectName(QStringLiteral("reopenLeft"));
  setLook(reopen, Look::primary);
  connect(reopen, &QPushButton::clicked, &document_, &ProjectDocument::reopenLeft);
  auto* discard = new QPushButton(tr("Discard"));
  discard->setObjectName(QStringLiteral("discardLeft"));
  connect(discard, &QPushButton::clicked, &document_, &ProjectDocument::discardLeft);
  row->addWidget(reopen);
  row->addWidget(discard);
  row->addStretch(1);
  column->addLayout(row);
  return box;
}

QWidget* StitchPanel::makeWorkPage(StitchSession& session) {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, kGrid_px);
  column->setSpacing(kGrid_px);

  const auto flat = [this](const QString& text, const QString& hint, const char* name) {
    auto* button = new QPushButton(text);
    setLook(button, Look::flat);
    button->setToolTip(hint);
    button->setObjectName(QLatin1String(name));
    return button;
  };
  auto* top = new QHBoxLayout;
  top->setSpacing(0);
  top->addWidget(headingLabel(tr("Subvolumes")), 1);
  auto* whole = flat(tr("project"), tr("Begin, open or save a stitch project"), "projectMenu");
  auto* menu = new QMenu(whole);
  const auto entry = [&](const QString& text, const char* name, auto&& act) {
    QAction* action = menu->addAction(text);
    action->setObjectName(QLatin1String(name));
    connect(action, &QAction::triggered, this, act);
    return action;
  };
  entry(tr("New"), "newProject", [this] {
    if (mayLeaveProject()) document_.startAnew();
  });
  entry(tr("Open…"), "openProject", [this] { askForProject(); });
  saveProject_ = entry(tr("Save"), "saveProject", [this] { document_.save(false); });
  saveProject_->setToolTip(tr("Save the stitch project; the command line runs it identically (Ctrl+S)"));
  menu->setToolTipsVisible(true);
  entry(tr("Save as…"), "saveProjectElsewhere", [this] { document_.save(true); });
  whole->setMenu(menu);
  top->addWidget(whole);
  auto* add = flat(tr("+ add"), tr("Add volumes or sweeps"), "addMore");
  connect(add, &QPushButton::clicked, this, &StitchPanel::askForFiles);
  top->addWidget(add);
  column->addLayout(top);

  list_ = new VolumeList(session);
  connect(list_, &VolumeList::problem, this, &StitchPanel::showProblem);
  column->addWidget(list_, 3);

  pairsBox_ = new QWidget;
  auto* pairs = new QVBoxLayout(pairsBox_);
  pairs->setContentsMargins(0, 0, 0, 0);
  pairs->setSpacing(kGrid_px / 2);
  auto* pairsTop = new QHBoxLayout;
  pairsTop->addWidget(headingLabel(tr("Pairs")));
  pairWord_ = quietLabel({});
  pairWord_->setObjectName(QStringLiteral("pairWord"));
  pairWord_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  pairsTop->addWidget(pairWord_, 1);
  pairs->addLayout(pairsTop);
  graph_ = new PairGraph(session);
  graph_->setMaximumHeight(280);
  pairs->addWidget(graph_, 1);
  pairs->addWidget(makeLegend());
  pairsBox_->setMaximumHeight(360);  // on a tall screen the room is left below, not between
  column->addWidget(pairsBox_, 4);
  column->addWidget(makeSteps());
  column->addWidget(makeResultBox());
  column->addStretch(1);
  return page;
}

QWidget* StitchPanel::makeLegend() {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGrid_px);
  grid->setVerticalSpacing(2);
  int n = 0;
  using Mark = StitchResults::Mark;
  for (const auto mark : {Mark::aligned, Mark::cannotTell, Mark::landmarks, Mark::notAligned, Mark::byHand, Mark::rejected}) {
    auto* word = quietLabel(mark == Mark::byHand ? tr("manual") : wordsOfMark(mark));  // that it was not checked is said at the pair
    setLook(word, Look::small);
    word->setWordWrap(false);
    grid->addWidget(new LegendMark(mark), n / 2, 2 * (n % 2));
    grid->addWidget(word, n / 2, 2 * (n % 2) + 1);
    ++n;
  }
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  return box;
}

QWidget* StitchPanel::makeSteps() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  const auto step = [&](const QString& text, const QString& hint, const char* name) {
    auto* button = new QPushButton(text);
    button->setToolTip(hint);
    button->setObjectName(QLatin1String(name));
    return button;
  };
  match_ = step(tr("Match all without tracker"), tr("Find how all subvolumes lie to each other, whatever is recorded about their places"),
                "matchAll");
  connect(match_, &QPushButton::clicked, this, [this] { runs_.matchAll(true); });
  column->addWidget(match_);
  refine_ = step(tr("Refine the poses"), tr("Start from the poses as they are recorded or set manually, and let the images refine them"),
                 "refine");
  connect(refine_, &QPushButton::clicked, this, [this] { runs_.matchAll(false); });
  column->addWidget(refine_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  elastic_ = step(tr("Elastic"), tr("Deform the subvolumes so that they fit where they overlap"), "elastic");
  connect(elastic_, &QPushButton::clicked, this, [this] {
    if (!document_.project().settings.elastic) {
      StitchProject next = document_.project();
      next.settings.elastic = true;
      document_.edit(std::move(next), tr("elastic step on"));
    }
    runs_.run(Step::elastic, tr("Elastic"));
  });
  seams_ = step(tr("Compute mosaic"), tr("Choose for every place the view that saw it best, and make one volume"), "seams");
  connect(seams_, &QPushButton::clicked, this, [this] { runs_.run(Step::volume, tr("Compute mosaic")); });
  row->addWidget(elastic_, 2);
  row->addWidget(seams_, 3);
  column->addLayout(row);
  return box;
}

QWidget* StitchPanel::makeResultBox() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px / 2);
  resultBox_ = new QWidget;
  auto* row = new QHBoxLayout(resultBox_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGrid_px / 2);
  const auto button = [&](const QString& text, const QString& hint, const char* name) {
    auto* made = new QPushButton(text);
    setLook(made, Look::compact);
    made->setToolTip(hint);
    made->setObjectName(QLatin1String(name));
    row->addWidget(made, 1);
    return made;
  };
  handOver_ = button(tr("Add to case"), tr("The open case takes over the stitched volume"), "handToCase");
  connect(handOver_, &QPushButton::clicked, &mosaic_, &Mosaic::handToCase);
  saveVolume_ = button(tr("Save volume…"), tr("Save volume, coverage, source and provenance in a folder"), "saveResult");
  connect(saveVolume_, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the stitched volume"), lastFolder());
    if (!folder.isEmpty()) mosaic_.saveIn(folder.toStdString());
  });
  column->addWidget(resultBox_);
  old_ = new Paragraph(tr("Older than the last edit."));
  old_->setToolTip(tr("'Compute mosaic' renews the stitched volume"));
  old_->setObjectName(QStringLiteral("resultIsOld"));
  setLook(old_, Look::small);
  column->addWidget(old_);
  outcome_ = new Paragraph;
  outcome_->setObjectName(QStringLiteral("outcome"));
  outcome_->hide();
  column->addWidget(outcome_);
  auto* more = new QPushButton(tr("Options"));
  more->setObjectName(QStringLiteral("moreOptions"));
  setLook(more, Look::flat);
  more->setCheckable(false);
  forecast_ = new Paragraph;
  forecast_->setObjectName(QStringLiteral("forecast"));
  setLook(forecast_, Look::small);
  moreRow_ = new QWidget;
  auto* moreRow = new QHBoxLayout(moreRow_);
  moreRow->setContentsMargins(0, 0, 0, 0);
  moreRow->addWidget(forecast_, 1);
  moreRow->addWidget(more);
  column->addWidget(moreRow_);
  options_ = makeOptions();
  options_->hide();
  column->addWidget(options_);
  connect(more, &QPushButton::clicked, this, [this, more] {
    options_->setVisible(!options_->isVisible());
    more->setText(options_->isVisible() ? tr("Fewer options") : tr("Options"));
  });
  return box;
}

QWidget* StitchPanel::makeOptions() {
  auto* box = new QWidget;
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  form->setSpacing(kGrid_px);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  spacing_ = new NumberField(0.0, 20.0, 2, tr("mm"));
  spacing_->setObjectName(QStringLiteral("spacing"));
  spacing_->setSpecialValueText(tr("finest"));
  spacing_->setSingleStep(0.1);
  fallOff_ = new NumberField(0.0, 200.0, 0, tr("mm"));
  fallOff_->setObjectName(QStringLiteral("fallOff"));
  fallOff_->setToolTip(tr("The deformation has faded out this far outside the overlap"));
  seamMethod_ = new QComboBox;
  seamMethod_->addItem(tr("cut"), static_cast<int>(SeamMethod::graphCut));
  seamMethod_->addItem(tr("deepest view"), static_cast<int>(SeamMethod::nearest));
  seamMethod_->addItem(tr("mean"), static_cast<int>(SeamMethod::feather));
  seamMethod_->setToolTip(
      tr("Cut along the surface where the views differ least; or each place from the view in whose inside it lies deepest; or "
         "a mean, which smooths speckle"));
  axes_ = new QComboBox;
  axes_->addItem(tr("first volume"), static_cast<int>(GridAxes::first));
  axes_->addItem(tr("body"), static_cast<int>(GridAxes::world));
  form->addRow(tr("Spacing"), spacing_);
  form->addRow(tr("Seam"), seamMethod_);
  form->addRow(tr("Fall-off"), fallOff_);
  form->addRow(tr("Axes"), axes_);
  for (QComboBox* each : {seamMethod_, axes_}) each->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  const auto change = [this](const QString& what, const std::string& key, auto&& set) {
    if (showing_) return;
    StitchProject next = document_.project();
    set(next.settings);
    document_.edit(std::move(next), what, key);
  };
  connect(spacing_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [change](double value) {
    change(tr("voxel spacing"), "spacing", [value](ProjectSettings& settings) { settings.join.grid.spacing_mm = value; });
  });
  connect(fallOff_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [change](double value) {
    change(tr("fall-off of the deformation"), "falloff", [value](ProjectSettings& settings) { settings.fallOff_mm = value; });
  });
  connect(seamMethod_, qOverload<int>(&QComboBox::activated), this, [this, change] {
    change(tr("seam by %1").arg(seamMethod_->currentText()), {},
           [this](ProjectSettings& settings) { settings.join.seam.method = static_cast<SeamMethod>(seamMethod_->currentData().toInt()); });
  });
  connect(axes_, qOverload<int>(&QComboBox::activated), this, [this, change] {
    change(tr("axes of the %1").arg(axes_->currentText()), {},
           [this](ProjectSettings& settings) { settings.join.grid.axes = static_cast<GridAxes>(axes_->currentData().toInt()); });
  });
  return box;
}

void StitchPanel::refresh() {
  const bool was = std::exchange(showing_, true);
  const auto* left = document_.left();
  offer_->setVisible(left != nullptr);
  setLook(addFirst_, Look::primary, left == nullptr);
  if (left != nullptr) {
    QString word = left->file.empty() ? tr("A project of %n volumes was not saved when the program ended.", nullptr,
                                           static_cast<int>(left->project.volumes.size()))
                                      : tr("Changes to '%1' were not saved when the program ended.").arg(words(left->file.stem().string()));
    if (document_.leftCount() > 1) word += QLatin1Char(' ') + tr("%n more is offered after it.", nullptr, document_.leftCount() - 1);
    offerWord_->setText(word);
  }
  const auto& project = document_.project();
  pages_->setCurrentIndex(project.volumes.empty() ? 0 : 1);
  list_->refresh();
  pairWord_->setText(results_.pairSummary(look_.pair()));
  pairsBox_->setVisible(project.volumes.size() >= 2);
  const bool running = runs_.isRunning();
  moreRow_->setVisible(!running);  // its room is the card's on a small screen
  // Where the focus is on a button that is switched off, it waits here: else it goes to whatever comes next in the window.
  if (running && !waiting_ && isAncestorOf(QApplication::focusWidget())) {
    for (QPushButton* button : {match_, refine_, elastic_, seams_})
      if (button->hasFocus()) {
        waiting_ = button;
        setFocus();
      }
  }
  for (QPushButton* button : {match_, refine_, elastic_, seams_}) button->setEnabled(!running);
  if (!running && waiting_ != nullptr) {
    if (hasFocus()) waiting_->setFocus();
    waiting_ = nullptr;
  }
  // Once each: what is shown and hidden again in one go leaves its room behind.
  for (QPushButton* button : {match_, elastic_, seams_}) button->setVisible(project.volumes.size() >= 2);
  const auto isPlaced = [](const ProjectVolume& volume) { return volume.placement != Placement::unknown; };
  refine_->setVisible(project.volumes.size() >= 2 && std::any_of(project.volumes.begin(), project.volumes.end(), isPlaced));
  // One button leads: finding the places, from the recorded ones where all are; then the volume; then what it is for.
  const bool matched = results_.isMatchFresh();
  const bool placed = std::all_of(project.volumes.begin(), project.volumes.end(), isPlaced);
  const bool made = mosaic_.isFresh();
  setLook(match_, Look::primary, !matched && !placed);
  setLook(refine_, Look::primary, !matched && placed);
  setLook(seams_, Look::primary, matched && !made && results_.pairsToLookAt() == 0);  // a pair that needs a look comes first
  const bool isCaseOpen = mosaic_.isCaseOpen();
  setLook(handOver_, Look::primary, matched && made && isCaseOpen);
  setLook(saveVolume_, Look::primary, matched && made && !isCaseOpen);
  saveProject_->setEnabled(document_.hasUnsavedChanges());
  resultBox_->setVisible(mosaic_.volume() != nullptr);
  old_->setVisible(mosaic_.volume() != nullptr && !mosaic_.isFresh());
  spacing_->setValue(project.settings.join.grid.spacing_mm);
  fallOff_->setValue(project.settings.fallOff_mm);
  seamMethod_->setCurrentIndex(std::max(0, seamMethod_->findData(static_cast<int>(project.settings.join.seam.method))));
  axes_->setCurrentIndex(std::max(0, axes_->findData(static_cast<int>(project.settings.join.grid.axes))));
  showForecast();
  showing_ = was;
}

void StitchPanel::showForecast() {
  std::vector<GridPlacement> grids;
  for (std::size_t n = 0; n < document_.project().volumes.size(); ++n)
    if (const auto volume = inputs_.volume(n)) grids.push_back({volume->grid, results_.toWorld(n), document_.project().volumes[n].name});
  if (grids.empty()) return forecast_->say({});
  const auto forecast = forecastJoin(grids, document_.project().settings.join);
  if (!forecast) return forecast_->say(words(forecast.error().message));
  const QString needs = memoryText(static_cast<double>(forecast->bytes));
  QString tip = tr("What the stitched volume will be, and the memory that making it takes at its peak");
  if (const auto free = availableMemory_bytes()) tip += QLatin1Char('\n') + tr("%1 are free").arg(memoryText(static_cast<double>(*free)));
  forecast_->setToolTip(tip);
  forecast_->say(tr("Result: %1, %2").arg(sizeOf(forecast->grid), needs));
}

void StitchPanel::askForFiles() {
  const QStringList chosen = QFileDialog::getOpenFileNames(
      this, tr("Add volumes"), lastFolder(),
      tr("Volumes, sweeps and stitch projects (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.json);;All files (*)"));
  if (chosen.isEmpty()) return;
  std::vector<fs::path> files;
  for (const auto& each : chosen) files.emplace_back(each.toStdString());
  inputs_.addFiles(files);
}

bool StitchPanel::mayLeaveProject() {
  if (document_.project().volumes.empty() || !document_.hasUnsavedChanges()) return true;
  const auto answer = askBeforeLeaving(this, {"unsavedProjectQuestion", tr("The stitch project has changes that are not saved."), {}});
  if (answer == QMessageBox::Save) {
    document_.save(false);
    return !document_.hasUnsavedChanges();
  }
  return answer == QMessageBox::Discard;
}

void StitchPanel::askForProject() {
  if (!mayLeaveProject()) return;
  const QString chosen =
      QFileDialog::getOpenFileName(this, tr("Open a stitch project"), lastFolder(), tr("Stitch projects (*.json);;All files (*)"));
  if (chosen.isEmpty()) return;
  keepFolderOf(chosen);
  document_.openProject(chosen.toStdString());
}

void StitchPanel::showProblem(const QString& sentence) {
  setProblem(problem_, sentence);
  if (sentence.isEmpty()) return;
  // Where the column is longer than the window, the sentence stands below what is seen of it.
  QMetaObject::invokeMethod(
      this,
      [this] {
        for (QWidget* above = parentWidget(); above != nullptr; above = above->parentWidget())
          if (auto* scroll = qobject_cast<QScrollArea*>(above)) return scroll->ensureWidgetVisible(problem_, 0, 0);
      },
      Qt::QueuedConnection);
}

void StitchPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void StitchPanel::dropEvent(QDropEvent* event) { inputs_.addDropped(*event); }

}  // namespace ew::stitching
