#include <string>
#include <vector>

#include "ew/cli/run_bench.h"
#include "run/program.h"

/// The benches: `echoweave` becomes this program when its words begin with "bench". Called by itself it needs that word no more.
int main(int argc, char** argv) {
  ew::cli::beginProgram();
  std::vector<std::string> args(argv + 1, argv + argc);
  if (!ew::cli::isBench(args)) args.insert(args.begin(), "bench");
  return ew::cli::runUntilStopped([&](const ew::cli::Surroundings& surroundings) { return ew::cli::runBench(args, surroundings); });
}
