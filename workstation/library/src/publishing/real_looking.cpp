#include "ew/library/real_looking.h"
#include "ew/library/lesson_links.h"

namespace ew {
namespace {

void lookIn(std::vector<RealLooking>& all, std::string_view text, const std::string& field) {
  for (RealLooking& each : realLookingIn(text, field)) all.push_back(std::move(each));
}

void lookIn(std::vector<RealLooking>& all, const std::vector<std::string>& texts, const std::string& field) {
  for (const std::string& each : texts) lookIn(all, each, field);
}

void lookInLessons(std::vector<RealLooking>& all, const Case& opened) {
  const auto lessons = lessonsOf(opened);
  if (!lessons) return;
  for (const Lesson& lesson : *lessons) {
    const std::string field = "parts.lessons";
    for (const std::string* text : {&lesson.title, &lesson.aim}) lookIn(all, *text, field);
    for (const LessonStep& step : lesson.steps) {
      for (const std::string* text : {&step.title, &step.text, &step.lookFor, &step.after}) lookIn(all, *text, field);
      lookIn(all, step.hints, field);
      if (const auto* answer = std::get_if<AnswerTask>(&step.task))
        for (const AnswerOption& option : answer->options) {
          lookIn(all, option.text, field);
          lookIn(all, option.why, field);
        }
      if (const auto* watch = std::get_if<WatchTask>(&step.task))
        for (const ExpertMark& mark : watch->marks) lookIn(all, mark.text, field);
    }
  }
}

}  // namespace

std::vector<RealLooking> realLooking(const Case& opened) {
  std::vector<RealLooking> all;
  lookIn(all, opened.title, "title");
  lookIn(all, opened.titleForTrainees, "title_for_trainees");
  lookIn(all, opened.patient.name, "patient.name");
  lookIn(all, opened.complaint, "complaint");
  lookIn(all, opened.history, "history");
  lookIn(all, opened.indication, "indication");
  for (std::size_t n = 0; n < opened.previousExaminations.size(); ++n) {
    const CaseExamination& each = opened.previousExaminations[n];
    const std::string place = "previous_examinations[" + std::to_string(n) + "]";
    lookIn(all, each.when, place + ".when");
    lookIn(all, each.kind, place + ".kind");
    lookIn(all, each.findings, place + ".findings");
  }
  for (std::size_t n = 0; n < opened.laboratory.size(); ++n) {
    const std::string place = "laboratory[" + std::to_string(n) + "]";
    lookIn(all, opened.laboratory[n].when, place + ".when");
    lookIn(all, opened.laboratory[n].findings, place + ".findings");
  }
  lookIn(all, opened.findings, "findings");
  lookIn(all, opened.diagnosis, "diagnosis");
  lookIn(all, opened.differential, "differential");
  lookIn(all, opened.tags, "tags");
  lookInLessons(all, opened);
  return all;
}

}  // namespace ew
