#include "ew/reports/class_report.h"

#include "attempt_parts.h"
#include "class_parts.h"
#include "report_words.h"

namespace ew {

using namespace reports;

namespace {

constexpr std::size_t kScoreParts = 20;

Message quartilesText(const FiveNumbers& numbers) {
  return say<"%1 (half of them from %2 to %3)">(percentText(numbers.median), percentText(numbers.lowerQuartile),
                                                percentText(numbers.upperQuartile));
}

std::string titleOf(const ClassOf& of, const ClassStep& step) { return stepTitle(of.lesson.words, step.stepId, step.title); }

ReportFacts summaryOf(const ClassOf& of) {
  const ClassFigures& figures = of.figures;
  ReportFacts facts;
  facts.rows = {{say<"Case">(), verbatim(of.lesson.caseTitle)}, {say<"Attempts">(), verbatim(std::to_string(of.attempts.size()))}};
  if (figures.unscored > 0)
    facts.rows.push_back({say<"Not scored yet">(), verbatim(std::to_string(figures.unscored)), ReportTone::caution});
  if (figures.scored == 0) return facts;
  facts.rows.push_back({say<"Passed">(), say<"%1 of %2">(figures.passed, figures.scored)});
  facts.rows.push_back({say<"Median score">(), quartilesText(fiveNumbersOf(figures.scores))});
  facts.rows.push_back({say<"Plan">(), of.lesson.plan.revision == 0 ? say<"none: tasks alone, at the lesson's pass levels">()
                                                                    : say<"revision %1">(of.lesson.plan.revision)});
  return facts;
}

/// Attempts scored by different plans or programs cannot be compared without a word.
std::optional<ReportParagraph> mixedScores(const ClassOf& of) {
  std::set<std::tuple<int, int>> kinds;
  for (const ReportAttempt& one : of.attempts)
    if (one.score) kinds.insert({one.score->planRevision, one.score->scoring});
  if (kinds.size() < 2) return std::nullopt;
  return ReportParagraph{
      say<"These scores were made by different plans or versions of scoring; score all attempts again before comparing them.">(),
      ReportTone::caution};
}

ReportParagraph hardestOf(const ClassOf& of) {
  if (!of.figures.hardest) return {say<"Nobody failed a step that counts.">(), ReportTone::good};
  const ClassStep& step = of.figures.steps[*of.figures.hardest];
  return {say<"Hardest step: '%1', which %2 of %3 did not pass.">(titleOf(of, step), step.failed + step.skipped, step.reached()),
          ReportTone::bad};
}

ReportPlot scoresPlot(const ClassOf& of) {
  return {say<"Scores of the lesson; dashed: what passes">(),
          HistogramPlot{countsIn(of.figures.scores, 0.0, 1.0, kScoreParts), 0.0, 1.0, true, say<"score">(), of.lesson.plan.passLevel}};
}

ReportPlot stepsPlot(const ClassOf& of) {
  StripPlot plot;
  plot.isShare = true;
  plot.axis = say<"score">();
  for (const ClassStep& step : of.figures.steps)
    if (step.weight > 0.0) plot.rows.push_back({verbatim(titleOf(of, step)), step.scores, step.passLevel, {}});
  return {say<"Scores of each step: attempts, quartiles as a box; dashed: what passes">(), std::move(plot)};
}

ReportTable stepsTableOf(const ClassOf& of) {
  ReportTable table{say<"Steps">(),
                    {{say<"Step">()},
                     {say<"Task">()},
                     {say<"Passed">(), true},
                     {say<"Not passed">(), true},
                     {say<"Skipped">(), true},
                     {say<"Not reached">(), true},
                     {say<"Median score">(), true},
                     {say<"Passes from">(), true}},
                    {}};
  for (std::size_t n = 0; n < of.figures.steps.size(); ++n) {
    const ClassStep& step = of.figures.steps[n];
    const bool isHardest = of.figures.hardest == n;
    const auto count = [](std::size_t number) { return ReportCell{verbatim(std::to_string(number))}; };
    ReportCell failed = count(step.failed);
    if (isHardest) failed.tone = ReportTone::bad;
    const Message title = verbatim(titleOf(of, step));
    table.rows.push_back({{isHardest ? say<"%1 (most fail here)">(title) : title},
                          {kindText(step.kind)},
                          count(step.passed),
                          std::move(failed),
                          count(step.skipped),
                          count(step.notReached),
                          {step.scores.empty() ? verbatim("–") : percentText(fiveNumbersOf(step.scores).median)},
                          {step.weight > 0.0 ? percentText(step.passLevel) : say<"does not count">()}});
  }
  return table;
}

void addWorth(const ClassOf& of, std::vector<ReportBlock>& blocks) {
  blocks.emplace_back(ReportHeading{2, say<"What this is worth">()});
  blocks.emplace_back(ReportParagraph{validitySentence()});
  std::vector<std::string> ids;
  for (const ClassStep& step : of.figures.steps)
    for (const ClassMetric& metric : step.metrics)
      if (metric.isMetric) ids.push_back(metric.id);
  if (!ids.empty()) blocks.emplace_back(metricsExplained(ids));
}

}  // namespace

ClassAttempt classAttemptOf(const ReportAttempt& attempt, const StandingsByAttempt& standings) {
  return classAttemptOf(attempt.attempt, attempt.result(), standingIn(standings, attempt.attempt.id), standingBy(attempt.ratings));
}

ClassFigures classFiguresOf(const std::vector<ReportAttempt>& attempts, const StandingsByAttempt& standings) {
  std::vector<ClassAttempt> all;
  for (const ReportAttempt& one : attempts) all.push_back(classAttemptOf(one, standings));
  return classFiguresOf(all);
}

ReportDocument classReport(const std::vector<ReportAttempt>& attempts, const ReportLesson& lesson, const Pseudonyms& codes,
                           const std::vector<std::string>& pages, const ReportOptions& options) {
  const ClassOf of{attempts, lesson, codes, pages, options, classFiguresOf(attempts, lesson.standings)};
  ReportDocument document;
  document.title = say<"%1: class">(attempts.empty() ? lesson.lessonTitle : lessonName(attempts.front().attempt, lesson));
  document.subtitle = verbatim(lesson.caseTitle);
  for (const ReportAttempt& one : attempts) document.at = std::max(document.at, newestOf(one));
  auto& blocks = document.blocks;
  blocks.emplace_back(summaryOf(of));
  if (attempts.empty())
    blocks.emplace_back(ReportParagraph{say<"Nobody has tried this lesson yet.">()});
  else if (of.figures.scored == 0)
    blocks.emplace_back(ReportParagraph{say<"No attempt has a score yet; score them first (echoweave assess).">(), ReportTone::caution});
  if (of.figures.scored > 0) {
    if (auto mixed = mixedScores(of)) blocks.emplace_back(std::move(*mixed));
    blocks.emplace_back(hardestOf(of));
    blocks.emplace_back(scoresPlot(of));
    blocks.emplace_back(stepsTableOf(of));
    blocks.emplace_back(stepsPlot(of));
    addPassLevels(of, blocks);
    addClassSteps(of, blocks);
  }
  addAgreement(of, blocks);
  addAttemptTable(of, blocks);
  addWorth(of, blocks);
  return document;
}

}  // namespace ew
