#include <algorithm>
#include <map>
#include <optional>

#include "attempt_parts.h"
#include "ew/core/figure.h"
#include "ew/scanning/recording.h"
#include "report_words.h"

namespace ew::reports {
namespace {

/// With what it has to reach, or why it has to reach nothing.
Message stepScoreText(const AttemptResult& result, const StepScore& step) {
  if (!result.isKnown) return percentText(step.score);  // nobody knows what counts, and from where on it passes
  if (weightIn(result, step) <= 0.0) return say<"%1 (does not count)">(percentText(step.score));
  const Message score = scoreText(step.score, step.passLevel), level = percentText(step.passLevel);
  return result.areAlike ? say<"%1 (passes from %2; all steps count alike)">(score, level) : say<"%1 (passes from %2)">(score, level);
}

ReportFacts stepFacts(const AttemptResult& result, const StepScore& step, const StepOutcome* outcome, std::size_t tries) {
  ReportFacts facts;
  facts.rows.push_back({say<"Task">(), kindText(step.kind)});
  facts.rows.push_back({say<"Verdict">(), outcome == nullptr ? say<"not reached">() : verdictWord(step.verdict), toneOf(step.verdict)});
  if (outcome == nullptr) return facts;
  const bool isJudged = step.verdict != StepVerdict::skipped && step.verdict != StepVerdict::handedIn;
  if (step.verdict != StepVerdict::handedIn) facts.rows.push_back({say<"Score">(), stepScoreText(result, step)});
  if (step.task != step.score) facts.rows.push_back({say<"Of the task itself">(), percentText(step.task)});
  facts.rows.push_back({say<"Time">(), durationText(outcome->seconds)});
  if (outcome->hints > 0) facts.rows.push_back({say<"Hints">(), figureText(outcome->hints, "")});
  if (tries > 1) facts.rows.push_back({say<"Tries">(), say<"%1, of which the last one counts">(tries)});
  if (step.validShare && *step.validShare < 1.0) facts.rows.push_back({say<"Images with a usable pose">(), percentText(*step.validShare)});
  if (result.isScored && !step.isJudgedAnew && isJudged)
    facts.rows.push_back({say<"Judged">(), say<"as in the lesson; its raw data are not there">(), ReportTone::caution});
  return facts;
}

/// The weight that a plan gives a metric; empty: it does not count, or nobody knows any more.
std::optional<double> weightInPlan(const PartOf& of, const StepScore& step, const std::string& metric) {
  if (of.lesson.plan.revision != of.result.counted.planRevision) return std::nullopt;
  if (const StepPlan* plan = of.lesson.plan.of(step.stepId))
    for (const MetricWeight& weight : plan->metrics)
      if (weight.metric == metric) return weight.weight;
  return std::nullopt;
}

/// What the expert has in the same version of a metric; null: nothing to compare with.
const MetricValue* expertsOf(const PartOf& of, const StepScore& step, const MetricValue& value) {
  const StepScore* expert = of.lesson.expert ? of.lesson.expert->of(step.stepId) : nullptr;
  if (expert == nullptr || of.lesson.expert->attemptId == of.one.attempt.id) return nullptr;
  for (const MetricValue& other : expert->metrics)
    if (other.id == value.id && other.version == value.version) return &other;
  return nullptr;
}

/// Metrics that count or are on, beside the expert's where there are any. Those that are off by default are counted alone: a page of them
/// says nothing.
void addMetrics(const PartOf& of, const StepScore& step, Blocks& blocks) {
  const bool isPlanKnown = of.lesson.plan.revision == of.result.counted.planRevision;
  std::vector<const MetricValue*> listed;
  for (const MetricValue& value : step.metrics)
    if (weightInPlan(of, step, value.id) || !of.lesson.offByDefault.contains({step.kind, value.id})) listed.push_back(&value);
  const bool hasExpert =
      std::any_of(listed.begin(), listed.end(), [&](const MetricValue* value) { return expertsOf(of, step, *value) != nullptr; });
  ReportTable table{say<"Metrics">(), {{say<"Metric">()}, {say<"Value">(), true}}, {}};
  if (hasExpert) table.columns.push_back({say<"Expert">(), true});
  table.columns.push_back({say<"Version">(), true});
  table.columns.push_back({say<"In the score">()});
  for (const MetricValue* value : listed) {
    auto& row = table.rows.emplace_back();
    row.push_back({metricName(value->id)});
    row.push_back({figureText(value->value, metricUnit(value->id))});
    const MetricValue* expert = expertsOf(of, step, *value);
    if (hasExpert) row.push_back({expert != nullptr ? figureText(expert->value, metricUnit(value->id)) : verbatim("–")});
    row.push_back({verbatim(std::to_string(value->version))});
    const auto weight = weightInPlan(of, step, value->id);
    row.push_back({weight ? say<"weight %1">(figureText(*weight, "")) : isPlanKnown ? say<"no">() : Message()});
  }
  if (!table.rows.empty()) blocks.emplace_back(std::move(table));
  if (const std::size_t left = step.metrics.size() - listed.size(); left > 0)
    blocks.emplace_back(ReportParagraph{
        say<"Left out, since they are off by default and do not count: %1 of %2 metrics. The table has all.">(left, step.metrics.size()),
        ReportTone::soft});
}

void addFigures(const std::vector<Figure>& figures, Blocks& blocks) {
  if (figures.empty()) return;
  ReportTable table{say<"What the task was judged by">(), {{say<"Figure">()}, {say<"Value">(), true}}, {}};
  for (const Figure& figure : figures) table.rows.push_back({{figureName(figure.name)}, {figureText(figure.value, figure.unit)}});
  blocks.emplace_back(std::move(table));
}

void addRemarks(const PartOf& of, const std::vector<AttemptRemark>& remarks, Blocks& blocks) {
  ReportList list;
  for (const AttemptRemark& remark : remarks)
    list.items.push_back({inWordsOf(of.lesson.words, remark.text), remark.good ? ReportTone::good : ReportTone::bad});
  if (!list.items.empty()) blocks.emplace_back(std::move(list));
}

/// The recordings of a step: each is read once, and only when it is needed.
class StepRecordings {
 public:
  explicit StepRecordings(const std::filesystem::path& folder) : folder_(folder) {}
  const Result<ScanRecording>& of(const std::string& name) {
    const auto known = read_.find(name);
    return known != read_.end() ? known->second
                                : read_.emplace(name, readRecording(folder_ / std::filesystem::path(name).filename())).first->second;
  }
  /// Of a moment on the recording's own clock, from its first image on; empty: it cannot be read.
  std::optional<double> sinceBegin_s(const std::string& name, double time_s) {
    if (name.empty()) return std::max(0.0, time_s);  // of no recording: there is no other clock
    const auto& recording = of(name);
    if (!recording || recording->log.frameCount() == 0) return std::nullopt;
    return std::max(0.0, time_s - recording->log.begin_s());
  }

