#include "ew/door/host_parts.h"

#include <spdlog/spdlog.h>

#include <utility>

#include "ew/acquisition/sweep_volume.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/io/volume_stream.h"

namespace ew::door {
namespace {

SweepVolumeOptions optionsOf(const sdk::SweepOptions& asked) {
  return {.spacing_mm = asked.spacing_mm, .calibration = asked.calibration, .threads = asked.threads, .maxBytes = asked.maxBytes};
}

/// As checkMeant, with what a person can do about it who is asked nothing here.
Result<void> checkMeantOf(const SweepInput& opened) {
  auto meant = checkMeant(opened);
  if (meant) return {};
  Error question = meant.error();
  question.message =
      say<"%1 To say so, reconstruct the sweep by itself, which asks about it, and choose its volume instead.">(question.message);
  return passOn(std::move(question));
}

}  // namespace

Result<Volume> FileVolumes::read(const std::filesystem::path& file, Progress& progress) {
  auto loaded = readVolume(file, progress);
  if (!loaded) return passOn(loaded.error());
  for (const auto& note : loaded->notes) spdlog::warn("{}: {}", file.string(), note.english());
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
  auto opened = openSweepVolume(sweep, optionsOf(options), progress);
  if (!opened) return passOn(opened.error());
  const ImportPlan& plan = opened->plan;
  return sdk::SweepPlan{plan.grid, plan.reconstruct.spacing_mm, sweepVolumeBytes(plan), plan.frames.used};
}
Result<sdk::SweepVolume> FileVolumes::reconstruct(const std::filesystem::path& sweep, const sdk::SweepOptions& options,
                                                  Progress& progress) {
  PartOfProgress reading(progress, 0.0, 0.3), making(progress, 0.3, 1.0);
  auto opened = openSweepVolume(sweep, optionsOf(options), reading);
  if (!opened) return passOn(opened.error());
  if (auto meant = checkMeantOf(*opened); !meant) return passOn(meant.error());
  auto made = makeSweepVolume(*opened, making);
  if (!made) return passOn(made.error());
  return sdk::SweepVolume{std::move(made->volume), std::move(made->confidence), made->beams, std::move(made->notes)};
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
