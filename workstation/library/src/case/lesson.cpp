#include "ew/library/lesson.h"

#include <algorithm>
#include <array>
#include <set>

#include "ew/core/json_fields.h"
#include "ew/core/message.h"
#include "ew/io/content_key.h"
#include "files/json_rest.h"
#include "files/schema_text.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr std::size_t kMostLessons = 200, kMostSteps = 200, kMostEntries = 50;
constexpr std::size_t kLongestText = 20'000, kLongestPath = 240;
constexpr double kLongestTime_s = 7200.0;

constexpr std::array<std::string_view, std::variant_size_v<LessonTask>> kTaskWords = {"read",  "watch",    "plane",  "sweep", "measure",
                                                                                      "point", "settings", "answer", "free"};
constexpr std::array<std::string_view, 12> kStepFields = {"id",   "title", "task", "text",     "look_for",   "after",
                                                          "case", "hints", "aids", "feedback", "pass_level", "time_s"};
constexpr std::array<std::string_view, 9> kLessonFields = {"id",   "title",   "aim",      "level", "minutes",
                                                           "tags", "sources", "language", "steps"};

struct AidField {
  std::string_view word;
  bool LessonAids::*member;
};
constexpr std::array<AidField, 7> kAids = {{{"translucent_skin", &LessonAids::translucentSkin},
                                            {"organs", &LessonAids::organs},
                                            {"volume_box", &LessonAids::volumeBox},
                                            {"own_path", &LessonAids::ownPath},
                                            {"expert_probe", &LessonAids::expertProbe},
                                            {"outline", &LessonAids::outline},
                                            {"compass", &LessonAids::compass}}};

std::string longText(const JsonFields& fields, std::string_view key) { return fields.text(key, std::string(), 0, kLongestText); }

std::optional<double> optionalNumber(const JsonFields& fields, std::string_view key, double lowest, double highest) {
  if (!fields.has(key)) return std::nullopt;
  return fields.number(key, lowest, highest);
}

/// A file of the section's folder. The file itself is looked for by whoever checks the case.
std::string pathOf(const JsonFields& fields, std::string_view key) {
  std::string path = fields.text(key, std::string(), 0, kLongestPath);
  const std::filesystem::path asPath(path);
  if (asPath.is_absolute() || path.find('\\') != std::string::npos || std::find(asPath.begin(), asPath.end(), "..") != asPath.end())
    fields.refuse(key, say<"a relative path inside the folder parts/lessons of the case">());
  return path;
}

template <class T>
struct TaskFields;

template <>
struct TaskFields<ReadingTask> {
  static constexpr std::array<std::string_view, 1> names = {"picture"};
  static ReadingTask read(const JsonFields& f) { return {pathOf(f, "picture")}; }
  static void write(const ReadingTask& task, json& into) {
    if (!task.image.empty()) into["picture"] = task.image;
  }
};

