#include "panel/class_page.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ew/assessment/metric.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/class_table.h"
#include "panel/report_button.h"
#include "panel/session/review_session.h"

namespace ew::review {

namespace {

enum StepColumn { kStep, kPassed, kMedian, kSpread };

QString nameOfFigure(const ClassMetric& figure) {
  const Metric* metric = metricOf(figure.id);
  return metric != nullptr ? words(metric->name) : words(figure.id);
}

/// By which a figure is found again among those of another step.
QString keyOfFigure(const ClassMetric& figure) { return words((figure.isMetric ? "metric " : "task ") + figure.id + " " + figure.unit); }

}  // namespace

ClassPage::ClassPage(ReviewSession& session, QWidget* parent)
    : QWidget(parent), session_(session), selection_(session.selection()), reviewer_(session.reviewer()), scores_(session.scores()) {
  setObjectName(QStringLiteral("classPage"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  rows->setSpacing(kGrid_px);
  auto* head = new QHBoxLayout;
  heading_ = headingLabel({});
  heading_->setObjectName(QStringLiteral("classHeading"));
  heading_->setWordWrap(true);
  head->addWidget(heading_, 1);
  head->addWidget(new ReportButton(session_.reports(), true));
  back_ = new QPushButton(tr("Back to the scans"));
  back_->setObjectName(QStringLiteral("classBack"));
  connect(back_, &QPushButton::clicked, this, [this] { session_.setShowsClass(false); });
  head->addWidget(back_);
  rows->addLayout(head);
  hardest_ = new QLabel;
  hardest_->setObjectName(QStringLiteral("classHardest"));
  hardest_->setWordWrap(true);
  rows->addWidget(hardest_);
  auto* halves = new QHBoxLayout;
  halves->setSpacing(2 * kGrid_px);
  halves->addWidget(makeSteps(), 5);
  halves->addWidget(makeDetails(), 4);
  rows->addLayout(halves, 1);
  connect(&session_, &ReviewSession::pageChanged, this, &ClassPage::refresh);
  connect(&selection_, &ReviewSelection::shelfChanged, this, &ClassPage::refresh);
  connect(&selection_, &ReviewSelection::changed, this, &ClassPage::refresh);
  connect(&scores_, &LessonScores::changed, this, &ClassPage::refresh);
}

QWidget* ClassPage::makeSteps() {
  steps_ = table("classSteps", tr("Steps of the lesson"), {tr("Step"), tr("Passed"), tr("Median"), tr("Middle half")});
  steps_->header()->setToolTip(
      tr("Click a heading to sort; the scores of the middle half of all attempts lie between the two last figures"));
  steps_->sortByColumn(-1, Qt::AscendingOrder);  // as in the lesson, until a heading is clicked
  connect(steps_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (showing_ || item == nullptr) return;
    stepId_ = item->data(kStep, Qt::UserRole).toString().toStdString();
    showStep();
  });
  return steps_;
}

QWidget* ClassPage::makeDetails() {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* body = new QWidget;
  auto* rows = new QVBoxLayout(body);
  rows->setContentsMargins(0, 0, kGrid_px, 0);
  rows->setSpacing(kGrid_px);
  stepTitle_ = headingLabel({});
  stepTitle_->setWordWrap(true);
  rows->addWidget(stepTitle_);
  figure_ = new QComboBox;
  figure_->setObjectName(QStringLiteral("classFigure"));
  figure_->setAccessibleName(tr("Figure"));
  figure_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(figure_, qOverload<int>(&QComboBox::activated), this, [this] { showStep(); });
  rows->addWidget(figure_);
  chart_ = new DistributionChart;
  rows->addWidget(chart_);
  numbers_ = quietLabel({});
  numbers_->setObjectName(QStringLiteral("classNumbers"));
  rows->addWidget(numbers_);
  auto* levelRow = new QHBoxLayout;
  auto* levelName = new QLabel(tr("Pass level of this step"));
  levelName->setWordWrap(true);
  level_ = new NumberField(0.0, 100.0, 0, QStringLiteral("%"));
  level_->setObjectName(QStringLiteral("classLevel"));
  level_->setAccessibleName(tr("Pass level of this step"));
  level_->setKeyboardTracking(false);
  levelName->setBuddy(level_);
  connect(level_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    if (!showing_) keepLevel(value / 100.0);
  });
  levelRow->addWidget(levelName, 1);
  levelRow->addWidget(level_);
  rows->addLayout(levelRow);
  rows->addWidget(
      quietLabel(tr("To find a pass level, say of people you know whether they should pass; the level then lies where both groups part.")));
  attempts_ = table("classAttempts", tr("Attempts at this step"), {tr("Who"), tr("Score"), tr("Passed"), tr("Stands")});
  attempts_->header()->setSectionResizeMode(kWho, QHeaderView::ResizeToContents);
  attempts_->header()->setSectionResizeMode(kVerdict, QHeaderView::Stretch);
  holdLeastHeight(*attempts_, 150);
  rows->addWidget(attempts_, 1);
  suggestion_ = quietLabel({});
  suggestion_->setObjectName(QStringLiteral("classSuggestion"));
  rows->addWidget(suggestion_);
  take_ = new QPushButton(tr("Use this level"));
  take_->setObjectName(QStringLiteral("classTakeLevel"));
  connect(take_, &QPushButton::clicked, this, [this] {
    if (suggested_) keepLevel(std::round(100.0 * *suggested_) / 100.0);
  });
  rows->addWidget(take_, 0, Qt::AlignLeft);
  scroll->setWidget(body);
  return scroll;
}

const LessonStep* ClassPage::lessonStep(const std::string& id) const {
  if (selection_.lesson() == nullptr) return nullptr;
  for (const LessonStep& each : selection_.lesson()->lesson.steps)
    if (each.id == id) return &each;
  return nullptr;
}

const ClassStep* ClassPage::shownStep() const {
  for (const ClassStep& each : rows_)
    if (each.stepId == stepId_) return &each;
  return nullptr;
}

QString ClassPage::titleOfStep(const ClassStep& step) const {
  const LessonStep* now = lessonStep(step.stepId);
  const std::string& title = now != nullptr ? now->title : step.title.empty() ? step.stepId : step.title;
  return words(selection_.lesson() != nullptr ? selection_.lesson()->words.of(title) : title);
}

void ClassPage::workOut() {
  const LessonAttempts* of = selection_.lesson();
  class_ = scores_.classAttempts();
  figures_ = classFiguresOf(class_);
  rows_ = of != nullptr ? overviewSteps(figures_, of->lesson, scores_.plan()) : std::vector<ClassStep>();
}

void ClassPage::refresh() {
  if (!session_.showsClass()) return;
  showing_ = true;
  workOut();
  const LessonAttempts* of = selection_.lesson();
  heading_->setText(of == nullptr ? tr("No lesson is chosen")
                                  : (class_.size() == 1 ? tr("%1: one attempt")
                                                        : tr("%1: %2 attempts").arg(QStringLiteral("%1"), QString::number(class_.size())))
                                        .arg(words(of->words.of(of->lesson.title))));
  if (shownStep() == nullptr && figures_.hardest) stepId_ = figures_.steps[*figures_.hardest].stepId;
  if (shownStep() == nullptr) stepId_ = rows_.empty() ? std::string() : rows_.front().stepId;
  showHardest();
  showSteps();
  showing_ = false;
  showStep();
}

void ClassPage::showHardest() {
  if (figures_.hardest) {
    const ClassStep& hardest = figures_.steps[*figures_.hardest];
    hardest_->setText(tr("Most fail at “%1”: %2 of %3 who ended it did not pass.")
                          .arg(titleOfStep(hardest))
                          .arg(hardest.failed + hardest.skipped)
                          .arg(hardest.reached()));
    return;
  }
  const bool isAnyJudged = std::any_of(rows_.begin(), rows_.end(), [](const ClassStep& row) { return row.reached() > 0; });
  hardest_->setText(isAnyJudged ? tr("Nobody failed a step that counts.") : tr("No step was judged yet."));
}

void ClassPage::showSteps() {
  steps_->clear();
  for (std::size_t n = 0; n < rows_.size(); ++n) {
    const ClassStep& step = rows_[n];
    auto* item = new SortableItem(steps_);
    const QString title = titleOfStep(step);
    const bool isHardest = figures_.hardest && figures_.steps[*figures_.hardest].stepId == step.stepId;
    item->setText(kStep, (isHardest ? QStringLiteral("▲ ") : QString()) + title);
    item->setToolTip(kStep, isHardest            ? tr("%1: most fail here").arg(title)
                            : step.weight <= 0.0 ? tr("%1: does not count in the score").arg(title)
                                                 : title);
    item->setData(kStep, Qt::UserRole, words(step.stepId));
    item->setData(kStep, kSortRole, static_cast<double>(n));
    item->set(kPassed, step.reached() == 0 ? QStringLiteral("–") : tr("%1 of %2").arg(step.passed).arg(step.reached()),
              step.reached() == 0 ? -1.0 : 1.0 - step.notPassedShare());
    const Distribution scores = distributionOf(step.scores);
    const bool isEmpty = scores.values.empty();
    item->set(kMedian, isEmpty ? QStringLiteral("–") : percent(scores.median), isEmpty ? -1.0 : scores.median);
    item->set(kSpread, isEmpty ? QStringLiteral("–") : tr("%1 to %2").arg(percent(scores.lowerQuartile), percent(scores.upperQuartile)),
              scores.upperQuartile - scores.lowerQuartile);
    if (step.stepId == stepId_) steps_->setCurrentItem(item);
  }
}

void ClassPage::showStep() {
  const ClassStep* step = shownStep();
  if (step == nullptr) return;
  const LessonStep* told = lessonStep(stepId_);
  showing_ = true;
  stepTitle_->setText(titleOfStep(*step));
  const QString chosen = figure_->currentData().toString();
  figure_->clear();
  figure_->addItem(tr("Score"), QString());
  for (const ClassMetric& figure : step->metrics) figure_->addItem(nameOfFigure(figure), keyOfFigure(figure));
  figure_->setCurrentIndex(std::max(0, figure_->findData(chosen)));
  const int n = figure_->currentIndex();
  const double level = told != nullptr ? passLevelOf(*told, scores_.plan()) : step->passLevel;
  const QLocale locale;
  if (n == 0) {
    const Distribution scores = distributionOf(step->scores);
    Distribution percents = scores;
    for (double& value : percents.values) value *= 100.0;
    for (double* each :
         {&percents.lowest, &percents.lowerQuartile, &percents.median, &percents.upperQuartile, &percents.highest, &percents.mean})
      *each *= 100.0;
    chart_->show(percents, QStringLiteral("%"), 0.0, 100.0, 100.0 * level);
    numbers_->setText(percents.values.empty() ? QString()
                                              : tr("Median %1, mean %2; %3 of %4 passed, %5 left the step out.")
                                                    .arg(percent(scores.median), percent(scores.mean))
                                                    .arg(step->passed)
                                                    .arg(step->reached())
                                                    .arg(step->skipped));
    figure_->setToolTip({});
  } else {
    const ClassMetric& figure = step->metrics[static_cast<std::size_t>(n - 1)];
    const Distribution values = distributionOf(figure.values);
    const double room = std::max(1e-6, 0.05 * (values.highest - values.lowest));
    chart_->show(values, words(figure.unit), values.lowest - room, values.highest + room, std::nullopt);
    numbers_->setText(tr("Median %1, mean %2, from %3 to %4 %5")
                          .arg(locale.toString(values.median, 'g', 4), locale.toString(values.mean, 'g', 4),
                               locale.toString(values.lowest, 'g', 4), locale.toString(values.highest, 'g', 4), words(figure.unit)));
    const Metric* metric = metricOf(figure.id);
    figure_->setToolTip(metric != nullptr ? words(metric->definition) : QString());
  }
  level_->setValue(100.0 * level);
  level_->setEnabled(told != nullptr && !scores_.isScoring());
  showing_ = false;
  showAttempts();
}

}  // namespace ew::review
