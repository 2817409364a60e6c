#include <algorithm>

#include "ew/reports/class_report.h"

namespace ew {
namespace {

/// What everybody who rated an attempt says of whoever made it.
Standing standingBy(const KeptRatings& ratings) {
  std::optional<bool> verdict;
  for (const KeptRating& each : ratings.ratings) {
    if (!each.rating.finished || each.rating.sawOthers) continue;
    const auto passed = passedBy(*each.form, each.rating);
    if (!passed) continue;
    if (verdict && *verdict != *passed) return Standing::unknown;
    verdict = passed;
  }
  if (!verdict) return Standing::unknown;
  return *verdict ? Standing::shouldPass : Standing::shouldFail;
}

ClassStep& stepOf(ClassFigures& figures, const StepScore& score) {
  const auto known =
      std::find_if(figures.steps.begin(), figures.steps.end(), [&](const ClassStep& one) { return one.stepId == score.stepId; });
  if (known != figures.steps.end()) return *known;
  ClassStep made;
  made.stepId = score.stepId;
  return figures.steps.emplace_back(std::move(made));
}

/// Values of the newest version alone: those of others mean something else.
void addMetric(ClassStep& step, const MetricValue& value) {
  auto known = std::find_if(step.metrics.begin(), step.metrics.end(), [&](const ClassMetric& one) { return one.id == value.id; });
  if (known == step.metrics.end()) {
    step.metrics.push_back({value.id, value.version, {}});
    known = step.metrics.end() - 1;
  }
  if (value.version < known->version) return;
  if (value.version > known->version) *known = {value.id, value.version, {}};
  known->values.push_back(value.value);
}

void addStepScore(ClassStep& step, const StepScore& score, double weight, bool isReached) {
  step.title = score.title;
  step.kind = score.kind;
  step.weight = weight;
  step.passLevel = score.passLevel;
  if (!isReached) {
    ++step.notReached;
    return;
  }
  switch (score.verdict) {
    case StepVerdict::skipped:
      ++step.skipped;
      return;
    case StepVerdict::handedIn:
      return;  // nobody has judged it yet
    case StepVerdict::passed:
      ++step.passed;
      break;
    case StepVerdict::failed:
      ++step.failed;
      break;
  }
  step.scores.push_back(score.score);
  for (const MetricValue& value : score.metrics) addMetric(step, value);
}

bool vary(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [&](double value) { return value != values.front(); });
}

/// Scores of the two groups that raters told apart.
struct Groups {
  std::vector<double> shouldFail, shouldPass;
  /// Of a group that is one and the same score the normal curve is none, and where it crosses the other means nothing.
  [[nodiscard]] std::optional<Estimate> passLevel() const {
    return vary(shouldFail) && vary(shouldPass) ? contrastingGroups(shouldFail, shouldPass) : std::nullopt;
  }
  void add(Standing standing, double score) {
    if (standing != Standing::unknown) (standing == Standing::shouldPass ? shouldPass : shouldFail).push_back(score);
  }
};

void suggest(ClassFigures& figures, const std::vector<ReportedAttempt>& attempts) {
  Groups lesson;
  std::map<std::string, Groups> steps;
  for (const ReportedAttempt& one : attempts) {
    const Standing standing = figures.standing[one.attempt.id] = standingBy(one.ratings);
    const AttemptResult result = one.result();
    if (!result.isKnown || !result.passed()) continue;
    figures.shouldPass += standing == Standing::shouldPass ? 1 : 0;
    figures.shouldFail += standing == Standing::shouldFail ? 1 : 0;
    lesson.add(standing, result.counted.score);
    for (const StepScore& step : result.counted.steps)
      if (one.attempt.outcomeOf(step.stepId) != nullptr && step.verdict != StepVerdict::skipped)
        steps[step.stepId].add(standing, step.score);
  }
  if (figures.shouldPass < 2 || figures.shouldFail < 2) return;
  figures.suggested = lesson.passLevel();
  for (ClassStep& step : figures.steps)
    if (step.weight > 0.0) step.suggested = steps[step.stepId].passLevel();
}

}  // namespace

double ClassStep::notPassedShare() const {
  return reached() == 0 ? 0.0 : static_cast<double>(failed + skipped) / static_cast<double>(reached());
}

ClassFigures classFiguresOf(const std::vector<ReportedAttempt>& attempts) {
  ClassFigures figures;
  for (const ReportedAttempt& one : attempts) {
    const AttemptResult result = one.result();
    if (!result.isKnown || !result.passed()) {
      ++figures.unscored;
      continue;
    }
    ++figures.scored;
    figures.passed += *result.passed() ? 1 : 0;
    figures.scores.push_back(result.counted.score);
    for (const StepScore& step : result.counted.steps)
      addStepScore(stepOf(figures, step), step, weightIn(result, step), one.attempt.outcomeOf(step.stepId) != nullptr);
  }
  for (std::size_t n = 0; n < figures.steps.size(); ++n) {
    const double share = figures.steps[n].weight > 0.0 ? figures.steps[n].notPassedShare() : 0.0;
    if (share > 0.0 && (!figures.hardest || share > figures.steps[*figures.hardest].notPassedShare())) figures.hardest = n;
  }
  suggest(figures, attempts);
  return figures;
}

}  // namespace ew
