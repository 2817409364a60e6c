#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// What `echoweave bench surfaces` measures; the defaults take about half a minute.
struct SurfacesBenchOptions {
  int side = 256;       ///< voxels of the label volume along each axis, 32..512
  int threads = 2;      ///< of ours, 1..256
  int repetitions = 5;  ///< interleaved; the medians are reported; 1..1000
  bool peers = true;    ///< also measure VTK
};

/// Times surfaces of twelve labelled organs whose shapes are known, and measures them against these: labelling::labelSurfaces on one thread
/// and on `threads`, and VTK's vtkDiscreteFlyingEdges3D with vtkWindowedSincPolyDataFilter (20 iterations, pass band 0.05) as its package
/// is built. Times are by the clock on the wall, with the processor time beside them. The result: {"machine", "side", "labels", "threads",
/// "repetitions", "results": [{"name", "median_us", "cpu_us", "of_peer" (absent without one), "points", "triangles", "farthest_voxel",
/// "farthest_back_voxel", "mean_voxel", "normal_deg", "volume_percent"}], "must_show": [{"name", "value", "limit", "met"}], "steps"}.
/// Distances are of points and middles of triangles to the organs, and back from where the organs' surfaces pass between voxels;
/// "normal_deg" is the root of the mean square between normals of points and of the shapes, "volume_percent" the worst of the organs.
/// @error badUsage (an option outside its range), cancelled
[[nodiscard]] Result<nlohmann::json> benchSurfaces(const SurfacesBenchOptions& options, Progress& progress);

/// The report of benchSurfaces as a section of a page.
[[nodiscard]] std::vector<BenchSection> surfacesSections(const nlohmann::json& report);

}  // namespace ew
