#include "bench/images/bench_flow.h"
#include "ew/core/figures.h"

namespace ew {
namespace {

using nlohmann::json;

std::string flowFigure(const json& row, const char* key, int decimals) { return fixedText(row[key].get<double>(), decimals); }

BenchSection flowTimes(const json& report) {
  BenchSection section;
  section.title = "Doppler: what it adds to a frame";
  section.text = std::to_string(report["width"].get<int>()) + " x " + std::to_string(report["height"].get<int>()) +
                 " pixels with every effect of the case, " + std::to_string(report["frames"].get<int>()) +
                 " frames each by turns, the probe sliding, 25 frames a second of the patient's time. Added: the median of what a frame "
                 "took more than the same frame without Doppler.";
  section.limits_ms = {{50.0, "wanted of triplex: 20 a second"}};
  section.table = {2, {"Case", "Setting", "Threads", "Median, ms", "99 %", "Added, ms", "99 %"}, {}};
  for (const auto& row : report["results"]) {
    if (row["threads"] == 2)
      section.bars.push_back(
          {row["case"].get<std::string>() + ", " + row["setting"].get<std::string>(), row["median_ms"].get<double>(), BenchMark::own});
    section.table.rows.push_back({row["case"].get<std::string>(), row["setting"].get<std::string>(),
                                  std::to_string(row["threads"].get<int>()), flowFigure(row, "median_ms", 2), flowFigure(row, "p99_ms", 2),
                                  flowFigure(row, "added_ms", 2), flowFigure(row, "added_p99_ms", 2)});
  }
  return section;
}

BenchSection flowAccuracy(const json& report) {
  BenchSection section;
  section.title = "Colour against the truth and against moving scatterers";
  section.text =
      "On the axis of a straight vessel, velocities along the beam as shares of the Nyquist velocity, packets of 10 behind a wall filter "
      "of order 0; " +
      std::to_string(report["packets"].get<int>()) +
      " packets of scatterers that are moved through the gate one by one, twice as many of colour, whose packets are drawn with the "
      "statistics that those have. Time: of one gate.";
  section.axis = {.title = "standard deviation, % nearer than 50", .unit = "%", .decimals = 1, .smallestStep = 10.0};
  section.legend = {{BenchMark::own, "colour"}, {BenchMark::peer, "moving scatterers"}};
  section.table = {1,
                   {"Angle", "Signal to noise, dB", "Truth", "Colour", "Scatterers", "Deviation, colour", "Deviation, scatterers",
                    "Gate, colour, us", "Gate, scatterers, us"},
                   {}};
  for (const auto& row : report["accuracy"]) {
    const std::string angle = flowFigure(row, "angle_deg", 0) + " degrees";
    const double off_percent = 100.0 * std::abs(row["colour_deviation"].get<double>() / row["scatterers_deviation"].get<double>() - 1.0);
    const std::string name = angle + ", " + flowFigure(row, "signal_to_noise_db", 0) + " dB";
    section.points.push_back({name, name, 1e-3 * row["colour_us"].get<double>(), 50.0 - std::min(50.0, off_percent), BenchMark::own, ""});
    section.points.push_back({"", name, 1e-3 * row["scatterers_us"].get<double>(), 50.0, BenchMark::peer, ""});
    section.table.rows.push_back({angle, flowFigure(row, "signal_to_noise_db", 0), flowFigure(row, "truth", 3),
                                  flowFigure(row, "colour", 3), flowFigure(row, "scatterers", 3), flowFigure(row, "colour_deviation", 3),
                                  flowFigure(row, "scatterers_deviation", 3), flowFigure(row, "colour_us", 2),
                                  flowFigure(row, "scatterers_us", 1)});
  }
  return section;
}

}  // namespace

std::vector<BenchSection> flowSections(const json& report) { return {flowTimes(report), flowAccuracy(report)}; }

}  // namespace ew
