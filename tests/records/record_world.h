#pragma once

#include <atomic>
#include <nlohmann/json.hpp>
#include <string>

#include "ew/core/quiet_progress.h"
#include "ew/records/statement_outbox.h"
#include "ew/records/xapi.h"

namespace ew::test {

inline constexpr const char* kTestSpace = "0b54bd4c-2f2c-4c1b-9a2c-0c7f2b3d5e11";

/// A small statement, the n-th of a series.
inline nlohmann::json statementNumbered(int n, const std::string& series = "a") {
  const std::string name = series + std::to_string(n);
  return {{"id", uuidOfName(kTestSpace, name)},
          {"actor", {{"objectType", "Agent"}, {"account", {{"homePage", "https://school.example/"}, {"name", "p1"}}}}},
          {"verb", jsonOf(XapiVerb::passed)},
          {"object", {{"objectType", "Activity"}, {"id", "urn:echoweave:step/" + name}}},
          {"result", {{"score", {{"scaled", 0.5}}}, {"success", true}}},
          {"timestamp", "2026-11-26T09:30:00.000Z"}};
}
inline std::string idNumbered(int n, const std::string& series = "a") { return statementNumbered(n, series)["id"]; }

inline void fill(StatementOutbox& outbox, int count, const std::string& series = "a") {
  for (int n = 0; n < count; ++n) (void)outbox.add(statementNumbered(n, series));
}

/// Of an attempt with one outcome of each kind, one of them repeated.
inline Attempt someAttempt() {
  using namespace std::chrono;
  const sys_seconds begun = sys_days(year{2026} / 11 / 26) + hours(9) + minutes(30);
  Attempt attempt;
  attempt.id = "20261126-093000-4f2a91c7";
  attempt.caseId = "upper-abdomen-normal";
  attempt.lessonId = "first-movements";
  attempt.lessonTitle = "First movements";
  attempt.lessonContent = "4711abcd";
  attempt.person = "Ada Lovelace";
  attempt.program = "0.1.0";
  attempt.startedAt = begun;
  const auto outcome = [&](const char* step, StepVerdict verdict, double score, double seconds, int at_s) {
    StepOutcome one;
    one.stepId = step;
    one.verdict = verdict;
    one.score = score;
    one.seconds = seconds;
    one.at = begun + std::chrono::seconds(at_s);
    attempt.outcomes.push_back(one);
  };
  outcome("read", StepVerdict::passed, 1.0, 20.0, 20);
  outcome("plane", StepVerdict::failed, 0.25, 83.42, 110);
  outcome("plane", StepVerdict::passed, 0.75, 61.0, 180);
  outcome("question", StepVerdict::failed, 0.0, 10.5, 200);
  outcome("free", StepVerdict::skipped, 0.0, 1.0, 205);
  attempt.outcomes[1].hints = 2;
  attempt.outcomes[1].figures = {{"angle", 14.5, "deg"}, {"distance", 6.0, "mm"}};
  attempt.outcomes[3].otherAnswer = nlohmann::json::array({1, 2});
  attempt.outcomes[1].remarks = {{false, verbatim("a remark")}};
  attempt.finishedAt = begun + minutes(4);
  return attempt;
}

inline Lesson someLesson() {
  Lesson lesson;
  lesson.id = "first-movements";
  lesson.title = "First movements";
  const auto step = [&](const char* id, const char* title, LessonTask task) {
    LessonStep one;
    one.id = id;
    one.title = title;
    one.task = std::move(task);
    lesson.steps.push_back(one);
  };
  step("read", "Read this", ReadingTask{});
  step("plane", "Find the portal vein", PlaneTask{"portal", {}, {}});
  step("question", "What is it?", AnswerTask{});
  step("free", "Scan freely", FreeTask{});
  return lesson;
}

inline XapiOptions someOptions() {
  XapiOptions options;
  options.homePage = "https://school.example/";
  options.pseudonym = "T-9DC4-XB0M";
  return options;
}

}  // namespace ew::test
