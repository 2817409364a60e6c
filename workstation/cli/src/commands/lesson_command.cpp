#include <algorithm>
#include <ostream>

#include "commands/expert_path.h"
#include "ew/core/numbers.h"
#include "ew/core/printable.h"
#include "ew/library/body_skin.h"
#include "ew/library/case_words.h"
#include "ew/library/course.h"
#include "ew/library/lesson_links.h"
#include "ew/scanning/first_image.h"
#include "run/arguments.h"
#include "run/command.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;

struct LessonArguments {
  std::string chosen;  ///< a case
  std::string lesson;
  std::string language = "en";
  std::string path;
  std::string output;
  std::string course;
};

struct Home {
  Case opened;
  std::vector<Lesson> lessons;
};

Result<Home> readHome(const std::string& chosen, Run& run) {
  auto opened = findCase(chosen);
  if (!opened) return passOn(opened.error());
  if (auto kept = run.input(opened->folder / "case.json"); !kept) return passOn(kept.error());
  auto lessons = lessonsOf(*opened);
  if (!lessons) return passOn(lessons.error());
  return Home{std::move(*opened), std::move(*lessons)};
}

Result<Lesson> lessonOf(const Home& home, const std::string& id) {
  std::string ids;
  for (const Lesson& each : home.lessons) {
    if (each.id == id) return each;
    ids += (ids.empty() ? "" : ", ") + each.id;
  }
  return failure(ErrorCode::notFound,
                 say<"The case '%1' has no lesson '%2'; it has %3.">(home.opened.id, id, ids.empty() ? say<"none">() : verbatim(ids)),
                 {{"lesson", id}});
}

/// "level 2, about 15 minutes, 8 steps". In German where the titles beside it are: a line is in one language.
std::string sizeOf(const Lesson& lesson, const std::string& language) {
  if (language.starts_with("de"))
    return "Stufe " + std::to_string(lesson.level) + ", etwa " + std::to_string(lesson.minutes) +
           (lesson.minutes == 1 ? " Minute, " : " Minuten, ") + std::to_string(lesson.steps.size()) +
           (lesson.steps.size() == 1 ? " Schritt" : " Schritte");
  return "level " + std::to_string(lesson.level) + ", about " + counted(static_cast<std::size_t>(lesson.minutes), "minute") + ", " +
         counted(lesson.steps.size(), "step");
}

Result<int> list(const LessonArguments& arguments, Run& run) {
  const auto home = readHome(arguments.chosen, run);
  if (!home) return passOn(home.error());
  const CaseWords words = wordsOf(home->opened.folder, arguments.language);
  std::size_t width = 0;
  for (const Lesson& lesson : home->lessons) width = std::max(width, lesson.id.size());
  for (const Lesson& lesson : home->lessons)
    run.out() << lesson.id << std::string(width - lesson.id.size() + 2, ' ') << printableLine(words.of(lesson.title)) << " ("
              << sizeOf(lesson, arguments.language) << ")\n";
  if (home->lessons.empty()) run.out() << "The case " << home->opened.id << " has no lessons.\n";
  run.report.quality = {{"lessons", home->lessons.size()}};
  return kDone;
}

/// The texts of a step below its title.
void showStep(const LessonStep& step, Run& run) {
  const auto line = [&](const std::string& name, const std::string& text) {
    if (!text.empty()) run.out() << "   " << name << printableLine(text) << "\n";
  };
  line("", step.text);
  line("Look for: ", step.lookFor);
  if (const auto* watch = std::get_if<WatchTask>(&step.task))
    for (const ExpertMark& mark : watch->marks) line(rounded(mark.time_s, 1) + " s: ", mark.text);
  if (const auto* answer = std::get_if<AnswerTask>(&step.task)) {
    for (const AnswerOption& option : answer->options) {
      line(option.right ? "+ " : "- ", option.text);
      line("  ", option.why);
    }
    if (answer->number) line("= ", textOf(*answer->number) + " " + answer->unit + ", within " + textOf(answer->tolerance));
  }
  for (const std::string& hint : step.hints) line("Hint: ", hint);
  line("Afterwards: ", step.after);
}

