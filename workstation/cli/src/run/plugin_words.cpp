#include <algorithm>

#include "ew/door/door.h"
#include "run/plugin_commands.h"

namespace ew::cli {
namespace {

constexpr std::string_view kCapability = "command:";

}  // namespace

bool brings(const door::PluginStatus& plugin, const std::string& command) {
  if (!plugin.manifest) return false;
  const auto& abilities = plugin.manifest->capabilities;
  return std::find(abilities.begin(), abilities.end(), std::string(kCapability) + command) != abilities.end();
}

bool isPluginCommand(const std::string& name) {
  const auto plugins = door::discoverPlugins(door::pluginFolders());
  return std::any_of(plugins.begin(), plugins.end(), [&](const auto& plugin) { return brings(plugin, name); });
}

void describePluginCommands(CLI::App& root) {
  const auto taken = [&](const std::string& name) {
    const auto commands = root.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; });
    return !commands.empty();
  };
  for (const auto& plugin : door::discoverPlugins(door::pluginFolders())) {
    if (!plugin.manifest) continue;
    for (const auto& ability : plugin.manifest->capabilities) {
      if (!ability.starts_with(kCapability)) continue;
      const std::string name = ability.substr(kCapability.size());
      if (name.empty() || taken(name)) continue;
      root.add_subcommand(name, "(plugin " + plugin.title() + ") " + plugin.manifest->description);
    }
  }
}

}  // namespace ew::cli
