#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/library/case.h"

namespace ew {

/// What `echoweave bench flow` measures.
struct FlowBenchOptions {
  std::vector<Case> cases;  ///< whose blood is known; prepared first where they are not
  int frames = 120;         ///< timed for each setting and number of threads, 5..10000
  int packets = 1500;       ///< of which an estimate's mean and standard deviation are, 100..100000
  int width_px = 1024;      ///< of a timed image, 128..4096
  int height_px = 768;
};

/// What Doppler costs and how near it comes.
/// Time: whole frames as the window makes them, the probe sliding about the case's pose that shows most blood, at 25 frames a second of the
/// patient's time; every setting makes a frame of one pose before any makes the next, so that a busy machine is busy for all. "Added" is
/// the median of what each frame took more than the same frame without Doppler. Accuracy: the colour box on the axis of a straight vessel
/// (flow_trial.h) against its true velocity, and beside it scatterers that are moved through the same gate one by one: their scatter is
/// what colour's is to be, and what a packet of them takes is what colour saves. The result: {"machine", "frames", "packets", "width",
/// "height", "results": [{"name", "case", "setting", "threads", "median_ms", "p99_ms", "added_ms", "added_p99_ms"}], "accuracy":
/// [{"angle_deg", "signal_to_noise_db", "truth", "colour", "colour_deviation", "scatterers", "scatterers_deviation", "colour_us",
/// "scatterers_us"}], "must_show": [{"name", "value", "limit", "met"}]}.
/// @error badUsage (an option outside its range, a case without flow), as readContents; cancelled
[[nodiscard]] Result<nlohmann::json> benchFlow(const FlowBenchOptions& options, Progress& progress);

/// The report of benchFlow as sections of a page.
[[nodiscard]] std::vector<BenchSection> flowSections(const nlohmann::json& report);

}  // namespace ew
