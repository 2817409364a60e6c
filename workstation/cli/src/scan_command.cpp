#include <algorithm>
#include <chrono>
#include <ostream>

#include "arguments.h"
#include "command.h"
#include "contact_sheet.h"
#include "ew/core/numbers.h"
#include "ew/imaging/caption.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/latency.h"
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
  std::vector<std::string> offSkin;
  std::string output;
  std::string contactSheet;
  glm::ivec2 size_px{640, 480};
  int repeat = 0;
  int threads = 1;
  double rate_hz = 30.0;
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

/// What is scanned: a volume, or a case with what it says about probes, poses, effects and tissues.
struct Subject {
  std::optional<Case> opened;
  InputVolume volume;
  std::optional<Volume> labels;
  std::vector<std::string> probes;
  std::optional<Pose> startPose;
  Scene scene;
};

/// What a case's manifest says, before its volume is read (which may take long).
Result<Subject> nameSubject(const ScanArguments& arguments, Run& run) {
  Subject subject;
  if (meansCase(arguments.source)) {
    auto found = findCase(arguments.source);
    if (!found) return passOn(found.error());
    subject.opened = std::move(*found);
    if (auto kept = run.protect(subject.opened->folder / "case.json"); !kept) return passOn(kept.error());
    subject.probes = subject.opened->probes;
    subject.startPose = subject.opened->startPose;
    subject.scene = subject.opened->scene;
  } else if (auto kept = run.protect(arguments.source); !kept) {
    return passOn(kept.error());
  }
  if (!arguments.scene.empty()) {
    if (auto kept = run.input(arguments.scene); !kept) return passOn(kept.error());
    auto read = readScene(arguments.scene);
    if (!read) return passOn(read.error());
    subject.scene = std::move(*read);
  }
  return subject;
}

Result<void> readSubject(const ScanArguments& arguments, Run& run, Subject& subject) {
  if (!subject.opened) {
    auto volume = openInputVolume(run, arguments.source, arguments.map);
    if (!volume) return passOn(volume.error());
    subject.volume = std::move(*volume);
    return {};
  }
  auto echo = readCaseEcho(run, *subject.opened);
  if (!echo) return passOn(echo.error());
  subject.volume.volume = std::move(echo->volume);
  subject.labels = std::move(echo->labels);
  subject.scene = sceneWithTissues(subject.scene, echo->tissues);
  return {};
}

Result<std::vector<Pose>> posesFor(const ScanArguments& arguments, const Subject& subject, Run& run) {
  if (!arguments.pose.empty()) return readPoses(run, arguments.pose);
  if (subject.startPose) return std::vector<Pose>{*subject.startPose};
  return failure(ErrorCode::badUsage, subject.opened ? "The case has no start pose; say where the probe is with --pose."
                                                     : "Say where the probe is with --pose: 16 numbers, or a file with one pose a line.");
}

/// Gaps between skin and face at evenly spread points of the face; empty when everything touches.
/// @param parts "FROM:TO", each from -1 (the face's -x end) to 1
Result<std::vector<float>> gapsOf(const std::vector<std::string>& parts) {
  constexpr int kPoints = 129;
  constexpr float kPressed_mm = -1.0F, kAir_mm = 1000.0F;
  std::vector<float> gaps_mm;
  if (parts.empty()) return gaps_mm;
  gaps_mm.assign(kPoints, kPressed_mm);
  for (const std::string& part : parts) {
    const auto colon = part.find(':');
    const auto from = parseNumber(std::string_view(part).substr(0, colon));
    const auto to = colon == std::string::npos ? std::nullopt : parseNumber(std::string_view(part).substr(colon + 1));
    if (!from || !to || !(*from >= -1.0 && *from <= *to && *to <= 1.0))
      return failure(ErrorCode::badUsage, "--off-skin is '" + part +
                                              "', expected are two numbers from -1 (the face's -x end) to 1 (its +x end), the smaller "
                                              "one first, such as 0.5:1.");
    for (int n = 0; n < kPoints; ++n) {
      const double position = 2.0 * n / (kPoints - 1) - 1.0;
      if (position >= *from && position <= *to) gaps_mm[static_cast<std::size_t>(n)] = kAir_mm;
    }
  }
  return gaps_mm;
}

