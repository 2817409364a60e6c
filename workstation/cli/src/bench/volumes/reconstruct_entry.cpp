#include "bench/volumes/reconstruct_entry.h"

#include <memory>

#include "bench/tools/bench_options.h"
#include "ew/core/numbers.h"
#include "run/arguments.h"

namespace ew::cli {

void ReconstructEntry::addOptions(CLI::App& app) {
  addOwnOptions(app);
  addRepetitions(app, repetitions);
}

void ReconstructEntry::addOwnOptions(CLI::App& app) {
  app.add_option("--spacing", spacings_mm, "Voxel size of reconstructions; may be given several times (0.5 and 1)")->type_name("MM");
  addCount(app, "--sweep", options.frames, 6, 1000, "Frames of each sweep (60)");
  addCount(app, "--image", options.imageSide, 32, 1024, "Pixels a side of a sweep's frame, which shows 60 mm (240)");
  addCount(app, "--views", options.views, 1, 20, "Virtual frames of each probe for the confidence (2)");
}

Result<void> ReconstructEntry::measure(Run& run, BenchResults& results, Progress& progress) {
  ReconstructBenchOptions asked = options;
  asked.repetitions = repetitions.value_or(asked.repetitions);
  if (!spacings_mm.empty()) asked.spacings_mm.clear();
  for (const auto& spacing : spacings_mm) {
    const auto value = parseNumber(spacing);
    if (!value) return failure(ErrorCode::badUsage, say<"--spacing '%1' is no number of mm; give one from 0.25 to 4.">(spacing));
    asked.spacings_mm.push_back(*value);
  }
  run.report.options["reconstruct"] = {{"spacings_mm", asked.spacings_mm},
                                       {"frames", asked.frames},
                                       {"image_side", asked.imageSide},
                                       {"views", asked.views},
                                       {"repetitions", asked.repetitions}};
  return results.take("reconstruct", benchReconstruct(asked, progress), reconstructSections);
}

void addReconstructBench(CLI::App& group, Selection& selection) {
  addBenchEntry(
      group, selection,
      {"reconstruct",
       "Every way from a sweep to a volume against an exact field, and confidence maps against known shadows",
       {"bench reconstruct", "bench reconstruct --html bench --report bench.json", "bench reconstruct --spacing 0.5 --repetitions 3"}},
      std::make_shared<ReconstructEntry>());
}

}  // namespace ew::cli