 private:
  const std::filesystem::path& folder_;
  std::map<std::string, Result<ScanRecording>> read_;
};

void addComments(const PartOf& of, const std::string& stepId, StepRecordings& recordings, Blocks& blocks) {
  ReportList list;
  for (const CommentFile& file : of.one.comments.files)
    for (const ReviewComment& comment : file.comments) {
      if (comment.stepId != stepId) continue;
      const std::string author = reviewerIn(of.options, of.codes, file.author);
      const Message said = comment.text.empty() ? say<"(a drawing on the image)">() : verbatim(comment.text);
      const auto at_s = recordings.sinceBegin_s(comment.recording, comment.time_s);
      list.items.push_back(
          {at_s ? say<"%1, at %2 of the scan: %3">(author, durationText(*at_s), said) : joined({verbatim(author), said}, ": ")});
    }
  if (list.items.empty()) return;
  blocks.emplace_back(ReportHeading{4, say<"Comments">()});
  blocks.emplace_back(std::move(list));
}

void addImages(const PartOf& of, const StepOutcome& outcome, const std::string& title, Blocks& blocks) {
  if (!of.options.images) return;
  for (std::size_t n = 0; n < outcome.images.size(); ++n)
    blocks.emplace_back(
        ReportImage{of.one.folder / std::filesystem::path(outcome.images[n]).filename(),
                    outcome.images.size() == 1 ? say<"Stored image: %1">(title) : say<"Stored image %1: %2">(n + 1, title)});
}

void addPath(const PartOf& of, const StepOutcome& outcome, StepRecordings& recordings, Blocks& blocks) {
  if (!of.options.images || outcome.recording.empty()) return;
  const auto& recording = recordings.of(outcome.recording);
  if (!recording) {
    blocks.emplace_back(ReportParagraph{inWordsOf(of.lesson.words, recording.error().message), ReportTone::caution});
    return;
  }
  PathPlot plot;
  if (const auto expert = of.lesson.expertPaths.find(outcome.stepId);
      expert != of.lesson.expertPaths.end() && of.lesson.plan.expertAttempt != of.one.attempt.id && !expert->second.empty())
    plot.paths.push_back({say<"the expert">(), true, expert->second});
  if (auto own = pathOf(recording->log); !own.empty()) plot.paths.push_back({say<"this attempt">(), false, std::move(own)});
  if (!plot.paths.empty()) blocks.emplace_back(ReportPlot{say<"Way of the probe over the skin">(), std::move(plot)});
}

void addStep(const PartOf& of, const StepScore& step, std::size_t number, Blocks& blocks) {
  const std::string title = stepTitle(of.lesson.words, step.stepId, step.title);
  blocks.emplace_back(ReportHeading{3, verbatim(std::to_string(number) + ". " + title)});
  const StepOutcome* outcome = of.one.attempt.outcomeOf(step.stepId);
  const auto& all = of.one.attempt.outcomes;
  const auto tries = std::count_if(all.begin(), all.end(), [&](const StepOutcome& each) { return each.stepId == step.stepId; });
  blocks.emplace_back(stepFacts(of.result, step, outcome, static_cast<std::size_t>(tries)));
  addRemarks(of, step.remarks, blocks);
  addFigures(step.figures, blocks);
  if (!step.metrics.empty()) addMetrics(of, step, blocks);
  StepRecordings recordings(of.one.folder);
  if (outcome != nullptr) {
    addImages(of, *outcome, title, blocks);
    addPath(of, *outcome, recordings, blocks);
  }
  addComments(of, step.stepId, recordings, blocks);
}

}  // namespace

void addSteps(const PartOf& of, Blocks& blocks) {
  const auto& steps = of.result.counted.steps;
  if (steps.empty()) return;
  blocks.emplace_back(ReportHeading{2, say<"Step by step">()});
  for (std::size_t n = 0; n < steps.size(); ++n) addStep(of, steps[n], n + 1, blocks);
}

}  // namespace ew::reports
