#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

#include "ew/door/door.h"
#include "run/command.h"

namespace ew::cli {

/// Whether a plugin's manifest says it brings this command ("command:NAME" among its capabilities).
[[nodiscard]] bool brings(const door::PluginStatus& plugin, const std::string& command);

/// Whether one of the plugins brings it; no code is loaded.
[[nodiscard]] bool isPluginCommand(const std::string& name);

/// Names the commands of plugins in the help of `root`, as their manifests describe them; no code is loaded.
void describePluginCommands(CLI::App& root);

/// Selects `NAME words…` as a plugin's command: its words go to the plugin as they are, but for the options all commands share. The
/// plugins are loaded when it runs; then a name nobody brings is wrong usage.
/// @error badUsage (--report without a file)
[[nodiscard]] Result<void> selectPluginCommand(std::span<const std::string> args, Selection& selection);

}  // namespace ew::cli
