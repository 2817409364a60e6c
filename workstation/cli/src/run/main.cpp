#include <unistd.h>

#include <csignal>
#include <iostream>
#include <string>
#include <vector>

#include "run/command_line.h"
#include "run/programs.h"

/// The program a user calls. It answers for the words of the command line itself, help among them, and becomes another program for what
/// they ask: a start takes the libraries that its work needs and no others.
int main(int argc, char** argv) {
  using namespace ew::cli;
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a sentence and a clean folder, not the end of the program
  const std::vector<std::string> args(argv + 1, argv + argc);
  if (isBench(args))
    if (const auto bench = programBeside(kBenchProgram); !bench.empty()) return become(bench, "The program of the benches", argv);
  if (isHeadless(args)) {
    Selection selection;
    if (isBuiltIn(args))
      if (const auto status = understand(args, {std::cout, std::cerr, isatty(STDERR_FILENO) == 1}, addAllCommands, selection))
        return *status;
    return becomeCommand(argv);
  }
  const auto window = programBeside(kWindowProgram);
  return window.empty() || !hasDisplay() ? becomeCommand(argv) : become(window, "The window", argv);
}
