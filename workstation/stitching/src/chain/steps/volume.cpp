#include <algorithm>

#include "chain/chain_json.h"
#include "chain/chain_memory.h"
#include "chain/provenance.h"
#include "chain/steps/result_blocks.h"
#include "chain/steps/steps.h"
#include "ew/imaging/tissue_level.h"
#include "ew/io/content_key.h"
#include "ew/io/mapped_volume.h"
#include "ew/io/safe_file.h"
#include "ew/stitching/result_files.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::array kVolumes = {ResultFiles::kNames[0], ResultFiles::kNames[1], ResultFiles::kNames[2]};
constexpr const char* kLevel = ResultFiles::kNames[3];
/// With what the level belongs to.
constexpr std::array kVoxels = {kVolumes[0], kVolumes[1], kVolumes[2], kLevel};
constexpr const char* kProvenance = ResultFiles::kProvenance;

fs::path waiting(const ChainRun& run, const std::string& key, const char* name) { return waitingFile(run.store, key, name); }

/// As waiting(), of one result.
ResultFiles::Waiting allWaiting(const ChainRun& run, const std::string& key) {
  return [&run, key](const char* name) { return waiting(run, key, name); };
}

/// Joining measures its seams block by block; where the whole is at hand, nothing has to be left out at the blocks' edges.
void measureWhole(const SeamOptions& seam, const std::array<Volume, 3>& made, JoinReport& report) {
  if (seam.method == SeamMethod::feather) return;
  const double step_db = report.seam.meanStep_db;
  report.seam = seamVisibility(made[0], made[2].echo, seam.blend_mm);
  if (seam.blend_mm > 0.0) report.seam.meanStep_db = step_db;  // that of the views: an edge of tissue is none
}

LevelOptions levelOptions(const ChainRun& run) { return {.threads = run.options.threads, .maxBytes = run.options.maxBytes}; }

/// The level of a result in files, into a file.
Result<void> levelInFiles(const ChainRun& run, const std::string& key, Progress& progress) {
  PartOfProgress making(progress, 0.0, 0.8), writing(progress, 0.8, 1.0);
  const auto echo = mapVolume(waiting(run, key, kVolumes[0]));
  if (!echo) return passOn(echo.error());
  const auto coverage = mapVolume(waiting(run, key, kVolumes[1]));
  if (!coverage) return passOn(coverage.error());
  auto writer = VolumeStream::create(echo->grid(), waiting(run, key, kLevel));
  if (!writer) return passOn(writer.error());
  const LevelSink sink = [&](const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> level) {
    writer->put(corner, size, level);
  };
  const std::span<const std::uint8_t> covered{coverage->view().data, coverage->grid().voxelCount()};
  if (auto made = levelInBlocks(echo->view(), covered, levelOptions(run), sink, making); !made) return made;
  return writer->finish(writing);
}

Result<JoinReport> makeInBlocks(ChainRun& run, std::span<const View> views, const Grid& grid, const std::string& key, Progress& progress) {
  PartOfProgress joining(progress, 0.0, 0.6), writing(progress, 0.6, 0.75), levelling(progress, 0.75, 1.0);
  FileBlocks blocks(run.included);
  for (const char* name : kVolumes) {
    auto writer = VolumeStream::create(grid, waiting(run, key, name));
    if (!writer) return passOn(writer.error());
    blocks.writers.push_back(std::move(*writer));
  }
  auto report = join(views, run.seams, grid, run.joinOptions(), blocks, joining);
  if (!report) return report;
  for (auto& writer : blocks.writers)
    if (auto finished = writer.finish(writing); !finished) return passOn(finished.error());
  if (auto level = levelInFiles(run, key, levelling); !level) return passOn(level.error());
  return report;
}

