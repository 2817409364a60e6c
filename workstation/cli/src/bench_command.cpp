#include <ostream>

#include "arguments.h"
#include "bench_frame.h"
#include "bench_page.h"
#include "bench_slicing.h"
#include "command.h"
#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"

namespace ew::cli {
namespace {

using nlohmann::json;

struct BenchArguments {
  std::string html;
  std::vector<std::string> sides;
  int sliceSide = 400;
  glm::ivec2 frame_px{1024, 768};
  int poses = 0;  // 0: as many as the benchmark likes
  int repetitions = 7;
  bool noPeers = false;
  bool large = false;
};

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

void printResults(std::ostream& out, const json& measured) {
  std::size_t nameWidth = 4;
  for (const auto& row : measured.value("results", json::array())) nameWidth = std::max(nameWidth, textIn(row, "name").size());
  for (const auto& row : measured.value("results", json::array())) {
    std::string name = textIn(row, "name");
    name.resize(nameWidth + 2, ' ');
    out << name << right(numberIn(row, "median_us", 0), 8) << " us  ";
    if (row.contains("of_peer")) out << right(numberIn(row, "of_peer", 3), 7) << " of VTK  ";
    if (row.contains("psnr_db"))
      out << right(numberIn(row, "psnr_db", 1), 6) << " dB  worst " << right(numberIn(row, "worst_grey", 0), 3) << " grey";
    if (row.contains("psnr_double_db")) out << "  " << right(numberIn(row, "psnr_double_db", 1), 5) << " dB from double precision";
    out << "\n";
  }
  for (const auto& row : measured.value("ratios", json::array()))
    out << textIn(row, "quality") << ", " << numberIn(row, "volume_side", 0) << " cubed, " << textIn(row, "pose_kind")
        << " poses: " << numberIn(row, "times_faster", 2) << " times as fast as the peer\n";
  for (const auto& row : measured.value("promises", json::array()))
    out << textIn(row, "what") << ": " << numberIn(row, "found", 2) << ", wanted at least " << numberIn(row, "bar", 2)
        << (row["passed"].get<bool>() ? ": met\n" : ": NOT MET\n");
  for (const auto& row : measured.value("must_show", json::array()))
    out << textIn(row, "name") << ": " << numberIn(row, "value", 3) << ", wanted at most " << numberIn(row, "limit", 1)
        << (row["met"].get<bool>() ? ": met\n" : ": NOT MET\n");
}

Result<std::vector<int>> sidesOf(const BenchArguments& arguments, std::vector<int> sides, int smallest) {
  if (!arguments.sides.empty()) sides.clear();
  for (const auto& side : arguments.sides) {
    const auto value = parseIntegers(side);
    if (!value || value->size() != 1 || value->front() < smallest || value->front() > 1024)
      return failure(ErrorCode::badUsage,
                     "--side '" + side + "' cannot be used; give a whole number from " + std::to_string(smallest) + " to 1024.");
    sides.push_back(static_cast<int>(value->front()));
  }
  return sides;
}

Result<json> slicing(const BenchArguments& arguments, Run& run, Progress& progress) {
  BenchOptions options;
  options.sliceSide = arguments.sliceSide;
  options.poses = arguments.poses > 0 ? arguments.poses : options.poses;
  options.repetitions = arguments.repetitions;
  options.peers = !arguments.noPeers;
  auto sides = sidesOf(arguments, options.volumeSides, 8);
  if (!sides) return passOn(sides.error());
  options.volumeSides = *sides;
  if (arguments.large) options.volumeSides.push_back(1024);
  run.report.options["slicing"] = {{"volume_sides", options.volumeSides},
                                   {"slice_side", options.sliceSide},
                                   {"poses", options.poses},
                                   {"repetitions", options.repetitions},
                                   {"peers", options.peers}};
  return benchSlicing(options, progress);
}

Result<json> frame(const BenchArguments& arguments, Run& run, Progress& progress) {
  FrameBenchOptions options;
  options.width_px = arguments.frame_px.x;
  options.height_px = arguments.frame_px.y;
  options.poses = arguments.poses > 0 ? arguments.poses : options.poses;
  options.repetitions = arguments.repetitions;
  options.peers = !arguments.noPeers;
  auto sides = sidesOf(arguments, options.volumeSides, 64);
  if (!sides) return passOn(sides.error());
  options.volumeSides = *sides;
  run.report.options["frame"] = {{"volume_sides", options.volumeSides},
                                 {"size", {options.width_px, options.height_px}},
                                 {"poses", options.poses},
                                 {"repetitions", options.repetitions},
                                 {"peers", options.peers}};
  return benchFrame(options, progress);
}

constexpr const char* kPage = "accuracy-and-time.html";

Result<void> writePage(const BenchArguments& arguments, Run& run, const std::string& machine, const std::vector<BenchSection>& sections) {
  const std::filesystem::path folder(arguments.html);
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  const std::vector<std::string> introduction = {
      "Medians of interleaved repetitions, one run. Times of one thread are its processor time, so that other programs disturb them "
      "little; "
      "accuracy is measured against a field known exactly, so its ceiling is the rounding to 256 grey levels. VTK's vtkImageReslice reads "
      "the same voxels in the same memory, on one thread, with its optimisation on. In the charts, up and to the left is better.",
      "Machine: " + machine};
  if (auto written = writeFileSafely(folder / kPage, benchPage("EchoWeave: accuracy and time", introduction, sections)); !written)
    return written;
  run.report.outputs.push_back((folder / kPage).string());
  run.say("Wrote " + (folder / kPage).string() + ".");
  return {};
}

enum class Bench { slicing, frame, all };

Result<int> bench(Bench what, const BenchArguments& arguments, Run& run) {
  if (!arguments.html.empty())
    if (auto writable = run.outputs.announceFolder(arguments.html); !writable) return passOn(writable.error());
  std::vector<BenchSection> sections;
  std::string machine;
  const auto take = [&](const char* name, Result<json> measured, std::vector<BenchSection> (*sectionsOf)(const json&)) -> Result<void> {
    if (!measured) return passOn(measured.error());
    for (auto& step : (*measured)["steps"]) run.report.summarisedSteps.push_back(std::move(step));
    measured->erase("steps");
    for (auto& section : sectionsOf(*measured)) sections.push_back(std::move(section));
    machine = textIn(*measured, "machine");
    run.progress.clear();
    if (!run.quiet()) printResults(run.out(), *measured);
    if (what == Bench::all)
      run.report.quality[name] = *std::move(measured);
    else
      run.report.quality = *std::move(measured);
    return {};
  };
  const bool both = what == Bench::all;
  if (what != Bench::slicing) {
    PartOfProgress part(run.progress, 0.0, both ? 0.5 : 1.0);
    if (auto taken = take("frame", frame(arguments, run, part), frameSections); !taken) return passOn(taken.error());
  }
  if (what != Bench::frame) {
    PartOfProgress part(run.progress, both ? 0.5 : 0.0, 1.0);
    if (auto taken = take("slicing", slicing(arguments, run, part), slicingSections); !taken) return passOn(taken.error());
  }
  if (!arguments.html.empty())
    if (auto written = writePage(arguments, run, machine, sections); !written) return passOn(written.error());
  return kDone;
}

}  // namespace

void addBench(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("bench", "Measure what accuracy costs in time on this machine");
  group.require_subcommand(1);
  const auto add = [&](Bench what, const char* name, const char* description, const std::vector<std::string>& examples) {
    auto arguments = std::make_shared<BenchArguments>();
    auto& app =
        addCommand(group, selection, name, description, examples, [what, arguments](Run& run) { return bench(what, *arguments, run); });
    app.add_option("--html", arguments->html, std::string("Also write ") + kPage + ", the curves of accuracy against time")
        ->type_name("DIR");
    app.add_option("--side", arguments->sides, "Voxels a side of the volume; may be given several times (256 and 512)")->type_name("COUNT");
    if (what != Bench::frame) addCount(app, "--size", arguments->sliceSide, 16, 4096, "Pixels a side of a slice (400)");
    if (what != Bench::frame)
      app.add_flag("--large", arguments->large, "Also slices of a volume of 1024 cubed: 2.4 GiB of memory and some minutes");
    if (what != Bench::slicing) addSize(app, "--frame", arguments->frame_px, "Pixels of a frame (1024x768)");
    addCount(app, "--poses", arguments->poses, 2, 1000, "Poses of each kind (slices 40, frames 12)");
    addCount(app, "--repetitions", arguments->repetitions, 1, 1000, "Interleaved repetitions (7)");
    app.add_flag("--no-peers", arguments->noPeers, "Leave VTK's reslice out");
  };
  add(Bench::slicing, "slicing", "Every slicer against an exact answer and against VTK's, one thread, medians of one run",
      {"bench slicing", "bench slicing --html bench --report bench.json", "bench slicing --side 256 --repetitions 3"});
  add(Bench::frame, "frame", "Whole frames with every effect alone and together, against exact answers and VTK's bare slice",
      {"bench frame", "bench frame --html bench --report bench.json", "bench frame --side 256 --frame 640x480 --repetitions 3"});
  add(Bench::all, "all", "All of it, on one page", {"bench all --html bench --report bench.json"});
}

}  // namespace ew::cli