/// Frames of one subject, one after another on one clock.
class Scanner {
 public:
  Scanner(const ScanArguments& arguments, const Subject& subject, std::vector<float> gaps_mm, Run& run)
      : subject_(subject), gaps_mm_(std::move(gaps_mm)), rate_hz_(arguments.rate_hz), run_(run), maker(arguments.threads) {}

  ImageView<const std::uint8_t> make(const Pose& pose, bool isTimed = true) {
    FrameInput input;
    input.echo = subject_.volume.view();
    if (subject_.labels) input.labels = subject_.labels->view();
    input.pose = pose;
    input.gaps_mm = gaps_mm_;
    input.time_s = static_cast<double>(frames_) / rate_hz_;
    input.number = frames_++;
    const auto start = std::chrono::steady_clock::now();
    const auto frame = maker.make(input);
    const double took_us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    if (isTimed) {
      run_.report.addStep("frame", took_us);
      latency.add(took_us);
    }
    for (const auto& time : maker.lastTimes()) run_.report.addStep(nameOf(time.kind), time.measured_us);
    return frame;
  }

 private:
  const Subject& subject_;
  std::vector<float> gaps_mm_;
  double rate_hz_;
  Run& run_;
  std::uint64_t frames_ = 0;

 public:
  FrameMaker maker;
  LatencyHistogram latency;
};

bool isLit(ImageView<const std::uint8_t> frame) {
  for (int y = 0; y < frame.height; ++y)
    if (std::any_of(frame.row(y), frame.row(y) + frame.width, [](auto v) { return v > 0; })) return true;
  return false;
}

Result<void> write(Run& run, const std::filesystem::path& file, ImageView<const std::uint8_t> frame, double pixel_mm) {
  const StepClock clock(run.report, "write");
  GreyImage picture(frame.width, frame.height);
  for (int y = 0; y < frame.height; ++y) std::copy(frame.row(y), frame.row(y) + frame.width, viewOf(picture).row(y));
  if (file.extension() != ".mha") burnCaption(viewOf(picture), kNotForDiagnosis);
  return writeImage(viewOf(std::as_const(picture)), pixel_mm, run.outputs.staged(file));
}

