#pragma once

#include <functional>
#include <ostream>

#include "ew/cli/run_command.h"

namespace ew::cli {

/// What each of our programs does first: a file that may not grow becomes a sentence, and the log goes to the error stream, for the output
/// stream is for results.
/// @return the error stream, which shows no control characters
std::ostream& beginProgram();

/// Runs a command at the terminal: a first Ctrl-C asks it to stop, a second one ends the program.
int runUntilStopped(const std::function<int(const Surroundings&)>& run);

}  // namespace ew::cli