Result<int> show(const LessonArguments& arguments, Run& run) {
  const auto home = readHome(arguments.chosen, run);
  if (!home) return passOn(home.error());
  const auto found = lessonOf(*home, arguments.lesson);
  if (!found) return passOn(found.error());
  const Lesson shown = translated(*found, wordsOf(home->opened.folder, arguments.language));
  run.out() << printableLine(shown.title) << "\n" << sizeOf(shown, arguments.language) << "\n";
  if (!shown.aim.empty()) run.out() << "Aim: " << printableLine(shown.aim) << "\n";
  for (const std::string& source : shown.sources) run.out() << "After: " << printableLine(source) << "\n";
  for (std::size_t n = 0; n < shown.steps.size(); ++n) {
    const LessonStep& step = shown.steps[n];
    run.out() << "\n" << n + 1 << " " << printableLine(step.title) << " [" << taskWord(step.task);
    if (step.time_s) run.out() << ", " << textOf(*step.time_s) << " s";
    run.out() << "]\n";
    showStep(step, run);
  }
  return kDone;
}

/// What is wrong with the recording of a step: it cannot be read, was made of something else, or ends before its marks.
std::vector<Message> problemsOfRecording(const LessonStep& step, const Case& home) {
  const auto* watch = std::get_if<WatchTask>(&step.task);
  if (watch == nullptr || watch->recording.empty()) return {};
  std::error_code ignored;
  const fs::path file = home.folder / "parts" / std::string(kLessonsPart) / watch->recording;
  if (!fs::is_regular_file(file, ignored)) return {};  // said by problemsOf
  const auto recording = readRecording(file);
  if (!recording) return {recording.error().message};
  std::vector<Message> problems;
  const std::string& scanned = step.caseId.empty() ? home.id : step.caseId;
  if (recording->caseId != scanned)
    problems.push_back(say<"The recording '%1' is a scan of the case '%2', and the step scans '%3'; record it there, or choose another.">(
        watch->recording, recording->caseId, scanned));
  for (const ExpertMark& mark : watch->marks)
    if (mark.time_s < recording->log.begin_s() || mark.time_s > recording->log.end_s())
      problems.push_back(say<"A mark stands at %1 s, and the recording '%2' is from %3 to %4 s; move the mark.">(
          textOf(mark.time_s), watch->recording, rounded(recording->log.begin_s(), 1), rounded(recording->log.end_s(), 1)));
  return problems;
}

std::vector<LessonProblem> allProblemsOf(const Lesson& lesson, const Case& home, const CaseById& caseById) {
  std::vector<LessonProblem> problems = problemsOf(lesson, home, caseById);
  for (const LessonStep& step : lesson.steps)
    for (Message& text : problemsOfRecording(step, home)) problems.push_back({step.id, std::move(text)});
  return problems;
}

