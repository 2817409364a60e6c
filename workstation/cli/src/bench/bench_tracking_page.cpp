#include <algorithm>

#include "bench/bench_tracking.h"

namespace ew {

std::vector<BenchSection> trackingSections(const nlohmann::json& report) {
  BenchSection section;
  section.title = "A camera as tracker: how exact a probe's place is, and what an image costs";
  section.text =
      std::to_string(report["frames"].get<std::size_t>()) +
      " images of paper bodies whose truth is known, by a camera with a lens that bends, noise, uneven light and paper that is not "
      "flat; processor time of one thread. Upwards: how many times the median error at the transducer's face goes into a "
      "millimetre. Poses that are not shown do not count as errors; how many are shown stands in the table.";
  section.axis = {.title = "exactness, 1 over the median error in mm", .unit = "per mm", .decimals = 2, .smallestStep = 0.5};
  section.legend = {
      {BenchMark::own, "sides as lines"}, {BenchMark::ownHollow, "other corners, our pose"}, {BenchMark::peer, "estimatePoseBoard"}};
  section.table = {1, {"Setting", "ms", "95 %, ms", "Error, mm", "95 %, mm", "Turn, degrees", "95 %, degrees", "Shown, %", "Flipped"}, {}};
  const auto number = [](const nlohmann::json& row, const char* key, double factor, int decimals) {
    return row[key].is_number() ? fixedText(factor * row[key].get<double>(), decimals) : std::string("-");
  };
  for (const auto& row : report["results"]) {
    const std::string name = row["name"].get<std::string>();
    const bool isPeer = row["peer"].get<bool>();
    if (row["face_mm"].is_number())
      section.points.push_back({name, name, 1e-3 * row["median_us"].get<double>(), 1.0 / std::max(0.01, row["face_mm"].get<double>()),
                                isPeer                      ? BenchMark::peer
                                : row["corners"] == "edges" ? BenchMark::own
                                                            : BenchMark::ownHollow,
                                ""});
    section.table.rows.push_back({name, number(row, "median_us", 1e-3, 1), number(row, "p95_us", 1e-3, 1), number(row, "face_mm", 1.0, 2),
                                  number(row, "face_p95_mm", 1.0, 2), number(row, "turn_deg", 1.0, 2), number(row, "turn_p95_deg", 1.0, 2),
                                  number(row, "shown", 100.0, 1), number(row, "flipped", 1.0, 0)});
  }
  return {std::move(section)};
}

}  // namespace ew