void printPlan(std::ostream& out, const FrameMaker& maker, const Report& report) {
  const auto& geometry = maker.geometry();
  out << "Plan for " << geometry.width << " x " << geometry.height << " pixels of " << rounded(geometry.pixel_mm, 3) << " mm, depth "
      << rounded(geometry.depth_mm, 0) << " mm, sampled on " << (maker.plan().onBeams ? "beams" : "the display's pixels") << ":\n";
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

Result<void> checkContactSheet(const ScanArguments& arguments, Run& run) {
  constexpr glm::ivec2 kSmallest_px{160, 120}, kLargest_px{1024, 768};
  if (!arguments.output.empty() || arguments.repeat > 0 || arguments.plan)
    return failure(ErrorCode::badUsage, "--contact-sheet makes a picture of its own; give it without -o, --repeat and --plan.");
  const glm::ivec2& size_px = arguments.size_px;
  if (glm::any(glm::lessThan(size_px, kSmallest_px)) || glm::any(glm::greaterThan(size_px, kLargest_px)))
    return failure(ErrorCode::badUsage, "The tiles of a contact sheet are from 160x120 to 1024x768 pixels large; give --size 320x240.");
  return run.output(arguments.contactSheet, ".png");
}

Result<int> makeContactSheet(const ScanArguments& arguments, const Subject& subject, const Probe& probe, const std::vector<Pose>& poses,
                             Run& run) {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  auto probes = readProbes(*resources / "probes");
  if (!probes) return passOn(probes.error());
  SheetSource source{.echo = subject.volume.view(),
                     .labels = {},
                     .scene = subject.scene,
                     .probe = probe,
                     .probes = std::move(*probes),
                     .pose = poses.front(),
                     .interfacePose = poses.back()};
  if (subject.labels) source.labels = subject.labels->view();
  run.progress.report("Making the contact sheet", kShareOfReading);
  const GreyImage sheet = contactSheet(source, arguments.size_px);
  if (auto written = writeImage(viewOf(sheet), 1.0, run.outputs.staged(arguments.contactSheet)); !written) return passOn(written.error());
  run.say("Wrote a contact sheet of " + std::to_string(sheet.width) + " x " + std::to_string(sheet.height) + " pixels.");
  return kDone;
}

Result<int> scan(const ScanArguments& arguments, Run& run) {
  const bool isSheet = !arguments.contactSheet.empty();
  if (isSheet)
    if (auto usable = checkContactSheet(arguments, run); !usable) return passOn(usable.error());
  const bool writes = arguments.repeat == 0 && !arguments.output.empty();
  if (!writes && arguments.repeat == 0 && !arguments.plan && !isSheet)
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
    if (auto kept = run.input(arguments.knobs); !kept) return passOn(kept.error());
    auto read = readKnobs(arguments.knobs);
    if (!read) return passOn(read.error());
    knobs = *read;
  }
  auto subject = nameSubject(arguments, run);
  if (!subject) return passOn(subject.error());
  if (std::filesystem::path(arguments.probe).extension() == ".json")
    if (auto kept = run.protect(arguments.probe); !kept) return passOn(kept.error());
  const auto probe = findProbe(arguments.probe, subject->probes);
  if (!probe) return passOn(probe.error());
  if (auto fits = checkDepth(knobs, *probe); !fits) return passOn(fits.error());
  const auto poses = posesFor(arguments, *subject, run);
  if (!poses) return passOn(poses.error());
  auto gaps_mm = gapsOf(arguments.offSkin);
  if (!gaps_mm) return passOn(gaps_mm.error());
  if (!gaps_mm->empty() && !subject->scene.contact)
    run.remark("Nothing shows that a part of the face is off the skin, because the scene has no contact effect; give one with --scene.");

  const bool writesStrip = knobs.mode == DisplayMode::mMode;
  const std::size_t outputs = writesStrip ? 1 : poses->size();
  if (writes)
    for (std::size_t n = 0; n < outputs; ++n)
      if (auto announced = run.output(numbered(arguments.output, n, outputs), ".png .mha"); !announced) return passOn(announced.error());
  if (auto read = readSubject(arguments, run, *subject); !read) return passOn(read.error());
  if (isSheet) return makeContactSheet(arguments, *subject, *probe, *poses, run);

  run.report.options = {{"probe", probe->id},
                        {"pose", arguments.pose},
                        {"poses", poses->size()},
                        {"knobs", toJson(knobs)},
                        {"scene", toJson(subject->scene)},
                        {"size", {arguments.size_px.x, arguments.size_px.y}},
                        {"repeat", arguments.repeat},
                        {"threads", arguments.threads},
                        {"rate_hz", arguments.rate_hz},
                        {"off_skin", arguments.offSkin},
                        {"mapped", subject->volume.mapped.has_value()}};
  Scanner scanner(arguments, *subject, std::move(*gaps_mm), run);
  const FrameMaker& maker = scanner.maker;
  {
    const StepClock clock(run.report, "configure");
    scanner.maker.configure(*probe, knobs, subject->scene, subject->volume.grid(), arguments.size_px.x, arguments.size_px.y,
                            subject->labels.has_value());
  }
  run.report.options["pixel_mm"] = maker.geometry().pixel_mm;
  run.report.options["depth_mm"] = maker.geometry().depth_mm;
  const int rounds = std::max(1, arguments.repeat);
  const double total = static_cast<double>(rounds) * static_cast<double>(poses->size());
  double done = 0.0;
  std::size_t litPictures = 0;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t n = 0; n < poses->size(); ++n) {
      if (run.progress.cancelRequested()) return failure(ErrorCode::cancelled, "Stopped as asked; nothing was written.");
      if (auto whole = subject->volume.unchanged(); !whole) return passOn(whole.error());
      const auto frame = scanner.make((*poses)[n]);
      if (round == 0) {
        if (isLit(frame))
          ++litPictures;
        else
          run.remark("The picture of pose " + std::to_string(n + 1) + " is black; the probe looks past the volume or the gain is 0.");
      }
      if (writes && !writesStrip)
        if (auto written = write(run, numbered(arguments.output, n, outputs), frame, maker.geometry().pixel_mm); !written)
          return passOn(written.error());
      run.progress.report("Scanning", kShareOfReading + (1.0 - kShareOfReading) * ++done / total);
    }
  if (writes && writesStrip)
    if (auto written = write(run, numbered(arguments.output, 0, 1), maker.strip(), maker.geometry().pixel_mm); !written)
      return passOn(written.error());
  run.report.quality = {{"pictures_not_black", litPictures},
                        {"pose_to_picture_p50_us", scanner.latency.quantile_us(0.5)},
                        {"pose_to_picture_p95_us", scanner.latency.quantile_us(0.95)},
                        {"pose_to_picture_p99_us", scanner.latency.quantile_us(0.99)},
                        {"pose_to_picture_max_us", scanner.latency.max_us()},
                        {"pose_to_picture_count", scanner.latency.count()}};
  if (arguments.plan && arguments.repeat == 0)
    for (int n = 0; n < kWarmFrames; ++n) scanner.make(poses->front(), false);
  run.report.details["plan"] = nlohmann::json::array();
  for (const auto& step : maker.plan().steps)
    run.report.details["plan"].push_back(
        {{"name", nameOf(step.kind)}, {"estimated_us", step.estimated_us}, {"measured_us", run.report.median_us(nameOf(step.kind))}});
  run.report.details["on_beams"] = maker.plan().onBeams;
  run.progress.clear();
  if (arguments.plan) printPlan(run.out(), maker, run.report);
  if (writes)
    run.say(writesStrip ? "Wrote the strip of " + counted(poses->size(), "beam") + ", probe " + probe->name + "."
                        : "Wrote " + counted(poses->size(), "scan") + ", probe " + probe->name + ".");
  if (arguments.repeat > 0) run.say("Median " + rounded(run.report.median_us("frame"), 0) + " us a frame.");
  return kDone;
}

}  // namespace

