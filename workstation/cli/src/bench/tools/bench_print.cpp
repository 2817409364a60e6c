#include "bench/tools/bench_print.h"

#include <algorithm>
#include <ostream>
#include <string>

#include "ew/core/foreign_json.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

using nlohmann::json;

/// A column that ends at the same place whatever it holds.
std::string right(std::string text, std::size_t width) {
  text.insert(0, width - std::min(width, text.size()), ' ');
  return text;
}

std::string numberIn(const json& row, const char* key, int digits) {
  return row.contains(key) && row[key].is_number() ? rounded(row[key].get<double>(), digits) : std::string("-");
}
std::string textIn(const json& row, const char* key) {
  return row.contains(key) && row[key].is_string() ? row[key].get<std::string>() : std::string("-");
}

/// Live echoes against the forward model: a line for each case and quality, and one of totals for each quality.
void printEchoes(std::ostream& out, const json& measured) {
  constexpr std::size_t kName = 44;
  const auto line = [&](std::string name, const json& row) {
    name.resize(std::max(kName, name.size() + 1), ' ');
    out << name << right(numberIn(row, "level_db", 2), 6) << " dB (95 %" << right(numberIn(row, "level_p95_db", 2), 6) << ", by chance"
        << right(numberIn(row, "level_floor_p95_db", 2), 6) << ")  SNR" << right(numberIn(row, "snr_off_percent", 1), 6) << " %  axial"
        << right(numberIn(row, "axial_off_percent", 1), 6) << " %  lateral" << right(numberIn(row, "lateral_off_percent", 1), 6)
        << " %  views" << right(numberIn(row, "decorrelation_off", 3), 7) << "  shadow" << right(numberIn(row, "shadow_db", 2), 6)
        << " dB  " << right(numberIn(row, "one_thread_ms", 1), 6) << " ms, two threads" << right(numberIn(row, "two_threads_ms", 1), 6)
        << " ms (99 %" << right(numberIn(row, "two_p99_ms", 1), 6) << "), model" << right(numberIn(row, "forward_ms", 0), 5) << " ms\n";
  };
  for (const auto& row : measured["results"]) line(textIn(row, "name"), row);
  for (const auto& total : measured["totals"]) line("the worst, " + textIn(total, "quality"), total);
}

}  // namespace

void printResults(std::ostream& out, const json& measured) {
  if (measured.contains("totals")) printEchoes(out, measured);
  std::size_t nameWidth = 4;
  for (const auto& row : listAt(measured, "results")) nameWidth = std::max(nameWidth, textIn(row, "name").size());
  for (const auto& row : listAt(measured, "results")) {
    if (row.contains("removed_percent") || row.contains("derivative_ratio") || row.contains("decorrelation")) continue;
    std::string name = textIn(row, "name");
    name.resize(nameWidth + 2, ' ');
    out << name << right(numberIn(row, "median_us", 0), 8) << " us  ";
    if (row.contains("of_peer")) out << right(numberIn(row, "of_peer", 3), 7) << " of VTK  ";
    if (row.contains("mpx_per_s")) out << right(numberIn(row, "mpx_per_s", 1), 6) << " Mpx/s  ";
    for (const char* kind : {"measured", "filled"})
      if (row.contains(kind) && row[kind].is_object())
        out << kind << right(rounded(100.0 * row[kind]["share"].get<double>(), 1), 6) << " %" << right(numberIn(row[kind], "psnr_db", 1), 6)
            << " dB, mae" << right(numberIn(row[kind], "mae", 2), 6) << "  ";
    if (row.contains("psnr_db"))
      out << right(numberIn(row, "psnr_db", 1), 6) << " dB  worst " << right(numberIn(row, "worst_grey", 0), 3) << " grey";
    if (row.contains("face_mm"))
      out << numberIn(row, "face_mm", 2) << " mm (95 %" << right(numberIn(row, "face_p95_mm", 2), 6) << "), "
          << numberIn(row, "turn_deg", 2) << " degrees (95 %" << right(numberIn(row, "turn_p95_deg", 2), 6) << "), shown "
          << right(rounded(100.0 * row["shown"].get<double>(), 1), 5) << " %, flipped " << numberIn(row, "flipped", 0);
    if (row.contains("psnr_double_db")) out << "  " << right(numberIn(row, "psnr_double_db", 1), 5) << " dB from double precision";
    out << "\n";
  }
  for (const char* rows : {"results", "peers"})
    for (const auto& row : measured.value(rows, json::array())) {
      if (row.contains("failed")) out << textIn(row, "name") << ": " << textIn(row, "failed") << "\n";
      if (!row.contains("removed_percent")) continue;
      std::string name = textIn(row, "name");
      name.resize(std::max(nameWidth + 2, name.size() + 1), ' ');
      out << name << right(rounded(row["median_us"].get<double>() * 1e-3, 1), 9) << " ms  " << right(numberIn(row, "error_start_mm", 2), 6)
          << " mm ->" << right(numberIn(row, "error_mm", 3), 7) << " mm, 95 % below" << right(numberIn(row, "error_p95_mm", 3), 7)
          << " mm  " << (row.contains("verdict") ? textIn(row, "verdict") : std::string()) << "\n";
    }
  for (const auto& row : listAt(measured, "results"))
    if (row.contains("derivative_ratio"))
      out << textIn(row, "name") << ": " << rounded(row["median_us"].get<double>() * 1e-3, 1) << " ms, derivative across the seam "
          << numberIn(row, "derivative_ratio", 3) << ", speckle " << numberIn(row, "speckle_ratio", 3) << ", step "
          << numberIn(row, "step_db", 2) << " dB, shadow off by " << numberIn(row, "shadow_error_db", 2) << " dB\n";
  for (const auto& name : listAt(measured, "peers_missing"))
    out << name.get<std::string>() << " is not installed here; nothing was compared with it\n";
  for (const auto& row : listAt(measured, "threads_measured"))
    if (row.contains("same_voxels"))
      out << textIn(row, "name") << ", two threads: " << numberIn(row, "times_faster", 2) << " times as fast as one, "
          << (row["same_voxels"].get<bool>() ? "the same voxels\n" : "OTHER VOXELS\n");
  for (const auto& row : listAt(measured, "confidence"))
    out << textIn(row, "name") << ": " << numberIn(row, "median_us", 0) << " us a frame, area under the curve "
        << numberIn(row, "area_under_curve", 4) << ", mean in shadow " << numberIn(row, "mean_in_shadow", 2) << " and in sight "
        << numberIn(row, "mean_in_sight", 2) << "\n";
  for (const auto& row : listAt(measured, "ratios"))
    out << textIn(row, "quality") << ", " << numberIn(row, "volume_side", 0) << " cubed, " << textIn(row, "pose_kind")
        << " poses: " << numberIn(row, "times_faster", 2) << " times as fast as the peer\n";
  for (const auto& row : listAt(measured, "promises"))
    out << textIn(row, "what") << ": " << numberIn(row, "found", 2) << ", wanted at least " << numberIn(row, "bar", 2)
        << (row["passed"].get<bool>() ? ": met\n" : ": NOT MET\n");
  for (const auto& row : listAt(measured, "must_show"))
    out << textIn(row, "name") << ": " << numberIn(row, "value", 3) << ", wanted at most " << numberIn(row, "limit", 2)
        << (row["met"].get<bool>() ? ": met\n" : ": NOT MET\n");
}

}  // namespace ew::cli
