#pragma once

#include <gtest/gtest.h>

#include "assessment/assessed_world.h"
#include "ew/core/result.h"
#include "ew/io/image_file.h"
#include "ew/reports/attempt_report.h"
#include "ew/reports/class_report.h"
#include "ew/reports/html.h"
#include "export/export_world.h"

namespace ew::test {

inline Pseudonyms someCodes() {
  Pseudonyms::Key key{};
  key[0] = std::byte{7};
  return Pseudonyms(key);
}

/// A form of two items from 1 to 5, passed from 3.
inline std::shared_ptr<const RatingForm> someForm() {
  RatingForm form;
  form.id = "two-items";
  form.title = {"Two items", "Zwei Fragen"};
  form.source = "A test.";
  form.validity = {"None.", "Keine."};
  for (const std::string id : {"plan", "image"}) {
    RatingItem item;
    item.id = id;
    item.title = {"Item " + id, "Frage " + id};
    item.description = {"What is seen.", "Was zu sehen ist."};
    item.anchors = {{1, {"poor", "schlecht"}}, {5, {"good", "gut"}}};
    form.items.push_back(item);
  }
  form.passLevels = {{"all", {"All", "Alle"}, 3.0, "A test."}};
  return std::make_shared<const RatingForm>(form);
}

inline RatingRecord ratedBy(const std::string& rater, int plan, int image) {
  Rating rating;
  rating.rater = rater;
  rating.items = {{"plan", plan, "planned <b>well</b>"}, {"image", image, ""}};
  rating.finished = true;
  rating.formId = "two-items";
  rating.formContent = contentOf(*someForm());
  return {rating, someForm()};
}

/// An attempt of two steps that count and one that is read, scored, that lies nowhere. @param plane, answer scores of the steps
inline ReportAttempt madeAttempt(int number, double plane, double answer, const std::string& person = "Ana Gomez") {
  ReportAttempt one;
  Attempt& attempt = one.attempt;
  attempt.id = "20261101-10" + std::to_string(1000 + number);
  attempt.caseId = "ball";
  attempt.lessonId = "about-balls";
  attempt.lessonTitle = "About balls";
  attempt.person = person;
  attempt.program = "0.1.0";
  attempt.startedAt = std::chrono::sys_days(std::chrono::year(2026) / 11 / 1) + std::chrono::hours(10) + std::chrono::minutes(number);
  attempt.finishedAt = attempt.startedAt + std::chrono::minutes(5);
  AttemptScore score;
  score.attemptId = attempt.id;
  score.caseId = attempt.caseId;
  score.lessonId = attempt.lessonId;
  score.key = "0123456789abcdef";
  score.program = "0.1.0";
  score.number = 2;
  score.madeAt = attempt.startedAt + std::chrono::hours(1);
  score.score = 0.5 * (plane + answer);
  for (const auto& [id, kind, value] :
       {std::tuple("read", "read", 1.0), std::tuple("plane", "plane", plane), std::tuple("answer", "answer", answer)}) {
    StepOutcome outcome;
    outcome.stepId = id;
    outcome.verdict = value >= 0.7 ? StepVerdict::passed : StepVerdict::failed;
    outcome.score = value;
    outcome.seconds = 75.0;
    attempt.outcomes.push_back(outcome);
    StepScore step;
    step.stepId = id;
    step.title = std::string("Step ") + id;
    step.kind = kind;
    step.verdict = outcome.verdict;
    step.score = step.task = value;
    step.weight = step.kind == "read" ? 0.0 : 1.0;
    step.isJudgedAnew = true;
    score.steps.push_back(step);
  }
  StepScore& found = score.steps[1];
  found.figures = {{"angle", 4.25, "deg"}, {"in_picture", 3.0, "mm"}};
  found.remarks = {{true, say<"The plane is found: %1 degrees and %2 mm from the expert's.">(numeral("4.2"), numeral("1.0"))}};
  found.metrics = {{"path_length", 1, 200.0 + number}, {"hints", 1, 2.0}};
  score.passed = plane >= 0.7 && answer >= 0.7;
  one.score = score;
  return one;
}

/// The lesson of madeAttempt(): with it an attempt without a score that counts has what its lesson said.
inline Lesson triedLesson() {
  Lesson lesson;
  for (const auto& [id, task] :
       {std::pair<const char*, LessonTask>{"read", ReadingTask{}}, {"plane", PlaneTask{}}, {"answer", AnswerTask{}}}) {
    LessonStep& step = lesson.steps.emplace_back();
    step.id = id;
    step.title = std::string("Step ") + id;
    step.task = task;
  }
  return lesson;
}

/// An attempt at a lesson of reading and watching alone, without a score: 100 % and 80 %, both passed.
inline ReportAttempt readingAttempt() {
  ReportAttempt one = madeAttempt(1, 0.8, 0.8);
  one.score.reset();
  one.attempt.outcomes.pop_back();
  one.lesson = triedLesson();
  one.lesson->steps.pop_back();
  one.attempt.outcomes[1].stepId = one.lesson->steps[1].id = "watch";
  one.lesson->steps[1].title = "Step watch";
  one.lesson->steps[1].task = WatchTask{};
  return one;
}

inline ReportLesson madeLesson() {
  ReportLesson lesson;
  lesson.caseId = "ball";
  lesson.lessonId = "about-balls";
  lesson.caseTitle = "A ball, said to hurt";
  lesson.lessonTitle = "About balls";
  lesson.lesson = Lesson{};
  return lesson;
}

/// Every text of a report, block by block.
inline std::string plainTextOf(const ReportDocument& document, const ReportOptions& options = {}) {
  std::string text = options.say(document.title) + "\n" + options.say(document.subtitle) + "\n";
  const auto put = [&](const Message& message) { text += options.say(message) + " | "; };
  for (const ReportBlock& block : document.blocks) {
    if (const auto* heading = std::get_if<ReportHeading>(&block)) put(heading->text);
    if (const auto* paragraph = std::get_if<ReportParagraph>(&block)) put(paragraph->text);
    if (const auto* list = std::get_if<ReportList>(&block))
      for (const ReportItem& item : list->items) put(item.text);
    if (const auto* facts = std::get_if<ReportFacts>(&block))
      for (const ReportFact& fact : facts->rows) text += options.say(fact.name) + ": " + options.say(fact.value) + " | ";
    if (const auto* table = std::get_if<ReportTable>(&block)) {
      put(table->caption);
      for (const auto& row : table->rows) {
        for (const ReportCell& cell : row) put(cell.text);
        text += "\n";
      }
    }
    if (const auto* plot = std::get_if<ReportPlot>(&block)) put(plot->title);
    if (const auto* image = std::get_if<ReportImage>(&block)) put(image->caption);
    text += "\n";
  }
  return text;
}

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

}  // namespace ew::test
