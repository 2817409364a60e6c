#include "panel/pair_inspector.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/widgets/fields.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/marks.h"
#include "panel/stitch_session.h"

namespace ew::stitching {
namespace {

QString briefly(const std::vector<registration::Remark>& remarks) {
  return words(registration::messageOf(remarks, registration::Wording::brief));
}
/// A line of the inspector: what at the left, how much at the right.
QLabel* addLine(QVBoxLayout* column, const QString& name, const QString& hint) {
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  auto* label = quietLabel(name);
  label->setWordWrap(false);
  label->setToolTip(hint);
  auto* value = new QLabel;
  value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  value->setToolTip(hint);
  row->addWidget(label);
  row->addWidget(value, 1);
  column->addLayout(row);
  return value;
}

QVBoxLayout* columnIn(QWidget* box) {
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px / 2);
  return column;
}

class MarkBox final : public QWidget {
 public:
  explicit MarkBox(QWidget* parent = nullptr) : QWidget(parent) { setFixedSize(16, 16); }
  StitchResults::Mark mark = StitchResults::Mark::unknown;

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    drawMark(painter, QRectF(rect()).adjusted(1, 1, -1, -1), mark, palette());
  }
};

}  // namespace

PairInspector::PairInspector(StitchSession& session, Tools& tools, QWidget* parent)
    : QWidget(parent),
      document_(session.document()),
      inputs_(session.inputs()),
      results_(session.results()),
      look_(session.look()),
      runs_(session.runs()),
      edits_(session.edits()),
      tools_(tools) {
  setObjectName(QStringLiteral("pairInspector"));
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->setSpacing(0);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  body_ = new QWidget;
  auto* column = new QVBoxLayout(body_);
  column->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  column->setSpacing(kGrid_px);
  column->addWidget(makeHead());
  column->addWidget(makeFigures());
  column->addSpacing(kGrid_px / 2);
  column->addWidget(headingLabel(tr("Correlation by level")));
  chart_ = new LevelChart(session);
  column->addWidget(chart_);
  column->addSpacing(kGrid_px / 2);
  column->addWidget(makeLandmarks());
  column->addSpacing(kGrid_px / 2);
  column->addWidget(makePose());
  column->addSpacing(kGrid_px / 2);
  column->addWidget(makeElastic());
  column->addSpacing(kGrid_px / 2);
  column->addWidget(makeRedo());
  column->addStretch(1);
  scroll->setWidget(body_);
  body_->setAutoFillBackground(false);
  scroll->viewport()->setAutoFillBackground(false);
  empty_ = quietLabel(tr("How well two volumes fit is told here, once there are two."));
  static_cast<QLabel*>(empty_)->setAlignment(Qt::AlignCenter);
  empty_->setContentsMargins(24, 24, 24, 24);
  outer->addWidget(empty_, 1);
  outer->addWidget(scroll, 1);
  connect(&session, &StitchSession::changed, this, &PairInspector::refresh);
  connect(&session, &StitchSession::lookChanged, this, [this] { showFigures(); });
  refresh();
}

