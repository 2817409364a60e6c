#pragma once

#include <map>
#include <string>

#include "ew/sdk/host.h"

namespace ew::test {

/// Volumes in memory by path, as a plugin's door to files.
class MemoryVolumes final : public sdk::Volumes {
 public:
  Result<Volume> read(const std::filesystem::path& file, Progress&) override {
    const auto at = volumes.find(file.string());
    if (at == volumes.end()) return failure(ErrorCode::notFound, "There is no file '" + file.string() + "'.");
    return at->second;
  }
  Result<void> write(const Volume& volume, const std::filesystem::path& file, Progress&) override {
    if (--writesLeft < 0) return failure(ErrorCode::notWritable, "The disk is full; make room and try again.");
    if (auto made = files_.writeText(file, "volume"); !made) return made;
    written[file.filename().string()] = volume;
    return {};
  }
  Result<void> writeCoverage(const Volume& volume, const std::filesystem::path& file, Progress& progress) override {
    return write(volume, file, progress);
  }
  Result<void> readCoverageInto(Volume& volume, const std::filesystem::path& file, Progress&) override {
    const auto at = volumes.find(file.string());
    if (at == volumes.end()) return failure(ErrorCode::notFound, "There is no file '" + file.string() + "'.");
    volume.coverage = at->second.echo;
    return {};
  }
  Result<sdk::VolumeInfo> inspect(const std::filesystem::path& file) override {
    const auto at = volumes.find(file.string());
    if (at == volumes.end()) return failure(ErrorCode::notFound, "There is no file '" + file.string() + "'.");
    return sdk::VolumeInfo{false, at->second.grid, {file}};
  }
  Result<std::vector<std::uint8_t>> readConfidence(const Grid&, const std::filesystem::path& file, Progress&) override {
    const auto at = volumes.find(file.string());
    if (at == volumes.end()) return failure(ErrorCode::notFound, "There is no file '" + file.string() + "'.");
    return at->second.echo;
  }
  Result<void> writeConfidence(const Grid& grid, std::span<const std::uint8_t> confidence, const std::filesystem::path& file,
                               Progress& progress) override {
    return write({grid, {confidence.begin(), confidence.end()}, {}}, file, progress);
  }
  Result<sdk::SweepPlan> planSweep(const std::filesystem::path&, const sdk::SweepOptions&, Progress&) override { return noSweep(); }
  Result<sdk::SweepVolume> reconstruct(const std::filesystem::path&, const sdk::SweepOptions&, Progress&) override { return noSweep(); }
  Result<std::unique_ptr<sdk::VolumeWriter>> writeInBlocks(const Grid& grid, const std::filesystem::path& file) override {
    return std::make_unique<Writer>(*this, grid, file);
  }
  void show(Volume, const std::string&) override {}

  explicit MemoryVolumes(sdk::Files& files) : files_(files) {}
  std::map<std::string, Volume> volumes;
  std::map<std::string, Volume> written;
  /// The last volume written to a file whose name ends like this.
  [[nodiscard]] Volume writtenAs(const std::string& ending) const {
    for (const auto& [name, volume] : written)
      if (name.ends_with(ending)) return volume;
    return {};
  }
  int writesLeft = 1000;

 private:
  class Writer final : public sdk::VolumeWriter {
   public:
    Writer(MemoryVolumes& owner, const Grid& grid, std::filesystem::path file)
        : owner_(owner), volume_{grid, std::vector<std::uint8_t>(grid.voxelCount()), {}}, file_(std::move(file)) {}
    void put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) override {
      std::size_t from = 0;
      for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
          for (int i = 0; i < size.x; ++i) volume_.echo[volume_.grid.indexOf(corner.x + i, corner.y + j, corner.z + k)] = values[from++];
    }
    Result<void> finish(Progress& progress) override { return owner_.write(volume_, file_, progress); }

   private:
    MemoryVolumes& owner_;
    Volume volume_;
    std::filesystem::path file_;
  };
  static tl::unexpected<Error> noSweep() { return failure(ErrorCode::unsupported, "There are no sweeps here."); }
  sdk::Files& files_;
};

/// Texts on disk without any care: what the logic does on top is under test.
class PlainFiles final : public sdk::Files {
 public:
  Result<std::string> readText(const std::filesystem::path& file) override;
  Result<void> writeText(const std::filesystem::path& file, const std::string& text) override;
};

}  // namespace ew::test
