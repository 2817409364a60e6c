#include "bench/volumes/surfaces_entry.h"

#include <memory>

#include "bench/tools/bench_options.h"
#include "run/arguments.h"

namespace ew::cli {

void SurfacesEntry::addOptions(CLI::App& app) {
  addCount(app, "--side", options.side, 32, 512, "Voxels a side of the labels (256)");
  addCount(app, "--threads", options.threads, 1, 256, "Threads of ours, beside one (2)");
  addCount(app, "--repetitions", repetitions, 1, 1000, "Interleaved repetitions (5)");
  addNoPeers(app, noPeers);
}

Result<void> SurfacesEntry::measure(Run& run, BenchResults& results, Progress& progress) {
  SurfacesBenchOptions asked = options;
  asked.repetitions = repetitions.value_or(asked.repetitions);
  asked.peers = !noPeers;
  run.report.options["surfaces"] = {
      {"side", asked.side}, {"threads", asked.threads}, {"repetitions", asked.repetitions}, {"peers", asked.peers}};
  return results.take("surfaces", benchSurfaces(asked, progress), surfacesSections);
}

void addSurfacesBench(CLI::App& group, Selection& selection) {
  addBenchEntry(group, selection,
                {"surfaces",
                 "Surfaces of twelve labelled organs against their shapes and against VTK's",
                 {"bench surfaces", "bench surfaces --html bench --report bench.json", "bench surfaces --side 128 --repetitions 9"}},
                std::make_shared<SurfacesEntry>());
}

}  // namespace ew::cli
