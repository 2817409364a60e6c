#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "bench/images/bench_flow.h"
#include "bench/tools/bench_entry.h"

namespace ew::cli {

struct FlowEntry final : BenchEntry {
  FlowBenchOptions options;  ///< without its cases
  glm::ivec2 size_px{options.width_px, options.height_px};
  std::vector<std::string> cases;  ///< empty: the shipped ones whose blood is known

  void addOptions(CLI::App& app) override;
  [[nodiscard]] Result<void> measure(Run& run, BenchResults& results, Progress& progress) override;
};
void addFlowBench(CLI::App& group, Selection& selection);

}  // namespace ew::cli
