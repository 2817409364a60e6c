#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/library/case.h"

namespace ew {

/// What `echoweave bench echoes` measures.
struct EchoBenchOptions {
  std::vector<Case> cases;  ///< drawn ones (a recipe, no sweeps); prepared first where they are not
  int poses = 3;    ///< of each case, 1..1000: its standard planes, start and expert pose, then others slid, tilted and turned from them
  int frames = 40;  ///< timed for each quality and number of threads, 5..10000
  int width_px = 1024;  ///< of a timed image, 128..4096
  int height_px = 768;
  std::uint64_t seed = 1;  ///< of poses
};

/// Live echoes of every quality against the full forward model (VirtualScanner) of the same patient, pose, probe, depth and focus, on
/// beams; and what whole frames of the case take, a new pose for each, from pose to image through Scanner.
/// Compared like with like: no noise, no gel or air, no reverberation, linear map, TGC that removes what the scene expects, looks and pulse
/// of the case's effect; of both, scatterers alone (no mirrors). Switched off in live echoes is what they have on purpose beside the model:
/// scatter of the scatterers' strength, little walls, line filter and line average, haze, gain; aperture and F-number are the model's, and
/// focus and slice thickness act. Decorrelation is measured without losses, on every fifth pose.
/// Patches of about 8 mm count where at least half of them is tissue throughout the slice, and of them what is (see echo_measures.h).
/// The result: {"machine", "poses", "frames", "width", "height", "seed", "results": [{"name", "case", "quality", "probe", "looks",
/// "patches", "level_db" (median of live less forward), "level_p95_db" (of its absolute value), "level_floor_p95_db" (the same between two
/// forward models of other scatterers: what patches of this size leave to chance), "level_bands_db" (medians by depth), "snr_live",
/// "snr_forward", "snr_off_percent", "axial_off_percent", "lateral_off_percent" (the worst band), "lengths": [...], "decorrelation":
/// [{"motion", "amount", "live", "forward"}], "decorrelation_off" (the worst), "shadow_patches", "shadow_db" (median difference behind
/// reflectors less that beside them), "shadow_p95_db", "one_thread_ms", "two_threads_ms" (medians), "one_p95_ms", "one_p99_ms",
/// "two_p95_ms", "two_p99_ms", "forward_ms", "median_us" (of two threads)}], "totals": [...], "must_show": [{"name", "value", "limit",
/// "met"}], "steps"}. A figure for which no patch was found is null.
/// @error badUsage (an option outside its range, a case that is not drawn), as readContents, readPatient, makeVirtualScanner; cancelled
[[nodiscard]] Result<nlohmann::json> benchEchoes(const EchoBenchOptions& options, Progress& progress);

/// The report of benchEchoes as sections of a page.
[[nodiscard]] std::vector<BenchSection> echoSections(const nlohmann::json& report);

}  // namespace ew
