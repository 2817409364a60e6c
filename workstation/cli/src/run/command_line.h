#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>

#include "ew/cli/run_command.h"
#include "run/command.h"

namespace ew::cli {

inline constexpr const char* kBench = "bench";
inline constexpr const char* kBenchDescription = "Measure what accuracy costs in time on this machine";

using AddCommands = void(CLI::App& root, Selection& selection);
/// Gives the root the commands of `echoweave`, in the order in which its help lists them; of the benches the name.
AddCommands addAllCommands;

/// Whether the words are for this program itself, and not for a plugin's command: a command of its own, an option, or nothing.
[[nodiscard]] bool isBuiltIn(std::span<const std::string> args);

/// Reads words that isBuiltIn, and answers those that ask for help or the version or cannot be understood.
/// @param add gives the root its commands
/// @return the status of what was answered; empty: `selection` is to be run
[[nodiscard]] std::optional<int> understand(std::span<const std::string> args, const Surroundings& surroundings, AddCommands* add,
                                            Selection& selection);

void tellError(std::ostream& terminal, const Error& error, bool verbose);

/// Understands a command line and runs the command it selects, with all that surrounds one: help, errors, access, report, outputs.
/// @param add gives the root its commands
/// @return as runCommand
int runCommandLine(std::span<const std::string> args, const Surroundings& surroundings, AddCommands* add);

}  // namespace ew::cli
