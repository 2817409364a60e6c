#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/images/bench_frame.h"
#include "bench/tools/bench_entry.h"

namespace ew::cli {

struct FrameEntry final : BenchEntry {
  FrameBenchOptions options;
  glm::ivec2 size_px{options.width_px, options.height_px};
  std::vector<std::string> sides;
  std::optional<int> poses, repetitions;
  bool noPeers = false;

  void addOptions(CLI::App& app) override;
  [[nodiscard]] Result<void> measure(Run& run, BenchResults& results, Progress& progress) override;
};
void addFrameBench(CLI::App& group, Selection& selection);

}  // namespace ew::cli
