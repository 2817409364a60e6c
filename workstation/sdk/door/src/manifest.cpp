#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "ew/core/foreign_json.h"
#include "ew/core/json_fields.h"
#include "ew/core/word_table.h"
#include "ew/door/door.h"
#include "ew/io/safe_file.h"
#include "ew/library/schema.h"

namespace ew::door {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifestName = "plugin.json";
constexpr std::size_t kLargestManifest_bytes = 1u << 20;

void addFolder(std::vector<fs::path>& folders, const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return;
  const fs::path whole = fs::weakly_canonical(folder, error);
  if (!error && std::find(folders.begin(), folders.end(), whole) == folders.end()) folders.push_back(whole);
}

constexpr WordTable<PluginState, 7> kPluginStateWords{{{"found", PluginState::found},
                                                       {"loaded", PluginState::loaded},
                                                       {"bad manifest", PluginState::badManifest},
                                                       {"other ABI", PluginState::otherAbi},
                                                       {"not loadable", PluginState::notLoadable},
                                                       {"failed", PluginState::failed},
                                                       {"replaced", PluginState::replaced}}};

}  // namespace

const char* nameOf(PluginState state) { return wordIn(kPluginStateWords, state); }

std::string PluginStatus::title() const { return manifest ? manifest->title : folder.filename().string(); }

std::vector<fs::path> pluginFolders() {
  std::vector<fs::path> folders;
  if (const char* chosen = std::getenv("ECHOWEAVE_PLUGINS")) {
    const std::string list(chosen);
    for (std::size_t start = 0; start <= list.size();) {
      const std::size_t end = std::min(list.find(':', start), list.size());
      if (end > start) addFolder(folders, list.substr(start, end - start));
      start = end + 1;
    }
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    addFolder(folders, program.parent_path() / "../lib/plugins");
    addFolder(folders, program.parent_path() / "../lib/echoweave/plugins");
  }
  return folders;
}

Result<PluginManifest> readPluginManifest(const fs::path& folder) {
  const fs::path file = folder / kManifestName;
  std::error_code error;
  if (!fs::exists(file, error))
    return failure(
        ErrorCode::notFound,
        say<"The plugin folder '%1' holds no %2; install the plugin again or remove the folder.">(folder, std::string(kManifestName)),
        {{"file", file.string()}});
  auto text = readTextFile(file, kLargestManifest_bytes);
  if (!text) return passOn(text.error());
  auto json = parseJson(*text, verbatim(kManifestName));
  if (json) {
    const auto problems = schemaProblems(*json, SchemaName::pluginManifest, verbatim(kManifestName));
    if (!problems.empty()) json = passOn(problems.front());
  }
  if (!json) {
    Error problem = json.error();
    problem.context.emplace_back("file", file.string());
    return passOn(std::move(problem));
  }
  PluginManifest manifest;
  manifest.name = (*json)["name"];
  manifest.title = textAt(*json, "title", manifest.name);
  manifest.version = (*json)["version"];
  manifest.abi = (*json)["abi"].get<std::uint32_t>();
  if (json->contains("capabilities")) manifest.capabilities = (*json)["capabilities"].get<std::vector<std::string>>();
  manifest.description = textAt(*json, "description");
  // The schema allows no slash, so the library lies in this folder; dlopen searches the system's folders unless the path is whole.
  const fs::path whole = fs::absolute(folder / (*json)["library"].get<std::string>(), error);
  if (error || !fs::is_regular_file(whole, error))
    return failure(ErrorCode::notFound,
                   say<"The plugin '%1' names the library '%2', which is not in its folder; install the plugin again.">(
                       manifest.title, (*json)["library"].get<std::string>()),
                   {{"file", whole.string()}});
  manifest.library = whole;
  return manifest;
}

std::vector<PluginStatus> discoverPlugins(const std::vector<fs::path>& folders) {
  std::vector<PluginStatus> found;
  for (const auto& folder : folders) {
    std::vector<fs::path> entries;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
      std::error_code ignored;
      if (fs::is_directory(at->path(), ignored) && !at->path().filename().string().starts_with('.')) entries.push_back(at->path());
    }
    std::sort(entries.begin(), entries.end());
    for (const auto& entry : entries) {
      PluginStatus status;
      status.folder = entry;
      if (auto manifest = readPluginManifest(entry)) {
        status.manifest = std::move(*manifest);
      } else {
        status.state = PluginState::badManifest;
        status.message = manifest.error().message;
      }
      found.push_back(std::move(status));
    }
  }
  return found;
}

}  // namespace ew::door
