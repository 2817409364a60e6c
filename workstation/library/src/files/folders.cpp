#include "ew/library/folders.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "ew/imaging/probe.h"
#include "files/private_folder.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

bool isFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

fs::path programFolder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path();
}

/// `name` below the first home of the program's data that has it.
Result<fs::path> dataFolder(const std::string& name) {
  const fs::path program = programFolder();
  std::vector<fs::path> homes;
  if (!program.empty()) homes.push_back((program / "../share/echoweave").lexically_normal());
  homes.emplace_back(EW_SOURCE_DIR);
  homes.emplace_back(EW_INSTALLED_DATA_DIR);
  for (const auto& home : homes)
    if (isFolder(home / name)) return home / name;
  return failure(
      ErrorCode::notFound,
      say<"The program's folder '%1' was not found beside the program; install EchoWeave again or set ECHOWEAVE_RESOURCES to its "
          "resources folder.">(name),
      {{"folder", name}, {"program", program.string()}});
}

}  // namespace

Result<fs::path> resourceFolder() {
  // Someone who sets the variable wants that folder; another one in its place would only hide a typing error.
  if (const std::string chosen = environment("ECHOWEAVE_RESOURCES"); !chosen.empty()) {
    if (isFolder(chosen)) return fs::path(chosen);
    return failure(ErrorCode::notFound, say<"ECHOWEAVE_RESOURCES is '%1', which is not a folder; correct it or unset it.">(chosen),
                   {{"folder", chosen}});
  }
  return dataFolder("resources");
}

Result<fs::path> shippedCasesFolder() {
  if (const std::string chosen = environment("ECHOWEAVE_RESOURCES"); !chosen.empty()) {
    const fs::path beside = fs::path(chosen).lexically_normal() / "../cases";
    if (isFolder(beside)) return beside.lexically_normal();
  }
  return dataFolder("cases");
}

bool isShipped(const fs::path& folder) {
  const auto shipped = shippedCasesFolder();
  if (!shipped) return false;
  // Through links as well: what counts is where the files lie.
  std::error_code failed;
  const fs::path root = fs::weakly_canonical(*shipped, failed);
  if (failed) return false;
  const fs::path place = fs::weakly_canonical(folder, failed);
  if (failed) return false;
  return std::mismatch(root.begin(), root.end(), place.begin(), place.end()).first == root.end();
}

fs::path libraryFolder() {
  if (const std::string chosen = environment("ECHOWEAVE_LIBRARY"); !chosen.empty()) return chosen;
  if (const std::string home = environment("HOME"); !home.empty()) return fs::path(home) / "EchoWeave";
  return "EchoWeave";
}

Result<std::vector<Probe>> shippedProbes() {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  return readProbes(*resources / "probes");
}

bool isTaken(const fs::path& folder) {
  std::error_code failed;
  return fs::exists(folder, failed) && !(fs::is_directory(folder, failed) && fs::is_empty(folder, failed));
}

fs::path ownCasesFolder() {
  if (const std::string chosen = environment("ECHOWEAVE_CASES"); !chosen.empty()) return chosen;
  return libraryFolder() / "cases";
}

fs::path cacheFolder() {
  if (const std::string chosen = environment("ECHOWEAVE_CACHE"); !chosen.empty()) return chosen;
  if (const std::string chosen = environment("XDG_CACHE_HOME"); !chosen.empty()) return fs::path(chosen) / "echoweave";
  if (const std::string home = environment("HOME"); !home.empty()) return fs::path(home) / ".cache/echoweave";
  return ownTemporaryFolder("echoweave-cache");
}

}  // namespace ew
