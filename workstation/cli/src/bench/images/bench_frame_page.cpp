#include <algorithm>

#include "bench/images/bench_frame.h"
#include "bench/tools/bench_parts.h"

namespace ew {
namespace {

using nlohmann::json;

BenchSection sectionOf(const json& report, const std::string& group, int side, const std::string& title, const std::string& text) {
  BenchSection section;
  section.title = title;
  section.text = text;
  section.table = {1, {"Setting", "Median, ms", "Of VTK's linear slice", "PSNR, dB", "Worst, grey levels"}, {}};
  for (const auto& row : report["results"]) {
    if (row["group"] != group || row["volume_side"] != side) continue;
    const std::string method = row["method"].get<std::string>();
    const double ms = row["median_us"].get<double>() * 1e-3;
    const bool peer = row["peer"].get<bool>(), measured = row.contains("psnr_db");
    if (measured)
      section.points.push_back({method, method, ms, row["psnr_db"].get<double>(), peer ? BenchMark::peer : BenchMark::own,
                                peer                          ? ""
                                : method.starts_with("beams") ? "beams"
                                                              : "own"});
    section.table.rows.push_back({method, fixedText(ms, 3), row.contains("of_peer") ? fixedText(row["of_peer"].get<double>(), 3) : "",
                                  measured ? fixedText(row["psnr_db"].get<double>(), 1) : "",
                                  measured ? fixedText(row["worst_grey"].get<double>(), 1) : ""});
  }
  return section;
}

}  // namespace

std::vector<BenchSection> frameSections(const json& report) {
  std::vector<BenchSection> sections;
  std::vector<int> sides;
  for (const auto& row : report["results"])
    if (const int side = row["volume_side"].get<int>(); std::find(sides.begin(), sides.end(), side) == sides.end()) sides.push_back(side);
  const std::string size = std::to_string(report["width"].get<int>()) + " x " + std::to_string(report["height"].get<int>());
  for (const int side : sides) {
    const std::string of = ", " + std::to_string(side) + " cubed";
    double peer_ms = 0.0;
    BenchSection times;
    times.title = "Whole frames, " + size + of;
    times.text =
        "Probe " + report["probe"].get<std::string>() +
        ", one thread. Each bar is a whole frame with the effect named and no other; the last ones have everything on. VTK makes a "
        "bare slice of the same plane and as many pixels, without a fan and without any effect. Memory is what such frames keep beyond the "
        "voxels: the image, tables, and what one frame leaves for the next.";
    times.table = {1, {"Setting", "Threads", "Median, ms", "Of VTK's linear slice", "Memory, MiB"}, {}};
    for (const auto& row : report["results"]) {
      if (row["volume_side"] != side) continue;
      const std::string method = row["method"].get<std::string>();
      const double ms = row["median_us"].get<double>() * 1e-3;
      const bool peer = row["peer"].get<bool>();
      if (method == "VTK linear") peer_ms = ms;
      if (method != "VTK cubic" && row["threads"] == 1) times.bars.push_back({method, ms, peer ? BenchMark::peer : BenchMark::own});
      times.table.rows.push_back({method, std::to_string(row["threads"].get<int>()), fixedText(ms, 3),
                                  row.contains("of_peer") ? fixedText(row["of_peer"].get<double>(), 3) : "", memoryIn(row, "held_mib")});
    }
    if (peer_ms > 0.0) times.limits_ms = {{0.2 * peer_ms, "0.2"}, {0.5 * peer_ms, "0.5"}, {peer_ms, "VTK linear = 1"}};
    for (const auto& must : report["must_show"])
      if (must["name"].get<std::string>().find(of) != std::string::npos)
        times.text += " " + must["name"].get<std::string>() + ": " + fixedText(must["value"].get<double>(), 3) + ", wanted at most " +
                      fixedText(must["limit"].get<double>(), 2) + (must["met"].get<bool>() ? "." : ": NOT MET.");
    sections.push_back(std::move(times));

    BenchSection sampling = sectionOf(report, "sampling", side, "Sampling a frame" + of,
                                      "The neutral frame at each quality, on the display grid and by way of beams and scan conversion, "
                                      "against the field itself.");
    sampling.legend = {{BenchMark::own, "EchoWeave, a frame"}, {BenchMark::peer, "VTK, a bare slice"}};
    sections.push_back(std::move(sampling));
    sections.push_back(sectionOf(report, "slice thickness", side, "Slice thickness" + of,
                                 "Planes averaged over the beam's elevational width, against the field's exact mean under it. What the "
                                 "linear sampling itself leaves is in the figures."));
    sections.push_back(sectionOf(report, "focus", side, "Focus" + of,
                                 "The paper's row stretching and the lateral kernel, against the field's exact mean under the beam's "
                                 "lateral width."));
  }
  return sections;
}

}  // namespace ew
