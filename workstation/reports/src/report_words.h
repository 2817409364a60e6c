#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/library/attempt.h"
#include "ew/library/case_words.h"
#include "ew/reports/report_attempt.h"
#include "ew/reports/report_document.h"

namespace ew::reports {

[[nodiscard]] ReportTone toneOf(StepVerdict verdict);
/// Of a whole lesson.
[[nodiscard]] ReportTone toneOf(const AttemptResult& result);
/// Before a line of a list, beside its colour.
[[nodiscard]] const char* signOf(ReportTone tone);
/// Of a taskWord: "plane" is "Find a plane".
[[nodiscard]] Message kindText(std::string_view kind);
/// "2026-11-26 09:30 UTC"; "not known" of a moment that was never set.
[[nodiscard]] Message momentWords(std::chrono::sys_seconds moment);
/// When the newest thing that counts was made: the attempt or its score; nothing when no clock was set.
[[nodiscard]] std::optional<std::chrono::sys_seconds> newestOf(const ReportAttempt& attempt);
/// What judging calls a figure of a task, for people: "in_picture" is "shift in the image".
[[nodiscard]] Message figureName(const std::string& name);
/// The name of a metric; its id when this program does not know it.
[[nodiscard]] Message metricName(const std::string& id);
[[nodiscard]] std::string_view metricUnit(const std::string& id);
/// What lessons say in the report's language, and files without the folders of somebody's computer.
[[nodiscard]] Message inWordsOf(const CaseWords& words, const Message& message);
/// A score's step as the lesson calls it, in the report's language.
[[nodiscard]] std::string stepTitle(const CaseWords& words, const std::string& stepId, const std::string& title);
/// Of a lesson that is gone, what it was called when it was tried.
[[nodiscard]] std::string lessonName(const Attempt& attempt, const ReportLesson& lesson);
/// "95 % interval 0.61 to 0.74"
[[nodiscard]] Message intervalText(double low, double high);

}  // namespace ew::reports