QWidget* PairInspector::makeHead() {
  auto* box = new QWidget;
  auto* column = columnIn(box);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  title_ = headingLabel({});
  title_->setObjectName(QStringLiteral("pairTitle"));
  mark_ = new MarkBox;
  word_ = new QLabel;
  word_->setObjectName(QStringLiteral("pairVerdict"));
  row->addWidget(title_);
  row->addSpacing(kGrid_px);
  row->addWidget(mark_);
  row->addWidget(word_, 1);
  column->addLayout(row);
  reason_ = new Paragraph;
  reason_->setObjectName(QStringLiteral("pairReason"));
  column->addWidget(reason_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  const auto decide = [&](const QString& text, const QString& hint, const char* name, Decision decision) {
    auto* button = new QPushButton(text);
    button->setCheckable(true);
    button->setToolTip(hint);
    button->setObjectName(QLatin1String(name));
    connect(button, &QPushButton::clicked, this, [this, decision] {
      edits_.setDecision(decision);
      refresh();  // a button that was already down stays down
    });
    buttons->addWidget(button, 1);
    return button;
  };
  accept_ = decide(tr("Accept"), tr("This pair is right, whatever the figures say (Enter)"), "acceptPair", Decision::accepted);
  reject_ = decide(tr("Reject"), tr("Leave this pair out of the result (Backspace)"), "rejectPair", Decision::rejected);
  column->addSpacing(kGrid_px / 2);
  column->addLayout(buttons);
  return box;
}

QWidget* PairInspector::makeFigures() {
  auto* box = new QWidget;
  auto* column = columnIn(box);
  overlap_ = addLine(column, tr("Overlap"), tr("Of the smaller volume's covered part, how much both cover"));
  correlation_ = addLine(
      column, tr("Correlation"),
      tr("As matched; without gain and speckle. In brackets what it was at the start, and what unrelated tissue reaches by chance. It may "
         "fall: a search that has no start looks for the pose that stands out, and the start may lie on it already"));
  now_ = addLine(column, tr("Grey levels now"),
                 tr("Plain correlation of the grey levels as they lie now: for a hand that nudges, no verdict"));
  halves_ =
      addLine(column, tr("Halves differ by"), tr("Two halves of the overlap, matched apart, would place the volume this much differently"));
  jacobian_ = addLine(column, tr("Smallest Jacobian"), tr("Of the elastic step: above 0 nothing folds; 1 is no change of volume"));
  time_ = addLine(column, tr("Time"), tr("That matching this pair took"));
  overlap_->setObjectName(QStringLiteral("overlapFigure"));
  correlation_->setObjectName(QStringLiteral("correlationFigure"));
  now_->setObjectName(QStringLiteral("nowFigure"));
  jacobian_->setObjectName(QStringLiteral("jacobianFigure"));
  return box;
}

QWidget* PairInspector::makePose() {
  auto* box = new QWidget;
  auto* column = columnIn(box);
  auto* heading = headingLabel(tr("Pose"));
  heading->setToolTip(tr("Where the moving volume lies in the fixed one; in the views the arrow keys move it"));
  column->addWidget(heading);
  pose_ = new sdk::PlacementFields<frame::Fixed, frame::Moving>;
  pose_->onChanged = [this](const Transform<frame::Fixed, frame::Moving>& movingToFixed, const std::string& axis) {
    if (showing_ || !look_.pair()) return;
    edits_.setTransform(rigidInverse(movingToFixed), tr("pose of %1 by numbers").arg(words(letterOf(look_.pair()->moving))),
                        "figures " + axis + ' ' + std::to_string(look_.pair()->fixed) + ' ' + std::to_string(look_.pair()->moving));
  };
  column->addWidget(pose_);
  return box;
}

QWidget* PairInspector::makeLandmarks() {
  auto* box = new QWidget;
  auto* column = columnIn(box);
  auto* head = new QHBoxLayout;
  head->addWidget(headingLabel(tr("Landmarks")), 1);
  pick_ = new QPushButton(tr("+ pick in both"));
  pick_->setObjectName(QStringLiteral("pickLandmarks"));
  setLook(pick_, Look::flat);
  pick_->setCheckable(true);
  pick_->setToolTip(tr("Click the same place in the fixed and in the moving view (P)"));
  connect(pick_, &QPushButton::toggled, this, [this](bool on) {
    tools_.hand = on ? Tools::Hand::pick : Tools::Hand::look;
    if (!on) look_.dropPick();
    Q_EMIT handChosen();
    refresh();
  });
  head->addWidget(pick_);
  column->addLayout(head);
  table_ = new QTableWidget(0, 3);
  table_->setObjectName(QStringLiteral("landmarks"));
  table_->horizontalHeader()->hide();
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(30);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->setTextElideMode(Qt::ElideRight);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row, int, int, int) {
    if (!showing_ && row >= 0) look_.chooseLandmark(row);
  });
  connect(table_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (!showing_ && item->column() == 1) edits_.renameLandmark(item->row(), item->text());
  });
  column->addWidget(table_);
  landmarkWord_ = new Paragraph;
  landmarkWord_->setObjectName(QStringLiteral("landmarkWord"));
  column->addWidget(landmarkWord_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  useMarks_ = new QPushButton(tr("Match by landmarks"));
  useMarks_->setObjectName(QStringLiteral("useLandmarks"));
  useMarks_->setToolTip(tr("Bring this pair together by these places alone"));
  connect(useMarks_, &QPushButton::clicked, &edits_, &AlignmentEdits::useLandmarks);
  removeMark_ = new QPushButton(tr("Remove"));
  removeMark_->setObjectName(QStringLiteral("removeLandmark"));
  removeMark_->setToolTip(tr("Remove the chosen landmark (Delete)"));
  connect(removeMark_, &QPushButton::clicked, this, [this] { edits_.removeLandmark(look_.chosenLandmark()); });
  buttons->addWidget(useMarks_, 1);
  buttons->addWidget(removeMark_);
  column->addLayout(buttons);
  return box;
}

