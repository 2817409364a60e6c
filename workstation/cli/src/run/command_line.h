#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

#include "ew/cli/run_command.h"
#include "run/command.h"

namespace ew::cli {

inline constexpr const char* kBench = "bench";
inline constexpr const char* kBenchDescription = "Measure what accuracy costs in time on this machine";

/// Understands a command line and runs the command it selects, with all that surrounds one: help, errors, access, report, outputs.
/// @param add gives the root its commands
/// @return as runCommand
int runCommandLine(std::span<const std::string> args, const Surroundings& surroundings, void (*add)(CLI::App& root, Selection& selection));

}  // namespace ew::cli
