#include "logic/class_overview.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"

namespace ew::review {
namespace {

const StepResult* resultOf(const AttemptResult& attempt, const std::string& stepId) {
  for (const StepResult& each : attempt.steps)
    if (each.stepId == stepId) return &each;
  return nullptr;
}

StepOverview stepOverview(std::span<const AttemptResult> attempts, const std::string& stepId) {
  StepOverview made;
  made.stepId = stepId;
  std::vector<double> scores;
  std::vector<std::vector<double>> values;
  for (const AttemptResult& attempt : attempts) {
    const StepResult* result = resultOf(attempt, stepId);
    if (result == nullptr) continue;
    ++made.ended;
    made.passed += result->isPassed && !result->isSkipped ? 1 : 0;
    made.skipped += result->isSkipped ? 1 : 0;
    if (result->isSkipped) continue;
    scores.push_back(result->score);
    for (const StepResult::Figure& figure : result->figures) {
      const auto isSame = [&](const FigureOverview& each) { return each.name == figure.name && each.unit == figure.unit; };
      const auto known = std::find_if(made.figures.begin(), made.figures.end(), isSame);
      const auto n = static_cast<std::size_t>(known - made.figures.begin());
      if (known == made.figures.end()) {
        made.figures.push_back({figure.name, figure.unit, {}});
        values.emplace_back();
      }
      values[n].push_back(figure.value);
    }
  }
  made.scores = distributionOf(std::move(scores));
  for (std::size_t n = 0; n < values.size(); ++n) made.figures[n].values = distributionOf(std::move(values[n]));
  return made;
}

}  // namespace

Distribution distributionOf(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end());
  Distribution made{fiveNumbersOf(values), {}};
  made.values = std::move(values);
  return made;
}

std::vector<std::size_t> histogramOf(std::span<const double> values, double lowest, double highest, int bins) {
  EW_EXPECTS(bins > 0);
  const auto parts = static_cast<std::size_t>(bins);
  if (highest > lowest) return countsIn(values, lowest, highest, parts);
  std::vector<std::size_t> counts(parts, 0);
  counts.front() = static_cast<std::size_t>(std::count(values.begin(), values.end(), lowest));
  return counts;
}

ClassOverview overviewOf(std::span<const AttemptResult> attempts, std::span<const std::string> steps) {
  ClassOverview made;
  made.attempts = attempts.size();
  for (const std::string& step : steps) made.steps.push_back(stepOverview(attempts, step));
  for (std::size_t n = 0; n < made.steps.size(); ++n) {
    const double failed = made.steps[n].failedShare();
    if (failed > 0.0 && (!made.hardest || failed > made.steps[*made.hardest].failedShare())) made.hardest = n;
  }
  return made;
}

std::optional<Estimate> suggestedPassLevel(std::span<const AttemptResult> attempts, std::span<const Standing> standings,
                                           const std::string& stepId) {
  EW_EXPECTS(attempts.size() == standings.size());
  std::vector<double> failing, passing;
  for (std::size_t n = 0; n < attempts.size(); ++n) {
    const StepResult* result = resultOf(attempts[n], stepId);
    if (result == nullptr || result->isSkipped || standings[n] == Standing::unknown) continue;
    (standings[n] == Standing::competent ? passing : failing).push_back(result->score);
  }
  return contrastingGroups(failing, passing);
}

}  // namespace ew::review
