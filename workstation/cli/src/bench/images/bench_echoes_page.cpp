
#include "bench/images/bench_echoes.h"

namespace ew {
namespace {

using nlohmann::json;

std::string figureIn(const json& row, const char* key, int decimals) {
  return row.contains(key) && row[key].is_number() ? fixedText(row[key].get<double>(), decimals) : std::string("-");
}

BenchSection accuracySection(const json& report) {
  BenchSection section;
  section.title = "Live echoes against the forward model";
  section.text =
      std::to_string(report["poses"].get<int>()) +
      " poses of each case; the model (VirtualScanner) sees the same patient from the same poses with the same probe, depth, focus, "
      "looks and pulse. Scatterers alone, without mirrors and noise; texture, little walls, line filter, haze and gain of live "
      "echoes are off. Level is the median difference of patches of 8 mm, beside it the 95th percentile of its absolute value and "
      "the same between two models of other scatterers, which is what chance leaves. Lengths are the worst of four bands of depth, "
      "decorrelation the worst of rotations by 1 to 8 degrees, elevation by 0.5 to 1.5 mm and slides by 0.5 to 2 mm. In the chart "
      "upwards: decibels that the level is closer to the model than 10 dB.";
  section.axis = {.title = "level, dB closer than 10", .unit = "dB", .decimals = 2, .smallestStep = 1.0};
  section.legend = {{BenchMark::own, "default"}, {BenchMark::ownHollow, "fast"}, {BenchMark::peer, "fine"}};
  section.table = {2,
                   {"Case", "Quality", "Patches", "Level, dB", "95 %", "By chance", "SNR, % off", "Axial, % off", "Lateral, % off",
                    "Decorrelation, off", "Shadow, dB", "Model, ms"},
                   {}};
  const auto addRow = [&](const json& row, const std::string& name) {
    section.table.rows.push_back({name, row["quality"].get<std::string>(), figureIn(row, "patches", 0), figureIn(row, "level_db", 2),
                                  figureIn(row, "level_p95_db", 2), figureIn(row, "level_floor_p95_db", 2),
                                  figureIn(row, "snr_off_percent", 1), figureIn(row, "axial_off_percent", 1),
                                  figureIn(row, "lateral_off_percent", 1), figureIn(row, "decorrelation_off", 3),
                                  figureIn(row, "shadow_db", 2), figureIn(row, "forward_ms", 1)});
  };
  for (const auto& row : report["results"]) {
    const std::string name = row["case"].get<std::string>(), quality = row["quality"].get<std::string>();
    addRow(row, name);
    if (row["level_p95_db"].is_number())
      section.points.push_back({quality == "default" ? name : "", row["name"].get<std::string>(), row["two_threads_ms"].get<double>(),
                                10.0 - std::min(10.0, row["level_p95_db"].get<double>()),
                                quality == "default" ? BenchMark::own
                                : quality == "fast"  ? BenchMark::ownHollow
                                                     : BenchMark::peer,
                                name});
  }
  for (const auto& total : report["totals"]) addRow(total, "the worst");
  return section;
}

BenchSection timeSection(const json& report) {
  BenchSection section;
  section.title = "Live echoes: whole frames from pose to image";
  section.text =
      std::to_string(report["width"].get<int>()) + " x " + std::to_string(report["height"].get<int>()) +
      " pixels with every effect of the case, " + std::to_string(report["frames"].get<int>()) +
      " frames each, a new pose for every frame, by the clock on the wall. Memory: what the case keeps once it is read (what "
      "rests in its prepared files is left out), what the scanner on two threads keeps for its frames, and what the model takes.";
  section.limits_ms = {{12.0, "wanted: 12 ms"}, {16.0, "wanted of 99 in 100: 16 ms"}};
  section.table = {2,
                   {"Case", "Quality", "One thread, ms", "95 %", "99 %", "Two threads, ms", "95 %", "99 %", "Case, MiB", "Its frames, MiB",
                    "Model, MiB"},
                   {}};
  for (const auto& row : report["results"]) {
    section.bars.push_back({row["name"].get<std::string>(), row["two_threads_ms"].get<double>(), BenchMark::own});
    section.table.rows.push_back({row["case"].get<std::string>(), row["quality"].get<std::string>(), figureIn(row, "one_thread_ms", 2),
                                  figureIn(row, "one_p95_ms", 2), figureIn(row, "one_p99_ms", 2), figureIn(row, "two_threads_ms", 2),
                                  figureIn(row, "two_p95_ms", 2), figureIn(row, "two_p99_ms", 2), figureIn(row, "case_mib", 0),
                                  figureIn(row, "held_mib", 1), figureIn(row, "forward_mib", 0)});
  }
  return section;
}

}  // namespace

std::vector<BenchSection> echoSections(const json& report) { return {accuracySection(report), timeSection(report)}; }

}  // namespace ew
