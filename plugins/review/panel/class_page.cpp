#include "panel/class_page.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>

#include "ew/assessment/metric.h"
#include "ew/sdk/panel.h"
#include "panel/class_table.h"
#include "panel/look.h"
#include "panel/report_button.h"

namespace ew::review {

using sdk::kGap_px;
using sdk::words;

namespace {

enum StepColumn { kStep, kPassed, kMedian, kSpread };

QString nameOfFigure(const std::string& name) {
  const Metric* metric = metricOf(name);
  return metric != nullptr ? words(metric->name) : words(name);
}

/// @param isScored its metrics are there; else the figures that the lesson judged by
StepResult stepResultOf(const StepScore& score, bool isScored) {
  StepResult made{score.stepId, score.score, score.verdict == StepVerdict::passed, score.verdict == StepVerdict::skipped, {}};
  for (const MetricValue& value : score.metrics) {
    const Metric* metric = metricOf(value.id);
    if (metric != nullptr && metric->version == value.version) made.figures.push_back({value.id, value.value, std::string(metric->unit)});
  }
  if (!isScored)
    for (const AttemptFigure& figure : score.figures) made.figures.push_back({figure.name, figure.value, figure.unit});
  return made;
}

}  // namespace

ClassPage::ClassPage(ReviewSession& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("classPage"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(2 * kGap_px, 2 * kGap_px, 2 * kGap_px, 2 * kGap_px);
  rows->setSpacing(kGap_px);
  auto* head = new QHBoxLayout;
  heading_ = sdk::headingLabel({});
  heading_->setObjectName(QStringLiteral("classHeading"));
  heading_->setWordWrap(true);
  head->addWidget(heading_, 1);
  head->addWidget(new ReportButton(session_, true));
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
  halves->setSpacing(2 * kGap_px);
  halves->addWidget(makeSteps(), 5);
  halves->addWidget(makeDetails(), 4);
  rows->addLayout(halves, 1);
  connect(&session_, &ReviewSession::pageChanged, this, &ClassPage::refresh);
  connect(&session_, &ReviewSession::shelfChanged, this, &ClassPage::refresh);
  connect(&session_, &ReviewSession::choiceChanged, this, &ClassPage::refresh);
  connect(&session_, &ReviewSession::scoresChanged, this, &ClassPage::refresh);
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
  rows->setContentsMargins(0, 0, kGap_px, 0);
  rows->setSpacing(kGap_px);
  stepTitle_ = sdk::headingLabel({});
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
  numbers_ = sdk::quietLabel({});
  numbers_->setObjectName(QStringLiteral("classNumbers"));
  rows->addWidget(numbers_);
  auto* levelRow = new QHBoxLayout;
  auto* levelName = new QLabel(tr("Pass level of this step"));
  levelName->setWordWrap(true);
  level_ = new sdk::NumberField(0.0, 100.0, 0, QStringLiteral("%"));
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
      sdk::quietLabel(tr("To find a pass level, say of people you know how they stand; the level then lies where both groups part.")));
  attempts_ = table("classAttempts", tr("Attempts at this step"), {tr("Who"), tr("Score"), tr("Passed"), tr("Stands")});
  attempts_->header()->setSectionResizeMode(kWho, QHeaderView::ResizeToContents);
  attempts_->header()->setSectionResizeMode(kVerdict, QHeaderView::Stretch);
  attempts_->setMinimumHeight(withText(150, font()));
  rows->addWidget(attempts_, 1);
  suggestion_ = sdk::quietLabel({});
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

std::vector<AttemptResult> ClassPage::results() const {
  std::vector<AttemptResult> all;
  const ShelvedLesson* of = session_.lesson();
  if (of == nullptr) return all;
  for (std::size_t n = 0; n < of->attempts.size(); ++n) {
    const Attempt& tried = of->attempts[n].second;
    AttemptResult made{tried.id, {}};
    const ew::AttemptResult result = session_.resultOf(n);
    for (const LessonStep& step : of->lesson.steps) {
      if (tried.outcomeOf(step.id) == nullptr) continue;  // a step that was never reached says nothing about the step
      const StepScore* counted = result.counted.of(step.id);
      if (counted == nullptr || counted->verdict == StepVerdict::handedIn) continue;  // nobody has judged it yet
      made.steps.push_back(stepResultOf(*counted, result.isScored));
    }
    all.push_back(std::move(made));
  }
  return all;
}

const LessonStep* ClassPage::lessonStep(const std::string& id) const {
  if (session_.lesson() == nullptr) return nullptr;
  for (const LessonStep& each : session_.lesson()->lesson.steps)
    if (each.id == id) return &each;
  return nullptr;
}

const StepOverview* ClassPage::shownStep() const {
  for (const StepOverview& each : overview_.steps)
    if (each.stepId == stepId_) return &each;
  return nullptr;
}

void ClassPage::refresh() {
  if (!session_.showsClass()) return;
  showing_ = true;
  const ShelvedLesson* of = session_.lesson();
  std::vector<std::string> ids;
  if (of != nullptr)
    for (const LessonStep& step : of->lesson.steps)
      if (!std::holds_alternative<ReadTask>(step.task) && !std::holds_alternative<WatchTask>(step.task)) ids.push_back(step.id);
  const std::vector<AttemptResult> all = results();
  overview_ = overviewOf(all, ids);
  heading_->setText(of == nullptr ? tr("No lesson is chosen")
                                  : (all.size() == 1 ? tr("%1: one attempt")
                                                     : tr("%1: %2 attempts").arg(QStringLiteral("%1"), QString::number(all.size())))
                                        .arg(words(of->lesson.title)));
  const StepOverview* hardest = overview_.hardest ? &overview_.steps[*overview_.hardest] : nullptr;
  hardest_->setText(hardest == nullptr ? tr("Every step that was ended was passed.")
                                       : tr("Most fail at “%1”: %2 of %3 who ended it did not pass.")
                                             .arg(words(lessonStep(hardest->stepId)->title))
                                             .arg(hardest->ended - hardest->passed)
                                             .arg(hardest->ended));
  steps_->clear();
  if (shownStep() == nullptr) stepId_ = hardest != nullptr ? hardest->stepId : ids.empty() ? std::string() : ids.front();
  for (std::size_t n = 0; n < overview_.steps.size(); ++n) {
    const StepOverview& step = overview_.steps[n];
    auto* item = new SortedItem(steps_);
    const bool isHardest = overview_.hardest == n;
    item->setToolTip(kStep, words(lessonStep(step.stepId)->title));
    item->setText(kStep, (isHardest ? QStringLiteral("▲ ") : QString()) + words(lessonStep(step.stepId)->title));
    if (isHardest) item->setToolTip(kStep, tr("%1: most fail here").arg(item->toolTip(kStep)));
    item->setData(kStep, Qt::UserRole, words(step.stepId));
    item->setData(kStep, kSortRole, static_cast<double>(n));
    item->set(kPassed, step.ended == 0 ? QStringLiteral("–") : tr("%1 of %2").arg(step.passed).arg(step.ended),
              step.ended == 0 ? -1.0 : 1.0 - step.failedShare());
    const bool isEmpty = step.scores.values.empty();
    item->set(kMedian, isEmpty ? QStringLiteral("–") : percent(step.scores.median), isEmpty ? -1.0 : step.scores.median);
    item->set(kSpread,
              isEmpty ? QStringLiteral("–") : tr("%1 to %2").arg(percent(step.scores.lowerQuartile), percent(step.scores.upperQuartile)),
              step.scores.upperQuartile - step.scores.lowerQuartile);
    if (step.stepId == stepId_) steps_->setCurrentItem(item);
  }
  showing_ = false;
  showStep();
}

void ClassPage::showStep() {
  const StepOverview* step = shownStep();
  const LessonStep* told = lessonStep(stepId_);
  if (step == nullptr || told == nullptr) return;
  showing_ = true;
  stepTitle_->setText(words(told->title));
  const QString chosen = figure_->currentData().toString();
  figure_->clear();
  figure_->addItem(tr("Score"), QString());
  for (const FigureOverview& figure : step->figures) figure_->addItem(nameOfFigure(figure.name), words(figure.name));
  figure_->setCurrentIndex(std::max(0, figure_->findData(chosen)));
  const int n = figure_->currentIndex();
  const double level = passLevelOf(*told, session_.plan());
  const QLocale locale;
  if (n == 0) {
    Distribution percents = step->scores;
    for (double& value : percents.values) value *= 100.0;
    for (double* each :
         {&percents.lowest, &percents.lowerQuartile, &percents.median, &percents.upperQuartile, &percents.highest, &percents.mean})
      *each *= 100.0;
    chart_->show(percents, QStringLiteral("%"), 0.0, 100.0, 100.0 * level);
    numbers_->setText(percents.values.empty() ? QString()
                                              : tr("Median %1, mean %2; %3 of %4 passed, %5 left the step out.")
                                                    .arg(percent(step->scores.median), percent(step->scores.mean))
                                                    .arg(step->passed)
                                                    .arg(step->ended)
                                                    .arg(step->skipped));
    figure_->setToolTip({});
  } else {
    const FigureOverview& figure = step->figures[static_cast<std::size_t>(n - 1)];
    const double room = std::max(1e-6, 0.05 * (figure.values.highest - figure.values.lowest));
    chart_->show(figure.values, words(figure.unit), figure.values.lowest - room, figure.values.highest + room, std::nullopt);
    numbers_->setText(tr("Median %1, mean %2, from %3 to %4 %5")
                          .arg(locale.toString(figure.values.median, 'g', 4), locale.toString(figure.values.mean, 'g', 4),
                               locale.toString(figure.values.lowest, 'g', 4), locale.toString(figure.values.highest, 'g', 4),
                               words(figure.unit)));
    const Metric* metric = metricOf(figure.name);
    figure_->setToolTip(metric != nullptr ? words(metric->definition) : QString());
  }
  level_->setValue(100.0 * level);
  level_->setEnabled(!session_.isScoring());
  showing_ = false;
  showAttempts();
}

}  // namespace ew::review
