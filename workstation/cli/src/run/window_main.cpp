#include <ostream>
#include <string>
#include <vector>

#include "ew/cli/run_command.h"
#include "ew/cli/window_arguments.h"
#include "ew/core/simd.h"
#include "ew/ui/run.h"
#include "run/program.h"
#include "run/programs.h"

/// The window: `echoweave` becomes this program when its words name no command.
int main(int argc, char** argv) {
  std::ostream& err = ew::cli::beginProgram();
  const std::vector<std::string> args(argv + 1, argv + argc);
  const auto wish = ew::cli::windowArguments(args);
  if (!wish) {
    if (ew::cli::seemsCommand(args, wish.error())) return ew::cli::becomeCommand(argv);
    err << "echoweave: " << wish.error().sentence() << "\n" << std::flush;
    return wish.error().code == ew::ErrorCode::badUsage ? ew::cli::kWrongUsage : ew::cli::kFailed;
  }
  if (const auto chosen = ew::useSimd(ew::simdOfEnvironment()); !chosen) {
    err << "echoweave: ECHOWEAVE_SIMD: " << chosen.error().sentence() << "\n" << std::flush;
    return ew::cli::kWrongUsage;
  }
  ew::ui::WindowOptions options;
  options.open = wish->open;
  options.lesson = wish->lesson;
  options.launchedBy = wish->launchedBy;
  options.startPage = wish->startPage;
  options.workspace = wish->workspace;
  options.theme = wish->theme;
  options.screenshot = wish->screenshot;
  options.size_px = wish->size_px;
  return ew::ui::runWorkstation(argc, argv, options);
}