Result<JoinReport> makeInMemory(ChainRun& run, std::span<const View> views, const Grid& grid, const std::string& key, Progress& progress) {
  PartOfProgress joining(progress, 0.0, 0.6), levelling(progress, 0.6, 0.8), writing(progress, 0.8, 1.0);
  MemoryBlocks blocks(run.included, grid);
  auto report = join(views, run.seams, grid, run.joinOptions(), blocks, joining);
  if (!report) return report;
  measureWhole(run.settings.join.seam, blocks.made, *report);
  auto& [echo, coverage, source] = blocks.made;
  Volume level{grid, std::vector<std::uint8_t>(grid.voxelCount(), 0), {}};
  const LevelSink sink = [&](const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) {
    copyBlock(corner, size, values, level);
  };
  if (auto made = levelInBlocks(echo.view(), coverage.echo, levelOptions(run), sink, levelling); !made) return passOn(made.error());
  const std::array<const Volume*, kVoxels.size()> all = {&echo, &coverage, &source, &level};
  for (std::size_t which = 0; which < all.size(); ++which)
    if (auto w = writeVolume(*all[which], waiting(run, key, kVoxels[which]), writing); !w) return passOn(w.error());
  return report;
}

/// The volumes, under their waiting names.
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
    report->notes.push_back(
        say<"Volume '%1' is not in the result: no pair that can be believed holds it to the others.">(run.project.volumes[v].name));
  return report;
}

/// What is left to do with a finished result, and where it will be.
void leaveToPutInPlace(ChainRun& run, const std::string& key) {
  std::vector<std::string> sweeps = {run.keys[Step::reconstruct]};
  for (std::size_t v = 0; v < run.inputs.size(); ++v) sweeps.push_back(run.inputs[v].key);
  run.result = {*run.resultFiles, key, run.options.isFolderOwn, std::move(sweeps)};
  run.state.volume = run.folder / kVolumes[0];
  run.state.coverage = run.folder / kVolumes[1];
  run.state.source = run.folder / kVolumes[2];
  run.state.level = run.folder / kLevel;
  run.state.provenance = run.folder / kProvenance;
}

}  // namespace

bool resultIsThere(const ChainRun& run, const std::string& key) {
  const auto data = run.store.find(nameOf(Step::volume), key);
  if (!data || !data->contains("results")) return false;
  const auto written = resultFilesFrom((*data)["results"]);
  if (written.size() != ResultFiles::kNames.size()) return false;
  return std::all_of(written.begin(), written.end(), [&](const ResultFile& file) {
    std::error_code error;
    const fs::path made = waiting(run, key, file.name.c_str());  // and not yet moved
    const bool isMoved = !fs::exists(made, error);
    if (fs::file_size(isMoved ? run.folder / file.name : made, error) != file.bytes || error) return false;
    if (!run.resultFiles) return true;
    if (isMoved) return run.resultFiles->contentOf(file.name) == file.content;
    const auto content = contentOf(made, noProgress());
    return content && *content == file.content;
  });
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
      leaveToPutInPlace(run, key);
      return {};
    }
  }
  auto report = makeResult(run, key, progress);
  if (!report) return passOn(report.error());
  run.state.report = std::move(*report);
  auto volumes = resultFilesAt({kVoxels.begin(), kVoxels.end()}, allWaiting(run, key));
  if (!volumes) return passOn(volumes.error());
  if (auto w = writeFileSafely(waiting(run, key, kProvenance), provenanceText(run.project, run.state, key, *volumes)); !w) return w;
  // What belongs to the result is kept beside the list of files, which are moved away.
  auto all = resultFilesAt({ResultFiles::kNames.begin(), ResultFiles::kNames.end()}, allWaiting(run, key));
  if (!all) return passOn(all.error());
  ordered_json data = {{"report", jsonOf(*run.state.report)}, {"results", jsonOf(*all)}};
  if (progress.cancelRequested()) return cancelledChain();
  if (auto kept = run.store.keep(step, key, std::move(data)); !kept) return kept;
  leaveToPutInPlace(run, key);
  return {};
}

}  // namespace ew::stitching
