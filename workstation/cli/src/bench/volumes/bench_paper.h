#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// Figures 6 to 8 of Aiger and Cohen-Or 1998, made from a virtual patient whose motion is known.
struct PaperBenchOptions {
  double peak_mm = 5.5;      ///< largest motion of figure 8, 0.5..12
  double seamPeak_mm = 4.0;  ///< of figures 6 and 7, 0.5..12
  double sweep_mm = 20.0;    ///< how far each of the two subvolumes reaches from the tangent plane, 8..60
  std::uint64_t seed = 1;    ///< of the scatterers
};

/// Where a fixed point lies in the moving image, mm.
using PlanarTruth = std::function<glm::dvec2(const glm::dvec2&)>;

/// The rows of figure 8 on any pair: nothing done, one resolution, after each of the factors 48, 24 and 6, and the schedule chosen by size.
/// [{"name", "factor" (null where it has none), "correlation", "error_mm", "error95_mm" (null without a truth), "smallest_jacobian",
/// "cpu_s", "verdict"}]; `warped`, when asked for, gets the moving image seen through each row's field, in the same order.
/// @error as registerElastic2d
[[nodiscard]] Result<nlohmann::json> paperRows(const GreyImage& fixed, const GreyImage& moving, double pixel_mm, const PlanarTruth& truth,
                                               std::vector<GreyImage>* warped, Progress& progress);

/// Where a file of that name is to be written. @error as OutputSet::announce
using PaperPlace = std::function<Result<std::filesystem::path>(const std::string& name)>;

/// Makes the pairs, registers them and, unless `placeOf` is empty, writes figure-6-*.png, figure-7-*.png, figure-8-*.png, paper.html and
/// paper.json where it says.
/// {"machine", "seed", "figure8": {"pixel_mm", "peak_mm", "mean_motion_mm", "rows"}, "figure7": {"motion_mm", "found_mm", "error_mm",
/// "correlation_before", "correlation_after", "fall_off_mm", "smallest_jacobian", "seam": {"pasted", "blended", "warped"}}}
/// seam: mean absolute difference of grey levels of columns on both sides of the tangent plane, 1 mm apart, over that of columns as far
/// apart nearby: 1 is no seam.
/// @error badUsage (an option outside its range), notWritable, cancelled
[[nodiscard]] Result<nlohmann::json> benchPaper(const PaperBenchOptions& options, const PaperPlace& placeOf, Progress& progress);

/// The report of benchPaper as sections of a page (without its images, which paper.html shows).
[[nodiscard]] std::vector<BenchSection> paperSections(const nlohmann::json& report);

}  // namespace ew
