#pragma once

#include <optional>

#include "bench/tools/bench_entry.h"
#include "bench/volumes/bench_stitch.h"

namespace ew::cli {

struct StitchEntry final : BenchEntry {
  StitchBenchOptions options;
  std::optional<int> repetitions;

  void addOptions(CLI::App& app) override;
  /// What no other bench is asked. @param side what the option for the voxels of a side is called
  void addOwnOptions(CLI::App& app, const char* side);
  [[nodiscard]] Result<void> measure(Run& run, BenchResults& results, Progress& progress) override;
};
void addStitchBench(CLI::App& group, Selection& selection);

}  // namespace ew::cli
