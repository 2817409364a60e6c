#include <algorithm>
#include <ostream>

#include "ew/door/door.h"
#include "ew/door/headless_host.h"
#include "run/command.h"

namespace ew::cli {
namespace {

using nlohmann::json;

json statusJson(const door::PluginStatus& plugin) {
  json shown = {
      {"title", plugin.title()}, {"state", door::nameOf(plugin.state)}, {"message", plugin.sentence()}, {"folder", plugin.folder.string()}};
  if (plugin.manifest) {
    shown["name"] = plugin.manifest->name;
    shown["version"] = plugin.manifest->version;
    shown["capabilities"] = plugin.manifest->capabilities;
    shown["description"] = plugin.manifest->description;
  }
  return shown;
}

Result<int> listPlugins(bool asJson, Run& run) {
  const auto folders = door::pluginFolders();
  door::HeadlessHost host(run.progress);
  door::PluginList plugins(folders);
  {
    const StepClock clock(run.report, "load plugins");
    plugins.openAll(host);
  }
  for (const auto& plugin : plugins.states())
    if (auto kept = run.protect(plugin.folder / "plugin.json"); !kept) return passOn(kept.error());
  json shown = {{"folders", json::array()}, {"plugins", json::array()}};
  std::size_t broken = 0;
  for (const auto& folder : folders) shown["folders"].push_back(folder.string());
  for (const auto& plugin : plugins.states()) {
    shown["plugins"].push_back(statusJson(plugin));
    broken += plugin.state == door::PluginState::loaded ? 0u : 1u;
  }
  run.report.quality = {{"plugins", plugins.states().size()}, {"not_loaded", broken}};
  run.report.details["folders"] = shown["folders"];
  run.report.details["plugins"] = shown["plugins"];
  if (asJson) {
    run.out() << shown.dump(2, ' ', false, json::error_handler_t::replace) << "\n";
    return kDone;
  }
  std::size_t titleWidth = 0, versionWidth = 0;
  for (const auto& plugin : plugins.states()) {
    titleWidth = std::max(titleWidth, plugin.title().size());
    versionWidth = std::max(versionWidth, plugin.manifest ? plugin.manifest->version.size() : 1);
  }
  for (const auto& plugin : plugins.states()) {
    std::string title = plugin.title(), version = plugin.manifest ? plugin.manifest->version : "-", abilities;
    title.resize(titleWidth + 2, ' ');
    version.resize(versionWidth + 2, ' ');
    if (plugin.manifest)
      for (const auto& ability : plugin.manifest->capabilities) abilities += (abilities.empty() ? "" : ", ") + ability;
    run.out() << title << version << door::nameOf(plugin.state) << (abilities.empty() ? "" : "  (" + abilities + ")") << "\n";
    if (!plugin.message.empty()) run.out() << "  " << plugin.message << "\n";
  }
  if (plugins.states().empty()) run.out() << "No plugins.\n";
  run.out() << "Searched:";
  for (const auto& folder : folders) run.out() << " " << folder.string();
  run.out() << (folders.empty() ? " no folder exists; set ECHOWEAVE_PLUGINS to one" : "") << "\n";
  return kDone;
}

}  // namespace

void addPlugins(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("plugins", "List the plugins");
  group.require_subcommand(1);
  auto asJson = std::make_shared<bool>(false);
  auto& list =
      addCommand(group, selection, "list", "Name, version, state and capabilities of every plugin; a broken one says what is wrong",
                 {"plugins list", "plugins list --json"}, [asJson](Run& run) { return listPlugins(*asJson, run); });
  list.add_flag("--json", *asJson, "As JSON");
}

}  // namespace ew::cli
