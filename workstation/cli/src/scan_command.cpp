#include <algorithm>
#include <ostream>

#include "arguments.h"
#include "caption.h"
#include "command.h"
#include "ew/core/numbers.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/settings_json.h"
#include "ew/io/image_file.h"
#include "knobs_file.h"
#include "volume_input.h"

namespace ew::cli {
namespace {

struct ScanArguments {
  std::string source;
  std::string probe;
  std::string pose;
  std::string knobs;
  std::string scene;
  std::string output;
  glm::ivec2 size_px{640, 480};
  int repeat = 0;
  bool plan = false;
  bool map = false;
};

/// A probe by the name of its file, by its id, or by the name it is shown with; empty: the first the case allows.
Result<Probe> findProbe(const std::string& wanted, const std::vector<std::string>& allowed) {
  if (std::filesystem::path(wanted).extension() == ".json") return readProbe(wanted);
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  const auto probes = readProbes(*resources / "probes");
  if (!probes) return passOn(probes.error());
  const std::string name = wanted.empty() && !allowed.empty() ? allowed.front() : wanted;
  std::string ids;
  for (const auto& probe : *probes) {
    if (!name.empty() && (probe.id == name || probe.name == name)) {
      if (!allowed.empty() && std::find(allowed.begin(), allowed.end(), probe.id) == allowed.end())
        return failure(ErrorCode::badUsage, "The case does not allow the probe '" + probe.id + "'; choose one of its own with --probe.");
      return probe;
    }
    ids += (ids.empty() ? "" : ", ") + probe.id;
  }
  if (name.empty()) return failure(ErrorCode::badUsage, "Say which probe scans with --probe; there are " + ids + ".");
  return failure(ErrorCode::badUsage, "There is no probe '" + name + "'; there are " + ids + ", or give a probe's .json file.");
}

/// Frames made only to be timed: the first frame of a program meets cold memory and says little.
constexpr int kWarmFrames = 15;

struct Source {
  Volume volume;
  std::vector<std::string> probes;
  std::optional<Pose> startPose;
  Scene scene;
};

void printPlan(std::ostream& out, const FrameMaker& maker, const Report& report) {
  const auto& geometry = maker.geometry();
  out << "Plan for " << geometry.width << " x " << geometry.height << " pixels of " << rounded(geometry.pixel_mm, 3) << " mm, depth "
      << rounded(geometry.depth_mm, 0) << " mm:\n";
  double estimated_us = 0.0, measured_us = 0.0;
  const auto line = [&](std::string name, double estimate_us, double measure_us) {
    std::string estimate = rounded(estimate_us, 0), measure = rounded(measure_us, 0);
    name.resize(std::max<std::size_t>(name.size(), 16), ' ');
    estimate.insert(0, 8 - std::min<std::size_t>(8, estimate.size()), ' ');
    measure.insert(0, 8 - std::min<std::size_t>(8, measure.size()), ' ');
    out << "  " << name << estimate << " us estimated" << measure << " us measured\n";
  };
  for (const auto& step : maker.plan().steps) {
    const double median = report.median_us(nameOf(step.kind));
    line(nameOf(step.kind), step.estimated_us, median);
    estimated_us += step.estimated_us;
    measured_us += median;
  }
  line("whole frame", estimated_us, measured_us);
}

Result<int> scan(const ScanArguments& arguments, Run& run) {
  const bool writes = arguments.repeat == 0 && !arguments.output.empty();
  if (!writes && arguments.repeat == 0 && !arguments.plan)
    return failure(ErrorCode::badUsage,
                   "Say where the picture goes with -o OUT.png, look at the plan with --plan, or measure with --repeat N.");
  if (writes && std::filesystem::path(arguments.output).extension() != ".mha" &&
      (arguments.size_px.x < kCaptionMinWidth_px || arguments.size_px.y < kCaptionMinHeight_px))
    return failure(ErrorCode::badUsage,
                   "A picture of " + std::to_string(arguments.size_px.x) + " x " + std::to_string(arguments.size_px.y) +
                       " pixels is too small for the words it must carry; give at least " + std::to_string(kCaptionMinWidth_px) + "x" +
                       std::to_string(kCaptionMinHeight_px) + ", or write .mha.");
  Knobs knobs;
  if (!arguments.knobs.empty()) {
    run.input(arguments.knobs);
    auto read = readKnobs(arguments.knobs);
    if (!read) return passOn(read.error());
    knobs = *read;
  }
  Source source;
  std::optional<Case> opened;
  if (meansCase(arguments.source)) {
    auto found = findCase(arguments.source);
    if (!found) return passOn(found.error());
    opened = std::move(*found);
    source.probes = opened->probes;
    source.startPose = opened->startPose;
    source.scene = opened->scene;
  } else {
    run.outputs.protect(arguments.source);
  }
  if (!arguments.scene.empty()) {
    run.input(arguments.scene);
    const auto read = readScene(arguments.scene);
    if (!read) return passOn(read.error());
    source.scene = *read;
  }
  const auto probe = findProbe(arguments.probe, source.probes);
  if (!probe) return passOn(probe.error());
  if (auto fits = checkDepth(knobs, *probe); !fits) return passOn(fits.error());

  std::vector<Pose> poses;
  if (!arguments.pose.empty()) {
    auto given = posesOf(arguments.pose);
    if (!given) return passOn(given.error());
    poses = std::move(*given);
  } else if (source.startPose) {
    poses.push_back(*source.startPose);
  } else {
    return failure(ErrorCode::badUsage, opened ? "The case has no start pose; say where the probe is with --pose."
                                               : "Say where the probe is with --pose: 16 numbers, or a file with one pose a line.");
  }
  if (writes)
    for (std::size_t n = 0; n < poses.size(); ++n)
      if (auto announced = run.output(numbered(arguments.output, n, poses.size()), ".png .mha"); !announced)
        return passOn(announced.error());

  auto volume = [&]() -> Result<InputVolume> {
    if (!opened) return openInputVolume(run, arguments.source, arguments.map);
    auto read = readCaseVolume(run, *opened);
    if (!read) return passOn(read.error());
    return InputVolume{std::move(*read), std::nullopt};
  }();
  if (!volume) return passOn(volume.error());

  run.report.options = {{"probe", probe->id},
                        {"pose", arguments.pose},
                        {"poses", poses.size()},
                        {"knobs", toJson(knobs)},
                        {"scene", toJson(source.scene)},
                        {"size", {arguments.size_px.x, arguments.size_px.y}},
                        {"repeat", arguments.repeat},
                        {"mapped", volume->mapped.has_value()}};
  FrameMaker maker;
  {
    const StepClock clock(run.report, "configure");
    maker.configure(*probe, knobs, source.scene, volume->grid(), arguments.size_px.x, arguments.size_px.y);
  }
  run.report.options["pixel_mm"] = maker.geometry().pixel_mm;
  run.report.options["depth_mm"] = maker.geometry().depth_mm;
  const int rounds = std::max(1, arguments.repeat);
  const double total = static_cast<double>(rounds) * static_cast<double>(poses.size());
  double done = 0.0;
  std::size_t litPictures = 0;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t n = 0; n < poses.size(); ++n) {
      if (run.progress.cancelRequested()) return failure(ErrorCode::cancelled, "Stopped as asked; nothing was written.");
      if (auto whole = volume->unchanged(); !whole) return passOn(whole.error());
      ImageView<const std::uint8_t> frame;
      {
        const StepClock clock(run.report, "frame");
        frame = maker.make(volume->view(), poses[n]);
      }
      for (const auto& time : maker.lastTimes()) run.report.addStep(nameOf(time.kind), time.measured_us);
      if (round == 0) {
        bool lit = false;
        for (int y = 0; y < frame.height && !lit; ++y)
          lit = std::any_of(frame.row(y), frame.row(y) + frame.width, [](auto v) { return v > 0; });
        litPictures += lit ? 1u : 0u;
        if (!lit)
          run.remark("The picture of pose " + std::to_string(n + 1) + " is black; the probe looks past the volume or the gain is 0.");
      }
      if (writes) {
        const StepClock clock(run.report, "write");
        const auto file = numbered(arguments.output, n, poses.size());
        GreyImage picture(frame.width, frame.height);
        for (int y = 0; y < frame.height; ++y) std::copy(frame.row(y), frame.row(y) + frame.width, viewOf(picture).row(y));
        if (file.extension() != ".mha") burnCaption(viewOf(picture), kNotForDiagnosis);
        auto written = writeImage(viewOf(std::as_const(picture)), maker.geometry().pixel_mm, run.outputs.staged(file));
        if (!written) return passOn(written.error());
      }
      run.progress.report("Scanning", kShareOfReading + (1.0 - kShareOfReading) * ++done / total);
    }
  if (arguments.plan && arguments.repeat == 0)
    for (int n = 0; n < kWarmFrames; ++n) {
      maker.make(volume->view(), poses.front());
      for (const auto& time : maker.lastTimes()) run.report.addStep(nameOf(time.kind), time.measured_us);
    }
  run.report.quality = {{"pictures_not_black", litPictures}};
  run.report.details["plan"] = nlohmann::json::array();
  for (const auto& step : maker.plan().steps)
    run.report.details["plan"].push_back({{"name", nameOf(step.kind)}, {"estimated_us", step.estimated_us}});
  run.progress.clear();
  if (arguments.plan) printPlan(run.out(), maker, run.report);
  if (writes) run.say("Wrote " + counted(poses.size(), "scan") + ", probe " + probe->name + ".");
  if (arguments.repeat > 0) run.say("Median " + rounded(run.report.median_us("frame"), 0) + " us a frame.");
  return kDone;
}

}  // namespace

