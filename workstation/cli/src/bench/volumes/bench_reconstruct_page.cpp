#include <algorithm>

#include "bench/tools/bench_parts.h"
#include "bench/volumes/bench_reconstruct.h"
#include "ew/core/numbers.h"

namespace ew {
namespace {

using nlohmann::json;

std::vector<std::string> distinct(const json& rows, const char* key) {
  std::vector<std::string> found;
  for (const auto& row : rows)
    if (const std::string value = row[key].get<std::string>(); std::find(found.begin(), found.end(), value) == found.end())
      found.push_back(value);
  return found;
}

std::string settingOf(const json& row) {
  std::string setting = row["interpolation"].get<std::string>();
  if (row["fill_reach_mm"] > 0.0)
    setting += " + " + row["fill_method"].get<std::string>() + " " + textOf(row["fill_reach_mm"].get<double>()) + " mm";
  return setting;
}

std::string figure(const json& errors, const char* key, int decimals, double times = 1.0) {
  return errors.is_object() ? fixedText(times * errors[key].get<double>(), decimals) : std::string();
}

/// Measured voxels by interpolation, without filling: what pasting costs and gives.
BenchSection pastingSection(const json& report) {
  BenchSection section;
  section.title = "Pasting frames into a volume: the measured voxels";
  section.text =
      "Sweeps of " + std::to_string(report["frames"].get<int>()) + " frames of " + std::to_string(report["image_side"].get<int>()) + " x " +
      std::to_string(report["image_side"].get<int>()) +
      " pixels, one thread, the whole reconstruction without filling. Solid: the finer spacing. A voxel of `nearest` holds the "
      "mean of pixels somewhere in it, one of `centred` what the frames show at its centre. Memory is the peak beyond the frames.";
  section.legend = {{BenchMark::own, "finest spacing"}, {BenchMark::ownHollow, "coarser"}};
  section.table = {
      3, {"Sweep", "Spacing, mm", "Interpolation", "Median, ms", "Mpx/s", "Memory, MiB", "Measured, %", "PSNR, dB", "MAE", "Bias"}, {}};
  double finest_mm = 1e300;
  for (const auto& row : report["results"]) finest_mm = std::min(finest_mm, row["spacing_mm"].get<double>());
  for (const auto& row : report["results"]) {
    if (row["fill_reach_mm"] > 0.0) continue;
    const double ms = row["median_us"].get<double>() * 1e-3, spacing_mm = row["spacing_mm"].get<double>();
    const std::string sweep = row["sweep"].get<std::string>(), spacing = textOf(spacing_mm);
    const bool fine = spacing_mm == finest_mm;
    if (row["measured"].is_object())
      section.points.push_back({fine ? sweep + ", " + row["interpolation"].get<std::string>() : "", row["name"].get<std::string>(), ms,
                                row["measured"]["psnr_db"].get<double>(), fine ? BenchMark::own : BenchMark::ownHollow, sweep + spacing});
    section.table.rows.push_back({sweep, spacing, row["interpolation"].get<std::string>(), fixedText(ms, 1),
                                  fixedText(row["mpx_per_s"].get<double>(), 1), memoryIn(row, "peak_mib"),
                                  figure(row["measured"], "share", 1, 100.0), figure(row["measured"], "psnr_db", 1),
                                  figure(row["measured"], "mae", 2), figure(row["measured"], "bias", 2)});
  }
  return section;
}

/// Filled voxels of one sweep: bridges beside the way of the probe.
BenchSection fillingSection(const json& report, const std::string& sweep) {
  BenchSection section;
  section.title = "Filling the holes of a " + sweep + " sweep: the voxels no frame passed through";
  section.text =
      "The time is of the whole reconstruction. Bridges join measured voxels in straight lines; `sweep` first follows the probe from frame "
      "to frame. A longer reach fills more of the holes, the harder ones too. Memory is the peak beyond the frames.";
  section.legend = {{BenchMark::own, "along the sweep"}, {BenchMark::peer, "bridges"}};
  section.table = {
      2, {"Spacing, mm", "Setting", "Median, ms", "Memory, MiB", "Measured, %", "PSNR, dB", "MAE", "Filled, %", "PSNR, dB", "MAE"}, {}};
  for (const auto& row : report["results"]) {
    if (row["sweep"] != sweep) continue;
    const double ms = row["median_us"].get<double>() * 1e-3;
    const std::string spacing = textOf(row["spacing_mm"].get<double>()), setting = settingOf(row);
    const bool along = row["fill_method"] == "sweep";
    const std::string label = spacing + " mm, " + row["interpolation"].get<std::string>();
    if (row["filled"].is_object())
      section.points.push_back({row["fill_reach_mm"] > 4.0 ? label : "", row["name"].get<std::string>(), ms,
                                row["filled"]["psnr_db"].get<double>(), along ? BenchMark::own : BenchMark::peer,
                                label + (along ? " sweep" : " bridges")});
    section.table.rows.push_back({spacing, setting, fixedText(ms, 1), memoryIn(row, "peak_mib"), figure(row["measured"], "share", 1, 100.0),
                                  figure(row["measured"], "psnr_db", 1), figure(row["measured"], "mae", 2),
                                  figure(row["filled"], "share", 1, 100.0), figure(row["filled"], "psnr_db", 1),
                                  figure(row["filled"], "mae", 2)});
  }
  return section;
}

BenchSection threadsSection(const json& report) {
  BenchSection section;
  section.title = "Reconstruction on two threads";
  section.text = "Wall clock, one thread and two in turns.";
  section.table = {1, {"Setting", "One thread, ms", "Two, ms", "Times as fast", "Voxels"}, {}};
  for (const auto& row : report["threads_measured"])
    section.table.rows.push_back({row["name"].get<std::string>(), fixedText(row["one_us"].get<double>() * 1e-3, 1),
                                  fixedText(row["two_us"].get<double>() * 1e-3, 1), fixedText(row["times_faster"].get<double>(), 2),
                                  row["same_voxels"].get<bool>() ? "the same" : "OTHERS"});
  return section;
}

BenchSection confidenceSection(const json& report) {
  BenchSection section;
  section.title = "Confidence maps: which echoes lie in shadow";
  section.text =
      "Virtual frames with stones, one thread, time of one frame of scan lines. Truth is what the forward model takes away. The area under "
      "the curve is the share of pairs, one block in sight and one in shadow, that the confidence puts in the right order. The random walk "
      "is drawn over the size of its graph.";
  section.axis = {.title = "area under the curve", .unit = "", .decimals = 4, .smallestStep = 0.01};
  const auto probes = distinct(report["confidence"], "probe");
  for (std::size_t n = 0; n < probes.size(); ++n) section.legend.push_back({n == 0 ? BenchMark::own : BenchMark::ownHollow, probes[n]});
  section.table = {2, {"Probe", "Method", "Median, ms", "Area under the curve", "Mean in shadow", "Mean in sight"}, {}};
  for (const auto& row : report["confidence"]) {
    const std::string probe = row["probe"].get<std::string>();
    const bool walks = row["method"] == "randomwalk";
    const std::string size = std::to_string(row["lines"].get<int>()) + " x " + std::to_string(row["samples"].get<int>());
    const double ms = row["median_us"].get<double>() * 1e-3, area = row["area_under_curve"].get<double>();
    section.points.push_back({walks ? size : "beam-wise", row["name"].get<std::string>(), ms, area,
                              probe == probes.front() ? BenchMark::own : BenchMark::ownHollow, walks ? probe : ""});
    section.table.rows.push_back({probe, walks ? "random walk, " + size : "beam-wise", fixedText(ms, 2), fixedText(area, 4),
                                  fixedText(row["mean_in_shadow"].get<double>(), 3), fixedText(row["mean_in_sight"].get<double>(), 3)});
  }
  return section;
}

}  // namespace

std::vector<BenchSection> reconstructSections(const json& report) {
  std::vector<BenchSection> sections{pastingSection(report)};
  for (const auto& sweep : distinct(report["results"], "sweep")) sections.push_back(fillingSection(report, sweep));
  sections.push_back(threadsSection(report));
  sections.push_back(confidenceSection(report));
  return sections;
}

}  // namespace ew