QWidget* PairInspector::makeRedo() {
  auto* box = new QWidget;
  auto* column = columnIn(box);
  column->addWidget(headingLabel(tr("Match this pair again")));
  auto* choice = new QHBoxLayout;
  choice->setSpacing(kGrid_px);
  method_ = new QComboBox;
  method_->setObjectName(QStringLiteral("pairMethod"));
  method_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  method_->addItem(tr("Automatic"), static_cast<int>(PairMethod::automatic));
  method_->addItem(tr("Search without initial pose"), static_cast<int>(PairMethod::search));
  method_->addItem(tr("Refine from here"), static_cast<int>(PairMethod::refine));
  method_->addItem(tr("As placed manually"), static_cast<int>(PairMethod::byHand));
  choice->addWidget(method_, 1);
  auto* redo = new QPushButton(tr("Match again"));
  redo->setObjectName(QStringLiteral("redoPair"));
  setLook(redo, Look::compact);
  connect(redo, &QPushButton::clicked, this, [this] {
    const auto method = static_cast<PairMethod>(method_->currentData().toInt());
    if (method == PairMethod::byHand) return edits_.setTransform(look_.transform(), tr("keep the pair as it lies"), {});
    if (method == PairMethod::refine && look_.pair()) edits_.pinStart();
    edits_.redoPair(method, method == PairMethod::search || method == PairMethod::automatic ? std::optional(turn_->value()) : std::nullopt);
  });
  choice->addWidget(redo);
  column->addLayout(choice);
  turnRow_ = new QWidget;
  auto* turnColumn = columnIn(turnRow_);
  auto* row = new QHBoxLayout;
  auto* name = quietLabel(tr("Maximum rotation"));
  name->setWordWrap(false);
  turn_ = new NumberField(0.0, 180.0, 0, QStringLiteral("°"));
  turn_->setObjectName(QStringLiteral("maxTurn"));
  turn_->setValue(30.0);
  turn_->setToolTip(tr("Rotations searched in every direction; the time grows with the third power"));
  name->setBuddy(turn_);
  row->addWidget(name, 1);
  row->addWidget(turn_);
  turnColumn->addLayout(row);
  searchCost_ = addLine(turnColumn, tr("Expected time"),
                        tr("Of a search, from 'echoweave bench register', scaled to this pair's size and to the rotations to be searched"));
  searchCost_->setObjectName(QStringLiteral("searchCost"));
  connect(turn_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { showSearchCost(); });
  connect(method_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    const auto method = static_cast<PairMethod>(method_->currentData().toInt());
    turnRow_->setVisible(method == PairMethod::search || method == PairMethod::automatic);
  });
  column->addWidget(turnRow_);
  return box;
}

