#include <algorithm>

#include "bench/tools/bench_parts.h"
#include "bench/volumes/bench_stitch.h"
#include "ew/core/numbers.h"

namespace ew {
namespace {

using nlohmann::json;

std::string labelOf(const json& row) {
  const std::string method = row["method"].get<std::string>();
  if (method == "feather") return "feathered mean";
  const double blend_mm = row["blend_mm"].get<double>();
  std::string label = method == "nearest" ? "deepest view" : "cut";
  label += blend_mm > 0.0 ? ", blend " + textOf(blend_mm) + " mm" : ", pasted";
  if (row["cell_mm"] != 1.5) label += ", cells " + textOf(row["cell_mm"].get<double>()) + " mm";
  if (row["block"] > 0) label += ", blocks of " + std::to_string(row["block"].get<int>());
  return label;
}

}  // namespace

std::vector<BenchSection> stitchSections(const json& report) {
  BenchSection seams;
  seams.title = "Joining two views: how well the seam is hidden, and what it costs";
  seams.text =
      "Two views of " + std::to_string(report["side"].get<int>()) +
      " voxels a side, of one scene with independent speckle, other gain, other depth gain and a shadow in one; one thread, seam and "
      "join together. Upwards: how many times the worst of three measures goes into its limit (derivative across the seam against the "
      "surfaces beside it 1.00 +- 0.05, deviation of speckle 1.00 +- 0.05, step of the mean 0.5 dB); above 1 the seam is not "
      "apparent. The deepest view knows no shadow; the cut fills it from the other view. The forecast is "
      "what the program says before; beside it the peak that was measured beyond the views, with the joined volume that is kept here to be "
      "compared.";
  seams.axis = {.title = "limit over the worst measure", .unit = "", .decimals = 2, .smallestStep = 0.5};
  seams.legend = {{BenchMark::own, "cut"}, {BenchMark::ownHollow, "deepest view"}, {BenchMark::peer, "feathered mean, or pasted"}};
  seams.table = {1,
                 {"Setting", "Seam, ms", "Join, ms", "Derivative", "Speckle", "Step, dB", "Shadow off by, dB", "Forecast, MiB",
                  "Memory, MiB", "As whole"},
                 {}};
  for (const auto& row : report["results"]) {
    const std::string method = row["method"].get<std::string>();
    const bool usual = method == "feather" || row["blend_mm"] == 0.0;
    const double worst = std::max(0.1, row["seam_times_limit"].get<double>());
    if (row["block"] == 0)
      seams.points.push_back({labelOf(row), row["name"].get<std::string>(), row["median_us"].get<double>() * 1e-3, 1.0 / worst,
                              usual                 ? BenchMark::peer
                              : method == "nearest" ? BenchMark::ownHollow
                                                    : BenchMark::own,
                              ""});
    seams.table.rows.push_back({labelOf(row), fixedText(row["find_us"].get<double>() * 1e-3, 1),
                                fixedText(row["join_us"].get<double>() * 1e-3, 1), fixedText(row["derivative_ratio"].get<double>(), 3),
                                fixedText(row["speckle_ratio"].get<double>(), 3), fixedText(row["step_db"].get<double>(), 2),
                                fixedText(row["shadow_error_db"].get<double>(), 2), fixedText(row["forecast_mib"].get<double>(), 1),
                                memoryIn(row, "peak_mib"),
                                row.contains("same_as_whole") ? (row["same_as_whole"].get<bool>() ? "the same" : "OTHERS") : ""});
  }
  BenchSection threads;
  threads.title = "Joining on two threads";
  const json& equalise = report["equalise"];
  threads.text = "Wall clock, one thread and two in turns. Equalising the views before took " +
                 fixedText(equalise["median_us"].get<double>() * 1e-3, 1) + " ms and brought their cells from " +
                 fixedText(equalise["before_db"].get<double>(), 2) + " to " + fixedText(equalise["after_db"].get<double>(), 2) + " dB.";
  threads.table = {1, {"Setting", "One thread, ms", "Two, ms", "Times as fast", "Voxels"}, {}};
  for (const auto& row : report["threads_measured"])
    threads.table.rows.push_back({row["name"].get<std::string>(), fixedText(row["one_us"].get<double>() * 1e-3, 1),
                                  fixedText(row["two_us"].get<double>() * 1e-3, 1), fixedText(row["times_faster"].get<double>(), 2),
                                  row["same_voxels"].get<bool>() ? "the same" : "OTHERS"});
  return {std::move(seams), std::move(threads)};
}

}  // namespace ew
