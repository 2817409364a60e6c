#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "ew/core/result.h"

namespace ew::cli {

// The programs that share the words of one command line: `echoweave` answers for the words alone and becomes one of the others, which do
// the work and load the libraries it takes.
inline constexpr const char* kCommandProgram = "echoweave-command";
inline constexpr const char* kWindowProgram = "echoweave-window";
inline constexpr const char* kBenchProgram = "echoweave-bench";

/// A program of ours, which lies beside this one; empty when it is not there.
[[nodiscard]] std::filesystem::path programBeside(const char* name);

/// Hands over to a program of ours that reads the same words. Returns only when that fails.
/// @param what is told then: "The window"
int become(const std::filesystem::path& program, const char* what, char** argv);

/// Hands over to the program of the commands. Returns only when that fails.
int becomeCommand(char** argv);

/// Whether the environment names a screen for a window.
[[nodiscard]] bool hasDisplay();

/// Whether words that open nothing are most likely a command all the same: one of a plugin that does not announce it, or a slip of the pen.
/// @param problem of windowArguments
[[nodiscard]] bool seemsCommand(std::span<const std::string> args, const Error& problem);

}  // namespace ew::cli