QWidget* PairInspector::makeElastic() {
  auto* box = new QWidget;
  auto* column = columnIn(box);
  column->addWidget(headingLabel(tr("Elastic")));
  auto* row = new QHBoxLayout;
  auto* name = quietLabel(tr("Quality of all pairs"));
  name->setWordWrap(false);
  effort_ = new QComboBox;
  effort_->setObjectName(QStringLiteral("effort"));
  for (const auto effort : kEfforts) effort_->addItem(nameOfEffort(effort));
  effort_->setToolTip(tr("For all pairs that have no quality of their own: how much time is spent on accuracy"));
  connect(effort_, qOverload<int>(&QComboBox::activated), this,
          [this](int index) { edits_.setEffort(static_cast<registration::ElasticEffort>(index)); });
  row->addWidget(name, 1);
  row->addWidget(effort_);
  column->addLayout(row);
  auto* own = new QHBoxLayout;
  auto* ownName = quietLabel(tr("Of this pair alone"));
  ownName->setWordWrap(false);
  pairEffort_ = new QComboBox;
  pairEffort_->setObjectName(QStringLiteral("pairEffort"));
  pairEffort_->addItem(tr("as all"), -1);
  for (const auto effort : kEfforts) pairEffort_->addItem(nameOfEffort(effort), static_cast<int>(effort));
  pairEffort_->setToolTip(tr("For this pair alone; the command line keeps to it too"));
  const auto chooseEffort = [this](int effort) {
    edits_.setPairEffort(effort < 0 ? std::nullopt : std::optional(static_cast<registration::ElasticEffort>(effort)));
  };
  connect(pairEffort_, qOverload<int>(&QComboBox::activated), this,
          [this, chooseEffort] { chooseEffort(pairEffort_->currentData().toInt()); });
  own->addWidget(ownName, 1);
  own->addWidget(pairEffort_);
  column->addLayout(own);
  for (QComboBox* each : {effort_, pairEffort_}) each->setMinimumWidth(13 * kGrid_px);
  expected_ = addLine(column, tr("Expected"), {});
  expected_->setObjectName(QStringLiteral("expectedCost"));
  measured_ = addLine(column, tr("Measured"), {});
  measured_->setObjectName(QStringLiteral("measuredCost"));
  memory_ = addLine(column, tr("Memory"), tr("That the elastic step of this pair takes at its peak, the volumes themselves not counted"));
  memory_->setObjectName(QStringLiteral("elasticMemory"));
  warpedReason_ = new Paragraph;
  warpedReason_->setObjectName(QStringLiteral("bentReason"));
  column->addWidget(warpedReason_);
  costHead_ = new Paragraph;
  costHead_->setObjectName(QStringLiteral("costHead"));
  column->addSpacing(kGrid_px / 2);
  column->addWidget(costHead_);
  cost_ = new CostChart;
  connect(cost_, &CostChart::chosen, this, chooseEffort);
  column->addWidget(cost_);
  warpAgain_ = new QPushButton(tr("Deform this pair again"));
  warpAgain_->setObjectName(QStringLiteral("bendAgain"));
  warpAgain_->setToolTip(tr("Runs the elastic step; pairs that did not change keep what they have"));
  connect(warpAgain_, &QPushButton::clicked, &edits_, &AlignmentEdits::warpAgain);
  column->addWidget(warpAgain_);
  return box;
}

