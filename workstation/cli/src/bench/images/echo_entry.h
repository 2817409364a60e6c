#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "bench/images/bench_echoes.h"
#include "bench/tools/bench_entry.h"

namespace ew::cli {

struct EchoEntry final : BenchEntry {
  EchoBenchOptions options;  ///< without its cases
  glm::ivec2 size_px{options.width_px, options.height_px};
  std::vector<std::string> cases;  ///< empty: every drawn one that is shipped

  void addOptions(CLI::App& app) override;
  void addOwnOptions(CLI::App& app);  ///< what no other bench is asked
  [[nodiscard]] Result<void> measure(Run& run, BenchResults& results, Progress& progress) override;
};
void addEchoBench(CLI::App& group, Selection& selection);

}  // namespace ew::cli
