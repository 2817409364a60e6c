#include "ew/library/lesson_links.h"

#include <algorithm>
#include <set>

#include "ew/core/message.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

bool hasTarget(const Case& scanned, const std::string& name, CaseTarget::Kind kind) {
  return std::any_of(scanned.targets.begin(), scanned.targets.end(),
                     [&](const CaseTarget& target) { return target.name == name && target.kind == kind; });
}

/// Whether two steps ask for the same in the same way: all but their names is equal.
bool isTwin(const LessonStep& one, const LessonStep& other) {
  if (one.id == other.id) return true;
  LessonStep renamed = one;
  renamed.id = other.id;
  renamed.title = other.title;
  return renamed == other;
}

/// Looks at the tasks of one lesson; each problem stands with the step it was found in.
class Looking {
 public:
  Looking(const Case& home, std::vector<LessonProblem>& problems)
      : folder_(home.folder / "parts" / std::string(kLessonsPart)), hasFolder_(!home.folder.empty()), problems_(problems) {}

  void look(const LessonStep& step, const Case& scanned) {
    step_ = &step;
    scanned_ = &scanned;
    std::visit([this](const auto& task) { at(task); }, step.task);
    wording();
  }

 private:
  void say(Message text) { problems_.push_back({step_->id, std::move(text)}); }

  void file(const std::string& relative) {
    std::error_code ignored;
    if (hasFolder_ && !fs::is_regular_file(folder_ / relative, ignored))
      say(ew::say<"The file '%1' of the lesson is not in the case folder; put it into parts/lessons, or choose another.">(relative));
  }

  /// What a trainee has to read, and nobody wrote.
  void wording() {
    const bool saysItself = std::holds_alternative<ReadingTask>(step_->task) || std::holds_alternative<AnswerTask>(step_->task) ||
                            std::holds_alternative<WatchTask>(step_->task);
    if (!saysItself && step_->text.empty()) say(ew::say<"Nothing says what is to be done; write it.">());
  }

  void plane(const std::string& name) {
    if (name.empty()) return say(ew::say<"No plane is chosen; choose one of the case's.">());
    if (!hasTarget(*scanned_, name, CaseTarget::Kind::plane))
      say(ew::say<"The case '%1' has no plane '%2'; choose one of its own.">(scanned_->id, name));
  }

  void structure(const std::string& name) {
    if (name.empty()) return say(ew::say<"No structure is chosen; choose one of the case's.">());
    if (!hasTarget(*scanned_, name, CaseTarget::Kind::structure))
      say(ew::say<"The case '%1' has no structure '%2'; choose one of its own.">(scanned_->id, name));
  }

  void at(const ReadingTask& task) {
    if (!task.image.empty()) file(task.image);
    if (step_->text.empty() && task.image.empty()) say(ew::say<"There is nothing to read; write a text.">());
  }
  void at(const WatchTask& task) {
    if (task.recording.empty()) return say(ew::say<"The expert's scan is not recorded yet; record it, or leave the step out.">());
    file(task.recording);
    for (const ExpertMark& mark : task.marks)
      if (isGivenName(mark.text)) say(ew::say<"The mark '%1' says nothing of what is to be seen there; describe it.">(mark.text));
  }
  void at(const PlaneTask& task) { plane(task.target); }
  void at(const SweepTask& task) { structure(task.target); }
  void at(const MeasureTask& task) {
    if (task.measurement.empty()) return say(ew::say<"No measurement is chosen; choose one that the case expects.">());
    const auto& all = scanned_->measurements;
    const auto found = std::find_if(all.begin(), all.end(), [&](const CaseMeasurement& one) { return one.name == task.measurement; });
    if (found == all.end())
      return say(ew::say<"The case '%1' expects no measurement '%2'; choose one that it does.">(scanned_->id, task.measurement));
    if (!task.tolerance && !found->tolerance)
      say(ew::say<"Neither the step nor the case says how far the measurement may be off; give a tolerance.">());
  }
  void at(const PointTask& task) {
    if (task.target.empty()) return say(ew::say<"Nothing is chosen to point at; choose a point or a structure of the case.">());
    if (!hasTarget(*scanned_, task.target, CaseTarget::Kind::point) && !hasTarget(*scanned_, task.target, CaseTarget::Kind::structure))
      say(ew::say<"The case '%1' has no point or structure '%2'; choose one of its own.">(scanned_->id, task.target));
  }
  void at(const SettingsTask& task) {
    if (task.probes.empty() && task.bands.empty()) say(ew::say<"No setting is asked for; name a probe or give a range.">());
  }
  void at(const AnswerTask& task) {
    if (step_->text.empty()) say(ew::say<"There is no question; write one.">());
    if (task.number) return;
    const auto right = std::count_if(task.options.begin(), task.options.end(), [](const AnswerOption& one) { return one.right; });
    if (task.options.size() < 2) return say(ew::say<"A question needs at least two answers to choose from, or a number.">());
    for (const AnswerOption& option : task.options)
      if (isGivenName(option.text)) say(ew::say<"The answer '%1' is not written yet; say what can be chosen.">(option.text));
    if (right == 0) say(ew::say<"None of the answers is marked as right; mark one.">());
  }
  void at(const FreeTask& task) {
    for (const std::string& name : task.targets)
      if (!hasTarget(*scanned_, name, CaseTarget::Kind::plane) && !hasTarget(*scanned_, name, CaseTarget::Kind::structure))
        say(ew::say<"The case '%1' has no plane or structure '%2'; choose one of its own.">(scanned_->id, name));
  }

