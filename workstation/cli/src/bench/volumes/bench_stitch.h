#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// What `echoweave bench stitch` measures; the defaults take a minute or two.
struct StitchBenchOptions {
  int side = 128;       ///< voxels a side of each view, 64..320; 0.5 mm each
  int repetitions = 3;  ///< interleaved; the medians are reported; 1..1000
  std::uint64_t seed = 1;
};

/// Joins two speckled views of one scene (ew/phantom/speckle_view.h: other speckle, other gain and depth gain, a shadow in one) in every
/// way: seam method x cell x blend x block, after equalising them, on one thread by its processor time; two threads against one by the
/// clock on the wall. Measure 20 says how visible the seam is. A seam without a blend and a feathered mean stand for what is usual.
/// The result: {"machine", "side", "repetitions", "seed", "equalise": {"median_us", "before_db", "after_db"}, "results": [{"name",
/// "method", "cell_mm", "blend_mm", "block" (0: whole, in memory), "median_us", "find_us", "join_us", "derivative_ratio", "speckle_ratio",
/// "step_db", "shadow_error_db" (mean level in the shadow against the truth), "seam_times_limit" (the worst of the three against 0.05, 0.05
/// and 0.5 dB; up to 1 is not apparent), "forecast_mib"}], "threads_measured": [{"name", "one_us", "two_us", "times_faster",
/// "same_voxels"}], "steps"}.
/// @error badUsage (an option outside its range), cancelled, as join
[[nodiscard]] Result<nlohmann::json> benchStitch(const StitchBenchOptions& options, Progress& progress);

/// The report of benchStitch as sections of a page.
[[nodiscard]] std::vector<BenchSection> stitchSections(const nlohmann::json& report);

}  // namespace ew
