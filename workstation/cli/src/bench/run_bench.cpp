#include "ew/cli/run_bench.h"

#include "bench/all_entry.h"
#include "bench/bench_library.h"
#include "bench/images/echo_entry.h"
#include "bench/images/flow_entry.h"
#include "bench/images/frame_entry.h"
#include "bench/images/slicing_entry.h"
#include "bench/teaching/teaching_commands.h"
#include "bench/tracking_entry.h"
#include "bench/volumes/reconstruct_entry.h"
#include "bench/volumes/register_entry.h"
#include "bench/volumes/stitch_entry.h"
#include "bench/volumes/surfaces_entry.h"
#include "run/command_line.h"

namespace ew::cli {
namespace {

void addBenches(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("bench", kBenchDescription);
  group.require_subcommand(1);
  addSlicingBench(group, selection);
  addFrameBench(group, selection);
  addEchoBench(group, selection);
  addFlowBench(group, selection);
  addReconstructBench(group, selection);
  addRegisterBench(group, selection);
  addStitchBench(group, selection);
  addSurfacesBench(group, selection);
  addTrackingBench(group, selection);
  addCompassBench(group, selection);
  addExercisesBench(group, selection);
  addMetricsBench(group, selection);
  addAttemptsBench(group, selection);
  addLibraryBench(group, selection);
  addAllBenches(group, selection);
}

}  // namespace

int runBench(std::span<const std::string> args, const Surroundings& surroundings) { return runCommandLine(args, surroundings, addBenches); }

}  // namespace ew::cli
