#include "ew/library/new_case.h"

#include <algorithm>

#include "ew/core/output_set.h"
#include "ew/library/echoes_field.h"
#include "ew/library/published.h"
#include "ew/library/templates.h"
#include "files/guarded_case.h"
#include "making/new_case_source.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScratch = ".stitching";

/// A volume is a field of its own in a case's unknown fields, too: "attribution" beside what plugins keep there.
void setText(nlohmann::json& volume, const char* field, const std::string& text) {
  if (text.empty())
    volume.erase(field);
  else
    volume[field] = text;
}

std::string textIn(const Case& opened, const char* field) {
  const auto& others = opened.otherFields;
  if (!others.is_object() || !others.contains("volume") || !others["volume"].is_object()) return {};
  const auto found = others["volume"].find(field);
  return found != others["volume"].end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// What a person said, and of the rest what the template has.
Result<Case> draftOf(const NewCase& wanted, const fs::path& folder) {
  Case draft;
  draft.title = wanted.title;
  draft.titleForTrainees = wanted.titleForTrainees;
  draft.region = wanted.region;
  draft.mannequin = wanted.mannequin;
  draft = withRights(std::move(draft), {wanted.attribution, wanted.licence});
  if (!wanted.templateId.empty()) {
    const auto from = readTemplate(wanted.templateId);
    if (!from) return passOn(from.error());
    draft = withTemplate(std::move(draft), *from);
  }
  draft.id = folder.empty() ? "case" : idForFolder(folder);
  if (wanted.fileToWorld) {
    if (auto rigid = checkRigid(*wanted.fileToWorld); !rigid) return passOn(rigid.error());
    draft.volume.fileToWorld = *wanted.fileToWorld;
  }
  if (auto problems = checkManifest(manifestOf(draft), {}); !problems.empty()) return passOn(std::move(problems.front()));
  return draft;
}

Result<void> checkIsFree(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(folder, ignored)) || (fs::is_directory(folder, ignored) && fs::is_empty(folder, ignored))) return {};
  return failure(ErrorCode::notWritable, say<"'%1' is there already, and nothing in it is overwritten; choose a new folder.">(folder),
                 {{"file", folder.string()}});
}

/// The folder's name without a separator at its end, absolute.
fs::path targetOf(const fs::path& folder) {
  std::error_code ignored;
  fs::path target = fs::absolute(folder, ignored).lexically_normal();
  return target.has_filename() ? target : target.parent_path();
}

void takeIn(Case& into, const SourceInCase& put) {
  into.volume.file = put.file;
  into.volume.level = put.level;
  into.volume.frames = put.images;
  if (put.axes) into = put.assumesAxes ? withAssumedAxes(std::move(into), *put.axes) : withSweepAxes(std::move(into), *put.axes);
}

/// A recording has its own shadows and reverberation: what a template switches on would come on top of them. @return whether any was on
bool withoutRecordedArtefacts(Scene& scene) {
  const bool hadAny = scene.attenuation || scene.reverberation;
  scene.attenuation.reset();
  scene.reverberation.reset();
  return hadAny;
}
Message artefactsAreOff() {
  return say<"Shadows and reverberation, which the template switches on, are off: the recording has its own.">();
}

/// What only the volume before knew.
void dropWhatIsLost(VolumeReplacement& given) {
  Case& edited = given.edited;
  const bool hadRecipe = !edited.volume.recipe.empty();
  const auto isLost = [&](const CaseTarget& each) {
    if (each.kind == CaseTarget::Kind::structure) return true;
    return hadRecipe && each.kind == CaseTarget::Kind::plane && !each.probeToFile;
  };
  given.lostTargets = std::erase_if(edited.targets, isLost);
  given.lostMeasurements = std::erase_if(edited.measurements, [](const CaseMeasurement& each) { return !each.value; });
  CaseVolume fresh;
  fresh.fileToWorld = edited.volume.fileToWorld;
  edited.volume = fresh;
  edited = withoutEchoes(std::move(edited));
  if (edited.otherFields.contains("volume"))
    for (const char* field : {"depth_direction", "lateral_direction", "probe_side_is_assumed", "attribution", "licence"})
      edited.otherFields["volume"].erase(field);
}

}  // namespace

RecordingRights rightsOf(const Case& opened) { return {textIn(opened, "attribution"), textIn(opened, "licence")}; }

