#include "panel/scores_page.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ew/assessment/metric.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/scroll_rows.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/report_button.h"
#include "panel/review_words.h"
#include "panel/session/review_session.h"

namespace ew::review {

namespace {

enum Column { kName, kValue, kExpert, kColumns };
constexpr double kMostWeight = 1000.0;

/// Three digits and the unit: "142 mm", "-1.84".
QString withUnit(double value, std::string_view unit) {
  const double size = std::abs(value);
  const int decimals = size >= 100.0 ? 0 : size >= 10.0 ? 1 : 2;
  QString text = QLocale().toString(value, 'f', decimals);
  if (!unit.empty()) text += QLatin1Char(' ') + (unit == "deg" ? QStringLiteral("°") : words(std::string(unit)));
  return text;
}

QString tipOf(const Metric& metric, const MetricDefaults& defaults, std::string_view kind) {
  QString tip =
      QStringLiteral("<p style='white-space:pre-wrap'><b>%1</b> (%2)<br>%3<br><i>%4</i><br>%5")
          .arg(words(metric.name).toHtmlEscaped(), ScoresPage::tr("version %1").arg(metric.version),
               words(metric.definition).toHtmlEscaped(), words(metric.source).toHtmlEscaped(), words(metric.validity).toHtmlEscaped());
  if (!defaults.isOn(metric.id, kind)) {
    const auto area = defaults.areaOf(metric.id, kind);
    const auto number = [](double value) { return QLocale().toString(value, 'f', 2); };
    tip += QStringLiteral("<br>") +
           (area ? ScoresPage::tr("Off by default: it tells simulated novices from experts with an area of %1 (%2 to %3).")
                       .arg(number(area->value), number(area->low), number(area->high))
                 : ScoresPage::tr("Off by default: it was not studied."));
  }
  return tip + QStringLiteral("</p>");
}

}  // namespace

ScoresPage::ScoresPage(ReviewSession& session, QWidget* parent)
    : QWidget(parent), selection_(session.selection()), scans_(session.scans()), scores_(session.scores()) {
  setObjectName(QStringLiteral("reviewScores"));
  if (const auto resources = resourceFolder())
    if (auto read = MetricDefaults::read(*resources)) defaults_ = std::move(*read);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new ScrollRows(2 * kGrid_px);
  auto* rows = scroll->rows();
  verdict_ = headingLabel({});
  verdict_->setObjectName(QStringLiteral("reviewVerdict"));
  verdict_->setWordWrap(true);
  rows->addWidget(verdict_);
  made_ = quietLabel({});
  rows->addWidget(made_);
  table_ = new QTableWidget(0, kColumns);
  table_->setObjectName(QStringLiteral("reviewMetrics"));
  table_->setAccessibleName(tr("Figures of this step"));
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);  // long names take two lines
  setLook(table_, Look::small);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setShowGrid(false);
  table_->setWordWrap(true);
  table_->setTabKeyNavigation(false);
  holdLeastHeight(*table_, 180);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    if (!showing_) showMetricPlan();
  });
  rows->addWidget(table_, 1);
  all_ = new QCheckBox(tr("Also figures that are off by default"));
  all_->setObjectName(QStringLiteral("reviewAllFigures"));
  all_->setToolTip(
      tr("Figures that did not tell simulated novices from experts, or were not studied; one that is given a weight counts all the same"));
  connect(all_, &QCheckBox::toggled, this, &ScoresPage::refresh);
  rows->addWidget(all_);
  rows->addWidget(makeMetricPlan());
  rows->addWidget(makePlan());
  score_ = new QPushButton(tr("Score the attempts"));
  score_->setObjectName(QStringLiteral("reviewScore"));
  score_->setToolTip(tr("Works out all scores of this lesson from what was recorded; earlier scores are kept"));
  connect(score_, &QPushButton::clicked, this, [this] { scores_.scoreAll(); });
  auto* buttons = new QHBoxLayout;
  report_ = new ReportButton(session.reports(), false);
  buttons->addWidget(score_, 1);
  buttons->addWidget(report_, 1);
  rows->addLayout(buttons);
  outer->addWidget(scroll);
  connect(&scans_, &ScanPair::changed, this, &ScoresPage::refresh);
  connect(&selection_, &ReviewSelection::changed, this, &ScoresPage::refresh);
  connect(&scores_, &LessonScores::changed, this, &ScoresPage::refresh);
  refresh();
}

