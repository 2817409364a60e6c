#include <algorithm>

#include "ew/assessment/attempt_result.h"
#include "ew/assessment/attempt_scoring.h"
#include "ew/assessment/step_metrics.h"
#include "ew/core/version.h"
#include "ew/io/content_key.h"
#include "ew/library/case.h"
#include "ew/library/learning_progress.h"
#include "ew/library/lesson_links.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

template <class All>
bool hasName(const All& all, const std::string& name) {
  return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
}

bool needsLabels(const LessonTask& task, const CaseTruth& truth) {
  if (std::holds_alternative<SweepTask>(task)) return true;
  if (const auto* point = std::get_if<PointTask>(&task)) return !hasName(truth.points, point->target);
  if (const auto* free = std::get_if<FreeTask>(&task))
    return std::any_of(free->targets.begin(), free->targets.end(),
                       [&](const std::string& name) { return hasName(truth.structures, name); });
  return false;
}

/// Puts a ground together, part by part.
class GroundMaker {
 public:
  GroundMaker(AttemptLesson home, const fs::path& library, Progress& progress)
      : home_(std::move(home)), library_(library), progress_(progress) {
    made_->caseId = home_.home.id;
    made_->lesson = home_.lesson;
    key_.add("lesson ground").add(contentOf(home_.lesson));
  }

  Result<std::shared_ptr<const LessonGround>> make() {
    if (!home_.isAsTried)
      made_->notes.push_back(
          say<"The lesson has changed since it was tried, and how it was is not in the library; it is scored as it is now.">());
    auto plan = readPlan(library_, home_.home.id, home_.lesson.id);
    if (!plan) return passOn(plan.error());
    made_->plan = std::move(*plan);
    addPlanToKey();
    if (auto added = addCases(); !added) return passOn(added.error());
    if (auto added = addExpert(); !added) return passOn(added.error());
    made_->key = key_.text();
    return std::shared_ptr<const LessonGround>(std::move(made_));
  }

 private:
  void addPlanToKey() {
    auto decided = jsonOf(made_->plan);
    decided.erase("changed_by");
    decided.erase("changed_at");
    key_.add(decided.dump());
  }

  Result<void> addCases() {
    std::map<std::string, std::vector<const LessonStep*>> steps;
    for (const LessonStep& step : home_.lesson.steps) steps[step.caseId.empty() ? home_.home.id : step.caseId].push_back(&step);
    for (const auto& [id, scanning] : steps) {
      std::optional<Case> opened;
      if (id == home_.home.id) {
        opened = home_.home;
      } else if (const auto folder = findCase(id, library_)) {
        auto read = loadCase(*folder);
        if (!read) return passOn(read.error());
        opened = std::move(*read);
      }
      if (!opened) {
        made_->notes.push_back(say<"The case '%1' is not in the library; its steps keep the verdicts they had.">(id));
        continue;
      }
      if (auto added = addCase(*opened, scanning); !added) return added;
    }
    return {};
  }

  Result<void> addCase(const Case& opened, const std::vector<const LessonStep*>& steps) {
    auto truth = loadCaseTruth(opened, progress_);
    if (!truth) return passOn(truth.error());
    const bool hasLabels = std::any_of(steps.begin(), steps.end(), [&](const LessonStep* step) { return needsLabels(step->task, *truth); });
    std::shared_ptr<const Volume> labels;
    Grid placed;
    if (hasLabels) {
      auto read = loadCaseLabels(opened, progress_);
      if (!read) return passOn(read.error());
      if (*read) {
        placed = (*read)->grid;
        labels = std::make_shared<const Volume>(std::move(**read));
      }
    }
    nlohmann::json manifest = manifestOf(opened);
    manifest.erase("parts");  // lessons stand for themselves
    key_.add(opened.id).add(manifest.dump()).add(hasLabels);
    made_->cases[opened.id] = std::make_shared<const CaseGround>(std::make_shared<const CaseTruth>(std::move(*truth)), labels, placed);
    return {};
  }

  Result<void> addExpert() {
    if (!made_->plan.expertAttempt.empty()) {
      const auto kept = AttemptFolder::open(attemptsFolder(library_) / made_->plan.expertAttempt);
      if (!kept)
        made_->notes.push_back(say<"The expert's attempt cannot be read; nothing is compared with it. %1">(kept.error().message));
      else
        addExpertAttempt(*kept);
    }
    addWatchedImages();
    return {};
  }

  void addExpertAttempt(const AttemptFolder& kept) {
    for (const LessonStep& step : home_.lesson.steps) {
      const StepOutcome* outcome = kept.attempt().outcomeOf(step.id);
      if (outcome == nullptr || outcome->recording.empty()) continue;
      const fs::path file = kept.folder() / outcome->recording;
      auto read = readRecording(file, progress_);
      if (!read || read->log.frameCount() == 0) continue;
      made_->expertImages[step.id] = read->log.frame(read->log.frameCount() - 1);
      made_->expertScans[step.id] = std::make_shared<const ScanRecording>(std::move(*read));
      if (const auto content = contentOf(file, progress_); content && *content) key_.add(step.id).add(**content);
    }
  }

  /// Where nobody's attempt says how an expert sets the machine, the recordings that the lesson shows do.
  void addWatchedImages() {
    for (const LessonStep& watch : home_.lesson.steps) {
      const auto* task = std::get_if<WatchTask>(&watch.task);
      if (task == nullptr || task->recording.empty()) continue;
      const fs::path file = home_.home.folder / "parts" / std::string(kLessonsPart) / task->recording;
      const auto read = readRecording(file, progress_);
      if (!read) continue;
      if (const auto content = contentOf(file, progress_); content && *content) key_.add(watch.id).add(**content);
      for (const LessonStep& step : home_.lesson.steps) addWatchedImage(step, *read);
    }
  }

  void addWatchedImage(const LessonStep& step, const ScanRecording& recording) {
    const auto* task = std::get_if<PlaneTask>(&step.task);
    const auto ground = made_->caseOf(step);
    const std::string& scanned = step.caseId.empty() ? home_.home.id : step.caseId;
    if (task == nullptr || !ground || recording.caseId != scanned || made_->expertImages.contains(step.id)) return;
    for (const ReferencePlane& plane : ground->truth().planes)
      if (plane.name == task->target)
        if (auto image = bestImageOf(recording.log, plane, ground->truth())) made_->expertImages[step.id] = std::move(*image);
  }

  AttemptLesson home_;
  const fs::path& library_;
  Progress& progress_;
  std::shared_ptr<LessonGround> made_ = std::make_shared<LessonGround>();
  ContentKey key_;
};

}  // namespace

std::shared_ptr<const CaseGround> LessonGround::caseOf(const LessonStep& step) const {
  const auto found = cases.find(step.caseId.empty() ? caseId : step.caseId);
  return found == cases.end() ? nullptr : found->second;
}

Result<std::shared_ptr<const LessonGround>> lessonGroundOf(const std::string& caseId, const std::string& lessonId,
                                                           const std::string& lessonContent, const fs::path& library, Progress& progress) {
  auto home = triedLessonOf(caseId, lessonId, lessonContent, library);
  if (!home) return passOn(home.error());
  return GroundMaker(std::move(*home), library, progress).make();
}

}  // namespace ew