Case withRights(Case edited, const RecordingRights& rights) {
  nlohmann::json& others = edited.otherFields;
  nlohmann::json volume = others.contains("volume") ? others["volume"] : nlohmann::json::object();
  setText(volume, "attribution", rights.attribution);
  setText(volume, "licence", rights.licence);
  if (volume.empty())
    others.erase("volume");
  else
    others["volume"] = std::move(volume);
  return edited;
}

Result<NewCasePlan> planCase(const NewCase& wanted, Progress& progress) {
  return guardedCase({}, [&]() -> Result<NewCasePlan> {
    if (const auto draft = draftOf(wanted, {}); !draft) return passOn(draft.error());
    return planSource(wanted.source, wanted.makesLevel, progress);
  });
}

Result<NewCasePlan> planOfSource(const CaseSource& source, Progress& progress) {
  return guardedCase({}, [&] { return planSource(source, true, progress); });
}

Result<CaseCreation> makeCase(const NewCase& wanted, const fs::path& folder, Progress& progress) {
  return guardedCase(folder, [&]() -> Result<CaseCreation> {
    if (auto isFree = checkIsFree(folder); !isFree) return passOn(isFree.error());
    const fs::path target = targetOf(folder);
    auto draft = draftOf(wanted, target);
    if (!draft) return passOn(draft.error());
    OutputSet outputs;
    if (auto made = outputs.announceFolder(target.parent_path()); !made) return passOn(made.error());
    if (auto announced = outputs.announceNewFolder(target); !announced) return passOn(announced.error());
    const fs::path aside = outputs.staged(target);
    CaseCreation made{*std::move(draft), {}};
    if (!std::holds_alternative<std::monostate>(wanted.source)) {
      const auto put = putSource(wanted.source, wanted.makesLevel, aside, aside.parent_path() / kScratch, progress);
      if (!put) return passOn(outputs.inGivenNames(put.error()));
      takeIn(made.made, *put);
      if (withoutRecordedArtefacts(made.made.scene)) made.notes.push_back(artefactsAreOff());
      const DefaultPlacement place = choosePlace(put->shape, made.made.mannequin, {}, made.made.region, wanted.fileToWorld);
      made.made.volume.fileToWorld = place.fileToWorld;
      made.contact = place.contact;
      made.frames = put->frames;
      made.notes.insert(made.notes.end(), put->notes.begin(), put->notes.end());
      made.notes.insert(made.notes.end(), place.notes.begin(), place.notes.end());
    }
    if (auto saved = saveCase(made.made, aside); !saved) return passOn(outputs.inGivenNames(saved.error()));
    if (progress.cancelRequested())
      return failure(ErrorCode::cancelled, say<"Stopped as asked; no case was made.">(), {{"file", folder.string()}});
    if (auto committed = outputs.commit(); !committed) return passOn(committed.error());
    made.made.folder = folder;
    return made;
  });
}

Result<VolumeReplacement> giveVolume(const Case& opened, const CaseSource& source, Progress& progress) {
  return guardedCase(opened.folder, [&]() -> Result<VolumeReplacement> {
    if (opened.folder.empty() || isShipped(opened.folder) || isPublished(opened.folder))
      return failure(ErrorCode::notWritable,
                     say<"The case is not your own, so that nothing is put into its folder; save it as your own case first.">());
    OutputSet outputs;  // never committed: what is only needed meanwhile goes with it
    const fs::path scratch = opened.folder / kScratch;
    if (auto announced = outputs.announceNewFolder(scratch); !announced) return passOn(announced.error());
    const auto put = putSource(source, true, opened.folder, outputs.staged(scratch), progress);
    if (!put) return passOn(put.error());
    VolumeReplacement given{opened};
    const bool hadNone = hasNoVolume(opened);
    const RecordingRights rights = rightsOf(opened);
    dropWhatIsLost(given);
    if (hadNone) given.edited = withRights(std::move(given.edited), rights);
    takeIn(given.edited, *put);
    given.notes = put->notes;
    if (hadNone && withoutRecordedArtefacts(given.edited.scene)) given.notes.push_back(artefactsAreOff());
    const bool isPlaced = !hadNone || opened.volume.fileToWorld != Transform<frame::World, frame::File>{};
    const DefaultPlacement place = choosePlace(put->shape, opened.mannequin, opened.folder, opened.region,
                                               isPlaced ? std::optional(opened.volume.fileToWorld) : std::nullopt);
    given.edited.volume.fileToWorld = place.fileToWorld;
    given.notes.insert(given.notes.end(), place.notes.begin(), place.notes.end());
    return given;
  });
}

}  // namespace ew
