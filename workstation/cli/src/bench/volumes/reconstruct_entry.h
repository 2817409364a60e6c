#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/tools/bench_entry.h"
#include "bench/volumes/bench_reconstruct.h"

namespace ew::cli {

struct ReconstructEntry final : BenchEntry {
  ReconstructBenchOptions options;
  std::vector<std::string> spacings_mm;  ///< as given; empty: the usual ones
  std::optional<int> repetitions;

  void addOptions(CLI::App& app) override;
  void addOwnOptions(CLI::App& app);  ///< what no other bench is asked
  [[nodiscard]] Result<void> measure(Run& run, BenchResults& results, Progress& progress) override;
};
void addReconstructBench(CLI::App& group, Selection& selection);

}  // namespace ew::cli
