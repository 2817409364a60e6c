#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// What `echoweave bench frame` measures.
struct FrameBenchOptions {
  std::vector<int> volumeSides = {256, 512};  ///< cubes of this many voxels a side and 300 mm, 64..1024
  int width_px = 1024;                        ///< of the image, 128..4096
  int height_px = 768;
  int poses = 12;       ///< of a hand that rocks and slides, 2..1000
  int repetitions = 7;  ///< interleaved; the medians are reported; 1..1000
  bool peers = true;    ///< also measure vtkImageReslice
};

/// Times whole frames of a convex probe: with no effect, with each effect alone, with each variant of an effect, with everything; and
/// beside them vtkImageReslice making a bare slice of the same plane and as many pixels from the same voxels. One thread is timed by its
/// processor time, two by the clock on the wall. Where a setting has an exact answer (the field itself; its mean over the beam's
/// elevational or lateral width, from the field's closed form) the image is measured against it. The result: {"machine", "width",
/// "height", "poses", "repetitions", "results": [{"name", "group", "method", "peer", "threads", "volume_side", "median_us", "wall_us",
/// "of_peer", "plan", "psnr_db", "worst_grey"}], "must_show": [{"name", "value", "limit", "met"}], "steps": [...] of the frame with
/// everything}. PSNR and worst error are missing where there is no exact answer, `of_peer` (of VTK's linear slice) without peers.
/// @error badUsage (an option outside its range), notFound (the probe), cancelled
[[nodiscard]] Result<nlohmann::json> benchFrame(const FrameBenchOptions& options, Progress& progress);

/// The report of benchFrame as sections of a page.
[[nodiscard]] std::vector<BenchSection> frameSections(const nlohmann::json& report);

}  // namespace ew
