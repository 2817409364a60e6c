#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/sdk/plugin.h"

namespace ew::door {

/// What plugin.json beside a plugin's library says; read without loading any code. Schema: resources/schemas/plugin.schema.json.
struct PluginManifest {
  std::string name;     ///< identifier, also the folder's name by habit
  std::string title;    ///< as shown; the name when the manifest gives none
  std::string version;  ///< "0.1.0"
  std::uint32_t abi = 0;
  std::vector<std::string> capabilities;  ///< "panel", "command:stitch", …: for people, the door does not act on them
  std::string description;
  std::filesystem::path library;  ///< absolute; inside the plugin's folder
  bool operator==(const PluginManifest&) const = default;
};

enum class PluginState {
  found,        ///< manifest read, code not loaded
  loaded,       ///< created and running
  badManifest,  ///< missing, broken, or naming a library that is not there
  otherAbi,     ///< built for another program or another version of this one
  notLoadable,  ///< not a library of this system, or one with missing symbols
  failed,       ///< its own code refused or threw while it was created
  replaced      ///< another plugin of the same name was found before it and is used
};
const char* nameOf(PluginState state);

/// One line of the Plugins page and of `echoweave plugins list`.
struct PluginStatus {
  std::filesystem::path folder;
  std::optional<PluginManifest> manifest;  ///< empty when it could not be read
  PluginState state = PluginState::found;
  std::string sentence;  ///< what is wrong and what to do; empty while nothing is

  /// The manifest's title, or the folder's name when there is no manifest.
  [[nodiscard]] std::string title() const;
};

/// $ECHOWEAVE_PLUGINS (several, separated by ':'), then <program>/../lib/plugins (build tree) and <program>/../lib/echoweave/plugins
/// (installed); those that exist, each once.
[[nodiscard]] std::vector<std::filesystem::path> pluginFolders();

/// Every sub-folder of `folders` as one plugin, by name within a folder. Reads manifests only.
[[nodiscard]] std::vector<PluginStatus> discoverPlugins(const std::vector<std::filesystem::path>& folders);

/// @error notFound, badHeader (not JSON), badField (name, value found, value expected), tooLarge
[[nodiscard]] Result<PluginManifest> readPluginManifest(const std::filesystem::path& folder);

/// A plugin that runs. Its library is never unloaded; destroying this destroys the plugin object.
class OpenPlugin {
 public:
  using Destroy = void (*)(sdk::Plugin*);
  OpenPlugin(sdk::Plugin* plugin, Destroy destroy) : plugin_(plugin), destroy_(destroy) {}
  ~OpenPlugin();
  OpenPlugin(OpenPlugin&& other) noexcept : plugin_(other.plugin_), destroy_(other.destroy_) { other.plugin_ = nullptr; }
  OpenPlugin& operator=(OpenPlugin&&) = delete;
  OpenPlugin(const OpenPlugin&) = delete;
  OpenPlugin& operator=(const OpenPlugin&) = delete;
  [[nodiscard]] sdk::Plugin& plugin() const { return *plugin_; }

 private:
  sdk::Plugin* plugin_;
  Destroy destroy_;
};

/// Loads what discoverPlugins found, checking in this order: manifest, ABI in the manifest, library, symbols, ABI of the code, creation.
/// Whatever goes wrong is written into `status` and gives an empty result; nothing is thrown.
[[nodiscard]] std::optional<OpenPlugin> openPlugin(PluginStatus& status, sdk::Host& host);

/// All plugins of a program: what the Plugins page shows and what keeps them alive. `host` must outlive the list.
class PluginList {
 public:
  /// Reads the manifests of `folders`; opens nothing.
  explicit PluginList(const std::vector<std::filesystem::path>& folders = pluginFolders());
  PluginList(PluginList&&) noexcept = default;
  ~PluginList();

  /// Opens every plugin that was found and not opened yet, in order. One whose name belongs to a plugin that runs already is not opened
  /// (replaced): the earlier folder wins, but a plugin that cannot be used hides nobody.
  void openAll(sdk::Host& host);
  [[nodiscard]] const std::vector<PluginStatus>& states() const { return states_; }

 private:
  std::vector<PluginStatus> states_;
  std::vector<OpenPlugin> open_;
};

}  // namespace ew::door