QWidget* ScoresPage::makePlan() {
  plan_ = new QWidget;
  auto* form = new QFormLayout(plan_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setSpacing(kGrid_px);
  form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
  const auto field = [&](const char* name, const QString& title, const QString& tip, double most, const QString& unit) {
    auto* made = new NumberField(0.0, most, unit.isEmpty() ? 1 : 0, unit);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    made->setAccessibleName(title);
    made->setKeyboardTracking(false);
    form->addRow(title, made);
    return made;
  };
  level_ = field("reviewLevel", tr("Pass level"), tr("The least score that passes this step"), 100.0, QStringLiteral("%"));
  weight_ = field("reviewWeight", tr("Weight in the lesson"), tr("How much this step counts in the score of the lesson, beside the others"),
                  kMostWeight, {});
  taskWeight_ = field("reviewTaskWeight", tr("Weight of the task"),
                      tr("How much the task itself counts in the score of the step, beside the figures that count"), kMostWeight, {});
  connect(level_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double value) { changeStep([=](StepPlan& step) { step.passLevel = value / 100.0; }); });
  connect(weight_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double value) { changeStep([=](StepPlan& step) { step.weight = value; }); });
  connect(taskWeight_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double value) { changeStep([=](StepPlan& step) { step.taskWeight = value; }); });
  return plan_;
}

/// How the chosen figure counts; a weight of 0: not at all.
QWidget* ScoresPage::makeMetricPlan() {
  metricPlan_ = new QWidget;
  auto* form = new QFormLayout(metricPlan_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setSpacing(kGrid_px);
  form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
  metricName_ = headingLabel({});
  metricName_->setWordWrap(true);
  form->addRow(metricName_);
  const auto field = [&](const char* name, const QString& title, const QString& tip, double least, double most) {
    auto* made = new NumberField(least, most, 2, {});
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    made->setAccessibleName(title);
    made->setKeyboardTracking(false);
    form->addRow(title, made);
    connect(made, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] {
      const std::string id = chosenMetric();
      if (showing_ || id.empty()) return;
      changeStep([this, id](StepPlan& step) {
        std::erase_if(step.metrics, [&](const MetricWeight& each) { return each.metric == id; });
        if (metricWeight_->value() > 0.0 && worst_->value() != best_->value())
          step.metrics.push_back({id, metricWeight_->value(), worst_->value(), best_->value()});
      });
    });
    return made;
  };
  metricWeight_ = field("reviewMetricWeight", tr("Counts with weight"), tr("0: this figure does not count"), 0.0, kMostWeight);
  worst_ = field("reviewWorst", tr("Worth nothing at"), tr("A figure like this, or worse, gives nothing"), -1e6, 1e6);
  best_ = field("reviewBest", tr("Worth all at"), tr("A figure like this, or better, gives everything"), -1e6, 1e6);
  return metricPlan_;
}

std::string ScoresPage::chosenMetric() const {
  const auto rows = table_->selectionModel()->selectedRows();
  return rows.isEmpty() ? std::string() : table_->item(rows.front().row(), kName)->data(Qt::UserRole).toString().toStdString();
}

void ScoresPage::changeStep(const std::function<void(StepPlan&)>& change) {
  if (showing_ || selection_.step() == nullptr || selection_.lesson() == nullptr) return;
  AssessmentPlan plan = scores_.plan();
  change(plan.at(selection_.step()->id));
  scores_.keepPlan(std::move(plan));
}

void ScoresPage::refresh() {
  showing_ = true;
  showVerdict();
  showTable();
  showPlan();
  showing_ = false;
  showMetricPlan();
}

QString ScoresPage::howItWasMade(const AttemptResult& result, const StepScore& counted, const StepOutcome& outcome) const {
  if (!result.isScored)
    return latestScore(selection_.attempt()->first) ? tr("As it was judged in the lesson; its last score no longer counts.")
                                                    : tr("As it was judged in the lesson; it was not scored since.");
  const QString task = percent(counted.task);
  // An earlier version wrote a share of steps without a recording, too.
  return counted.validShare && !outcome.recording.empty()
             ? tr("The task alone %1. Poses known in %2 of the images. Scored with revision %3 of what counts.")
                   .arg(task, percent(*counted.validShare))
                   .arg(result.counted.planRevision)
             : tr("The task alone %1. Scored with revision %2 of what counts.").arg(task).arg(result.counted.planRevision);
}

void ScoresPage::showVerdict() {
  const LessonStep* step = selection_.step();
  made_->setText({});
  if (step == nullptr) return verdict_->setText(tr("No step is chosen"));
  const StepOutcome* outcome = selection_.attempt() != nullptr ? selection_.attempt()->second.outcomeOf(step->id) : nullptr;
  if (outcome == nullptr || !selection_.attemptNumber()) return verdict_->setText(tr("This attempt has not ended this step"));
  const AttemptResult result = scores_.resultOf(*selection_.attemptNumber());
  const StepScore* counted = result.counted.of(step->id);
  const QString verdict = words(verdictWord(counted != nullptr ? counted->verdict : outcome->verdict));
  if (counted == nullptr || counted->verdict == StepVerdict::handedIn) {  // without figures: nobody has judged it
    verdict_->setText(verdict);
    return;
  }
  verdict_->setText(
      tr("%1, pass level %2: %3").arg(percentBeside(counted->score, counted->passLevel), percent(counted->passLevel), verdict));
  made_->setText(howItWasMade(result, *counted, *outcome));
}

