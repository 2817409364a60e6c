#pragma once

#include <span>
#include <string>

#include "ew/cli/run_command.h"

namespace ew::cli {

/// Runs `bench NAME …`, which is a program of its own, echoweave-bench: as runCommand, with the same words, numbers and streams.
int runBench(std::span<const std::string> args, const Surroundings& surroundings);

}  // namespace ew::cli
