#include <iostream>
#include <string>
#include <vector>

#include "ew/cli/run_command.h"
#include "ew/cli/window_arguments.h"
#include "run/program.h"
#include "run/programs.h"

namespace {

int runHeadless(const std::vector<std::string>& args) {
  return ew::cli::runUntilStopped([&](const ew::cli::Surroundings& surroundings) { return ew::cli::runCommand(args, surroundings); });
}

int openWindow(char** argv) {
  const std::filesystem::path window = ew::cli::programBeside(ew::cli::kWindowProgram);
  if (window.empty()) {
    std::cerr << "echoweave: This build has no window; configure it with the part 'ui', or use a command ('echoweave --help').\n";
    return ew::cli::kFailed;
  }
  if (!ew::cli::hasDisplay()) {
    std::cerr << "echoweave: There is no screen here to open the window on; set DISPLAY, start it with './run --screenshot OUT.png' for an "
                 "image of the window, or use a command ('echoweave --help').\n";
    return ew::cli::kFailed;
  }
  return ew::cli::become(window, "The window", argv);
}

}  // namespace

/// The commands: `echoweave` becomes this program when its words name one, or cannot be for the window.
int main(int argc, char** argv) {
  std::ostream& err = ew::cli::beginProgram();
  const std::vector<std::string> args(argv + 1, argv + argc);
  if (ew::cli::isHeadless(args)) return runHeadless(args);
  const auto wish = ew::cli::windowArguments(args);
  if (wish) return openWindow(argv);
  if (ew::cli::seemsCommand(args, wish.error())) return runHeadless(args);
  err << "echoweave: " << wish.error().sentence() << "\n" << std::flush;
  return wish.error().code == ew::ErrorCode::badUsage ? ew::cli::kWrongUsage : ew::cli::kFailed;
}
