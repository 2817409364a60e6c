#include "logic/chain_json.h"
#include "logic/chain_memory.h"
#include "logic/provenance.h"
#include "logic/steps/result_blocks.h"
#include "logic/steps/steps.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::array<const char*, 3> kResultFiles = {"volume.mha", "coverage.mha", "source.mha"};
constexpr const char* kProvenance = "provenance.json";

fs::path waiting(const ChainRun& run, const std::string& key, const char* name) {
  return run.store.fileOf(nameOf(Step::volume), key, name);
}

/// Joining measures its seams block by block; where the whole is at hand, nothing has to be left out at the blocks' edges.
void measureWhole(const SeamOptions& seam, const std::array<Volume, 3>& made, JoinReport& report) {
  if (seam.method == SeamMethod::feather) return;
  const double step_db = report.seam.meanStep_db;
  report.seam = seamVisibility(made[0], made[2].echo, seam.blend_mm);
  if (seam.blend_mm > 0.0) report.seam.meanStep_db = step_db;  // that of the views: an edge of tissue is none
}

Result<JoinReport> makeInBlocks(ChainRun& run, std::span<const View> views, const Grid& grid, const std::string& key, Progress& progress) {
  PartOfProgress joining(progress, 0.0, 0.8), writing(progress, 0.8, 1.0);
  FileBlocks blocks(run.included);
  for (std::size_t which = 0; which < kResultFiles.size(); ++which) {
    auto writer = run.volumes.writeInBlocks(grid, waiting(run, key, kResultFiles[which]));
    if (!writer) return passOn(writer.error());
    blocks.writers[which] = std::move(*writer);
  }
  auto report = join(views, run.seams, grid, run.joinOptions(), blocks, joining);
  if (!report) return report;
  for (auto& writer : blocks.writers)
    if (auto finished = writer->finish(writing); !finished) return passOn(finished.error());
  return report;
}

Result<JoinReport> makeInMemory(ChainRun& run, std::span<const View> views, const Grid& grid, const std::string& key, Progress& progress) {
  PartOfProgress joining(progress, 0.0, 0.8), writing(progress, 0.8, 1.0);
  MemoryBlocks blocks(run.included, grid);
  auto report = join(views, run.seams, grid, run.joinOptions(), blocks, joining);
  if (!report) return report;
  measureWhole(run.settings.join.seam, blocks.made, *report);
  for (std::size_t which = 0; which < kResultFiles.size(); ++which)
    if (auto w = run.volumes.write(blocks.made[which], waiting(run, key, kResultFiles[which]), writing); !w) return passOn(w.error());
  return report;
}

/// The three volumes, under their waiting names.
Result<JoinReport> makeResult(ChainRun& run, const std::string& key, Progress& progress) {
  auto views = run.views(progress);
  if (!views) return passOn(views.error());
  auto grid = run.resultGrid();
  if (!grid) return passOn(grid.error());
  if (auto room = run.store.prepare(nameOf(Step::volume)); !room) return passOn(room.error());
  const bool inBlocks = grid->voxelCount() > run.options.streamAbove_voxels;
  auto report = (inBlocks ? makeInBlocks : makeInMemory)(run, *views, *grid, key, progress);
  if (!report) return report;
  for (const std::size_t v : run.state.leftOut)
    report->notes.push_back("Volume '" + run.project.volumes[v].name +
                            "' is not in the result: no pair that can be believed holds it to the others.");
  return report;
}

/// Moves a finished result to its names. The provenance goes first and comes last: with it the four belong together, whenever the program
/// is stopped, and a run that finds them half moved goes on.
Result<void> publish(ChainRun& run, const std::string& key) {
  std::error_code error;
  const auto moveIn = [&](const char* name) -> Result<void> {
    const fs::path from = waiting(run, key, name), to = run.folder / name;
    if (!fs::exists(from, error)) return {};
    fs::rename(from, to, error);
    if (error)
      return failure(ErrorCode::notWritable, "'" + to.string() + "' cannot be written (" + error.message() + "); choose another folder.",
                     {{"file", to.string()}});
    return {};
  };
  if (fs::exists(waiting(run, key, kProvenance), error)) fs::remove(run.folder / kProvenance, error);
  for (const char* name : kResultFiles)
    if (auto moved = moveIn(name); !moved) return moved;
  if (auto moved = moveIn(kProvenance); !moved) return moved;
  run.state.volume = run.folder / kResultFiles[0];
  run.state.coverage = run.folder / kResultFiles[1];
  run.state.source = run.folder / kResultFiles[2];
  run.state.provenance = run.folder / kProvenance;
  return {};
}

/// Takes what a finished result leaves behind: results before it, and sweeps the project no longer names.
void clearBehind(const ChainRun& run) {
  run.store.removeAllBut(nameOf(Step::volume), {run.keys[Step::volume]});
  std::vector<std::string> sweeps = {run.keys[Step::reconstruct]};
  for (std::size_t v = 0; v < run.inputs.size(); ++v) sweeps.push_back(run.inputs[v].key);
  run.store.removeAllBut(ChainInputs::kStep, sweeps);
}

}  // namespace

bool resultIsThere(const ChainRun& run, const std::string& key) {
  const auto sizes = readBack<std::vector<std::uintmax_t>>(
      run.store.find(nameOf(Step::volume), key), [](const json& data) { return data.at("bytes").get<std::vector<std::uintmax_t>>(); });
  if (!sizes || sizes->size() != kResultFiles.size()) return false;
  std::error_code error;
  for (std::size_t which = 0; which < kResultFiles.size(); ++which) {
    if (fs::exists(waiting(run, key, kResultFiles[which]), error)) continue;  // made, and not yet moved
    if (fs::file_size(run.folder / kResultFiles[which], error) != (*sizes)[which] || error) return false;
  }
  if (fs::exists(waiting(run, key, kProvenance), error)) return true;
  const auto provenance = run.files.readText(run.folder / kProvenance);
  if (!provenance) return false;
  const json read = json::parse(*provenance, nullptr, false);
  return read.is_object() && read.contains("key") && read["key"] == key;
}

Result<void> volumeStep(ChainRun& run, Progress& progress) {
  if (auto fits = checkMemory(run, Step::volume); !fits) return fits;
  const char* step = nameOf(Step::volume);
  const std::string& key = run.keys[Step::volume];
  if (resultIsThere(run, key)) {
    auto report = readBack<JoinReport>(run.store.find(step, key), [](const json& data) { return reportFrom(data.at("report")); });
    if (report) {
      run.outcomeOf(Step::volume).reused = true;
      run.state.report = std::move(*report);
      return publish(run, key);
    }
  }
  run.store.remove(step, key);
  auto report = makeResult(run, key, progress);
  if (!report) return passOn(report.error());
  run.state.report = std::move(*report);
  const std::string provenance = provenanceText(run.project, run.state, key);
  if (auto w = run.files.writeText(waiting(run, key, kProvenance), provenance); !w) return w;
  // The sizes are kept beside the list of files, which are moved away.
  ordered_json data = {{"report", jsonOf(*run.state.report)}, {"bytes", ordered_json::array()}};
  for (const char* name : kResultFiles) {
    std::error_code ignored;
    data["bytes"].push_back(fs::file_size(waiting(run, key, name), ignored));
  }
  if (progress.cancelRequested()) return cancelledChain();
  if (auto kept = run.store.keep(step, key, std::move(data)); !kept) return kept;
  if (auto moved = publish(run, key); !moved) return moved;
  clearBehind(run);
  return {};
}

}  // namespace ew::stitching
