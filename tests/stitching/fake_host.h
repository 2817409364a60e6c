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
  void show(Volume, const std::string&) override {}

  explicit MemoryVolumes(sdk::Files& files) : files_(files) {}
  std::map<std::string, Volume> volumes;
  std::map<std::string, Volume> written;
  int writesLeft = 1000;

 private:
  sdk::Files& files_;
};

/// Texts on disk without any care: what the logic does on top is under test.
class PlainFiles final : public sdk::Files {
 public:
  Result<std::string> readText(const std::filesystem::path& file) override;
  Result<void> writeText(const std::filesystem::path& file, const std::string& text) override;
};

class QuietLog final : public sdk::Log {
 public:
  void info(const std::string&) override {}
  void warn(const std::string& text) override { warnings.push_back(text); }
  void error(const std::string&) override {}
  std::vector<std::string> warnings;
};

}  // namespace ew::test