Result<int> check(const LessonArguments& arguments, Run& run) {
  const auto home = readHome(arguments.chosen, run);
  if (!home) return passOn(home.error());
  std::vector<Lesson> lessons = home->lessons;
  if (!arguments.lesson.empty()) {
    auto one = lessonOf(*home, arguments.lesson);
    if (!one) return passOn(one.error());
    lessons = {std::move(*one)};
  }
  std::vector<std::unique_ptr<Case>> others;  // those that steps refer to
  const CaseById caseById = [&](const std::string& id) -> const Case* {
    auto found = findCase(id);
    if (!found) return nullptr;
    others.push_back(std::make_unique<Case>(std::move(*found)));
    return others.back().get();
  };
  std::size_t problems = 0;
  run.report.details["problems"] = nlohmann::json::array();
  for (const Lesson& lesson : lessons)
    for (const LessonProblem& problem : allProblemsOf(lesson, home->opened, caseById)) {
      ++problems;
      const std::string sentence = problem.text.english();
      run.out() << lesson.id << (problem.stepId.empty() ? "" : ", step " + problem.stepId) << ": " << sentence << "\n";
      run.report.details["problems"].push_back({{"lesson", lesson.id}, {"step", problem.stepId}, {"sentence", sentence}});
    }
  if (arguments.lesson.empty()) {
    run.report.details["unused"] = nlohmann::json::array();
    for (const std::string& file : unusedLessonFiles(home->opened)) {
      run.say("No lesson names the file " + file + "; it may go.");
      run.report.details["unused"].push_back(file);
    }
  }
  run.report.quality = {{"lessons", lessons.size()}, {"problems", problems}};
  if (problems == 0) {
    run.say(counted(lessons.size(), "lesson") + " of " + home->opened.id + " can be worked through.");
    return kDone;
  }
  run.out() << std::flush;
  return run.answer({ErrorCode::badField,
                     say<"The lessons of '%1' have %2; correct what is listed.">(arguments.chosen, counted(problems, "problem")),
                     {{"case", arguments.chosen}}});
}

Result<Probe> probeOf(const Case& opened, const std::vector<Probe>& probes, const std::string& wanted) {
  const std::string id = !wanted.empty() ? wanted : opened.probes.empty() ? probes.front().id : opened.probes.front();
  const bool isAllowed = opened.probes.empty() || std::find(opened.probes.begin(), opened.probes.end(), id) != opened.probes.end();
  const auto found = std::find_if(probes.begin(), probes.end(), [&](const Probe& each) { return each.id == id; });
  if (found == probes.end() || !isAllowed)
    return failure(ErrorCode::badField, say<"The case '%1' has no probe '%2'; choose one of its own.">(opened.id, id),
                   {{"field", "probe"}, {"found", id}});
  return *found;
}

Result<std::shared_ptr<const Skin>> skinOf(const Case& opened) {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  const std::string name = opened.mannequin.empty() ? std::string("adult.json") : opened.mannequin;
  const auto own = fileOfCase(opened.folder, name, "mannequin");
  return readBodySkin(own ? *own : *resources / "mannequin" / name);
}

Result<int> record(const LessonArguments& arguments, Run& run) {
  const auto opened = findCase(arguments.chosen);
  if (!opened) return passOn(opened.error());
  for (const fs::path& file : {opened->folder / "case.json", fs::path(arguments.path)})
    if (auto kept = run.input(file); !kept) return passOn(kept.error());
  if (auto announced = run.output(arguments.output, ".seq.mha .igs.mha .mha"); !announced) return passOn(announced.error());
  const auto there = beginningsThere();
  if (!there) return passOn(there.error());
  const auto path = readExpertPath(arguments.path, {*opened, there->probes, there->presets});
  if (!path) return passOn(path.error());
  const auto probe = probeOf(*opened, there->probes, path->probe);
  if (!probe) return passOn(probe.error());
  const auto skin = skinOf(*opened);
  if (!skin) return passOn(skin.error());
  const auto truth = loadCaseTruth(*opened, run.progress);
  if (!truth) return passOn(truth.error());
  const auto recording = [&] {
    const StepClock clock(run.report, "record");
    return recordAlong(*path, {*opened, *truth, **skin, *probe}, run.progress);
  }();
  if (!recording) return passOn(recording.error());
  if (auto written = writeRecording(*recording, run.outputs.staged(arguments.output)); !written) return passOn(written.error());
  const std::size_t frames = recording->log.frameCount();
  const double length_s = recording->log.end_s() - recording->log.begin_s();
  run.report.quality = {{"frames", frames}, {"seconds", length_s}};
  run.say("Recorded " + counted(frames, "frame") + " in " + rounded(length_s, 1) + " s of " + opened->id + ".");
  return kDone;
}

