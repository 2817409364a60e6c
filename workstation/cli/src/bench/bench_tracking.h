#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// What `echoweave bench tracking` measures.
struct TrackingBenchOptions {
  /// A folder with views.json and the images it names (grey, PGM): {"camera": as a camera's file, "bodies": [{"id", "is_board",
  /// "dictionary", "face_mm", "markers": [{"id", "corners_mm"}]}], "frames": [{"file", "time_s", "sequence", "poses": [bodyToCamera, 16
  /// numbers row by row]}]}. tests/camera_truth makes them: truth_run views.
  std::filesystem::path views;
  int frames = 0;  ///< at most; 0: all
};

/// Follows the first body of a folder of views whose truth is known, with each setting of the camera: resolution, markers used, how corners
/// are measured, filter; beside OpenCV's estimatePoseBoard. Errors at the transducer's face against the camera, of the poses that are
/// shown; time of an image on one thread, processor time. The result: {"machine", "frames", "results": [{"name", "resolution", "markers",
/// "corners", "filter", "peer", "median_us", "p95_us", "face_mm", "face_p95_mm", "turn_deg", "turn_p95_deg", "shown" (share), "flipped"
/// (poses shown that are turned by more than ten degrees)}]}.
/// @error notFound, badHeader, badField, cancelled
[[nodiscard]] Result<nlohmann::json> benchTracking(const TrackingBenchOptions& options, Progress& progress);

/// The report of benchTracking as a section of a page.
[[nodiscard]] std::vector<BenchSection> trackingSections(const nlohmann::json& report);

}  // namespace ew