void ScoresPage::showTable() {
  const std::string before = chosenMetric();
  const std::vector<MetricValue> own = scores_.metricsOf(scans_.opened(kReviewed)), others = scores_.metricsOf(scans_.opened(kCompared));
  const StepPlan* plan = selection_.step() != nullptr ? scores_.plan().of(selection_.step()->id) : nullptr;
  table_->setHorizontalHeaderLabels({tr("Figure"), wordOf(Who::trainee), wordOf(Who::expert)});
  table_->setRowCount(0);
  const std::string_view kind = selection_.step() != nullptr ? taskWord(selection_.step()->task) : std::string_view();
  bool areAll = true;
  for (const Metric& metric : metrics()) {
    const auto value = valueOf(own, metric.id), other = valueOf(others, metric.id);
    if (!value && !other) continue;
    const bool counts = plan != nullptr && std::any_of(plan->metrics.begin(), plan->metrics.end(),
                                                       [&](const MetricWeight& each) { return each.metric == metric.id; });
    const bool isOn = counts || defaults_.isOn(metric.id, kind);
    areAll = areAll && isOn;
    if (!isOn && !all_->isChecked()) continue;
    const int row = table_->rowCount();
    table_->insertRow(row);
    auto* name = new QTableWidgetItem(counts ? tr("%1 (counts)").arg(words(metric.name)) : words(metric.name));
    name->setData(Qt::UserRole, words(std::string(metric.id)));
    name->setToolTip(tipOf(metric, defaults_, kind));
    table_->setItem(row, kName, name);
    const auto put = [&](int column, const std::optional<double>& figure) {
      auto* item = new QTableWidgetItem(figure ? withUnit(*figure, metric.unit) : QStringLiteral("–"));
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setToolTip(tipOf(metric, defaults_, kind));
      table_->setItem(row, column, item);
    };
    put(kValue, value);
    put(kExpert, other);
    if (before == metric.id) table_->selectRow(row);
  }
  table_->setVisible(table_->rowCount() > 0);
  all_->setVisible(!areAll);
}

void ScoresPage::showPlan() {
  const LessonStep* step = selection_.step();
  plan_->setVisible(step != nullptr && selection_.lesson() != nullptr);
  score_->setVisible(selection_.lesson() != nullptr && !selection_.lesson()->attempts.empty());
  report_->setVisible(selection_.attempt() != nullptr);
  score_->setEnabled(!scores_.isScoring());
  score_->setText(scores_.isScoring() ? tr("Scoring …") : tr("Score the attempts"));
  if (step == nullptr) return;
  const StepPlan* plan = scores_.plan().of(step->id);
  level_->setValue(100.0 * passLevelOf(*step, scores_.plan()));
  weight_->setValue(weightOf(*step, scores_.plan()));
  taskWeight_->setValue(plan != nullptr ? plan->taskWeight : 1.0);
}

void ScoresPage::showMetricPlan() {
  const std::string id = chosenMetric();
  const Metric* metric = metricOf(id);
  metricPlan_->setVisible(metric != nullptr && selection_.step() != nullptr);
  if (metric == nullptr || selection_.step() == nullptr) return;
  showing_ = true;
  const StepPlan* plan = scores_.plan().of(selection_.step()->id);
  MetricWeight shown{id, 0.0, 0.0, 0.0};
  bool isKnown = false;
  for (const MetricWeight& each : plan != nullptr ? plan->metrics : std::vector<MetricWeight>{})
    if (each.metric == id) {
      shown = each;
      isKnown = true;
    }
  if (!isKnown) {  // a beginning that can be mended: the expert's figure is worth all, half or twice as much nothing
    const double best = valueOf(scores_.metricsOf(scans_.opened(kCompared)), id).value_or(0.0);
    shown.best = best;
    shown.worst = metric->better == Better::less ? best + std::max(1.0, std::abs(best)) : best - std::max(1.0, std::abs(best));
  }
  const QString unit = metric->unit.empty() ? QString() : QLatin1Char(' ') + words(std::string(metric->unit));
  metricName_->setText(words(metric->name));
  metricWeight_->setValue(shown.weight);
  for (auto* each : {worst_, best_}) each->setSuffix(unit);
  worst_->setValue(shown.worst);
  best_->setValue(shown.best);
  showing_ = false;
}

}  // namespace ew::review