Result<int> course(const LessonArguments& arguments, Run& run) {
  fs::path file = arguments.course;
  if (file.empty()) {
    const auto shipped = shippedCourseFile();
    if (!shipped) return passOn(shipped.error());
    file = *shipped;
  }
  if (auto kept = run.input(file); !kept) return passOn(kept.error());
  const auto read = readCourse(file);
  if (!read) return passOn(read.error());
  run.out() << read->title.in(arguments.language) << "\n" << read->text.in(arguments.language) << "\n\n";
  std::size_t missing = 0;
  for (const CourseLesson& each : read->lessons) {
    const auto home = readHome(each.caseId, run);
    const auto lesson = home ? lessonOf(*home, each.lessonId) : passOn(home.error());
    if (lesson) {
      const CaseWords words = wordsOf(home->opened.folder, arguments.language);
      run.out() << printableLine(words.of(lesson->title)) << " (" << sizeOf(*lesson, arguments.language) << ")  " << each.caseId << " "
                << each.lessonId << "\n";
    } else {
      ++missing;
      run.remark(lesson.error().message);
    }
  }
  run.report.quality = {{"lessons", read->lessons.size()}, {"missing", missing}};
  if (missing == 0) return kDone;
  return run.answer(
      {ErrorCode::notFound,
       say<"Of the course '%1' %2 cannot be found; import their cases, or take them out of it.">(read->id, counted(missing, "lesson")),
       {{"course", read->id}}});
}

void addLanguage(CLI::App& app, std::string& language) {
  app.add_option("--language", language, "Of the texts, where the case has them: en, de (en)")->type_name("LANGUAGE");
}

void addCaseArgument(CLI::App& app, std::string& chosen) {
  app.add_option("CASE", chosen, "A case folder, its case.json, or the id of a case of your own, a published or a shipped one")
      ->required()
      ->type_name("");
}

}  // namespace

void addLesson(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("lesson", "List, show and check the lessons of cases, and record an expert's scan for them");
  group.require_subcommand(1);
  auto arguments = std::make_shared<LessonArguments>();

  auto& listed = addCommand(group, selection, "list", "The lessons of a case", {"lesson list focused-trauma"},
                            [arguments](Run& run) { return list(*arguments, run); });
  addCaseArgument(listed, arguments->chosen);
  addLanguage(listed, arguments->language);

  auto& shown = addCommand(group, selection, "show", "Every text of a lesson, answers included",
                           {"lesson show upper-abdomen-normal first-movements --language de"},
                           [arguments](Run& run) { return show(*arguments, run); });
  addCaseArgument(shown, arguments->chosen);
  shown.add_option("LESSON", arguments->lesson, "Its id")->required()->type_name("");
  addLanguage(shown, arguments->language);

  auto& checked = addCommand(group, selection, "check", "Every problem of a case's lessons, one a line; exit status 1 when there are any",
                             {"lesson check my-cases/knee"}, [arguments](Run& run) { return check(*arguments, run); });
  addCaseArgument(checked, arguments->chosen);
  checked.add_option("LESSON", arguments->lesson, "Only this one")->type_name("");

  auto& recorded = addCommand(group, selection, "record", "Record an expert's scan along a path, without a window",
                              {"lesson record my-cases/knee --path knee.path.json -o knee.seq.mha"},
                              [arguments](Run& run) { return record(*arguments, run); });
  addCaseArgument(recorded, arguments->chosen);
  recorded.add_option("--path", arguments->path, "Stations of the hand, by planes of the case: .json")->required()->type_name("PATH.json");
  recorded.add_option("-o,--output", arguments->output, "The recording: .seq.mha")->required()->type_name("SCAN.seq.mha");

  auto& coursed = addCommand(group, selection, "course", "The lessons of a course, in their order", {"lesson course --language de"},
                             [arguments](Run& run) { return course(*arguments, run); });
  coursed.add_option("FILE", arguments->course, "A course: .json (that of the shipped cases)")->type_name("");
  addLanguage(coursed, arguments->language);
}

}  // namespace ew::cli