void PairInspector::showLandmarks() {
  const auto marks = look_.landmarks();
  const auto& result = look_.landmarkResult();
  table_->setRowCount(static_cast<int>(marks.size()));
  for (std::size_t n = 0; n < marks.size(); ++n) {
    const int row = static_cast<int>(n);
    const bool outlying = result && std::find(result->outlying.begin(), result->outlying.end(), n) != result->outlying.end();
    const bool known = result && n < result->residual_mm.size() && result->verdict != registration::Verdict::cannotTell;
    const QString texts[] = {QString::number(n + 1), words(marks[n].name),
                             known ? (outlying ? tr("%1 mm, off") : tr("%1 mm")).arg(figure(result->residual_mm[n], 1)) : tr("-")};
    for (int c = 0; c < 3; ++c) {
      auto* item = new QTableWidgetItem(texts[c]);
      item->setFlags(c == 1 ? item->flags() | Qt::ItemIsEditable : item->flags() & ~Qt::ItemIsEditable);
      if (c == 2) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      if (c != 1) item->setForeground(palette().color(QPalette::PlaceholderText));
      if (outlying && c == 2) item->setForeground(palette().color(QPalette::BrightText));
      item->setToolTip(c == 1     ? words(marks[n].name) + QLatin1Char('\n') + tr("Double-click to rename")
                       : outlying ? tr("This pair of places contradicts the others; look at it again or remove it")
                                  : QString());
      table_->setItem(row, c, item);
    }
  }
  table_->setVisible(!marks.empty());
  table_->setFixedHeight(std::min<int>(6, static_cast<int>(marks.size())) * 30 + 4);
  if (look_.chosenLandmark() >= 0 && look_.chosenLandmark() < table_->rowCount())
    table_->setCurrentCell(look_.chosenLandmark(), table_->currentColumn() < 0 ? 1 : table_->currentColumn());
  else
    table_->clearSelection();
  removeMark_->setVisible(look_.chosenLandmark() >= 0 && !marks.empty());
  useMarks_->setVisible(marks.size() >= 3);
  QString text;
  if (tools_.hand == Tools::Hand::pick) {
    text = look_.pickedFixed()    ? tr("Now the same place in the moving view. Escape drops it.")
           : look_.pickedMoving() ? tr("Now the same place in the fixed view. Escape drops it.")
                                  : tr("Click a place in the fixed view, then the same one in the moving view.");
  } else if (marks.empty()) {
    text = tr("None yet. Three places that are seen in both volumes bring a pair together where the images alone cannot.");
  } else if (result) {
    text = briefly(result->remarks);
  }
  if (result && result->verdict == registration::Verdict::aligned && tools_.hand != Tools::Hand::pick)
    text =
        tr("%1 mm on average, %2 mm to be expected at the far side").arg(figure(result->rms_mm, 1), figure(result->expectedError_mm, 1)) +
        (result->outlying.empty() ? QString() : QStringLiteral(". ") + briefly(result->remarks));
  landmarkWord_->say(text);
  landmarkWord_->setVisible(!text.isEmpty());
}

