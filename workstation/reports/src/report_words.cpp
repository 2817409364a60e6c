#include "report_words.h"

#include <algorithm>

#include "ew/library/timestamp.h"

namespace ew::reports {
namespace {

/// Names of files are told without the folders they lie in, which name people and machines.
std::string withoutFolders(const std::string& text) {
  std::string made;
  for (std::size_t n = 0; n < text.size();) {
    const bool begins = text[n] == '/' && (n == 0 || std::string_view(" '\"(").find(text[n - 1]) != std::string_view::npos);
    if (!begins) {
      made += text[n++];
      continue;
    }
    const std::size_t end = std::min(text.find_first_of("'\"\n", n), text.size());
    const std::size_t name = text.rfind('/', end - 1) + 1;
    made += text.substr(name, end - name);
    n = end;
  }
  return made;
}

}  // namespace

ReportTone toneOf(StepVerdict verdict) {
  switch (verdict) {
    case StepVerdict::passed:
      return ReportTone::good;
    case StepVerdict::failed:
      return ReportTone::bad;
    case StepVerdict::skipped:
    case StepVerdict::handedIn:
      break;
  }
  return ReportTone::soft;
}

ReportTone toneOf(const AttemptResult& result) {
  const auto passed = result.passed();
  if (!passed) return ReportTone::soft;
  return *passed ? ReportTone::good : ReportTone::bad;
}

const char* signOf(ReportTone tone) {
  switch (tone) {
    case ReportTone::plain:
    case ReportTone::soft:
      return "•";
    case ReportTone::good:
      return "✓";
    case ReportTone::bad:
      return "✗";
    case ReportTone::caution:
      return "!";
  }
  return "";
}

Message kindText(std::string_view kind) {
  if (kind == "read") return say<"Read">();
  if (kind == "watch") return say<"Watch the expert">();
  if (kind == "plane") return say<"Find a plane">();
  if (kind == "sweep") return say<"Sweep through a structure">();
  if (kind == "measure") return say<"Measure">();
  if (kind == "point") return say<"Point at something">();
  if (kind == "settings") return say<"Set the machine">();
  if (kind == "answer") return say<"Answer a question">();
  if (kind == "free") return say<"Scan freely">();
  return verbatim(std::string(kind));
}

Message momentWords(std::chrono::sys_seconds moment) {
  if (moment == std::chrono::sys_seconds{}) return say<"not known">();
  std::string text = timestampText(moment).substr(0, 16);
  text[10] = ' ';
  return verbatim(text + " UTC");
}

std::optional<std::chrono::sys_seconds> newestOf(const ReportAttempt& attempt) {
  std::chrono::sys_seconds newest = std::max(attempt.attempt.startedAt, attempt.attempt.finishedAt.value_or(attempt.attempt.startedAt));
  if (attempt.score) newest = std::max(newest, attempt.score->madeAt);
  if (newest == std::chrono::sys_seconds{}) return {};
  return newest;
}

Message figureName(const std::string& name) {
  if (name == "angle") return say<"Angle">();
  if (name == "distance") return say<"Distance">();
  if (name == "roll") return say<"Roll">();
  if (name == "in_picture") return say<"Shift in the image">();
  if (name == "face") return say<"Place of the probe">();
  if (name == "coverage") return say<"Coverage">();
  if (name == "value") return say<"Value that was measured">();
  if (name == "off") return say<"Off the expected value by">();
  if (name == "place") return say<"Calipers beside their place">();
  if (name == "error") return say<"Error">();
  if (name == "depth_mm") return say<"Depth">();
  if (name == "gain_db") return say<"Gain">();
  if (name == "dynamic_range_db") return say<"Dynamic range">();
  if (name == "focus_mm") return say<"Focus">();
  return verbatim(name);
}

Message metricName(const std::string& id) {
  const Metric* known = metricOf(id);
  return known == nullptr ? verbatim(id) : known->name;
}

std::string_view metricUnit(const std::string& id) {
  const Metric* known = metricOf(id);
  return known == nullptr ? std::string_view() : known->unit;
}

Message inWordsOf(const CaseWords& words, const Message& message) {
  return message.withVerbatim([&](const std::string& text) { return words.has(text) ? words.of(text) : withoutFolders(text); });
}

std::string stepTitle(const CaseWords& words, const std::string& stepId, const std::string& title) {
  return title.empty() ? stepId : words.of(title);
}

std::string lessonName(const Attempt& attempt, const ReportLesson& lesson) {
  return lesson.lesson || attempt.lessonTitle.empty() ? lesson.lessonTitle : attempt.lessonTitle;
}

Message intervalText(double low, double high) { return say<"95 % interval %1 to %2">(percentText(low), percentText(high)); }

}  // namespace ew::reports
