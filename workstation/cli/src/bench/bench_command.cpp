#include <fstream>
#include <ostream>
#include <sstream>
#include <utility>

#include "bench/bench_library.h"
#include "bench/bench_tracking.h"
#include "bench/images/bench_echoes.h"
#include "bench/images/bench_frame.h"
#include "bench/images/bench_slicing.h"
#include "bench/teaching/bench_teaching_commands.h"
#include "bench/tools/bench_page.h"
#include "bench/volumes/bench_paper.h"
#include "bench/volumes/bench_reconstruct.h"
#include "bench/volumes/bench_register.h"
#include "bench/volumes/bench_stitch.h"
#include "ew/core/foreign_json.h"
#include "ew/core/numbers.h"
#include "ew/core/simd.h"
#include "ew/io/safe_file.h"
#include "run/arguments.h"
#include "run/command.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

using nlohmann::json;

struct BenchArguments {
  std::string html;
  std::string note;   ///< about the machine, for the page
  std::string paper;  ///< folder for the figures
  std::vector<std::string> sides;
  int sliceSide = 400;
  glm::ivec2 frame_px{1024, 768};
  int poses = 0;        // 0: as many as the benchmark likes
  int repetitions = 0;  // the same
  std::vector<std::string> spacings_mm;
  int sweepFrames = 60;
  int imageSide = 240;
  int views = 2;
  int pairSide = 96;
  int viewSide = 128;
  std::uint64_t seed = 1;
  std::vector<std::string> cases;
  int timedFrames = 40;
  std::string trackedViews;  ///< folder
  int trackedFrames = 0;
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

Result<std::vector<int>> sidesOf(const BenchArguments& arguments, std::vector<int> sides, int smallest) {
  if (!arguments.sides.empty()) sides.clear();
  for (const auto& side : arguments.sides) {
    const auto value = parseIntegers(side);
    if (!value || value->size() != 1 || value->front() < smallest || value->front() > 1024)
      return failure(ErrorCode::badUsage, say<"--side '%1' cannot be used; give a whole number from %2 to 1024.">(side, smallest));
    sides.push_back(static_cast<int>(value->front()));
  }
  return sides;
}

Result<json> slicing(const BenchArguments& arguments, Run& run, Progress& progress) {
  BenchOptions options;
  options.sliceSide = arguments.sliceSide;
  options.poses = arguments.poses > 0 ? arguments.poses : options.poses;
  options.repetitions = arguments.repetitions > 0 ? arguments.repetitions : options.repetitions;
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
  options.repetitions = arguments.repetitions > 0 ? arguments.repetitions : options.repetitions;
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

/// The drawn ones among the shipped cases, or those that were named.
Result<std::vector<Case>> echoCases(const BenchArguments& arguments) {
  std::vector<Case> cases;
  for (const std::string& name : arguments.cases) {
    auto found = findCase(name);
    if (!found) return passOn(found.error());
    cases.push_back(std::move(*found));
  }
  if (!arguments.cases.empty()) return cases;
  const auto shipped = shippedCasesFolder();
  if (!shipped) return passOn(shipped.error());
  for (Case& each : listCases(*shipped).cases)
    if (!each.volume.recipe.empty() && each.volume.sweeps.empty()) cases.push_back(std::move(each));
  return cases;
}

Result<json> echoes(const BenchArguments& arguments, Run& run, Progress& progress) {
  auto cases = echoCases(arguments);
  if (!cases) return passOn(cases.error());
  EchoBenchOptions options;
  options.cases = std::move(*cases);
  options.poses = arguments.poses > 0 ? arguments.poses : options.poses;
  options.frames = arguments.timedFrames;
  options.width_px = arguments.frame_px.x;
  options.height_px = arguments.frame_px.y;
  options.seed = arguments.seed;
  json ids = json::array();
  for (const Case& each : options.cases) ids.push_back(each.id);
  run.report.options["echoes"] = {{"cases", std::move(ids)},
                                  {"poses", options.poses},
                                  {"frames", options.frames},
                                  {"size", {options.width_px, options.height_px}},
                                  {"seed", options.seed}};
  run.report.seed = options.seed;
  return benchEchoes(options, progress);
}

Result<json> reconstruction(const BenchArguments& arguments, Run& run, Progress& progress) {
  ReconstructBenchOptions options;
  options.frames = arguments.sweepFrames;
  options.imageSide = arguments.imageSide;
  options.views = arguments.views;
  options.repetitions = arguments.repetitions > 0 ? arguments.repetitions : options.repetitions;
  if (!arguments.spacings_mm.empty()) options.spacings_mm.clear();
  for (const auto& spacing : arguments.spacings_mm) {
    const auto value = parseNumber(spacing);
    if (!value) return failure(ErrorCode::badUsage, say<"--spacing '%1' is no number of mm; give one from 0.25 to 4.">(spacing));
    options.spacings_mm.push_back(*value);
  }
  run.report.options["reconstruct"] = {{"spacings_mm", options.spacings_mm},
                                       {"frames", options.frames},
                                       {"image_side", options.imageSide},
                                       {"views", options.views},
                                       {"repetitions", options.repetitions}};
  return benchReconstruct(options, progress);
}

Result<json> registering(const BenchArguments& arguments, Run& run, Progress& progress) {
  RegisterBenchOptions options;
  options.side = arguments.pairSide;
  options.repetitions = arguments.repetitions > 0 ? arguments.repetitions : options.repetitions;
  options.peers = !arguments.noPeers;
  options.seed = arguments.seed;
  run.report.options["register"] = {
      {"side", options.side}, {"repetitions", options.repetitions}, {"peers", options.peers}, {"seed", options.seed}};
  run.report.seed = options.seed;
  return benchRegister(options, progress);
}

Result<json> stitching(const BenchArguments& arguments, Run& run, Progress& progress) {
  StitchBenchOptions options;
  options.side = arguments.viewSide;
  options.repetitions = arguments.repetitions > 0 ? arguments.repetitions : options.repetitions;
  options.seed = arguments.seed;
  run.report.options["stitch"] = {{"side", options.side}, {"repetitions", options.repetitions}, {"seed", options.seed}};
  run.report.seed = options.seed;
  return benchStitch(options, progress);
}

Result<json> tracking(const BenchArguments& arguments, Run& run, Progress& progress) {
  run.report.options["tracking"] = {{"views", arguments.trackedViews}, {"frames", arguments.trackedFrames}};
  return benchTracking({arguments.trackedViews, arguments.trackedFrames}, progress);
}

constexpr const char* kPage = "accuracy-and-time.html";

Result<void> writePage(const BenchArguments& arguments, Run& run, const std::string& machine, std::vector<BenchSection> sections) {
  const std::filesystem::path folder(arguments.html);
  const std::vector<std::string> introduction = {
      "Medians of interleaved repetitions; what stands in one section comes from one run. Times of one thread are its processor time, so "
      "that "
      "other programs disturb them little; accuracy is measured against a field known exactly, so its ceiling is the rounding to 256 grey "
      "levels, and that of confidence against the shadows of a forward model. VTK's vtkImageReslice reads the same voxels in the same "
      "memory, "
      "on one thread, with its optimisation on. In the charts, up and to the left is better."};
  for (BenchSection& section : sections) {
    section.text += (section.text.empty() ? "" : " ") + ("Machine: " + machine + ".");
    if (simdInUse() != bestSimd()) section.title += ", kernels on " + simdInUse();  // beside the sections of the best
    if (!arguments.note.empty()) section.text += " " + arguments.note;
  }
  // What this run did not measure stays on the page.
  std::ostringstream before;
  if (std::ifstream old(folder / kPage, std::ios::binary); old) before << old.rdbuf();
  if (auto written = writeFileSafely(run.outputs.staged(folder / kPage),
                                     benchPage("EchoWeave: accuracy and time", introduction, sections, before.str()));
      !written)
    return written;
  run.say("Wrote " + (folder / kPage).string() + ".");
  return {};
}

enum class Bench { slicing, frame, echoes, reconstruct, registration, stitch, tracking, all };

Result<int> bench(Bench what, const BenchArguments& arguments, Run& run) {
  if (!arguments.html.empty()) {
    if (auto writable = run.outputs.announceFolder(arguments.html); !writable) return passOn(writable.error());
    // Before the first measurement: a page that comes to lie there meanwhile is somebody else's.
    if (auto announced = run.output(std::filesystem::path(arguments.html) / kPage); !announced) return passOn(announced.error());
  }
  if (!arguments.paper.empty())
    if (auto writable = run.outputs.announceFolder(arguments.paper); !writable) return passOn(writable.error());
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
  const auto wants = [what](Bench one) { return what == one || what == Bench::all; };
  const auto share = [&](double begin, double end) {
    return what == Bench::all ? PartOfProgress(run.progress, begin, end) : PartOfProgress(run.progress, 0.0, 1.0);
  };
  if (wants(Bench::frame)) {
    PartOfProgress part = share(0.0, 0.25);
    if (auto taken = take("frame", frame(arguments, run, part), frameSections); !taken) return passOn(taken.error());
  }
  if (wants(Bench::slicing)) {
    PartOfProgress part = share(0.25, 0.5);
    if (auto taken = take("slicing", slicing(arguments, run, part), slicingSections); !taken) return passOn(taken.error());
  }
  if (wants(Bench::reconstruct)) {
    PartOfProgress part = share(0.5, 0.7);
    if (auto taken = take("reconstruct", reconstruction(arguments, run, part), reconstructSections); !taken) return passOn(taken.error());
  }
  if (wants(Bench::registration)) {
    PartOfProgress part = share(0.7, 0.9);
    if (auto taken = take("register", registering(arguments, run, part), registerSections); !taken) return passOn(taken.error());
  }
  if (wants(Bench::registration) && !arguments.paper.empty()) {
    PartOfProgress part = share(0.9, 0.9);
    PaperBenchOptions options;
    options.seed = arguments.seed;
    const std::filesystem::path folder(arguments.paper);
    const auto place = [&](const std::string& name) -> Result<std::filesystem::path> {
      if (auto announced = run.output(folder / name); !announced) return passOn(announced.error());
      return run.outputs.staged(folder / name);
    };
    auto figures = benchPaper(options, place, part);
    if (!figures) return passOn(figures.error());
    for (auto& section : paperSections(*figures)) sections.push_back(std::move(section));
    run.report.quality["paper"] = *std::move(figures);
  }
  if (wants(Bench::echoes)) {
    PartOfProgress part = share(0.9, 0.95);
    if (auto taken = take("echoes", echoes(arguments, run, part), echoSections); !taken) return passOn(taken.error());
  }
  if (wants(Bench::stitch)) {
    PartOfProgress part = share(0.95, 1.0);
    if (auto taken = take("stitch", stitching(arguments, run, part), stitchSections); !taken) return passOn(taken.error());
  }
  if (what == Bench::tracking) {  // not part of all: it needs views
    PartOfProgress part = share(0.0, 1.0);
    if (auto taken = take("tracking", tracking(arguments, run, part), trackingSections); !taken) return passOn(taken.error());
  }
  if (!arguments.html.empty())
    if (auto written = writePage(arguments, run, machine, std::move(sections)); !written) return passOn(written.error());
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
    app.add_option("--html", arguments->html,
                   std::string("Also write ") + kPage + ", the curves of accuracy against time; what it held of other benchmarks stays")
        ->type_name("DIR");
    app.add_option("--note", arguments->note, "A sentence about the machine, for the page: what else it was doing")->type_name("TEXT");
    const bool slices = what != Bench::reconstruct && what != Bench::registration && what != Bench::stitch && what != Bench::echoes &&
                        what != Bench::tracking;
    const bool formsEchoes = what == Bench::echoes || what == Bench::all;
    if (slices)
      app.add_option("--side", arguments->sides, "Voxels a side of the volume; may be given several times (256 and 512)")
          ->type_name("COUNT");
    if (what == Bench::slicing || what == Bench::all) {
      addCount(app, "--size", arguments->sliceSide, 16, 4096, "Pixels a side of a slice (400)");
      app.add_flag("--large", arguments->large, "Also slices of a volume of 1024 cubed: 2.4 GiB of memory and some minutes");
    }
    if (what == Bench::frame || formsEchoes) addSize(app, "--frame", arguments->frame_px, "Pixels of a frame (1024x768)");
    if (slices) addCount(app, "--poses", arguments->poses, 2, 1000, "Poses of each kind (slices 40, frames 12, live echoes 3)");
    if (what == Bench::echoes) addCount(app, "--poses", arguments->poses, 1, 1000, "Poses of each case (3)");
    if (formsEchoes) {
      app.add_option("--case", arguments->cases,
                     "A drawn case whose live echoes are compared; may be given several times (every shipped one)")
          ->type_name("CASE");
      addCount(app, "--timed", arguments->timedFrames, 5, 10000, "Frames of live echoes timed for each quality and number of threads (40)");
    }
    if (what == Bench::reconstruct || what == Bench::all) {
      app.add_option("--spacing", arguments->spacings_mm, "Voxel size of reconstructions; may be given several times (0.5 and 1)")
          ->type_name("MM");
      addCount(app, "--sweep", arguments->sweepFrames, 6, 1000, "Frames of each sweep (60)");
      addCount(app, "--image", arguments->imageSide, 32, 1024, "Pixels a side of a sweep's frame, which shows 60 mm (240)");
      addCount(app, "--views", arguments->views, 1, 20, "Virtual frames of each probe for the confidence (2)");
    }
    if (what == Bench::registration || what == Bench::all) {
      addCount(app, what == Bench::all ? "--pair-side" : "--side", arguments->pairSide, 48, 256,
               "Voxels a side of a pair to register (96)");
      app.add_option("--paper", arguments->paper, "Write figures 6 to 8 of the 1998 paper, made from a virtual patient, to this folder")
          ->type_name("DIR");
    }
    if (what == Bench::stitch || what == Bench::all)
      addCount(app, what == Bench::all ? "--view-side" : "--side", arguments->viewSide, 64, 320, "Voxels a side of a view to join (128)");
    if (what == Bench::registration || what == Bench::stitch || formsEchoes)
      addSeed(app, "--seed", arguments->seed, "Which pairs are registered, which speckle is joined, which poses are compared (1)");
    if (what == Bench::tracking) {
      app.add_option("VIEWS", arguments->trackedViews, "A folder of pictures with views.json, which says where everything was")
          ->required()
          ->type_name("DIR");
      addCount(app, "--frames", arguments->trackedFrames, 0, 1000000, "Pictures at most; 0: all (0)");
    }
    if (what != Bench::echoes && what != Bench::tracking)
      addCount(app, "--repetitions", arguments->repetitions, 1, 1000,
               "Interleaved repetitions (slices and frames 7, reconstructions 5, registrations 1, joining 3)");
    if (what != Bench::reconstruct && what != Bench::stitch && what != Bench::echoes && what != Bench::tracking)
      app.add_flag("--no-peers", arguments->noPeers, "Leave VTK's reslice, elastix and plastimatch out");
  };
  add(Bench::slicing, "slicing", "Every slicer against an exact answer and against VTK's, one thread, medians of one run",
      {"bench slicing", "bench slicing --html bench --report bench.json", "bench slicing --side 256 --repetitions 3"});
  add(Bench::frame, "frame", "Whole frames with every effect alone and together, against exact answers and VTK's bare slice",
      {"bench frame", "bench frame --html bench --report bench.json", "bench frame --side 256 --frame 640x480 --repetitions 3"});
  add(Bench::echoes, "echoes", "Live echoes of every quality against the forward model of the same patients, and what their frames take",
      {"bench echoes", "bench echoes --poses 50 --timed 300 --html bench --report bench.json", "bench echoes --case neck-carotid-thyroid"});
  add(Bench::reconstruct, "reconstruct",
      "Every way from a sweep to a volume against an exact field, and confidence maps against known shadows",
      {"bench reconstruct", "bench reconstruct --html bench --report bench.json", "bench reconstruct --spacing 0.5 --repetitions 3"});
  add(Bench::registration, "register",
      "Every way of registering against pairs whose truth is known, beside elastix and plastimatch where they are installed",
      {"bench register", "bench register --html bench --report bench.json", "bench register --side 128 --no-peers"});
  add(Bench::stitch, "stitch", "Every way to join two views of one scene: how visible the seam is, and what it costs",
      {"bench stitch", "bench stitch --html bench --report bench.json", "bench stitch --side 96 --repetitions 5"});
  add(Bench::tracking, "tracking", "How exact a camera finds a probe with each of its settings, on views whose truth is known",
      {"bench tracking views", "bench tracking views --html bench --report bench.json"});
  addTeachingBenches(group, selection);
  addLibraryBench(group, selection);
  add(Bench::all, "all", "All of it, on one page", {"bench all --html bench --report bench.json"});
}

}  // namespace ew::cli