template <>
struct TaskFields<WatchTask> {
  static constexpr std::array<std::string_view, 4> names = {"recording", "begin_s", "end_s", "marks"};
  static WatchTask read(const JsonFields& f) {
    WatchTask task{pathOf(f, "recording"), optionalNumber(f, "begin_s", -1e9, 1e9), optionalNumber(f, "end_s", -1e9, 1e9), {}};
    if (task.begin_s && task.end_s && *task.end_s <= *task.begin_s) f.refuse("end_s", say<"a time after begin_s">());
    for (const JsonFields& mark : f.objects("marks", 0, kMostEntries)) {
      mark.only({"time_s", "text"});
      task.marks.push_back({mark.number("time_s", -1e9, 1e9), mark.text("text", {}, 1, kLongestText)});
    }
    std::stable_sort(task.marks.begin(), task.marks.end(), [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
    return task;
  }
  static void write(const WatchTask& task, json& into) {
    if (!task.recording.empty()) into["recording"] = task.recording;
    if (task.begin_s) into["begin_s"] = *task.begin_s;
    if (task.end_s) into["end_s"] = *task.end_s;
    for (const ExpertMark& mark : task.marks) into["marks"].push_back({{"time_s", mark.time_s}, {"text", mark.text}});
  }
};

template <>
struct TaskFields<PlaneTask> {
  static constexpr std::array<std::string_view, 3> names = {"target", "position_tolerance_mm", "angle_tolerance_deg"};
  static PlaneTask read(const JsonFields& f) {
    return {f.text("target", std::string(), 0), optionalNumber(f, "position_tolerance_mm", 0.1, 200.0),
            optionalNumber(f, "angle_tolerance_deg", 0.1, 180.0)};
  }
  static void write(const PlaneTask& task, json& into) {
    into["target"] = task.target;
    if (task.positionTolerance_mm) into["position_tolerance_mm"] = *task.positionTolerance_mm;
    if (task.angleTolerance_deg) into["angle_tolerance_deg"] = *task.angleTolerance_deg;
  }
};

template <>
struct TaskFields<SweepTask> {
  static constexpr std::array<std::string_view, 2> names = {"target", "share"};
  static SweepTask read(const JsonFields& f) { return {f.text("target", std::string(), 0), f.number("share", 0.05, 1.0, 0.9)}; }
  static void write(const SweepTask& task, json& into) {
    into["target"] = task.target;
    into["share"] = task.share;
  }
};

template <>
struct TaskFields<MeasureTask> {
  static constexpr std::array<std::string_view, 2> names = {"measurement", "tolerance"};
  static MeasureTask read(const JsonFields& f) {
    return {f.text("measurement", std::string(), 0), optionalNumber(f, "tolerance", 1e-6, 1e6)};
  }
  static void write(const MeasureTask& task, json& into) {
    into["measurement"] = task.measurement;
    if (task.tolerance) into["tolerance"] = *task.tolerance;
  }
};

template <>
struct TaskFields<PointTask> {
  static constexpr std::array<std::string_view, 1> names = {"target"};
  static PointTask read(const JsonFields& f) { return {f.text("target", std::string(), 0)}; }
  static void write(const PointTask& task, json& into) { into["target"] = task.target; }
};

template <>
struct TaskFields<SettingsTask> {
  static constexpr std::array<std::string_view, 2> names = {"probes", "bands"};
  static SettingsTask read(const JsonFields& f) {
    SettingsTask task{f.texts("probes", 0, kMostEntries), {}};
    std::set<std::string> seen;
    for (const JsonFields& band : f.objects("bands", 0, std::size(kLessonSettings))) {
      band.only({"setting", "lowest", "highest"});
      SettingBand made{band.text("setting"), band.number("lowest", -1e4, 1e4), band.number("highest", -1e4, 1e4)};
      if (std::find(std::begin(kLessonSettings), std::end(kLessonSettings), made.setting) == std::end(kLessonSettings))
        band.refuse("setting", wordsText(kLessonSettings));
      if (!seen.insert(made.setting).second) band.refuse("setting", say<"each setting once">());
      if (made.highest < made.lowest) band.refuse("highest", say<"at least lowest">());
      task.bands.push_back(std::move(made));
    }
    return task;
  }
  static void write(const SettingsTask& task, json& into) {
    if (!task.probes.empty()) into["probes"] = task.probes;
    for (const SettingBand& band : task.bands)
      into["bands"].push_back({{"setting", band.setting}, {"lowest", band.lowest}, {"highest", band.highest}});
  }
};

template <>
struct TaskFields<AnswerTask> {
  static constexpr std::array<std::string_view, 4> names = {"options", "number", "tolerance", "unit"};
  static AnswerTask read(const JsonFields& f) {
    AnswerTask task;
    for (const JsonFields& option : f.objects("options", 0, kMostEntries)) {
      option.only({"text", "right", "why"});
      task.options.push_back({option.text("text", {}, 1, kLongestText), option.flag("right", false), longText(option, "why")});
    }
    task.number = optionalNumber(f, "number", -1e9, 1e9);
    task.tolerance = f.number("tolerance", 0.0, 1e9, 0.0);
    task.unit = f.text("unit", std::string(), 0, 20);
    if (task.number && !task.options.empty()) f.refuse("number", say<"left out where there are options">());
    return task;
  }
  static void write(const AnswerTask& task, json& into) {
    for (const AnswerOption& option : task.options) {
      json each = {{"text", option.text}, {"right", option.right}};
      if (!option.why.empty()) each["why"] = option.why;
      into["options"].push_back(std::move(each));
    }
    if (task.number) into["number"] = *task.number;
    if (task.tolerance != 0.0) into["tolerance"] = task.tolerance;
    if (!task.unit.empty()) into["unit"] = task.unit;
  }
};

template <>
struct TaskFields<FreeTask> {
  static constexpr std::array<std::string_view, 2> names = {"shortest_s", "targets"};
  static FreeTask read(const JsonFields& f) {
    return {f.number("shortest_s", 0.0, kLongestTime_s, 0.0), f.texts("targets", 0, kMostEntries)};
  }
  static void write(const FreeTask& task, json& into) {
    if (task.shortest_s > 0.0) into["shortest_s"] = task.shortest_s;
    if (!task.targets.empty()) into["targets"] = task.targets;
  }
};

/// The task as it stands in the step, and the names of its fields.
LessonTask readTask(const JsonFields& step, std::vector<std::string_view>& names) {
  LessonTask made = taskOfWord(step.text("task")).value_or(ReadingTask{});
  if (!taskOfWord(step.text("task"))) step.refuse("task", wordsText(kTaskWords));
  return std::visit(
      [&](const auto& empty) -> LessonTask {
        using Fields = TaskFields<std::decay_t<decltype(empty)>>;
        names.insert(names.end(), Fields::names.begin(), Fields::names.end());
        return Fields::read(step);
      },
      made);
}

LessonAids readAids(const JsonFields& fields) {
  LessonAids aids;
  std::array<std::string, kAids.size()> names;
  for (std::size_t n = 0; n < kAids.size(); ++n) {
    names[n] = kAids[n].word;
    aids.*kAids[n].member = fields.flag(kAids[n].word, false);
  }
  fields.only(std::span<const std::string>(names));
  return aids;
}

LessonStep readStep(const JsonFields& fields) {
  LessonStep step;
  std::vector<std::string_view> names(kStepFields.begin(), kStepFields.end());
  step.id = fields.text("id", {}, 1, 100);
  step.task = readTask(fields, names);
  step.title = fields.text("title", {}, 1, 200);
  step.text = longText(fields, "text");
  step.lookFor = longText(fields, "look_for");
  step.after = longText(fields, "after");
  step.caseId = fields.text("case", std::string(), 0, 100);
  for (const json& hint : fields.list("hints", 0, kMostEntries)) {
    if (!hint.is_string() || hint.get_ref<const std::string&>().size() > kLongestText) {
      fields.refuse("hints", say<"a list of texts">());
      break;
    }
    step.hints.push_back(hint.get<std::string>());
  }
  step.aids = readAids(fields.object("aids"));
  step.feedback = fields.flag("feedback", true);
  step.passLevel = fields.number("pass_level", 0.0, 1.0, step.passLevel);
  step.time_s = optionalNumber(fields, "time_s", 5.0, kLongestTime_s);
  step.otherFields = without(fields.value(), names);
  return step;
}

Lesson readLesson(const JsonFields& fields) {
  Lesson lesson;
  lesson.id = fields.text("id", {}, 1, 100);
  lesson.title = fields.text("title", {}, 1, 200);
  lesson.aim = longText(fields, "aim");
  lesson.level = static_cast<int>(fields.whole("level", 1, 5, lesson.level));
  lesson.minutes = static_cast<int>(fields.whole("minutes", 1, 600, lesson.minutes));
  lesson.tags = fields.texts("tags", 0, kMostEntries);
  for (const json& source : fields.list("sources", 0, kMostEntries)) {
    if (!source.is_string()) {
      fields.refuse("sources", say<"a list of texts">());
      break;
    }
    lesson.sources.push_back(source.get<std::string>());
  }
  lesson.language = fields.text("language", lesson.language, 2, 35);
  std::set<std::string> ids;
  for (const JsonFields& each : fields.objects("steps", 0, kMostSteps)) {
    lesson.steps.push_back(readStep(each));
    if (!ids.insert(lesson.steps.back().id).second) each.refuse("id", say<"an id that no other step of the lesson has">());
  }
  lesson.otherFields = without(fields.value(), kLessonFields);
  return lesson;
}

json jsonOf(const LessonStep& step) {
  json made = step.otherFields.is_object() ? step.otherFields : json::object();
  made["id"] = step.id;
  made["task"] = taskWord(step.task);
  made["title"] = step.title;
  const auto text = [&](const char* key, const std::string& value) {
    if (!value.empty()) made[key] = value;
  };
  text("text", step.text);
  text("look_for", step.lookFor);
  text("after", step.after);
  text("case", step.caseId);
  if (!step.hints.empty()) made["hints"] = step.hints;
  for (const AidField& aid : kAids)
    if (step.aids.*aid.member) made["aids"][std::string(aid.word)] = true;
  if (!step.feedback) made["feedback"] = false;
  made["pass_level"] = step.passLevel;
  if (step.time_s) made["time_s"] = *step.time_s;
  std::visit([&](const auto& task) { TaskFields<std::decay_t<decltype(task)>>::write(task, made); }, step.task);
  return made;
}

json jsonOf(const Lesson& lesson) {
  json made = lesson.otherFields.is_object() ? lesson.otherFields : json::object();
  made["id"] = lesson.id;
  made["title"] = lesson.title;
  if (!lesson.aim.empty()) made["aim"] = lesson.aim;
  made["level"] = lesson.level;
  made["minutes"] = lesson.minutes;
  if (!lesson.tags.empty()) made["tags"] = lesson.tags;
  if (!lesson.sources.empty()) made["sources"] = lesson.sources;
  made["language"] = lesson.language;
  made["steps"] = json::array();
  for (const LessonStep& step : lesson.steps) made["steps"].push_back(jsonOf(step));
  return made;
}

}  // namespace

std::string_view taskWord(const LessonTask& task) { return kTaskWords[task.index()]; }

bool isScanned(const LessonTask& task) {
  return std::holds_alternative<PlaneTask>(task) || std::holds_alternative<SweepTask>(task) || std::holds_alternative<SettingsTask>(task) ||
         std::holds_alternative<FreeTask>(task);
}

std::optional<LessonTask> taskOfWord(std::string_view word) {
  static const std::array<LessonTask, kTaskWords.size()> tasks = {ReadingTask{}, WatchTask{},    PlaneTask{},  SweepTask{}, MeasureTask{},
                                                                  PointTask{},   SettingsTask{}, AnswerTask{}, FreeTask{}};
  const auto at = std::find(kTaskWords.begin(), kTaskWords.end(), word);
  if (at == kTaskWords.end()) return std::nullopt;
  return tasks[static_cast<std::size_t>(at - kTaskWords.begin())];
}

Result<std::vector<Lesson>> lessonsFromJson(const json& section) {
  JsonReading reading(say<"the lessons of case.json">());
  const JsonFields fields(section, reading, "parts.lessons");
  const auto format = fields.whole("format", 1, 1'000'000);
  if (reading.good() && format > kLessonsFormat)
    return failure(ErrorCode::newerFormat,
                   say<"The lessons of the case have format %1, and this program reads formats up to %2; open them with a newer "
                       "EchoWeave.">(std::to_string(format), kLessonsFormat),
                   {{"field", "parts.lessons.format"}, {"found", std::to_string(format)}});
  std::vector<Lesson> lessons;
  std::set<std::string> ids;
  for (const JsonFields& each : fields.objects("lessons", 0, kMostLessons)) {
    lessons.push_back(readLesson(each));
    if (!ids.insert(lessons.back().id).second) each.refuse("id", say<"an id that no other lesson of the case has">());
  }
  if (reading.problem()) return passOn(*reading.problem());
  return lessons;
}

json jsonOf(const std::vector<Lesson>& lessons) {
  json list = json::array();
  for (const Lesson& lesson : lessons) list.push_back(jsonOf(lesson));
  return {{"format", kLessonsFormat}, {"lessons", std::move(list)}};
}

const std::string& lessonsSchema() {
  static const std::string text(kLessonsSchemaText);
  return text;
}

std::string idFor(std::string_view name, const std::vector<std::string>& taken, std::string_view otherwise) {
  constexpr std::size_t kLongest = 90;  // an id has at most 100 characters; a number comes behind it
  std::string id;
  for (const char letter : name) {
    const bool isCapital = letter >= 'A' && letter <= 'Z';
    const bool fits = isCapital || (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
    if (fits) id += isCapital ? static_cast<char>(letter - 'A' + 'a') : letter;
    if (!fits && !id.empty() && id.back() != '-') id += '-';
    if (id.size() == kLongest) break;
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  if (id.empty()) id = otherwise;
  std::string found = id;
  for (int number = 2; std::find(taken.begin(), taken.end(), found) != taken.end(); ++number) found = id + "-" + std::to_string(number);
  return found;
}

std::string contentOf(const Lesson& lesson) { return ContentKey().add(jsonOf(std::vector<Lesson>{lesson}).dump()).text(); }

}  // namespace ew
