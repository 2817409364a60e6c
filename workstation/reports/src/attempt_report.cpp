#include "ew/reports/attempt_report.h"

#include <algorithm>

#include "attempt_parts.h"
#include "report_words.h"

namespace ew {

using namespace reports;

namespace {

/// Time from the start at which a step ended; of attempts whose clock nobody set, by the time that the steps took.
struct StepTime {
  double begin_s = 0.0, end_s = 0.0;
};
std::vector<StepTime> timesOf(const Attempt& attempt) {
  std::vector<StepTime> times;
  double sum_s = 0.0;
  for (const StepOutcome& outcome : attempt.outcomes) {
    const double byClock_s = std::chrono::duration<double>(outcome.at - attempt.startedAt).count();
    const bool hasClock = outcome.at != std::chrono::sys_seconds{} && byClock_s >= sum_s + outcome.seconds - 1.0;
    const double end_s = hasClock ? byClock_s : sum_s + outcome.seconds;
    times.push_back({std::max(0.0, end_s - outcome.seconds), end_s});
    sum_s = end_s;
  }
  return times;
}

ReportPlot timeLineOf(const ReportAttempt& one, const AttemptResult& result, const ReportLesson& lesson) {
  TimeLinePlot plot;
  const auto times = timesOf(one.attempt);
  std::vector<std::string> rows;
  for (std::size_t n = 0; n < times.size(); ++n) {
    const StepOutcome& outcome = one.attempt.outcomes[n];
    const auto known = std::find(rows.begin(), rows.end(), outcome.stepId);
    const auto row = static_cast<std::size_t>(known - rows.begin());
    if (known == rows.end()) {
      rows.push_back(outcome.stepId);
      const StepScore* scored = result.counted.of(outcome.stepId);
      plot.rows.push_back({verbatim(stepTitle(lesson.words, outcome.stepId, scored == nullptr ? "" : scored->title)), {}});
    }
    plot.rows[row].spans.push_back({times[n].begin_s, times[n].end_s, outcome.verdict == StepVerdict::passed});
    plot.end_s = std::max(plot.end_s, times[n].end_s);
  }
  return {say<"When the steps were worked on; hollow: not passed then">(), std::move(plot)};
}

/// Of a step as it counts in this attempt.
Message verdictIn(const Attempt& attempt, const StepScore& step) {
  return attempt.outcomeOf(step.stepId) == nullptr ? say<"not reached">() : verdictWord(step.verdict);
}

ReportPlot barsOf(const ReportAttempt& one, const AttemptResult& result, const ReportLesson& lesson) {
  BarsPlot plot;
  for (const StepScore& step : result.counted.steps) {
    if (weightIn(result, step) <= 0.0) continue;
    const Message says = joined({scoreText(step.score, step.passLevel), verdictIn(one.attempt, step)}, ", ");
    plot.bars.push_back({verbatim(stepTitle(lesson.words, step.stepId, step.title)), step.score, step.passLevel,
                         step.verdict == StepVerdict::passed, says});
  }
  return {say<"Score of each step that counts; dashed: what passes">(), std::move(plot)};
}

ReportTable stepsTable(const ReportAttempt& one, const AttemptResult& result, const ReportLesson& lesson) {
  ReportTable table{say<"Steps">(),
                    {{say<"Step">()},
                     {say<"Task">()},
                     {say<"Verdict">()},
                     {say<"Score">(), true},
                     {say<"Passes from">(), true},
                     {say<"Weight">(), true},
                     {say<"Time">(), true},
                     {say<"Hints">(), true}},
                    {}};
  for (const StepScore& step : result.counted.steps) {
    const StepOutcome* outcome = one.attempt.outcomeOf(step.stepId);
    const Message none = verbatim("–");
    const double weight = weightIn(result, step);
    table.rows.push_back({{verbatim(stepTitle(lesson.words, step.stepId, step.title))},
                          {kindText(step.kind)},
                          {verdictIn(one.attempt, step), toneOf(step.verdict)},
                          {step.verdict == StepVerdict::handedIn ? none : scoreText(step.score, step.passLevel)},
                          {weight > 0.0 ? percentText(step.passLevel) : none},
                          {figureText(weight, "")},
                          {outcome == nullptr ? none : durationText(outcome->seconds)},
                          {outcome == nullptr ? none : figureText(outcome->hints, "")}});
  }
  return table;
}

ReportFacts factsOf(const ReportAttempt& one, const AttemptResult& result, const ReportLesson& lesson, const std::string& who) {
  ReportFacts facts;
  facts.rows = {{say<"Trainee">(), verbatim(who)},
                {say<"Case">(), verbatim(lesson.caseTitle)},
                {say<"Lesson">(), verbatim(lessonName(one.attempt, lesson))},
                {say<"Began">(), momentWords(one.attempt.startedAt)},
                {say<"Ended">(), one.attempt.finishedAt ? momentWords(*one.attempt.finishedAt) : say<"not finished">()},
                {say<"Time on steps">(), durationText(result.worked_s)}};
  if (!result.isKnown) {
    facts.rows.push_back({say<"Score">(), one.score ? say<"none that counts now">() : say<"not scored yet">(), ReportTone::caution});
    return facts;
  }
  if (const auto score = result.score()) facts.rows.push_back({say<"Score">(), percentText(*score)});
  facts.rows.push_back({say<"Verdict">(), verdictWord(result), toneOf(result)});
  if (result.passed()) facts.rows.push_back({say<"Steps passed">(), say<"%1 of %2">(result.stepsPassed, result.stepsJudged)});
  return facts;
}

}  // namespace

std::string reviewerIn(const ReportOptions& options, const Pseudonyms& codes, const std::string& person) {
  return options.names ? calledIn(options, codes, person) : codes.ofReviewer(person);
}

std::string calledIn(const ReportOptions& options, const Pseudonyms& codes, const std::string& person) {
  if (!options.names) return codes.ofPerson(person);
  return person.empty() ? options.say(say<"without a name">()) : person;
}

ReportDocument attemptReport(const ReportAttempt& one, const ReportLesson& lesson, const Pseudonyms& codes, const ReportOptions& options) {
  const std::string who = calledIn(options, codes, one.attempt.person);
  ReportDocument document;
  document.title = say<"%1: %2">(lessonName(one.attempt, lesson), who);
  document.subtitle = joined({verbatim(lesson.caseTitle), momentWords(one.attempt.startedAt)}, " · ");
  document.at = newestOf(one);
  auto& blocks = document.blocks;
  const AttemptResult result = one.result();
  blocks.emplace_back(factsOf(one, result, lesson, who));
  if (const Message there = systemVerdictRemark(result, result.masteryScore); !there.empty())
    blocks.emplace_back(ReportParagraph{there, ReportTone::caution});
  if (result.isKnown) {
    if (result.passed()) blocks.emplace_back(barsOf(one, result, lesson));
    blocks.emplace_back(stepsTable(one, result, lesson));
  }
  if (!one.attempt.outcomes.empty()) blocks.emplace_back(timeLineOf(one, result, lesson));
  const PartOf part{one, result, lesson, codes, options};
  addSteps(part, blocks);
  addRatings(part, blocks);
  addEarlierScores(part, blocks);
  addOrigin(part, blocks);
  addMeaning(part, blocks);
  return document;
}

}  // namespace ew
