#include "ew/assessment/class_figures.h"
#include "ew/core/figure.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace ew {
namespace {

using ClassInOrder = std::vector<const ClassAttempt*>;

/// By time: the draws of intervals depend on the order, and window and report list a class differently.
ClassInOrder inOrder(const std::vector<ClassAttempt>& attempts) {
  ClassInOrder ordered;
  for (const ClassAttempt& one : attempts) ordered.push_back(&one);
  std::stable_sort(ordered.begin(), ordered.end(), [](const ClassAttempt* a, const ClassAttempt* b) {
    return std::tie(a->result.startedAt, a->id) < std::tie(b->result.startedAt, b->id);
  });
  return ordered;
}

ClassStep& classStepOf(ClassFigures& figures, const StepScore& score) {
  const auto known =
      std::find_if(figures.steps.begin(), figures.steps.end(), [&](const ClassStep& one) { return one.stepId == score.stepId; });
  if (known != figures.steps.end()) return *known;
  ClassStep made;
  made.stepId = score.stepId;
  return figures.steps.emplace_back(std::move(made));
}

/// Values of the newest version alone: those of others mean something else. @param kind without values
void addFigure(ClassStep& step, const ClassMetric& kind, double value) {
  auto known = std::find_if(step.metrics.begin(), step.metrics.end(), [&](const ClassMetric& one) {
    return one.isMetric == kind.isMetric && one.id == kind.id && one.unit == kind.unit;
  });
  if (known == step.metrics.end()) {
    step.metrics.push_back(kind);
    known = std::prev(step.metrics.end());
  }
  if (kind.version < known->version) return;
  if (kind.version > known->version) *known = kind;
  known->values.push_back(value);
}

void addFigures(ClassStep& step, const StepScore& score, bool isScored) {
  for (const MetricValue& value : score.metrics) {
    const Metric* metric = metricOf(value.id);
    const std::string unit = metric != nullptr ? std::string(metric->unit) : std::string();
    addFigure(step, {value.id, value.version, unit, true, {}}, value.value);
  }
  if (isScored) return;
  for (const Figure& figure : score.figures) addFigure(step, {figure.name, 1, figure.unit, false, {}}, figure.value);
}

void addStep(ClassStep& step, const StepScore& score, const ClassAttempt& attempt) {
  step.title = score.title;
  step.kind = score.kind;
  step.weight = weightIn(attempt.result, score);
  step.passLevel = score.passLevel;
  if (!attempt.ended.contains(score.stepId)) {
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
  addFigures(step, score, attempt.result.isScored);
}

void addClassAttempt(ClassFigures& figures, const ClassAttempt& attempt) {
  figures.standing[attempt.id] = attempt.standing();
  const AttemptResult& result = attempt.result;
  if (const auto passed = result.passed()) {
    ++figures.scored;
    figures.passed += *passed ? 1 : 0;
    figures.scores.push_back(result.counted.score);
  } else {
    ++figures.unscored;
  }
  if (!result.isKnown) return;
  for (const StepScore& score : result.counted.steps) addStep(classStepOf(figures, score), score, attempt);
}

std::optional<std::size_t> hardestStep(const std::vector<ClassStep>& steps) {
  std::optional<std::size_t> hardest;
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const double share = steps[n].weight > 0.0 ? steps[n].notPassedShare() : 0.0;
    if (share > 0.0 && (!hardest || share > steps[*hardest].notPassedShare())) hardest = n;
  }
  return hardest;
}

bool scoresDiffer(const std::vector<double>& scores) {
  return std::any_of(scores.begin(), scores.end(), [&](double score) { return score != scores.front(); });
}

/// Scores of those who should pass and of those who should not.
struct ContrastingScores {
  std::vector<double> shouldFail, shouldPass;
  [[nodiscard]] std::optional<Estimate> passLevel() const {
    return scoresDiffer(shouldFail) && scoresDiffer(shouldPass) ? contrastingGroups(shouldFail, shouldPass) : std::nullopt;
  }
  void add(Standing standing, double score) { (standing == Standing::shouldPass ? shouldPass : shouldFail).push_back(score); }
};

void suggestLevels(ClassFigures& figures, const ClassInOrder& attempts) {
  ContrastingScores lesson;
  std::map<std::string, ContrastingScores> steps;
  for (const ClassAttempt* one : attempts) {
    const Standing standing = one->standing();
    if (standing == Standing::unknown) continue;
    if (one->result.passed()) lesson.add(standing, one->result.counted.score);
    for (const StepScore& score : one->result.counted.steps)
      if (one->judged(score.stepId) != nullptr && score.verdict != StepVerdict::skipped) steps[score.stepId].add(standing, score.score);
  }
  figures.shouldPass = lesson.shouldPass.size();
  figures.shouldFail = lesson.shouldFail.size();
  figures.suggested = lesson.passLevel();
  for (ClassStep& step : figures.steps) {
    const ContrastingScores& groups = steps[step.stepId];
    step.shouldPass = groups.shouldPass.size();
    step.shouldFail = groups.shouldFail.size();
    if (step.weight > 0.0) step.suggested = groups.passLevel();
  }
}

}  // namespace

Standing standingBy(const RatingRecords& ratings) {
  std::optional<bool> verdict;
  for (const RatingRecord& each : ratings.ratings) {
    if (!each.rating.finished || each.rating.sawOthers) continue;
    const auto passed = passedBy(*each.form, each.rating);
    if (!passed) continue;
    if (verdict && *verdict != *passed) return Standing::unknown;
    verdict = passed;
  }
  if (!verdict) return Standing::unknown;
  return *verdict ? Standing::shouldPass : Standing::shouldFail;
}

const StepScore* ClassAttempt::judged(const std::string& stepId) const {
  const StepScore* score = result.isKnown && ended.contains(stepId) ? result.counted.of(stepId) : nullptr;
  return score != nullptr && score->verdict != StepVerdict::handedIn ? score : nullptr;
}

ClassAttempt classAttemptOf(const Attempt& attempt, AttemptResult result, Standing said, Standing byRaters) {
  ClassAttempt made{attempt.id, std::move(result), {}, said, byRaters};
  for (const StepOutcome& outcome : attempt.outcomes) made.ended.insert(outcome.stepId);
  return made;
}

double ClassStep::notPassedShare() const {
  return reached() == 0 ? 0.0 : static_cast<double>(failed + skipped) / static_cast<double>(reached());
}

ClassFigures classFiguresOf(const std::vector<ClassAttempt>& attempts) {
  const ClassInOrder ordered = inOrder(attempts);
  ClassFigures figures;
  for (const ClassAttempt* one : ordered) addClassAttempt(figures, *one);
  figures.hardest = hardestStep(figures.steps);
  suggestLevels(figures, ordered);
  return figures;
}

}  // namespace ew
