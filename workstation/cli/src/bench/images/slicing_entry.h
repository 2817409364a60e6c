#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/images/bench_slicing.h"
#include "bench/tools/bench_entry.h"

namespace ew::cli {

struct SlicingEntry final : BenchEntry {
  BenchOptions options;
  std::vector<std::string> sides;
  std::optional<int> poses, repetitions;
  bool large = false, noPeers = false;

  void addOptions(CLI::App& app) override;
  void addOwnOptions(CLI::App& app);  ///< what no other bench is asked
  [[nodiscard]] Result<void> measure(Run& run, BenchResults& results, Progress& progress) override;
};
void addSlicingBench(CLI::App& group, Selection& selection);

}  // namespace ew::cli
