#pragma once

#include <optional>

#include "bench/tools/bench_entry.h"
#include "bench/volumes/bench_surfaces.h"

namespace ew::cli {

struct SurfacesEntry final : BenchEntry {
  SurfacesBenchOptions options;
  std::optional<int> repetitions;
  bool noPeers = false;

  void addOptions(CLI::App& app) override;
  [[nodiscard]] Result<void> measure(Run& run, BenchResults& results, Progress& progress) override;
};
void addSurfacesBench(CLI::App& group, Selection& selection);

}  // namespace ew::cli
