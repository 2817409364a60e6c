#pragma once

#include <optional>
#include <string>

#include "bench/tools/bench_entry.h"
#include "bench/volumes/bench_register.h"

namespace ew::cli {

struct RegisterEntry final : BenchEntry {
  RegisterBenchOptions options;
  std::optional<int> repetitions;
  bool noPeers = false;
  std::string paper;  ///< folder for the figures of the 1998 paper; empty: none

  void addOptions(CLI::App& app) override;
  /// What no other bench is asked. @param side what the option for the voxels of a side is called
  void addOwnOptions(CLI::App& app, const char* side);
  [[nodiscard]] Result<void> announce(Run& run) override;
  [[nodiscard]] Result<void> measure(Run& run, BenchResults& results, Progress& progress) override;

 private:
  [[nodiscard]] Result<void> drawPaper(Run& run, BenchResults& results, Progress& progress) const;
};
void addRegisterBench(CLI::App& group, Selection& selection);

}  // namespace ew::cli
