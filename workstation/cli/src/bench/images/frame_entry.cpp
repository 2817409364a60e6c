#include "bench/images/frame_entry.h"

#include <memory>

#include "bench/tools/bench_options.h"

namespace ew::cli {

void FrameEntry::addOptions(CLI::App& app) {
  addSides(app, sides);
  addFrameSize(app, size_px);
  addPoses(app, poses);
  addRepetitions(app, repetitions);
  addNoPeers(app, noPeers);
}

Result<void> FrameEntry::measure(Run& run, BenchResults& results, Progress& progress) {
  FrameBenchOptions asked = options;
  asked.width_px = size_px.x;
  asked.height_px = size_px.y;
  asked.poses = poses.value_or(asked.poses);
  asked.repetitions = repetitions.value_or(asked.repetitions);
  asked.peers = !noPeers;
  auto volumeSides = sidesOf(sides, asked.volumeSides, 64);
  if (!volumeSides) return passOn(volumeSides.error());
  asked.volumeSides = *volumeSides;
  run.report.options["frame"] = {{"volume_sides", asked.volumeSides},
                                 {"size", {asked.width_px, asked.height_px}},
                                 {"poses", asked.poses},
                                 {"repetitions", asked.repetitions},
                                 {"peers", asked.peers}};
  return results.take("frame", benchFrame(asked, progress), frameSections);
}

void addFrameBench(CLI::App& group, Selection& selection) {
  addBenchEntry(group, selection,
                {"frame",
                 "Whole frames with every effect alone and together, against exact answers and VTK's bare slice",
                 {"bench frame", "bench frame --html bench --report bench.json", "bench frame --side 256 --frame 640x480 --repetitions 3"}},
                std::make_shared<FrameEntry>());
}

}  // namespace ew::cli
