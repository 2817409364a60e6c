#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/door/fault.h"
#include "ew/sdk/plugin.h"

namespace ew::door {

/// What plugin.json beside a plugin's library says; read without loading any code. Schema: resources/schemas/plugin.schema.json.
struct PluginManifest {
  std::string name;     ///< identifier, also the folder's name by habit
  std::string title;    ///< as shown; the name when the manifest gives none
  std::string version;  ///< "0.1.0"
  std::uint32_t abi = 0;
  std::vector<std::string> capabilities;  ///< "panel", "command:stitch", …: for people; "practice" opens Cases::forPractice()
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
  Message message;  ///< what is wrong and what to do; empty while nothing is. Of a plugin that runs: what it threw last

  /// The message in English.
  [[nodiscard]] std::string sentence() const { return message.english(); }

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

/// All plugins of a program: what the Plugins page shows and what keeps them alive. `host` must outlive the list.
///
/// A plugin may throw anything at any moment: while it is created, then nothing of what it asked the host for is put into place; in a
/// panel, a command, a job, a callback, then the call ends, the plugin stays, and the first time of each kind is told. Its jobs begin, and
/// its panels and commands are there, once it has been created.
class PluginList {
 public:
  /// Told of the first fault of each plugin and moment, on the window's thread; not of commands, whose error says it, nor of plugins that
  /// could not start, which states() names. May be empty. Faults also go to the host's log and into states().
  using Tell = std::function<void(const PluginFault&)>;

  /// Reads the manifests of `folders`; opens nothing.
  explicit PluginList(const std::vector<std::filesystem::path>& folders = pluginFolders());
  PluginList(PluginList&&) noexcept;
  ~PluginList();  ///< takes back what the plugins registered and destroys them, the last one first

  /// Opens every plugin that was found and not opened yet, in order. One whose name belongs to a plugin that runs already is not opened
  /// (replaced): the earlier folder wins, but a plugin that cannot be used hides nobody. What goes wrong stands in states(); nothing is
  /// thrown. Checked in this order: manifest, ABI in the manifest, library, symbols, ABI of the code, creation.
  void openAll(sdk::Host& host, const Tell& tell = {});
  [[nodiscard]] const std::vector<PluginStatus>& states() const { return states_; }

  /// For the program's last catch: something that belongs to the panel `panelId` threw while it handled an event.
  /// @return whether such a panel is known; then it was told as any fault
  bool tellOfPanel(const std::string& panelId, const Thrown& thrown);

 private:
  struct Open;
  std::vector<PluginStatus> states_;
  std::vector<std::unique_ptr<Open>> open_;  ///< also those that could not start: what they left behind may still know their host
};

}  // namespace ew::door
