#pragma once

#include <atomic>
#include <iosfwd>
#include <span>
#include <string>

namespace ew::cli {

/// What a command tells the shell.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;      ///< it could not be done; one sentence on the error stream says why and what to do
inline constexpr int kWrongUsage = 2;  ///< the words of the command line do not fit together
inline constexpr int kVerdict = 3;     ///< the work was done and its honest answer is "no" or "cannot tell"

/// Where a command talks to, and how it is asked to stop.
struct Surroundings {
  std::ostream& out;  ///< results: what was asked for, in words
  std::ostream& err;  ///< progress, remarks, errors
  bool errIsTerminal = false;
  const std::atomic<bool>* cancel = nullptr;  ///< becomes true when the user wants to stop; may be null
};

/// True when these words (without the program's name) name a headless command or ask for help or the version; otherwise they are
/// meant for the window: nothing, its options, or something to open.
[[nodiscard]] bool isHeadless(std::span<const std::string> args);

/// True when these words are for the benches, or ask for their help: they are run by a program of their own (run_bench.h).
[[nodiscard]] bool isBench(std::span<const std::string> args);

/// Runs one headless command, in this process, without a display. Returns one of the four numbers above.
int runCommand(std::span<const std::string> args, const Surroundings& surroundings);

}  // namespace ew::cli
