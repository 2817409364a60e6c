#include "attempt_parts.h"

#include <algorithm>

#include "report_words.h"

namespace ew::reports {
namespace {

std::string inLanguage(const Words& words, const ReportOptions& options) { return words.in(options.language); }

/// The latest that each rater finished with each form.
std::vector<const RatingRecord*> latestRatings(const RatingRecords& all) {
  std::vector<const RatingRecord*> latest;
  for (const RatingRecord& each : all.ratings) {
    const auto same = std::find_if(latest.begin(), latest.end(), [&](const RatingRecord* one) {
      return one->rating.rater == each.rating.rater && one->rating.formId == each.rating.formId;
    });
    if (same == latest.end())
      latest.push_back(&each);
    else if ((*same)->rating.revision < each.rating.revision)
      *same = &each;
  }
  return latest;
}

Message blindingText(const Rating& rating) {
  if (rating.isBlinded()) return say<"knew neither whose attempt it was nor other ratings">();
  if (rating.sawName && rating.sawOthers) return say<"knew whose attempt it was and could see other ratings">();
  return rating.sawName ? say<"knew whose attempt it was">() : say<"could see other ratings">();
}

ReportTable itemsTable(const RatingRecord& kept, const ReportOptions& options) {
  ReportTable table{say<"Items">(), {{say<"Item">()}, {say<"Rating">(), true}, {say<"Remark">()}}, {}};
  for (const RatingItem& item : kept.form->items) {
    const ItemRating* given = kept.rating.itemOf(item.id);
    const bool hasScore = given != nullptr && given->score;
    table.rows.push_back({{verbatim(inLanguage(item.title, options))},
                          {hasScore ? say<"%1 of %2">(*given->score, kept.form->highest) : say<"not applicable">()},
                          {verbatim(given == nullptr ? "" : given->remark)}});
  }
  return table;
}

void addRating(const PartOf& of, const RatingRecord& kept, Blocks& blocks) {
  const Rating& rating = kept.rating;
  blocks.emplace_back(
      ReportHeading{3, say<"%1, by %2">(inLanguage(kept.form->title, of.options), reviewerIn(of.options, of.codes, rating.rater))});
  ReportFacts facts;
  facts.rows.push_back({say<"Given">(), momentWords(rating.at)});
  if (const auto total = totalOf(*kept.form, rating))
    facts.rows.push_back({say<"Total">(), say<"%1 of %2">(figureText(*total, ""), figureText(kept.form->highest, ""))});
  if (const auto passed = passedBy(*kept.form, rating))
    facts.rows.push_back({say<"Verdict">(), passedWord(*passed), *passed ? ReportTone::good : ReportTone::bad});
  facts.rows.push_back({say<"Rater">(), blindingText(rating)});
  if (!rating.remark.empty()) facts.rows.push_back({say<"Remark">(), verbatim(rating.remark)});
  blocks.emplace_back(std::move(facts));
  blocks.emplace_back(itemsTable(kept, of.options));
}

/// The latest score, where it was kept but does not count: null where it does, and where there is none.
const AttemptScore* outdatedScore(const PartOf& of) { return of.one.score && !of.result.isScored ? &*of.one.score : nullptr; }

/// Why the verdicts of the lesson itself are what counts.
Message unscoredText(const PartOf& of) {
  const AttemptScore* outdated = outdatedScore(of);
  if (outdated == nullptr) return say<"as in the lesson; it was not scored since">();
  if (outdated->planRevision < of.one.plan.revision)
    return say<"as in the lesson; score %1 was made by an earlier revision of the plan">(outdated->number);
  return say<"as in the lesson; score %1 was made of an earlier state of the attempt">(outdated->number);
}

}  // namespace

void addRatings(const PartOf& of, Blocks& blocks) {
  const auto latest = latestRatings(of.one.ratings);
  if (latest.empty() && of.one.ratings.problems.empty() && of.one.comments.problems.empty()) return;
  blocks.emplace_back(ReportHeading{2, say<"Ratings">()});
  for (const RatingRecord* each : latest) addRating(of, *each, blocks);
  for (const auto* problems : {&of.one.ratings.problems, &of.one.comments.problems})
    for (const Error& problem : *problems)
      blocks.emplace_back(ReportParagraph{inWordsOf(of.lesson.words, problem.message), ReportTone::caution});
}

void addEarlierScores(const PartOf& of, Blocks& blocks) {
  std::vector<const AttemptScore*> earlier;
  for (const AttemptScore& score : of.one.earlier) earlier.push_back(&score);
  if (const AttemptScore* outdated = outdatedScore(of)) earlier.push_back(outdated);
  if (earlier.empty()) return;
  blocks.emplace_back(ReportHeading{2, say<"Earlier scores">()});
  ReportTable table{
      say<"Kept as they were; they no longer count">(),
      {{say<"Number">()}, {say<"Scored">()}, {say<"Score">(), true}, {say<"Verdict">()}, {say<"Plan">(), true}, {say<"Program">()}},
      {}};
  for (const AttemptScore* score : earlier)
    table.rows.push_back({{verbatim(std::to_string(score->number))},
                          {momentWords(score->madeAt)},
                          {percentText(score->score)},
                          {passedWord(score->passed), score->passed ? ReportTone::good : ReportTone::bad},
                          {verbatim(std::to_string(score->planRevision))},
                          {verbatim(score->program)}});
  blocks.emplace_back(std::move(table));
}

void addOrigin(const PartOf& of, Blocks& blocks) {
  blocks.emplace_back(ReportHeading{2, say<"What the score was made of">()});
  ReportFacts facts;
  facts.rows = {{say<"Attempt">(), verbatim(of.one.attempt.id)},
                {say<"Case and lesson">(), verbatim(of.one.attempt.caseId + " / " + of.one.attempt.lessonId)},
                {say<"Judged in the lesson by">(), verbatim("EchoWeave " + of.one.attempt.program)}};
  if (!of.result.isScored) {
    facts.rows.push_back({say<"Judged">(), unscoredText(of), ReportTone::caution});
  } else {
    const AttemptScore* score = &of.result.counted;
    facts.rows.push_back({say<"Scored">(), say<"%1 by EchoWeave %2">(momentWords(score->madeAt), score->program)});
    facts.rows.push_back({say<"Score number">(), verbatim(std::to_string(score->number))});
    facts.rows.push_back({say<"Version of scoring">(), verbatim(std::to_string(score->scoring))});
    facts.rows.push_back({say<"Plan">(), score->planRevision == 0 ? say<"none: tasks alone, at the lesson's pass levels">()
                                                                  : say<"revision %1">(score->planRevision)});
    facts.rows.push_back(
        {say<"Compared with">(), score->expertAttempt.empty() ? say<"no expert's attempt">() : verbatim(score->expertAttempt)});
    facts.rows.push_back({say<"Key of all that went in">(), verbatim(score->key)});
  }
  blocks.emplace_back(std::move(facts));
  ReportList notes;
  for (const Message& note : of.result.counted.notes) notes.items.push_back({inWordsOf(of.lesson.words, note), ReportTone::caution});
  if (!notes.items.empty()) blocks.emplace_back(std::move(notes));
}

ReportTable metricsExplained(const std::vector<std::string>& ids) {
  ReportTable table{
      say<"What the metrics are">(), {{say<"Metric">()}, {say<"Definition">()}, {say<"Source">()}, {say<"What is known of it">()}}, {}};
  for (const Metric& metric : metrics())
    if (std::find(ids.begin(), ids.end(), metric.id) != ids.end())
      table.rows.push_back({{metric.name}, {metric.definition}, {metric.source}, {metric.validity}});
  return table;
}

void addMeaning(const PartOf& of, Blocks& blocks) {
  blocks.emplace_back(ReportHeading{2, say<"What this is worth">()});
  blocks.emplace_back(ReportParagraph{validitySentence()});
  std::vector<std::string> ids;
  for (const StepScore& step : of.result.counted.steps)
    for (const MetricValue& value : step.metrics) ids.push_back(value.id);
  if (!ids.empty()) blocks.emplace_back(metricsExplained(ids));
}

}  // namespace ew::reports