void addScan(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<ScanArguments>();
  auto& app = addCommand(root, selection, "scan", "Scan a volume or a case with a probe, as the window shows it",
                         {"scan upper-abdomen-gall-stone -o scan.png --plan",
                          "scan liver.mha --probe convex-3.5 --pose poses.txt --knobs knobs.json --size 800x600 -o scan.png",
                          "scan liver.mha --probe linear-7.5 --pose poses.txt --repeat 100 --report times.json",
                          "scan upper-abdomen-gall-stone --size 320x240 --contact-sheet effects.png"},
                         [arguments](Run& run) { return scan(*arguments, run); });
  app.footer(app.get_footer() +
             "\n\nKNOBS.json is one object; what is missing stays neutral:\n"
             "  { \"gain\": 1.2, \"dgc\": [1, 1, 1, 1, 1.2, 1.4, 1.6, 1.8], \"depth_mm\": 160, \"focus_mm\": [60, 100] }\n" +
             knobsManual() +
             "With \"mode\": \"m\" the output is the strip of one beam over the poses, which are 1/30 s apart (--rate).\n"
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
  app.add_option("--scene", arguments->scene, "Which effects the scene calls for (the case's, or none)")->type_name("SCENE.json");
  addSize(app, "--size", arguments->size_px, "Pixels of the picture (640x480)");
  app.add_option("-o,--output", arguments->output,
                 "The picture: .png, which carries 'simulation, not for diagnosis', or .mha, the bare frame")
      ->type_name("OUT");
  app.add_option("--contact-sheet", arguments->contactSheet,
                 "One picture of many tiles of --size: every effect off and on, then every probe, at the first pose; reverberation at the "
                 "last")
      ->type_name("OUT.png");
  app.add_flag("--plan", arguments->plan, "Print what a frame runs, with estimated and measured microseconds");
  app.add_flag("--map", arguments->map,
               "Leave an uncompressed volume in its file and read it by the page, as files from 1 GiB on always are");
  app.add_option("--off-skin", arguments->offSkin,
                 "A part of the face off the skin, from -1 (its -x end) to 1; may be given several times. Acts when the scene has contact")
      ->allow_extra_args(false)
      ->type_name("FROM:TO");
  addNumber(app, "--rate", arguments->rate_hz, {0.1, 1000.0}, "Poses a second, for M-mode (30)");
  addCount(app, "--threads", arguments->threads, 0, 256, "Threads of one frame; 0: all cores; the picture does not depend on it (1)");
  addCount(app, "--repeat", arguments->repeat, 1, 1000000, "Run the whole list N times and write nothing but the report");
}

}  // namespace ew::cli