void addScan(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<ScanArguments>();
  auto& app = addCommand(root, selection, "scan", "Scan a volume or a case with a probe, as the window shows it",
                         {"scan upper-abdomen-gall-stone -o scan.png --plan",
                          "scan liver.mha --probe convex-3.5 --pose poses.txt --knobs knobs.json --size 800x600 -o scan.png",
                          "scan liver.mha --probe linear-7.5 --pose poses.txt --repeat 100 --report times.json"},
                         [arguments](Run& run) { return scan(*arguments, run); });
  app.footer(app.get_footer() +
             "\n\nKNOBS.json is one object; what is missing stays neutral:\n"
             "  { \"gain\": 1.2, \"dgc\": [1, 1, 1, 1, 1.2, 1.4, 1.6, 1.8], \"depth_mm\": 160, \"focus_mm\": [60, 100] }\n" +
             knobsManual() +
             "SCENE.json is one object; an effect that is missing does not run:\n"
             "  { \"focus\": true, \"attenuation\": { \"expected_db_per_cm_mhz\": 0.5 } }\n" +
             sceneManual());
  app.add_option("SOURCE", arguments->source,
                 "A volume (.mha, .mhd, .nrrd, .nii, .nii.gz), a case folder, a case.json, or a shipped case's id")
      ->required()
      ->type_name("");
  app.add_option("--probe", arguments->probe, "A probe's id or name, or a probe's .json file (a case: its first probe)")->type_name("NAME");
  app.add_option(
         "--pose", arguments->pose,
         "16 numbers, row by row, from probe to world in mm (LPS), or a file with one pose a line (a case: its start pose). Several "
         "poses number their outputs: out_0000.png …")
      ->type_name("POSE");
  app.add_option("--knobs", arguments->knobs, "Settings of the console (neutral)")->type_name("KNOBS.json");
  app.add_option("--scene", arguments->scene, "What the scene calls for (the case's, or everything)")->type_name("SCENE.json");
  addSize(app, "--size", arguments->size_px, "Pixels of the picture (640x480)");
  app.add_option("-o,--output", arguments->output,
                 "The picture: .png, which carries 'simulation, not for diagnosis', or .mha, the bare frame")
      ->type_name("OUT");
  app.add_flag("--plan", arguments->plan, "Print what a frame runs, with estimated and measured microseconds");
  app.add_flag("--map", arguments->map,
               "Leave an uncompressed volume in its file and read it by the page, as files from 1 GiB on always are");
  addCount(app, "--repeat", arguments->repeat, 1, 1000000, "Run the whole list N times and write nothing but the report");
}

}  // namespace ew::cli
