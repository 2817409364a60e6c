#include <algorithm>

#include "case/echo_files.h"
#include "case/frame_files.h"
#include "case/manifest.h"
#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "ew/library/preparation.h"
#include "ew/phantom/flow.h"
#include "ew/phantom/patient.h"
#include "files/guarded_case.h"
#include "making/case_acoustics.h"
#include "making/case_pipeline.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

Result<CaseEcho> fromRecipe(const Case& opened, const PreparationOptions& options, Progress& progress) {
  const auto plan = planOf(opened);
  if (!plan) return passOn(plan.error());
  auto tissues = acousticsOf(*plan);
  if (!tissues) return passOn(tissues.error());
  PartOfProgress reading(progress, 0.0, 0.01), making(progress, 0.01, 1.0);
  auto flow = flowOf(*plan, reading);
  if (!flow) return passOn(flow.error());
  CaseEcho found;
  found.flow = std::move(*flow);
  if (options.draft && isWorthDrafting(opened, *plan)) {
    auto draft = makeDraft(opened, *plan, options, making);
    if (!draft) return passOn(draft.error());
    found.volume = std::move(draft->volume);
    found.labels = std::move(draft->labels);
    found.tissue = std::move(draft->maps);
    found.motion = std::move(draft->motion);
    found.tissues = std::move(*tissues);
    found.isDraft = true;
    return found;
  }
  auto made = makePrepared(opened, *plan, options, making, found.notes);
  if (!made) return passOn(made.error());
  found.volume = std::move(made->volume);
  found.labels = std::move(made->labels);
  found.tissue = std::move(made->maps);
  found.motion = std::move(made->motion);
  found.tissues = std::move(*tissues);
  return found;
}

/// One of the files beside a volume: samples that stand for themselves.
Result<Volume> readBeside(const Case& opened, const std::string& relative, const std::string& field, Progress& progress,
                          std::vector<Message>& notes) {
  auto file = volumeOfCase(opened.folder, relative, field);
  if (!file) return passOn(file.error());
  auto read = readLabelVolume(*file, progress);
  if (!read) return passOn(read.error());
  notes.insert(notes.end(), read->notes.begin(), read->notes.end());
  return std::move(read->volume);
}

Result<CaseEcho> fromFiles(const Case& opened, const fs::path& file, Progress& progress) {
  const bool isAlone = opened.volume.labels.empty() && opened.volume.level.empty() && opened.volume.frames.empty();
  PartOfProgress first(progress, 0.0, isAlone ? 1.0 : 0.5), second(progress, 0.5, 0.65), third(progress, 0.65, 0.8),
      fourth(progress, 0.8, 1.0);
  auto loaded = readVolume(file, first);
  if (!loaded) return passOn(loaded.error());
  CaseEcho read{
      .volume = std::move(loaded->volume), .labels = {}, .tissue = {}, .motion = {}, .tissues = {}, .notes = std::move(loaded->notes)};
  if (!opened.volume.frames.empty()) {
    auto frames = readFrameStack(opened, read.volume.grid, second);
    if (!frames) return passOn(frames.error());
    read.frames = std::move(*frames);
  }
  if (!opened.volume.labels.empty()) {
    auto labels = readBeside(opened, opened.volume.labels, "volume.labels", second, read.notes);
    if (!labels) return passOn(labels.error());
    read.labels = std::move(*labels);
  }
  if (!opened.volume.level.empty()) {
    auto level = readBeside(opened, opened.volume.level, "volume.level", third, read.notes);
    if (!level) return passOn(level.error());
    auto tissue = readTissue(opened, std::move(*level), read.volume.grid, fourth, read.notes);
    if (!tissue) return passOn(tissue.error());
    read.tissue = std::move(tissue->maps);
    read.motion = std::move(tissue->motion);
    read.flow = std::move(tissue->flow);
  }
  return read;
}

}  // namespace

Result<std::vector<TissueAcoustics>> acousticsOf(const CasePlan& plan) {
  const auto tissues = readLabelTissues(plan.patientFile, plan.mannequins);
  if (!tissues) return passOn(tissues.error());
  std::vector<TissueAcoustics> acoustics;
  for (const LabelTissue& each : *tissues)
    acoustics.push_back({each.label, each.organ.empty() ? each.tissue.name : each.organ, each.tissue.attenuation_dbPerCmMhz,
                         each.tissue.reflection_db, each.tissue.impedance_mrayl});
  return acoustics;
}

Result<std::shared_ptr<const FlowField>> flowOf(const CasePlan& plan, Progress& progress) {
  if (!plan.sweeps.empty()) return std::shared_ptr<const FlowField>();
  auto flow = readPatientFlow(plan.patientFile, plan.mannequins, {}, progress);
  if (!flow) return passOn(flow.error());
  if (flow->streams.empty()) return std::shared_ptr<const FlowField>();
  return std::make_shared<const FlowField>(std::move(*flow));
}