  fs::path folder_;
  bool hasFolder_;
  std::vector<LessonProblem>& problems_;
  const LessonStep* step_ = nullptr;
  const Case* scanned_ = nullptr;
};

}  // namespace

Result<std::vector<Lesson>> lessonsOf(const Case& home) {
  const auto& fields = home.otherFields;
  if (!fields.is_object() || !fields.contains("parts") || !fields["parts"].is_object() || !fields["parts"].contains(kLessonsPart))
    return std::vector<Lesson>{};
  return lessonsFromJson(fields["parts"][std::string(kLessonsPart)]);
}

std::vector<LessonProblem> problemsOf(const Lesson& lesson, const Case& home, const CaseById& caseById) {
  std::vector<LessonProblem> problems;
  if (lesson.steps.empty()) problems.push_back({{}, say<"The lesson has no steps; add one.">()});
  Looking looking(home, problems);
  for (const LessonStep& step : lesson.steps) {
    const bool isHome = step.caseId.empty() || step.caseId == home.id;
    const Case* scanned = isHome ? &home : caseById ? caseById(step.caseId) : nullptr;
    if (scanned != nullptr)
      looking.look(step, *scanned);
    else
      problems.push_back({step.id, say<"The case '%1' is not in the library; import it, or choose another.">(step.caseId)});
    const auto twin = std::find_if(lesson.steps.begin(), lesson.steps.end(), [&](const LessonStep& one) { return isTwin(one, step); });
    if (twin->id != step.id)
      problems.push_back({step.id, say<"It asks the same as the step '%1'; change one of them, or leave it out.">(twin->title)});
  }
  return problems;
}

bool isGivenName(std::string_view name) {
  constexpr std::string_view kGiven[] = {"Answer", "Antwort", "Mark", "Marke", "Structure", "Struktur", "Point", "Punkt", "Plane", "Ebene"};
  while (!name.empty() && name.back() >= '0' && name.back() <= '9') name.remove_suffix(1);
  while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
  return std::find(std::begin(kGiven), std::end(kGiven), name) != std::end(kGiven);
}

std::vector<std::string> unusedLessonFiles(const Case& home) {
  if (home.folder.empty()) return {};
  const auto lessons = lessonsOf(home);
  if (!lessons) return {};  // nobody knows what they name
  std::set<std::string> named;
  for (const Lesson& lesson : *lessons)
    for (const LessonStep& step : lesson.steps) {
      if (const auto* read = std::get_if<ReadingTask>(&step.task)) named.insert(fs::path(read->image).lexically_normal().generic_string());
      if (const auto* watch = std::get_if<WatchTask>(&step.task))
        named.insert(fs::path(watch->recording).lexically_normal().generic_string());
    }
  std::vector<std::string> unused;
  const fs::path part = home.folder / "parts" / std::string(kLessonsPart);
  std::error_code ignored;
  for (const auto& [folder, ending] : {std::pair<const char*, std::string_view>{"scans", ".mha"}, {"media", ""}})
    for (const auto& each : fs::directory_iterator(part / folder, ignored)) {
      const std::string name = std::string(folder) + "/" + each.path().filename().string();
      if (each.is_regular_file(ignored) && !each.path().filename().string().starts_with(".") && name.ends_with(ending) &&
          named.count(name) == 0)
        unused.push_back(name);
    }
  std::sort(unused.begin(), unused.end());
  return unused;
}

}  // namespace ew
