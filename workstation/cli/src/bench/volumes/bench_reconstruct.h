#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// What `echoweave bench reconstruct` measures; the defaults take a few minutes.
struct ReconstructBenchOptions {
  std::vector<double> spacings_mm = {0.5, 1.0};  ///< of the volumes, 0.25..4
  int frames = 60;                               ///< of each sweep, 6..1000
  int imageSide = 240;                           ///< pixels a side of a frame, which shows 60 mm x 60 mm; 32..1024
  int views = 2;                                 ///< virtual frames of each probe for the confidence, 1..20
  int repetitions = 5;                           ///< interleaved; the medians are reported; 1..1000
};

/// Times reconstructions of sweeps whose truth is known everywhere, and measures each against it. The sweeps show an analytic field
/// (BenchField, 0.5 mm a voxel, so no wavelength below 3.5 mm along an axis): parallel frames 1.5 mm apart, a fan of frames turned about an
/// axis 40 mm behind the face, and a freehand sweep whose hand rocks, hurries, waits and goes back. Settings: interpolation x spacing x
/// (no filling, or fill method x reach). One thread is timed by its processor time; two threads against one by the clock on the wall.
/// The result: {"machine", "frames", "image_side", "pixels", "repetitions",
/// "results": [{"name", "sweep", "interpolation", "fill_method" ("none", "bridges", "sweep"), "fill_reach_mm", "spacing_mm", "median_us",
/// "mpx_per_s", "measured": {"share", "psnr_db", "mae", "bias"}, "filled": the same, or null when nothing was filled}],
/// "threads_measured": [{"name", "one_us", "two_us", "times_faster", "same_voxels"}], "confidence": as benchConfidence, "steps"}.
/// Shares are of the grid's voxels, errors in grey levels over the voxels that were measured, or filled.
/// @error badUsage (an option outside its range), cancelled, as benchConfidence
[[nodiscard]] Result<nlohmann::json> benchReconstruct(const ReconstructBenchOptions& options, Progress& progress);

/// Times confidence maps of virtual frames on one thread, and asks how well they tell true shadows: [{"name", "probe", "method", "lines",
/// "samples" (of the random walk's graph, else 0), "median_us" (a frame), "area_under_curve", "mean_in_shadow", "mean_in_sight"}].
/// Truth is what the forward model takes away. The same frame of a block of tissue with two stones, a weak one and a vessel is formed with
/// and without losses; blocks of 4 lines x 16 samples that lose over 15 dB more than even tissue does are in shadow, those below 3 dB in
/// sight. The area under the curve is the share of such pairs whose confidences stand in the right order.
/// @error notFound (the probes), notWritable (the patient's recipe, in the folder for temporary files), cancelled
[[nodiscard]] Result<nlohmann::json> benchConfidence(const ReconstructBenchOptions& options, Progress& progress);

/// The report of benchReconstruct as sections of a page.
[[nodiscard]] std::vector<BenchSection> reconstructSections(const nlohmann::json& report);

}  // namespace ew
