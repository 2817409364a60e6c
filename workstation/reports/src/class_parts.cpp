#include "class_parts.h"

#include <algorithm>

#include "ew/reports/attempt_report.h"
#include "report_words.h"

namespace ew::reports {
namespace {

std::optional<double> expertsValue(const ClassOf& of, const ClassStep& step, const ClassMetric& metric) {
  if (!of.lesson.expert || !metric.isMetric) return std::nullopt;
  const StepScore* expert = of.lesson.expert->of(step.stepId);
  if (expert == nullptr) return std::nullopt;
  for (const MetricValue& value : expert->metrics)
    if (value.id == metric.id && value.version == metric.version) return value.value;
  return std::nullopt;
}

Message nameOf(const ClassMetric& metric) { return metric.isMetric ? metricName(metric.id) : figureName(metric.id); }

Message weightText(const ClassOf& of, const ClassStep& step, const ClassMetric& metric) {
  if (!metric.isMetric) return say<"through the task">();
  if (const StepPlan* plan = of.lesson.plan.of(step.stepId))
    for (const MetricWeight& weight : plan->metrics)
      if (weight.metric == metric.id) return say<"weight %1">(figureText(weight.weight, ""));
  return of.lesson.offByDefault.contains({step.kind, metric.id}) ? say<"no; off by default">() : say<"no">();
}

ReportTable metricsOfClass(const ClassOf& of, const ClassStep& step) {
  ReportTable table{say<"Metrics of all attempts">(),
                    {{say<"Metric">()},
                     {say<"Attempts">(), true},
                     {say<"Lowest">(), true},
                     {say<"Lower quartile">(), true},
                     {say<"Median">(), true},
                     {say<"Upper quartile">(), true},
                     {say<"Highest">(), true},
                     {say<"Expert">(), true},
                     {say<"In the score">()}},
                    {}};
  for (const ClassMetric& metric : step.metrics) {
    const FiveNumbers numbers = fiveNumbersOf(metric.values);
    const std::string& unit = metric.unit;
    std::vector<ReportCell> row = {{nameOf(metric)}, {verbatim(std::to_string(numbers.count))}};
    for (const double value : {numbers.lowest, numbers.lowerQuartile, numbers.median, numbers.upperQuartile, numbers.highest})
      row.push_back({figureText(value, unit)});
    const auto expert = expertsValue(of, step, metric);
    row.push_back({expert ? figureText(*expert, unit) : verbatim("–")});
    row.push_back({weightText(of, step, metric)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportPlot metricPlot(const ClassOf& of, const ClassStep& step, const ClassMetric& metric) {
  StripPlot plot;
  plot.axis = verbatim(metric.unit == "deg" ? "°" : metric.unit);
  plot.rows.push_back({{}, metric.values, {}, expertsValue(of, step, metric)});
  return {nameOf(metric), std::move(plot), true};
}

/// Attempts as the statistics of ratings take them, under the ids that reports show.
std::vector<AttemptRatings> ratedAttempts(const ClassOf& of) {
  std::vector<AttemptRatings> rated;
  for (const ReportAttempt& one : of.attempts) {
    AttemptRatings made;
    made.attemptId = one.attempt.id;
    for (const RatingRecord& each : one.ratings.ratings) made.ratings.push_back(each.rating);
    rated.push_back(std::move(made));
  }
  return rated;
}

/// The forms that were used, of each the newest.
std::vector<std::shared_ptr<const RatingForm>> formsOf(const ClassOf& of) {
  std::vector<std::shared_ptr<const RatingForm>> forms;
  for (const ReportAttempt& one : of.attempts)
    for (const RatingRecord& each : one.ratings.ratings) {
      const auto same = std::find_if(forms.begin(), forms.end(), [&](const auto& form) { return form->id == each.form->id; });
      if (same == forms.end())
        forms.push_back(each.form);
      else if ((*same)->version < each.form->version)
        *same = each.form;
    }
  return forms;
}

Message estimateText(const std::optional<Estimate>& estimate) {
  if (!estimate) return verbatim("–");
  return say<"%1 (95 % interval %2 to %3)">(figureText(estimate->value, ""), figureText(estimate->low, ""), figureText(estimate->high, ""));
}

ReportTable kappasOf(const ClassOf& of, const RatingForm& form, const RatingStatistics& statistics) {
  ReportTable table{say<"Agreement of two raters on each item">(),
                    {{say<"Item">()}, {say<"Raters">()}, {say<"Attempts">(), true}, {say<"Weighted kappa">(), true}},
                    {}};
  for (const ItemStatistics& item : statistics.items) {
    const RatingItem* known = form.itemOf(item.item);
    for (const PairAgreement& pair : item.pairs) {
      const std::string raters = reviewerIn(of.options, of.codes, pair.first) + ", " + reviewerIn(of.options, of.codes, pair.second);
      table.rows.push_back({{verbatim(known == nullptr ? item.item : known->title.in(of.options.language))},
                            {verbatim(raters)},
                            {verbatim(std::to_string(pair.bothRated))},
                            {estimateText(pair.kappa)}});
    }
  }
  return table;
}

void addForm(const ClassOf& of, const RatingForm& form, std::vector<ReportBlock>& blocks) {
  const RatingStatistics statistics = ratingStatistics(form, ratedAttempts(of));
  blocks.emplace_back(ReportHeading{3, verbatim(form.title.in(of.options.language))});
  ReportFacts facts;
  facts.rows = {{say<"Raters">(), verbatim(std::to_string(statistics.raters.size()))},
                {say<"Attempts that were rated">(), verbatim(std::to_string(statistics.attempts))},
                {say<"Of these by every rater">(), verbatim(std::to_string(statistics.complete))}};
  if (statistics.totals) {
    facts.rows.push_back({say<"Reliability of one rater, ICC(2,1)">(), estimateText(statistics.totals->single)});
    facts.rows.push_back({say<"Reliability of their mean, ICC(2,k)">(), estimateText(statistics.totals->mean)});
  } else {
    facts.rows.push_back({say<"Agreement">(), say<"needs two raters and two attempts that both rated, with ratings that differ">()});
  }
  for (const Leniency& each : statistics.leniency)
    facts.rows.push_back(
        {say<"%1 rates above the others by">(reviewerIn(of.options, of.codes, each.rater)), figureText(each.aboveMean, "")});
  blocks.emplace_back(std::move(facts));
  if (ReportTable kappas = kappasOf(of, form, statistics); !kappas.rows.empty()) blocks.emplace_back(std::move(kappas));
}

}  // namespace

void addClassSteps(const ClassOf& of, std::vector<ReportBlock>& blocks) {
  const auto& steps = of.figures.steps;
  if (std::none_of(steps.begin(), steps.end(), [](const ClassStep& step) { return !step.metrics.empty(); })) return;
  blocks.emplace_back(ReportHeading{2, say<"Metrics, step by step">()});
  if (of.lesson.expert) blocks.emplace_back(ReportParagraph{say<"The thick line is the expert's value.">(), ReportTone::soft});
  for (const ClassStep& step : steps) {
    if (step.metrics.empty()) continue;
    blocks.emplace_back(ReportHeading{3, verbatim(stepTitle(of.lesson.words, step.stepId, step.title))});
    blocks.emplace_back(metricsOfClass(of, step));
    for (const ClassMetric& metric : step.metrics) blocks.emplace_back(metricPlot(of, step, metric));
  }
}

void addAgreement(const ClassOf& of, std::vector<ReportBlock>& blocks) {
  const auto forms = formsOf(of);
  if (forms.empty()) return;
  blocks.emplace_back(ReportHeading{2, say<"How far raters agree">()});
  blocks.emplace_back(ReportParagraph{say<"Ratings count that were given before the rater could see those of others. An ICC or kappa of 1 "
                                          "is full agreement, 0 is chance.">(),
                                      ReportTone::soft});
  for (const auto& form : forms) addForm(of, *form, blocks);
}

void addPassLevels(const ClassOf& of, std::vector<ReportBlock>& blocks) {
  const ClassFigures& figures = of.figures;
  blocks.emplace_back(ReportHeading{2, say<"Pass levels by contrasting groups">()});
  blocks.emplace_back(
      ReportParagraph{say<"Where the scores of those who should pass and of those who should not cross. Who should pass is what an "
                          "instructor has said of an attempt; else what raters say with a form that has a pass level, where all of them "
                          "say the same. Neither should come from the score.">()});
  if (of.lesson.standingsProblem)
    blocks.emplace_back(ReportParagraph{say<"What instructors have said of attempts cannot be read, so raters' word alone counts: %1">(
                                            inWordsOf(of.lesson.words, of.lesson.standingsProblem->message)),
                                        ReportTone::caution});
  const bool isAnySuggested = figures.suggested || std::any_of(figures.steps.begin(), figures.steps.end(),
                                                               [](const ClassStep& step) { return step.suggested.has_value(); });
  if (!isAnySuggested) {
    blocks.emplace_back(ReportParagraph{say<"No level can be suggested: %1 attempts should pass and %2 should not; each group needs two or "
                                            "more with scores that differ, and "
                                            "those who should pass have to score higher.">(figures.shouldPass, figures.shouldFail),
                                        ReportTone::caution});
    return;
  }
  ReportTable table{say<"%1 attempts should pass, %2 should not">(figures.shouldPass, figures.shouldFail),
                    {{say<"Of">()}, {say<"Passes from now">(), true}, {say<"Suggested">(), true}, {say<"How sure">()}},
                    {}};
  const auto add = [&](Message name, std::optional<double> now, const std::optional<Estimate>& suggested) {
    table.rows.push_back({{std::move(name)},
                          {now ? percentText(*now) : say<"every step">()},
                          {suggested ? percentText(suggested->value) : verbatim("–")},
                          {suggested ? intervalText(suggested->low, suggested->high) : say<"the groups do not differ as they should">()}});
  };
  add(say<"The whole lesson">(), of.lesson.plan.passLevel, figures.suggested);
  for (const ClassStep& step : figures.steps)
    if (step.weight > 0.0) add(verbatim(stepTitle(of.lesson.words, step.stepId, step.title)), step.passLevel, step.suggested);
  blocks.emplace_back(std::move(table));
}

void addAttemptTable(const ClassOf& of, std::vector<ReportBlock>& blocks) {
  if (of.attempts.empty()) return;
  blocks.emplace_back(ReportHeading{2, say<"Attempts">()});
  ReportTable table{say<"All attempts">(),
                    {{say<"Trainee">()},
                     {say<"Began">()},
                     {say<"Score">(), true},
                     {say<"Verdict">()},
                     {say<"Steps passed">(), true},
                     {say<"Ratings">(), true}},
                    {}};
  for (std::size_t n = 0; n < of.attempts.size(); ++n) {
    const ReportAttempt& one = of.attempts[n];
    const AttemptResult result = one.result();
    const bool isJudged = result.isKnown && result.passed();
    table.rows.push_back(
        {{verbatim(calledIn(of.options, of.codes, one.attempt.person)), ReportTone::plain,
          n < of.pages.size() ? of.pages[n] : std::string()},
         {momentWords(one.attempt.startedAt)},
         {isJudged ? percentText(*result.score()) : verbatim("–")},
         {result.isKnown ? verdictWord(result) : say<"not scored yet">(), result.isKnown ? toneOf(result) : ReportTone::caution},
         {isJudged ? say<"%1 of %2">(result.stepsPassed, result.stepsJudged) : verbatim("–")},
         {verbatim(std::to_string(one.ratings.ratings.size()))}});
  }
  blocks.emplace_back(std::move(table));
}

}  // namespace ew::reports
