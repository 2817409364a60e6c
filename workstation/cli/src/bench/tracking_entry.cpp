#include "bench/tracking_entry.h"

#include <memory>
#include <string>

#include "bench/bench_tracking.h"
#include "bench/tools/bench_entry.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

struct TrackingEntry final : BenchEntry {
  std::string views;  ///< folder
  int frames = 0;

  void addOptions(CLI::App& app) override {
    app.add_option("VIEWS", views, "A folder of images with views.json, which says where everything was")->required()->type_name("DIR");
    addCount(app, "--frames", frames, 0, 1000000, "Images at most; 0: all (0)");
  }

  [[nodiscard]] Result<void> measure(Run& run, BenchResults& results, Progress& progress) override {
    run.report.options["tracking"] = {{"views", views}, {"frames", frames}};
    return results.take("tracking", benchTracking({views, frames}, progress), trackingSections);
  }
};

}  // namespace

void addTrackingBench(CLI::App& group, Selection& selection) {
  addBenchEntry(group, selection,
                {"tracking",
                 "How exact a camera finds a probe with each of its settings, on views whose truth is known",
                 {"bench tracking views", "bench tracking views --html bench --report bench.json"}},
                std::make_shared<TrackingEntry>());
}

}  // namespace ew::cli
