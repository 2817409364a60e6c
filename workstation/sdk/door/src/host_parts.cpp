#include "ew/door/host_parts.h"

#include <spdlog/spdlog.h>

#include "ew/acquisition/sweep_geometry.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/io/volume_stream.h"
#include "ew/library/import.h"

namespace ew::door {
namespace {

Result<OpenedSweep> openAsAsked(const std::filesystem::path& sweep, const sdk::SweepOptions& options, Progress& progress) {
  SweepImportOptions import;
  if (!options.calibration.empty()) import.calibrations = {options.calibration};
  import.reconstruct.threads = options.threads;
  import.reconstruct.maxBytes = options.maxBytes;
  import.reconstruct.spacing_mm = options.spacing_mm;
  import.usual = {.spacing = options.spacing_mm <= 0.0, .interpolation = true, .compounding = true, .fillReach = true};
  return openSweep(sweep, import, progress);
}

/// The maps of all frames, and while they are pasted the finished volume.
std::uint64_t bytesWithConfidence(const ImportPlan& plan) { return plan.bytes + plan.frameBytes + 2 * plan.grid.voxelCount(); }

Result<sdk::SweepVolume> reconstructSweep(const OpenedSweep& opened, const sdk::SweepOptions& options, Progress& progress) {
  const ImportPlan& plan = opened.plan;
  if (const std::uint64_t bytes = bytesWithConfidence(plan); bytes > options.maxBytes)
    return failure(ErrorCode::tooLarge,
                   "The sweep would become " + std::to_string(plan.grid.dims.x) + " x " + std::to_string(plan.grid.dims.y) + " x " +
                       std::to_string(plan.grid.dims.z) + " voxels and need " + std::to_string(bytes >> 20) + " MiB, more than the " +
                       std::to_string(options.maxBytes >> 20) + " MiB allowed; give a coarser spacing_mm.",
                   {{"forecast_bytes", std::to_string(bytes)}});
  auto frames = posedFrames(opened);
  PartOfProgress pasting(progress, 0.3, 0.55);
  auto echoes = reconstructOnto(plan.grid, frames, plan.reconstruct, pasting);
  if (!echoes) return passOn(echoes.error());
  PartOfProgress judging(progress, 0.55, 0.75);
  const auto maps = confidenceOfFrames(frames, plan.reconstruct.clip, plan.confidence, plan.reconstruct.threads, judging);
  if (!maps) return passOn(maps.error());
  sdk::SweepVolume made;
  made.beams = beamsOf(frames, plan.reconstruct.clip);
  made.notes = plan.notes;
  // Confidence goes the way of the echoes, so that it lies where they do.
  for (std::size_t n = 0; n < frames.size(); ++n) frames[n].pixels = viewOf((*maps)[n]);
  PartOfProgress again(progress, 0.75, 1.0);
  auto confidence = reconstructOnto(plan.grid, frames, plan.reconstruct, again);
  if (!confidence) return passOn(confidence.error());
  made.volume = std::move(echoes->volume);
  made.confidence = std::move(confidence->volume.echo);
  return made;
}

}  // namespace

Result<Volume> FileVolumes::read(const std::filesystem::path& file, Progress& progress) {
  auto loaded = readVolume(file, progress);
  if (!loaded) return passOn(loaded.error());
  for (const auto& note : loaded->notes) spdlog::warn("{}: {}", file.string(), note);
  return std::move(loaded->volume);
}
Result<void> FileVolumes::write(const Volume& volume, const std::filesystem::path& file, Progress& progress) {
  return writeVolume(volume, file, progress);
}
Result<void> FileVolumes::writeCoverage(const Volume& volume, const std::filesystem::path& file, Progress& progress) {
  return ew::writeCoverage(volume, file, progress);
}
Result<void> FileVolumes::readCoverageInto(Volume& volume, const std::filesystem::path& file, Progress& progress) {
  return ew::readCoverageInto(volume, file, progress);
}
Result<sdk::VolumeInfo> FileVolumes::inspect(const std::filesystem::path& file) {
  auto header = readVolumeHeader(file);
  if (!header) return passOn(header.error());
  return sdk::VolumeInfo{header->sequence, header->grid, std::move(header->files)};
}
Result<std::vector<std::uint8_t>> FileVolumes::readConfidence(const Grid& grid, const std::filesystem::path& file, Progress& progress) {
  return ew::readConfidence(grid, file, progress);
}
Result<void> FileVolumes::writeConfidence(const Grid& grid, std::span<const std::uint8_t> confidence, const std::filesystem::path& file,
                                          Progress& progress) {
  return ew::writeConfidence(grid, confidence, file, progress);
}
Result<sdk::SweepPlan> FileVolumes::planSweep(const std::filesystem::path& sweep, const sdk::SweepOptions& options, Progress& progress) {
  auto opened = openAsAsked(sweep, options, progress);
  if (!opened) return passOn(opened.error());
  const ImportPlan& plan = opened->plan;
  return sdk::SweepPlan{plan.grid, plan.reconstruct.spacing_mm, bytesWithConfidence(plan), plan.frames.used};
}
Result<sdk::SweepVolume> FileVolumes::reconstruct(const std::filesystem::path& sweep, const sdk::SweepOptions& options,
                                                  Progress& progress) {
  PartOfProgress reading(progress, 0.0, 0.3);
  auto opened = openAsAsked(sweep, options, reading);
  if (!opened) return passOn(opened.error());
  return reconstructSweep(*opened, options, progress);
}

namespace {

class StreamWriter final : public sdk::VolumeWriter {
 public:
  explicit StreamWriter(VolumeStream stream) : stream_(std::move(stream)) {}
  void put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) override {
    stream_.put(corner, size, values);
  }
  Result<void> finish(Progress& progress) override { return stream_.finish(progress); }

 private:
  VolumeStream stream_;
};

}  // namespace

Result<std::unique_ptr<sdk::VolumeWriter>> FileVolumes::writeInBlocks(const Grid& grid, const std::filesystem::path& file) {
  auto stream = VolumeStream::create(grid, file);
  if (!stream) return passOn(stream.error());
  return std::make_unique<StreamWriter>(std::move(*stream));
}
void FileVolumes::show(Volume, const std::string&) {}

Result<std::string> TextFiles::readText(const std::filesystem::path& file) { return readTextFile(file); }
Result<void> TextFiles::writeText(const std::filesystem::path& file, const std::string& text) { return writeFileSafely(file, text); }

void ProgramLog::info(const std::string& text) { spdlog::info("{}", text); }
void ProgramLog::warn(const std::string& text) { spdlog::warn("{}", text); }
void ProgramLog::error(const std::string& text) { spdlog::error("{}", text); }

}  // namespace ew::door
