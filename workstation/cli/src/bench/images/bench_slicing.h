#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// What `echoweave bench slicing` measures; the defaults take about a minute.
struct BenchOptions {
  std::vector<int> volumeSides = {256, 512};  ///< cubes of this many voxels a side, 8..1024
  int sliceSide = 400;                        ///< pixels a side of each slice, one voxel a pixel; 16..4096
  int poses = 40;                             ///< per kind of pose (random, smooth), 2..1000
  int repetitions = 7;                        ///< interleaved; the medians are reported; 1..1000
  bool peers = true;                          ///< also measure vtkImageReslice
};

/// Times every slicer on one thread against vtkImageReslice (also on one thread) and measures each against an analytic band-limited
/// field. Times are processor time of that thread, so that other programs disturb them little. The result is the `quality` and `steps` part
/// of the report: {"machine", "threads", "slice_side", "poses", "results": [{"name", "method", "peer", "volume_side", "pose_kind",
/// "layout" ("chosen" for each slice, "rows", "bricks"), "bricks_share", "median_us", "psnr_db", "psnr_double_db", "worst_grey"}],
/// "ratios": [{"volume_side", "pose_kind", "quality", "times_faster"}], "layouts": [{"volume_side", "pose_kind", "quality", "rows_us",
/// "bricks_us", "choice_us"}] (medians of each pose, means over poses), "threads_measured": [{"volume_side", "size", "one_us", "two_us",
/// "times_faster"}], "promises": [{"what", "found", "bar", "passed"}], "steps": [{"name", "count", "median_us", "p99_us", "max_us"}]}.
/// @error badUsage (an option outside its range), cancelled
[[nodiscard]] Result<nlohmann::json> benchSlicing(const BenchOptions& options, Progress& progress);

/// The report of benchSlicing as sections of a page: one for each volume.
[[nodiscard]] std::vector<BenchSection> slicingSections(const nlohmann::json& report);

}  // namespace ew
