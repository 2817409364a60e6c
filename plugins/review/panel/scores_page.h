#pragma once

#include <QWidget>
#include <functional>
#include <string>

#include "ew/assessment/assessment_plan.h"
#include "ew/assessment/attempt_result.h"
#include "ew/assessment/attempt_score.h"
#include "ew/assessment/metric_defaults.h"
#include "ew/library/attempt.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace ew {
class NumberField;
}

namespace ew::review {

class LessonScores;
class ReviewSelection;
class ReviewSession;
class ScanPair;

/// What the step is worth and what it is made of: figures beside the expert's, and what an instructor decides about it: pass level,
/// weights, and which figures count. A change is kept and the lesson's attempts are scored anew.
class ScoresPage final : public QWidget {
  Q_OBJECT

 public:
  explicit ScoresPage(ReviewSession& session, QWidget* parent = nullptr);

 private:
  QWidget* makePlan();
  QWidget* makeMetricPlan();
  void refresh();
  void showVerdict();
  [[nodiscard]] QString howItWasMade(const AttemptResult& result, const StepScore& counted, const StepOutcome& outcome) const;
  void showTable();
  void showPlan();
  void showMetricPlan();
  void changeStep(const std::function<void(StepPlan&)>& change);
  [[nodiscard]] std::string chosenMetric() const;

  const ReviewSelection& selection_;
  const ScanPair& scans_;
  LessonScores& scores_;
  QLabel* verdict_ = nullptr;
  QLabel* made_ = nullptr;
  QTableWidget* table_ = nullptr;
  QCheckBox* all_ = nullptr;
  MetricDefaults defaults_;
  QWidget* plan_ = nullptr;
  NumberField* level_ = nullptr;
  NumberField* weight_ = nullptr;
  NumberField* taskWeight_ = nullptr;
  QWidget* metricPlan_ = nullptr;
  QLabel* metricName_ = nullptr;
  NumberField* metricWeight_ = nullptr;
  NumberField* worst_ = nullptr;
  NumberField* best_ = nullptr;
  QPushButton* score_ = nullptr;
  QPushButton* report_ = nullptr;
  bool showing_ = false;
};

}  // namespace ew::review
