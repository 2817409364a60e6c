#include "run/command_line.h"

namespace ew::cli {
namespace {

/// The benches are a program of their own; here they have their place among the commands, and a sentence where that program is missing.
void nameBenches(CLI::App& root, Selection& selection) {
  auto& app = *root.add_subcommand(kBench, kBenchDescription);
  app.set_help_flag();  // the program of the benches has it
  app.prefix_command();
  app.callback([&selection] {
    selection.command = kBench;
    selection.work = [](Run&) -> Result<int> {
      return failure(ErrorCode::notFound, say<"The program of the benches, echoweave-bench, is not here; install EchoWeave again.">());
    };
  });
}

}  // namespace

void addAllCommands(CLI::App& root, Selection& selection) {
  addImport(root, selection);
  addScreen(root, selection);
  addReconstruct(root, selection);
  addRegister(root, selection);
  addSlice(root, selection);
  addLevel(root, selection);
  addSurfaces(root, selection);
  addScan(root, selection);
  addReplay(root, selection);
  addPhantom(root, selection);
  addCase(root, selection);
  addLesson(root, selection);
  addAssess(root, selection);
  addKey(root, selection);
  addAccess(root, selection);
  addMeasure(root, selection);
  addCriteria(root, selection);
  addPreset(root, selection);
  addSend(root, selection);
  addRecords(root, selection);
  addTracker(root, selection);
  addPlugins(root, selection);
  nameBenches(root, selection);
}

}  // namespace ew::cli