void PairInspector::showCost() {
  const QString none = QStringLiteral("-");
  const auto [fixed, moving] = *look_.pair();
  const auto effort = effortOf(document_.project(), fixed, moving);
  const PairDeformation* warped = results_.warpedOf(fixed, moving);
  const bool fresh = warped != nullptr && !results_.isWarpedStale(fixed, moving);
  warpAgain_->setVisible(warped != nullptr);
  warpAgain_->setEnabled(!fresh && !runs_.isRunning());
  if (warped == nullptr) {
    measured_->setText(none);
  } else {
    const QString took = inSeconds(warped->seconds > 0.0 ? warped->seconds : warped->processor_s);
    measured_->setText(warped->effort == effort ? took : tr("%1 (%2)").arg(took, nameOfEffort(warped->effort)));
    measured_->setToolTip(
        tr("That deforming this pair took; it correlates %1 after %2 before, and moves by up to %3 mm")
            .arg(figure(warped->after.correlation, 2), figure(warped->before.correlation, 2), figure(warped->largestMotion_mm, 1)) +
        (warped->processor_s > 0.0
             ? QLatin1Char('\n') + tr("By the clock; %1 of it were work of the processor.").arg(inSeconds(warped->processor_s))
             : QString()));
  }
  warpedReason_->setVisible(warped != nullptr);
  if (warped != nullptr)
    warpedReason_->say((results_.pairLine(fixed, moving).warpDoubted
                            ? tr("The rigid pose is aligned; the deformation needs a look.") + QLatin1Char(' ')
                            : QString()) +
                       briefly(warped->remarks) + (fresh ? QString() : QLatin1Char(' ') + tr("Changed since: deform again.")));
  const auto a = inputs_.volume(fixed);
  const auto b = inputs_.volume(moving);
  searchCost_->setText(none);
  if (!a || !b) {
    for (QLabel* label : {expected_, memory_}) label->setText(none);
    costHead_->say(tr("Cost of accuracy"));
    return cost_->clear();
  }
  registration::ElasticOptions options;
  options.effort = effort;
  memory_->setText(memoryText(static_cast<double>(registration::forecastElastic_bytes(a->grid, b->grid, options))));
  const MachinePace pace = results_.warpPace();
  const auto costs = expectedWarps(a->grid, b->grid, pace);
  const CostEstimate& mine = costs[static_cast<std::size_t>(effort)];
  // What one waits for; the chart below compares processor times, which do not depend on what else the machine does.
  expected_->setText(tr("%1 mm in %2").arg(figure(mine.error_mm, 2), inSeconds(pace.clock * mine.seconds)));
  const QString from =
      tr("From 'echoweave bench register': two views of one tissue, up to 5 mm apart, with two thirds of their speckle in common, on one "
         "thread; scaled to this pair's %1 million voxels of %2 mm.")
          .arg(figure(1e-6 * static_cast<double>(a->grid.voxelCount() + b->grid.voxelCount()), 1),
               figure(std::min({a->grid.spacing_mm.x, a->grid.spacing_mm.y, a->grid.spacing_mm.z}), 2)) +
      QLatin1Char(' ') +
      (pace.pairs > 0 ? tr("Times are as %n pairs took here.", nullptr, static_cast<int>(pace.pairs))
                      : tr("Times are those of the machine of the figures until a pair was deformed here."));
  expected_->setToolTip(from + QLatin1Char('\n') +
                        tr("By the clock, as deforming went here; %1 of it are work of the processor.").arg(inSeconds(mine.seconds)));
  cost_->setToolTip(from);
  costHead_->say(pace.pairs > 0 ? tr("Cost of accuracy on this machine") : tr("Cost of accuracy, as measured elsewhere"));
  costHead_->setToolTip(from);
  cost_->show(costs, effort, fresh && warped->processor_s > 0.0 ? std::optional(warped->processor_s) : std::nullopt);
  showSearchCost();
}

void PairInspector::showSearchCost() {
  if (!look_.pair()) return;
  const auto a = inputs_.volume(look_.pair()->fixed);
  const auto b = inputs_.volume(look_.pair()->moving);
  if (!a || !b) return;
  searchCost_->setText(tr("about %1").arg(inSeconds(expectedSearch_s(a->grid, b->grid, turn_->value(), results_.searchPace()))));
}

void PairInspector::showFigures() {
  if (!look_.pair() || !isVisible()) return;
  const QuickAgreement now = look_.agreement();
  now_->setText(now.points < 200 ? tr("no overlap") : figure(now.correlation, 2));
  const bool was = std::exchange(showing_, true);
  pose_->setTransform(rigidInverse(look_.transform()));
  showing_ = was;
}