void placeEcho(const Case& opened, CaseEcho& echo) {
  const auto& fileToWorld = opened.volume.fileToWorld;
  echo.volume.grid = placed(echo.volume.grid, fileToWorld);
  if (echo.labels) echo.labels->grid = placed(echo.labels->grid, fileToWorld);
  if (echo.tissue) echo.tissue->grid = placed(echo.tissue->grid, fileToWorld);
  if (echo.motion)
    for (TissueMotion::Mode& mode : echo.motion->modes) mode.grid = placed(mode.grid, fileToWorld);
  if (echo.flow) {
    FlowField moved = *echo.flow;
    for (FlowStream& stream : moved.streams)
      for (FlowNode& node : stream.line) node.place_mm = (fileToWorld * Point<frame::File>{node.place_mm}).at;
    echo.flow = std::make_shared<const FlowField>(std::move(moved));
  }
}

Result<CaseEcho> loadCaseVolume(const Case& opened, Progress& progress, const PreparationOptions& options) {
  Result<CaseEcho> found = [&]() -> Result<CaseEcho> {
    if (!opened.volume.recipe.empty()) return fromRecipe(opened, options, progress);
    if (opened.volume.file.empty())
      return failure(
          ErrorCode::emptyVolume,
          say<"The case '%1' has no volume yet; give it one in the Author workspace, or make it anew from a volume.">(opened.title),
          {{"field", "volume.file"}, {"found", "missing"}});
    auto file = volumeOfCase(opened.folder, opened.volume.file, "volume.file");
    if (!file) return passOn(file.error());
    return fromFiles(opened, *file, progress);
  }();
  if (!found) return found;
  if (auto rigid = checkRigid(opened.volume.fileToWorld); !rigid) return passOn(rigid.error());
  placeEcho(opened, *found);
  return found;
}

Result<std::optional<Volume>> loadCaseLabels(const Case& opened, Progress& progress, const PreparationOptions& options) {
  Result<std::optional<Volume>> found = [&]() -> Result<std::optional<Volume>> {
    if (!opened.volume.recipe.empty()) {
      const auto plan = planOf(opened);
      if (!plan) return passOn(plan.error());
      auto made = makeLabels(opened, *plan, options, progress);
      if (!made) return passOn(made.error());
      return std::optional<Volume>(std::move(*made));
    }
    if (opened.volume.labels.empty()) return std::optional<Volume>();
    std::vector<Message> notes;
    auto read = readBeside(opened, opened.volume.labels, "volume.labels", progress, notes);
    if (!read) return passOn(read.error());
    return std::optional<Volume>(std::move(*read));
  }();
  if (!found || !*found) return found;
  if (auto rigid = checkRigid(opened.volume.fileToWorld); !rigid) return passOn(rigid.error());
  (*found)->grid = placed((*found)->grid, opened.volume.fileToWorld);
  return found;
}

Scene sceneWithTissues(const Scene& manifest, const std::vector<TissueAcoustics>& recipe) {
  Scene scene = manifest;
  for (const TissueAcoustics& each : recipe) {
    const bool own = std::any_of(manifest.tissues.begin(), manifest.tissues.end(), [&](const auto& t) { return t.label == each.label; });
    if (!own) scene.tissues.push_back(each);
  }
  std::stable_sort(scene.tissues.begin(), scene.tissues.end(), [](const auto& a, const auto& b) { return a.label < b.label; });
  return scene;
}

bool caseNeedsPreparation(const Case& opened) {
  if (opened.volume.recipe.empty()) return false;
  const auto plan = planOf(opened);
  return plan && !plan->isDone();
}

bool mayBeDrafted(const Case& opened) {
  if (opened.volume.recipe.empty()) return false;
  const auto plan = planOf(opened);
  return plan && isWorthDrafting(opened, *plan);
}

Result<PreparationEstimate> estimatePreparation(const Case& opened) {
  if (opened.volume.recipe.empty()) return PreparationEstimate{0.0, true};
  const auto plan = planOf(opened);
  if (!plan) return passOn(plan.error());
  return guardedCase(opened.folder, [&]() -> Result<PreparationEstimate> { return estimateOf(opened, *plan); });
}

Result<std::vector<Message>> prepareCase(const Case& opened, const PreparationOptions& options, Progress& progress) {
  if (opened.volume.recipe.empty()) return std::vector<Message>{};
  const auto plan = planOf(opened);
  if (!plan) return passOn(plan.error());
  std::vector<Message> notes;
  if (plan->isDone()) return notes;
  const auto made = makePrepared(opened, *plan, options, progress, notes);
  if (!made) return passOn(made.error());
  return notes;
}

std::vector<Case> preparationOrder(const std::vector<Case>& cases) {
  std::vector<std::pair<double, const Case*>> waiting;
  for (const Case& each : cases) {
    if (!caseNeedsPreparation(each)) continue;
    const auto estimate = estimatePreparation(each);
    waiting.emplace_back(estimate ? estimate->seconds : 1e9, &each);
  }
  std::stable_sort(waiting.begin(), waiting.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Case> order;
  for (const auto& [seconds, each] : waiting) order.push_back(*each);
  return order;
}

}  // namespace ew
