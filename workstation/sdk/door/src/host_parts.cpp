#include "ew/door/host_parts.h"

#include <spdlog/spdlog.h>

#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"

namespace ew::door {

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
void FileVolumes::show(Volume, const std::string&) {}

Result<std::string> TextFiles::readText(const std::filesystem::path& file) { return readTextFile(file); }
Result<void> TextFiles::writeText(const std::filesystem::path& file, const std::string& text) { return writeFileSafely(file, text); }

void ProgramLog::info(const std::string& text) { spdlog::info("{}", text); }
void ProgramLog::warn(const std::string& text) { spdlog::warn("{}", text); }
void ProgramLog::error(const std::string& text) { spdlog::error("{}", text); }

}  // namespace ew::door
