#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// What `echoweave bench register` measures; the defaults take some minutes.
struct RegisterBenchOptions {
  int side = 96;        ///< voxels of 0.6 mm a side of the elastic pair, 48..256; the pairs without a tracker have as many of 0.9 mm
  int repetitions = 1;  ///< the medians are reported; 1..100
  bool peers = true;    ///< elastix and plastimatch too, when they are installed
  std::uint64_t seed = 1;
};

/// Registers pairs of speckled tissue whose truth is known everywhere (ew/phantom/speckle_tissue.h) with every method at each of its
/// settings, on one thread, timed by processor time. Pairs: `elastic` (smooth motion up to 5 mm, two thirds of the speckle shared, other
/// gain, a shadow), `images` (the same in two dimensions), `turned` (9 degrees and 6 mm off, for the refinement), `partial` (half and a
/// third shared, 12 and 24 degrees, no start), `strangers` (two tissues: what is to be refused), `landmarks` (places hit within 1 mm). The
/// result: {"machine", "side", "repetitions", "seed", "results": [{"name", "method", "setting", "pair", "median_us", "error_start_mm",
/// "error_mm", "error_p95_mm", "removed_percent" (of the error at the start), "verdict", "jacobian_min" (elastic)}], "peers": the same
/// rows, timed by the processor time of their processes (files read to field written), "peers_missing": names, "steps"}. Errors are
/// distances between where the result and the truth take a voxel, over those whose true place lies in the moving view.
/// @error badUsage (an option outside its range), cancelled, notWritable (the folder for temporary files, with peers)
[[nodiscard]] Result<nlohmann::json> benchRegister(const RegisterBenchOptions& options, Progress& progress);

/// The report of benchRegister as sections of a page.
[[nodiscard]] std::vector<BenchSection> registerSections(const nlohmann::json& report);

}  // namespace ew
