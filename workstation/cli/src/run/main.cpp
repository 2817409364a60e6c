#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "ew/cli/run_command.h"
#include "ew/cli/window_arguments.h"
#include "ew/core/printable.h"
#include "run/program.h"

namespace {

namespace fs = std::filesystem;

int runHeadless(const std::vector<std::string>& args) {
  return ew::cli::runUntilStopped([&](const ew::cli::Surroundings& surroundings) { return ew::cli::runCommand(args, surroundings); });
}

bool hasDisplay() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    if (const char* value = std::getenv(name); value && *value) return true;
  return false;
}

/// A program of ours, which lies beside this one; empty when it is not there.
fs::path programBeside(const char* name) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path() / name;
  return !error && fs::exists(program, error) ? program : fs::path();
}

/// Hands over to a program of ours that reads the same words. Returns only when that fails.
int become(const fs::path& program, const char* what, char** argv) {
  execv(program.c_str(), argv);
  std::cerr << "echoweave: " << what << " in '" << ew::printableLine(program.string()) << "' could not be started (" << std::strerror(errno)
            << "); install EchoWeave again.\n";
  return ew::cli::kFailed;
}

int openWindow(char** argv) {
  const fs::path window = programBeside("echoweave-window");
  if (window.empty()) {
    std::cerr << "echoweave: This build has no window; configure it with the part 'ui', or use a command ('echoweave --help').\n";
    return ew::cli::kFailed;
  }
  if (!hasDisplay()) {
    std::cerr << "echoweave: There is no screen here to open the window on; set DISPLAY, start it with './run --screenshot OUT.png' for an "
                 "image of the window, or use a command ('echoweave --help').\n";
    return ew::cli::kFailed;
  }
  return become(window, "The window", argv);
}

}  // namespace

int main(int argc, char** argv) {
  std::ostream& err = ew::cli::beginProgram();
  const std::vector<std::string> args(argv + 1, argv + argc);
  if (ew::cli::isBench(args))
    if (const fs::path bench = programBeside("echoweave-bench"); !bench.empty()) return become(bench, "The program of the benches", argv);
  if (ew::cli::isHeadless(args)) return runHeadless(args);
  const auto wish = ew::cli::windowArguments(args);
  if (wish) return openWindow(argv);
  // A lone word that is nothing to open is most likely a command: one of a plugin that does not announce it, or a slip of the pen.
  if (!args.empty() && !args.front().starts_with("-") && wish.error().code == ew::ErrorCode::notFound &&
      args.front().find_first_of("/.") == std::string::npos)
    return runHeadless(args);
  err << "echoweave: " << wish.error().sentence() << "\n" << std::flush;
  return wish.error().code == ew::ErrorCode::badUsage ? ew::cli::kWrongUsage : ew::cli::kFailed;
}
