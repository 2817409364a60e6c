#include <algorithm>

#include "bench/volumes/bench_register.h"

namespace ew {
namespace {

using nlohmann::json;

std::string rowFigure(const json& row, const char* key, int decimals) {
  return row.contains(key) && row[key].is_number() ? fixedText(row[key].get<double>(), decimals) : std::string();
}
std::string word(const json& row, const char* key) {
  return row.contains(key) && row[key].is_string() ? row[key].get<std::string>() : std::string();
}

const BenchAxis kRemoved{.title = "error removed, %", .unit = "%", .decimals = 1, .smallestStep = 5.0};

void pointInto(BenchSection& section, const json& row, const std::string& label, BenchMark mark, const std::string& curve) {
  if (!row.contains("removed_percent") || !row["removed_percent"].is_number()) return;
  // Worse than nothing done is drawn at nothing done: how much worse, the table says.
  section.points.push_back({label, row["name"].get<std::string>(), row["median_us"].get<double>() * 1e-3,
                            std::max(0.0, row["removed_percent"].get<double>()), mark, curve});
}

void rowInto(BenchSection& section, const json& row, const std::string& who) {
  section.table.rows.push_back({who, word(row, "setting"), word(row, "pair"), word(row, "verdict"),
                                fixedText(row["median_us"].get<double>() * 1e-3, 1), rowFigure(row, "peak_mib", 1),
                                rowFigure(row, "error_start_mm", 2), rowFigure(row, "error_mm", 3), rowFigure(row, "error_p95_mm", 3),
                                rowFigure(row, "jacobian_min", 2)});
}

BenchSection sectionFor(const std::string& title, const std::string& text) {
  BenchSection section;
  section.title = title;
  section.text = text;
  section.axis = kRemoved;
  section.table = {
      4, {"Who", "Setting", "Pair", "Verdict", "Median, ms", "Memory, MiB", "Start, mm", "Error, mm", "95 %, mm", "Least Jacobian"}, {}};
  return section;
}

}  // namespace

std::vector<BenchSection> registerSections(const json& report) {
  std::vector<BenchSection> sections;
  const std::string side = std::to_string(report["side"].get<int>());
  const auto of = [&](const std::string& method) {
    std::vector<const json*> rows;
    for (const auto& row : report["results"])
      if (row["method"] == method) rows.push_back(&row);
    return rows;
  };

  std::string missing;
  for (const auto& name : report["peers_missing"]) missing += (missing.empty() ? "" : " and ") + name.get<std::string>();
  const auto elastic = of("elastic3d");
  if (!elastic.empty() || !report["peers"].empty()) {
    BenchSection section =
        sectionFor("Bending volumes onto each other",
                   "A pair of " + side +
                       " cubed voxels of 0.6 mm, motion up to 5 mm, two thirds of the speckle's power shared, 5 dB more gain and a shadow "
                       "in one. One thread; a peer's time is that of its process, files read to field written, and its setting one that is "
                       "sensible, not "
                       "tuned. Error removed: 100 is exact, 0 as if nothing had been done. Memory is the peak beyond the two volumes; of a "
                       "peer's process it "
                       "was not measured." +
                       (missing.empty() ? std::string() : " Not installed here: " + missing + "."));
    section.legend = {{BenchMark::own, "EchoWeave"}, {BenchMark::peer, "peer"}};
    for (const json* row : elastic) {
      pointInto(section, *row, word(*row, "setting"), BenchMark::own, "");
      rowInto(section, *row, "EchoWeave");
    }
    for (const auto& row : report["peers"]) {
      if (row.contains("failed")) {
        section.table.rows.push_back({word(row, "name"), word(row, "failed"), "", "", "", "", "", "", "", ""});
        continue;
      }
      pointInto(section, row, word(row, "method"), BenchMark::peer, "");
      rowInto(section, row, word(row, "method"));
    }
    sections.push_back(std::move(section));
  }
  const auto add = [&](const std::string& method, const std::string& title, const std::string& text) {
    const auto rows = of(method);
    if (rows.empty()) return;
    BenchSection section = sectionFor(title, text);
    section.legend = {{BenchMark::own, "EchoWeave"}};
    std::string first;
    for (const json* row : rows) {
      if (first.empty()) first = word(*row, "pair");
      pointInto(section, *row, word(*row, "setting"), word(*row, "pair") == first ? BenchMark::own : BenchMark::ownHollow,
                word(*row, "pair"));
      rowInto(section, *row, "EchoWeave");
    }
    sections.push_back(std::move(section));
  };
  add("partial", "Matching without a tracker",
      "Views of " + side +
          " cubed voxels of 0.9 mm that share half (12 degrees, solid) and a third (24 degrees, hollow) of what they show; any "
          "place, any turn up to 30 degrees. Memory is the peak beyond the volumes. Strangers show different tissue: what counts there is "
          "that they are refused.");
  add("rigid", "Refining a rigid start", "The same views 9 degrees and 6 mm off, refined from the files' coordinates.");
  add("elastic2d", "Bending images onto each other",
      "256 x 256 pixels of 0.4 mm, the same motion in the plane. Barber's method; `one level` is the paper's counter-example.");
  add("landmarks", "Landmarks",
      "Places hit within 1 mm (standard deviation, in each volume and along each axis) in a cube of 80 mm, every fifth 30 mm beside the "
      "right "
      "one. Error at the cube's corners.");
  return sections;
}

}  // namespace ew
