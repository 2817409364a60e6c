#include <ostream>

#include "arguments.h"
#include "bench_slicing.h"
#include "command.h"
#include "ew/core/numbers.h"

namespace ew::cli {
namespace {

using nlohmann::json;

struct BenchArguments {
  std::string html;
  std::vector<std::string> sides;
  int sliceSide = 400;
  int poses = 40;
  int repetitions = 7;
  bool noPeers = false;
};

/// A column that ends at the same place whatever it holds.
std::string right(std::string text, std::size_t width) {
  text.insert(0, width - std::min(width, text.size()), ' ');
  return text;
}

void printResults(std::ostream& out, const json& measured) {
  const auto number = [](const json& row, const char* key, int digits) {
    return row.contains(key) && row[key].is_number() ? rounded(row[key].get<double>(), digits) : std::string("-");
  };
  const auto text = [](const json& row, const char* key) {
    return row.contains(key) && row[key].is_string() ? row[key].get<std::string>() : std::string("-");
  };
  std::size_t nameWidth = 4;
  for (const auto& row : measured.value("results", json::array())) nameWidth = std::max(nameWidth, text(row, "name").size());
  for (const auto& row : measured.value("results", json::array())) {
    std::string name = text(row, "name");
    name.resize(nameWidth + 2, ' ');
    out << name << right(number(row, "median_us", 0), 8) << " us  " << right(number(row, "psnr_db", 1), 6) << " dB  worst "
        << right(number(row, "worst_grey", 0), 3) << " grey\n";
  }
  for (const auto& row : measured.value("ratios", json::array()))
    out << text(row, "quality") << ", " << number(row, "volume_side", 0) << " cubed, " << text(row, "pose_kind")
        << " poses: " << number(row, "times_faster", 2) << " times as fast as the peer\n";
}

Result<int> slicing(const BenchArguments& arguments, Run& run) {
  BenchOptions options;
  options.sliceSide = arguments.sliceSide;
  options.poses = arguments.poses;
  options.repetitions = arguments.repetitions;
  options.peers = !arguments.noPeers;
  options.html = arguments.html;
  if (!arguments.sides.empty()) options.volumeSides.clear();
  for (const auto& side : arguments.sides) {
    const auto value = parseIntegers(side);
    if (!value || value->size() != 1 || value->front() < 8 || value->front() > 1024)
      return failure(ErrorCode::badUsage, "--side '" + side + "' cannot be used; give a whole number from 8 to 1024.");
    options.volumeSides.push_back(static_cast<int>(value->front()));
  }
  if (!arguments.html.empty())
    if (auto writable = run.outputs.announceFolder(arguments.html); !writable) return passOn(writable.error());
  run.report.options = {{"volume_sides", options.volumeSides},
                        {"slice_side", options.sliceSide},
                        {"poses", options.poses},
                        {"repetitions", options.repetitions},
                        {"peers", options.peers}};
  auto measured = benchSlicing(options, run.progress);
  if (!measured) return passOn(measured.error());
  run.progress.clear();
  if (measured->contains("steps")) run.report.summarisedSteps = (*measured)["steps"];
  measured->erase("steps");
  run.report.quality = *measured;
  if (!arguments.html.empty()) {
    const auto page = (std::filesystem::path(arguments.html) / "slicing.html").string();
    run.report.outputs.push_back(page);
    run.say("Wrote " + page + ".");
  }
  if (!run.quiet()) printResults(run.out(), *measured);
  return kDone;
}

}  // namespace

void addBench(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("bench", "Measure what accuracy costs in time on this machine");
  group.require_subcommand(1);
  auto arguments = std::make_shared<BenchArguments>();
  auto& app =
      addCommand(group, selection, "slicing", "Every slicer against an exact answer and against VTK's, one thread, medians of one run",
                 {"bench slicing", "bench slicing --html bench --report bench.json", "bench slicing --side 256 --repetitions 3"},
                 [arguments](Run& run) { return slicing(*arguments, run); });
  app.add_option("--html", arguments->html, "Also write a page with the curves of accuracy against time")->type_name("DIR");
  app.add_option("--side", arguments->sides, "Voxels a side of the volume; may be given several times (256 and 512)")->type_name("COUNT");
  addCount(app, "--size", arguments->sliceSide, 16, 4096, "Pixels a side of a slice (400)");
  addCount(app, "--poses", arguments->poses, 2, 1000, "Poses of each kind, random and smooth (40)");
  addCount(app, "--repetitions", arguments->repetitions, 1, 1000, "Interleaved repetitions (7)");
  app.add_flag("--no-peers", arguments->noPeers, "Leave VTK's reslice out");
}

}  // namespace ew::cli
