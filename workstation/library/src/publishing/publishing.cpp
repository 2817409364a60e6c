#include "ew/library/publishing.h"

#include <algorithm>

#include "case/manifest.h"
#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/imaging/probe.h"
#include "ew/io/volume_file.h"
#include "ew/library/case_contents.h"
#include "ew/library/new_case.h"
#include "ew/library/placing.h"
#include "ew/library/real_looking.h"
#include "publishing/publishing_place.h"

namespace ew {
namespace {

using State = CheckItem::State;

/// A list in the making.
class CheckList {
 public:
  void done(Message what, std::string field) { add(std::move(what), State::done, std::move(field)); }
  void warn(Message what, std::string field) { add(std::move(what), State::warning, std::move(field)); }
  void miss(Message what, std::string field) { add(std::move(what), State::missing, std::move(field)); }
  void need(bool isThere, Message there, Message missing, const std::string& field) {
    if (isThere)
      done(std::move(there), field);
    else
      miss(std::move(missing), field);
  }
  std::vector<CheckItem> items;

 private:
  void add(Message what, State state, std::string field) { items.push_back({std::move(what), state, std::move(field)}); }
};

void checkTexts(const Case& opened, CheckList& list) {
  list.need(!opened.titleForTrainees.empty(), say<"It has a title for trainees.">(),
            say<"Write a title for trainees that gives no finding away.">(), "title_for_trainees");
  list.need(!opened.region.empty(), say<"The region is given.">(), say<"Give the region of the body.">(), "region");
  list.need(!opened.indication.empty(), say<"The indication is given.">(), say<"Write the indication: what is asked.">(), "indication");
  list.need(!opened.diagnosis.empty(), say<"The diagnosis is written.">(), say<"Write the diagnosis.">(), "diagnosis");
  if (opened.findings.empty())
    list.warn(say<"Write the findings, a sentence each.">(), "findings");
  else
    list.done(say<"The findings are written.">(), "findings");
  if (opened.difficulty)
    list.done(say<"The difficulty is given.">(), "difficulty");
  else
    list.warn(say<"Say how difficult the case is, 1 to 5.">(), "difficulty");
}

void checkVolume(const Case& opened, CheckList& list) {
  list.need(!hasNoVolume(opened), say<"It has a volume.">(), say<"Give the case a volume.">(), "volume.file");
  if (opened.volume.file.empty()) return;
  const RecordingRights rights = rightsOf(opened);
  list.need(!rights.licence.empty(), say<"The licence of the recording is given.">(),
            say<"Give the licence under which the recording may be passed on.">(), "volume.licence");
  list.need(!rights.attribution.empty(), say<"It says whom to name for the recording.">(), say<"Say whom to name for the recording.">(),
            "volume.attribution");
  if (assumesAxes(opened))
    list.warn(say<"Nobody has said from which side the volume was scanned; look whether the probe's side is at the top, and choose the "
                  "near face.">(),
              "volume.file_to_world");
}

void checkStart(const Case& opened, CheckList& list) {
  if (!opened.startPose) return list.miss(say<"Put the probe where a trainee begins, and take that as the start.">(), "start_pose");
  if (hasNoVolume(opened)) return;
  const auto sees = startSeesVolume(opened);
  if (sees && !*sees) return list.miss(say<"From the start nothing of the volume is seen; put the start above it.">(), "start_pose");
  if (startGivesAway(opened))
    list.warn(say<"The start shows what is to be found; begin somewhere else.">(), "start_pose");
  else
    list.done(say<"A trainee begins where the volume is seen and nothing is given away.">(), "start_pose");
}

void checkLessons(const Case& opened, const CaseById& caseById, CheckList& list) {
  const auto lessons = lessonsOf(opened);
  if (!lessons) return list.miss(lessons.error().message, "parts.lessons");
  if (lessons->empty()) return list.warn(say<"It has no lesson; trainees can scan it freely.">(), "parts.lessons");
  for (std::size_t n = 0; n < lessons->size(); ++n) {
    const Lesson& lesson = (*lessons)[n];
    const std::string field = "parts.lessons.lessons[" + std::to_string(n) + "]";
    const auto problems = problemsOf(lesson, opened, caseById);
    for (const LessonProblem& each : problems) {
      const auto step =
          std::find_if(lesson.steps.begin(), lesson.steps.end(), [&](const LessonStep& one) { return one.id == each.stepId; });
      list.miss(step == lesson.steps.end() ? say<"Lesson '%1': %2">(lesson.title, each.text)
                                           : say<"Lesson '%1', step '%2': %3">(lesson.title, step->title, each.text),
                field);
    }
    if (problems.empty()) list.done(say<"Lesson '%1' is ready.">(lesson.title), field);
  }
}

void checkReal(const Case& opened, CheckList& list) {
  const auto found = realLooking(opened);
  for (const RealLooking& each : found) list.warn(each.text, each.field);
  if (found.empty()) list.done(say<"Nothing in its texts looks like a real person's.">(), "patient.name");
}

Message millimetres(double value_mm) { return numeral(roundedText(value_mm, 1)); }
Message percent(double share) { return numeral(roundedText(100.0 * share, 0)); }

void checkContact(const Case& opened, const CheckSources& sources, CheckList& list, Progress& progress) {
  if (opened.volume.file.empty()) return;
  const auto contact = contactOfCase(opened, sources, progress);
  if (!contact) return list.warn(contact.error().message, "volume.file_to_world");
  constexpr double kEnough = 0.25;  // of a fan that rocked by 40 degrees a third lies on the skin at best
  constexpr double kMostOutside = 0.1;
  if (contact->faceShare < kEnough || contact->outsideShare > kMostOutside)
    list.warn(say<"%1 % of the volume's near face touch the skin (gap up to %2 mm), and %3 % of it lie outside the body; place it "
                  "better.">(percent(contact->faceShare), millimetres(contact->deepestGap_mm), percent(contact->outsideShare)),
              "volume.file_to_world");
  else
    list.done(say<"The volume lies against the skin: %1 % of its near face touch it.">(percent(contact->faceShare)),
              "volume.file_to_world");
}

void checkTargets(const Case& opened, const CheckSources& sources, CheckList& list) {
  std::size_t good = 0;
  for (std::size_t n = 0; n < opened.targets.size(); ++n) {
    const CaseTarget& each = opened.targets[n];
    const std::string field = "targets[" + std::to_string(n) + "]";
    if (isGivenName(each.name)) list.warn(say<"'%1' says nothing of what is to be found; name it.">(each.name), field);
    switch (reachOf(each, opened, sources)) {
      case Reach::outside:
        list.warn(say<"'%1' lies outside the volume; correct it, or leave it out.">(each.name), field);
        break;
      case Reach::offSkin:
        list.warn(say<"The probe of '%1' stands more than %2 mm off the skin, where no hand can put it.">(each.name, kFarthestFromSkin_mm),
                  field);
        break;
      case Reach::reached:
        ++good;
        break;
    }
  }
  if (opened.targets.empty()) return list.warn(say<"It has no target; say what is to be found.">(), "targets");
  if (good == opened.targets.size())
    list.done(good == 1 ? say<"Its target can be reached.">() : say<"All %1 targets can be reached.">(good), "targets");
}

void checkFiles(const Case& opened, CheckList& list) {
  if (opened.folder.empty()) return;
  const auto unused = unusedFiles(opened);
  if (unused.empty()) return list.done(say<"Every file of its folder is used.">(), "files");
  list.warn(unused.size() == 1 ? say<"A file of its folder is used by nothing, '%1'; it would be handed on as well.">(unused.front())
                               : say<"%1 files of its folder are used by nothing, '%2' first; they would be handed on as well.">(
                                     unused.size(), unused.front()),
            "files");
}

/// What trainees may not read is sealed, so nobody can look for it here, and an examination is not edited.
void sayExamination(CheckList& list) {
  list.done(say<"It is an examination, which is published as it was made: what trainees may not read is sealed.">(), "sealed");
}

void addMissing(const Case& opened, const CaseById& caseById, CheckList& list) {
  checkTexts(opened, list);
  checkVolume(opened, list);
  checkStart(opened, list);
  checkLessons(opened, caseById, list);
}

}  // namespace

Result<std::vector<CheckItem>> publishingList(const Case& opened, const CheckSources& sources, Progress& progress) {
  CheckList list;
  if (opened.sealed) {
    sayExamination(list);
    return std::move(list.items);
  }
  addMissing(opened, sources.caseById, list);
  CheckSources complete = sources;
  if (!complete.skin)
    if (auto skin = skinOfMannequin(opened.mannequin, opened.folder)) complete.skin = *std::move(skin);
  checkContact(opened, complete, list, progress);
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked before everything was checked.">());
  checkTargets(opened, complete, list);
  checkReal(opened, list);
  checkFiles(opened, list);
  return std::move(list.items);
}

std::vector<CheckItem> missingForPublishing(const Case& opened, const CaseById& caseById) {
  if (opened.sealed) return {};
  CheckList list;
  addMissing(opened, caseById, list);
  std::erase_if(list.items, [](const CheckItem& each) { return each.state != State::missing; });
  return std::move(list.items);
}

std::size_t countOf(const std::vector<CheckItem>& list, CheckItem::State state) {
  return static_cast<std::size_t>(std::count_if(list.begin(), list.end(), [&](const CheckItem& each) { return each.state == state; }));
}

}  // namespace ew
