#include "ew/reports/csv.h"

#include <algorithm>

#include "ew/core/numbers.h"
#include "ew/library/timestamp.h"

namespace ew {
namespace {

/// One metric of one version, wherever it was worked out.
struct MetricColumn {
  std::string id;
  int version = 1;
  bool operator==(const MetricColumn&) const = default;
};

std::size_t placeOf(const std::string& id) {
  const auto& all = metrics();
  return static_cast<std::size_t>(std::find_if(all.begin(), all.end(), [&](const Metric& one) { return one.id == id; }) - all.begin());
}

/// In the order of the registry; of those it does not know any more, by name. A score that no longer counts has no line, so no column.
std::vector<MetricColumn> columnsOf(const std::vector<AttemptResult>& results) {
  std::vector<MetricColumn> columns;
  for (const AttemptResult& result : results)
    for (const StepScore& step : result.counted.steps)
      for (const MetricValue& value : step.metrics)
        if (const MetricColumn column{value.id, value.version}; std::find(columns.begin(), columns.end(), column) == columns.end())
          columns.push_back(column);
  std::sort(columns.begin(), columns.end(), [](const MetricColumn& a, const MetricColumn& b) {
    return std::tuple(placeOf(a.id), a.id, a.version) < std::tuple(placeOf(b.id), b.id, b.version);
  });
  return columns;
}

std::string titleOf(const MetricColumn& column) {
  const Metric* known = metricOf(column.id);
  const std::string unit = known == nullptr || known->unit.empty() ? "" : " [" + std::string(known->unit) + "]";
  return column.id + " v" + std::to_string(column.version) + unit;
}

const char* yes(bool is) { return is ? "yes" : "no"; }

class CsvLine {
 public:
  CsvLine& add(std::string_view text) { return put(csvText(text)); }
  CsvLine& add(double number) { return put(textOf(number)); }
  CsvLine& add(int number) { return put(std::to_string(number)); }
  CsvLine& skip(std::size_t fields = 1) {
    for (std::size_t n = 0; n < fields; ++n) put({});
    return *this;
  }
  [[nodiscard]] std::string text() const { return line_ + "\r\n"; }

 private:
  CsvLine& put(const std::string& field) {
    line_ += isFirst_ ? field : "," + field;
    isFirst_ = false;
    return *this;
  }
  std::string line_;
  bool isFirst_ = true;
};

constexpr std::string_view kColumns[] = {"attempt",
                                         "person",
                                         "case",
                                         "lesson",
                                         "started",
                                         "finished",
                                         "scored",
                                         "lesson_score",
                                         "lesson_passed",
                                         "lesson_verdict",
                                         "steps_passed",
                                         "steps_judged",
                                         "lesson_seconds [s]",
                                         "plan_revision",
                                         "scoring_version",
                                         "program",
                                         "score_made",
                                         "step",
                                         "step_title",
                                         "kind",
                                         "verdict",
                                         "score",
                                         "task_score",
                                         "pass_level",
                                         "weight",
                                         "seconds [s]",
                                         "hints",
                                         "judged_anew",
                                         "valid_poses [%]"};

CsvLine begun(const ReportAttempt& one, const AttemptResult& result, const Pseudonyms& codes, bool names) {
  CsvLine line;
  const Attempt& attempt = one.attempt;
  line.add(attempt.id).add(names ? attempt.person : codes.ofPerson(attempt.person)).add(attempt.caseId).add(attempt.lessonId);
  line.add(timestampText(attempt.startedAt)).add(attempt.finishedAt ? timestampText(*attempt.finishedAt) : "").add(yes(result.isScored));
  const bool isJudged = result.isKnown && result.passed();
  isJudged ? line.add(*result.score()).add(yes(*result.passed())) : line.skip(2);
  result.isKnown ? line.add(verdictWord(result).english()) : line.skip();
  isJudged ? line.add(static_cast<int>(result.stepsPassed)).add(static_cast<int>(result.stepsJudged)) : line.skip(2);
  line.add(result.worked_s);
  if (!result.isScored) return line.skip(4);
  const AttemptScore& score = result.counted;
  return line.add(score.planRevision).add(score.scoring).add(score.program).add(timestampText(score.madeAt));
}

/// Whether scoring has looked at the poses of a step: an earlier version wrote 1 of steps without a recording, too.
bool arePosesCounted(const StepScore& step, const StepOutcome* outcome) {
  return step.validShare && outcome != nullptr && !outcome->recording.empty();
}

std::string stepLine(CsvLine line, const AttemptResult& result, const StepScore& step, const StepOutcome* outcome,
                     const std::vector<MetricColumn>& columns) {
  line.add(step.stepId).add(step.title).add(step.kind).add(verdictWord(step.verdict).english());
  step.verdict == StepVerdict::handedIn ? line.skip(2) : line.add(step.score).add(step.task);  // nobody has judged it yet
  line.add(step.passLevel);
  line.add(weightIn(result, step));
  outcome == nullptr ? line.skip(2) : line.add(outcome->seconds).add(outcome->hints);
  line.add(yes(step.isJudgedAnew));
  arePosesCounted(step, outcome) ? line.add(100.0 * *step.validShare) : line.skip();
  for (const MetricColumn& column : columns) {
    const auto value = std::find_if(step.metrics.begin(), step.metrics.end(), [&](const MetricValue& one) {
      return MetricColumn{one.id, one.version} == column;
    });
    value == step.metrics.end() ? line.skip() : line.add(value->value);
  }
  return line.text();
}

/// Of a step of a lesson that nobody has any more.
std::string outcomeLine(CsvLine line, const StepOutcome& outcome, std::size_t columns) {
  line.add(outcome.stepId).skip(2).add(verdictWord(outcome.verdict).english());
  outcome.verdict == StepVerdict::handedIn ? line.skip(2) : line.add(outcome.score).add(outcome.score);
  line.skip(2);
  return line.add(outcome.seconds).add(outcome.hints).add(yes(false)).skip(1 + columns).text();
}

}  // namespace

std::string csvText(std::string_view text) {
  std::string made(text);
  if (!made.empty() && std::string_view("=+-@\t\r").find(made.front()) != std::string_view::npos) made.insert(0, 1, '\'');
  if (made.find_first_of("\",\r\n") == std::string::npos) return made;
  std::string quoted = "\"";
  for (const char letter : made) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

std::string csvOf(const std::vector<ReportAttempt>& attempts, const Pseudonyms& codes, bool names) {
  std::vector<AttemptResult> results;
  for (const ReportAttempt& one : attempts) results.push_back(one.result());
  const std::vector<MetricColumn> columns = columnsOf(results);
  CsvLine heads;
  for (const std::string_view name : kColumns) heads.add(name);
  for (const MetricColumn& column : columns) heads.add(titleOf(column));
  std::string table = heads.text();
  for (std::size_t n = 0; n < attempts.size(); ++n) {
    const ReportAttempt& one = attempts[n];
    const AttemptResult& result = results[n];
    const CsvLine begin = begun(one, result, codes, names);
    if (result.isKnown)
      for (const StepScore& step : result.counted.steps)
        table += stepLine(begin, result, step, one.attempt.outcomeOf(step.stepId), columns);
    else
      for (const StepOutcome& outcome : one.attempt.outcomes)
        if (one.attempt.outcomeOf(outcome.stepId) == &outcome) table += outcomeLine(begin, outcome, columns.size());
  }
  return table;
}

}  // namespace ew