void PairInspector::refresh() {
  const bool any = look_.pair().has_value();
  empty_->setVisible(!any);
  body_->parentWidget()->parentWidget()->setVisible(any);
  if (!any) return;
  const bool was = std::exchange(showing_, true);
  const auto [fixed, moving] = *look_.pair();
  const auto line = results_.pairLine(fixed, moving);
  const ProjectPair said = pairOf(document_.project(), fixed, moving);
  title_->setText(tr("Pair %1 to %2").arg(words(letterOf(fixed)), words(letterOf(moving))));
  title_->setToolTip(words(document_.project().volumes[fixed].name) + QStringLiteral(" → ") +
                     words(document_.project().volumes[moving].name));
  static_cast<MarkBox*>(mark_)->mark = line.mark;
  mark_->update();
  const bool isAcceptedHand = line.mark == StitchResults::Mark::byHand && said.decision == Decision::accepted;
  word_->setText(isAcceptedHand ? tr("manual, accepted") : wordsOfMark(line.mark));
  QPalette colours = palette();
  colours.setColor(QPalette::WindowText, colourOfMark(line.mark, palette()));
  word_->setPalette(colours);
  QString reason;
  if (said.decision == Decision::rejected)
    reason = tr("Rejected manually: the result does not use it.");
  else if (line.outcome != nullptr)
    reason = briefly(line.outcome->rigid.remarks);
  else
    reason = tr("Match it, mark landmarks in both volumes, or nudge it with the keys.");
  if (line.mark == StitchResults::Mark::landmarks && line.outcome->landmarks)
    reason += QLatin1Char(' ') + tr("At the far side %1 mm are to be expected; the images were not asked.")
                                     .arg(figure(line.outcome->landmarks->expectedError_mm, 1));
  if (line.wrong) reason += QLatin1Char(' ') + tr("The other pairs contradict it.");
  if (line.stale) reason += QLatin1Char(' ') + tr("Changed since: match again.");
  reason_->say(reason);
  accept_->setChecked(said.decision == Decision::accepted);
  reject_->setChecked(said.decision == Decision::rejected);
  const QString none = QStringLiteral("-");
  if (line.outcome != nullptr) {
    const auto& rigid = line.outcome->rigid;
    overlap_->setText(tr("%1 %").arg(figure(100.0 * rigid.after.overlapShare, 0)));
    correlation_->setText(tr("%1 (was %2, chance %3)")
                              .arg(figure(rigid.after.correlation, 2), figure(rigid.before.correlation, 2), figure(rigid.after.chance, 2)));
    halves_->setText(rigid.halvesDisagree_mm > 0.0 ? tr("%1 mm").arg(figure(rigid.halvesDisagree_mm, 2)) : none);
    time_->setText(rigid.seconds > 0.0 ? inSeconds(rigid.seconds) : none);
    if (rigid.after.overlapShare == 0.0 && rigid.after.correlation == 0.0) {  // by landmarks or by hand the images were not asked
      overlap_->setText(none);
      correlation_->setText(none);
    }
  } else {
    for (QLabel* label : {overlap_, correlation_, halves_, time_}) label->setText(none);
  }
  if (look_.hasElastic()) {
    const Mapping mine = look_.fixedMapping(StitchLook::Stage::elastic);
    const Mapping other = look_.movingMapping(StitchLook::Stage::elastic);
    double smallest = 1.0;
    for (const auto* warp : {mine.warp, other.warp})
      if (!warp->displacement_mm.empty()) smallest = std::min(smallest, registration::jacobianOf(*warp).smallest);
    jacobian_->setText(figure(smallest, 2));
  } else {
    jacobian_->setText(none);
  }
  showLandmarks();
  pick_->setChecked(tools_.hand == Tools::Hand::pick);
  const auto method = said.method == PairMethod::landmarks ? PairMethod::automatic : said.method;
  method_->setCurrentIndex(std::max(0, method_->findData(static_cast<int>(method))));
  turn_->setValue(said.maxRotation_deg.value_or(document_.project().settings.maxRotation_deg));
  turnRow_->setVisible(method == PairMethod::search || method == PairMethod::automatic);
  effort_->setCurrentIndex(static_cast<int>(document_.project().settings.effort));
  pairEffort_->setCurrentIndex(pairEffort_->findData(said.effort ? static_cast<int>(*said.effort) : -1));
  showCost();
  showing_ = was;
  showFigures();
}

}  // namespace ew::stitching
