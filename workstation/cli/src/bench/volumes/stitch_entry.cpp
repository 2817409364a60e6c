#include "bench/volumes/stitch_entry.h"

#include <memory>

#include "bench/tools/bench_options.h"
#include "run/arguments.h"

namespace ew::cli {

void StitchEntry::addOptions(CLI::App& app) {
  addOwnOptions(app, "--side");
  addDrawSeed(app, options.seed);
  addRepetitions(app, repetitions);
}

void StitchEntry::addOwnOptions(CLI::App& app, const char* side) {
  addCount(app, side, options.side, 64, 320, "Voxels a side of a view to join (128)");
}

Result<void> StitchEntry::measure(Run& run, BenchResults& results, Progress& progress) {
  StitchBenchOptions asked = options;
  asked.repetitions = repetitions.value_or(asked.repetitions);
  run.report.options["stitch"] = {{"side", asked.side}, {"repetitions", asked.repetitions}, {"seed", asked.seed}};
  run.report.seed = asked.seed;
  return results.take("stitch", benchStitch(asked, progress), stitchSections);
}

void addStitchBench(CLI::App& group, Selection& selection) {
  addBenchEntry(group, selection,
                {"stitch",
                 "Every way to join two views of one scene: how visible the seam is, and what it costs",
                 {"bench stitch", "bench stitch --html bench --report bench.json", "bench stitch --side 96 --repetitions 5"}},
                std::make_shared<StitchEntry>());
}

}  // namespace ew::cli
