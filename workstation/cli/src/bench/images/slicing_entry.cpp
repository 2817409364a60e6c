#include "bench/images/slicing_entry.h"

#include <memory>

#include "bench/tools/bench_options.h"
#include "run/arguments.h"

namespace ew::cli {

void SlicingEntry::addOptions(CLI::App& app) {
  addSides(app, sides);
  addOwnOptions(app);
  addPoses(app, poses);
  addRepetitions(app, repetitions);
  addNoPeers(app, noPeers);
}

void SlicingEntry::addOwnOptions(CLI::App& app) {
  addCount(app, "--size", options.sliceSide, 16, 4096, "Pixels a side of a slice (400)");
  app.add_flag("--large", large, "Also slices of a volume of 1024 cubed: 2.4 GiB of memory and some minutes");
}

Result<void> SlicingEntry::measure(Run& run, BenchResults& results, Progress& progress) {
  BenchOptions asked = options;
  asked.poses = poses.value_or(asked.poses);
  asked.repetitions = repetitions.value_or(asked.repetitions);
  asked.peers = !noPeers;
  auto volumeSides = sidesOf(sides, asked.volumeSides, 8);
  if (!volumeSides) return passOn(volumeSides.error());
  asked.volumeSides = *volumeSides;
  if (large) asked.volumeSides.push_back(1024);
  run.report.options["slicing"] = {{"volume_sides", asked.volumeSides},
                                   {"slice_side", asked.sliceSide},
                                   {"poses", asked.poses},
                                   {"repetitions", asked.repetitions},
                                   {"peers", asked.peers}};
  return results.take("slicing", benchSlicing(asked, progress), slicingSections);
}

void addSlicingBench(CLI::App& group, Selection& selection) {
  addBenchEntry(group, selection,
                {"slicing",
                 "Every slicer against an exact answer and against VTK's, one thread, medians of one run",
                 {"bench slicing", "bench slicing --html bench --report bench.json", "bench slicing --side 256 --repetitions 3"}},
                std::make_shared<SlicingEntry>());
}

}  // namespace ew::cli
