#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>
#include <variant>

#include "commands/contact_sheet.h"
#include "ew/core/ending.h"
#include "ew/core/numbers.h"
#include "ew/export/dicom_image.h"
#include "ew/imaging/doppler_sound.h"
#include "ew/imaging/latency.h"
#include "ew/imaging/settings_json.h"
#include "ew/io/sound_file.h"
#include "ew/library/case_start.h"
#include "ew/scanning/display_image_file.h"
#include "ew/scanning/first_image.h"
#include "ew/scanning/preset.h"
#include "ew/scanning/scanner.h"
#include "run/arguments.h"
#include "run/command.h"
#include "run/knobs_file.h"
#include "run/volume_input.h"

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
  std::string sound;
  std::optional<double> seconds;
  glm::ivec2 size_px{640, 480};
  int repeat = 0;
  int threads = 1;
  double rate_hz = 30.0;
  std::vector<double> times_s;
  std::optional<double> breath;
  std::optional<double> pulse;
  bool plan = false;
  bool map = false;
};

/// A probe by the name of its file, by its id, or by the name it is shown with; empty: the first the case allows.
Result<Probe> findProbe(const std::string& wanted, const std::vector<std::string>& allowed) {
  if (hasEnding(wanted, ".json")) return readProbe(wanted);
  const auto probes = shippedProbes();
  if (!probes) return passOn(probes.error());
  const std::string name = wanted.empty() && !allowed.empty() ? allowed.front() : wanted;
  std::string ids;
  for (const auto& probe : *probes) {
    if (!name.empty() && (probe.id == name || probe.name == name)) {
      if (!allowed.empty() && std::find(allowed.begin(), allowed.end(), probe.id) == allowed.end())
        return failure(ErrorCode::badUsage, say<"The case does not allow the probe '%1'; choose one of its own with --probe.">(probe.id));
      return probe;
    }
    ids += (ids.empty() ? "" : ", ") + probe.id;
  }
  if (name.empty()) return failure(ErrorCode::badUsage, say<"Say which probe scans with --probe; there are %1.">(ids));
  return failure(ErrorCode::badUsage, say<"There is no probe '%1'; there are %2, or give a probe's .json file.">(name, ids));
}

/// Frames made only to be timed: the first frame of a program meets cold memory and says little.
constexpr int kWarmFrames = 15;
constexpr int kSound_hz = 48000;

/// What is to be scanned, as far as it is known before voxels are read (which may take long).
struct Wanted {
  std::optional<Case> opened;  ///< empty: a volume that belongs to no case
  std::optional<Scene> scene;  ///< in place of the case's
};

Result<Wanted> readWanted(const ScanArguments& arguments, Run& run) {
  Wanted wanted;
  if (meansCase(arguments.source)) {
    auto found = findCase(arguments.source);
    if (!found) return passOn(found.error());
    wanted.opened = std::move(*found);
    if (auto kept = run.protect(wanted.opened->folder / "case.json"); !kept) return passOn(kept.error());
  } else if (auto kept = run.protect(arguments.source); !kept) {
    return passOn(kept.error());
  }
  if (!arguments.scene.empty()) {
    if (auto kept = run.input(arguments.scene); !kept) return passOn(kept.error());
    auto read = readScene(arguments.scene);
    if (!read) return passOn(read.error());
    wanted.scene = std::move(*read);
    if (wanted.opened) wanted.opened->scene = *wanted.scene;
  }
  return wanted;
}

/// Whether every image that is made is known, of a body at rest: then no more of a case need be made than they show.
bool showsLittle(const ScanArguments& arguments) {
  return arguments.contactSheet.empty() && arguments.times_s.empty() && !arguments.breath && !arguments.pulse;
}

Result<ScanSubject> readSubject(const ScanArguments& arguments, const Wanted& wanted, const StillImages& images, Run& run) {
  if (wanted.opened) {
    auto contents = showsLittle(arguments) ? readCaseContentsFor(run, *wanted.opened, images) : readCaseContents(run, *wanted.opened);
    if (!contents) return passOn(contents.error());
    ScanSubject subject = subjectOf(*wanted.opened, *contents);
    if (auto formed = formEchoes(run, subject, wanted.opened->scene); !formed) return passOn(formed.error());
    return subject;
  }
  auto voxels = openInputVoxels(run, arguments.source, arguments.map);
  if (voxels && voxels->volume()) voxels = ScanVoxels::of(voxels->volume(), run.progress);
  if (!voxels) return passOn(voxels.error());
  ScanSubject subject = subjectOf(std::move(*voxels), arguments.source);
  if (!wanted.scene) return subject;
  subject.scene = *wanted.scene;
  if (auto formed = formEchoes(run, subject, *wanted.scene); !formed) return passOn(formed.error());
  return subject;
}

Result<std::vector<Pose>> posesFor(const ScanArguments& arguments, const Wanted& wanted, Run& run) {
  if (!arguments.pose.empty()) return readPoses(run, arguments.pose);
  if (wanted.opened && wanted.opened->startPose) return std::vector<Pose>{*wanted.opened->startPose};
  return failure(ErrorCode::badUsage, wanted.opened
                                          ? say<"The case has no start pose; say where the probe is with --pose.">()
                                          : say<"Say where the probe is with --pose: 16 numbers, or a file with one pose a line.">());
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
      return failure(ErrorCode::badUsage, say<"--off-skin is '%1', expected are two numbers from -1 (the face's -x end) to 1 (its +x end), "
                                              "the smaller one first, such as 0.5:1.">(part));
    for (int n = 0; n < kPoints; ++n) {
      const double position = 2.0 * n / (kPoints - 1) - 1.0;
      if (position >= *from && position <= *to) gaps_mm[static_cast<std::size_t>(n)] = kAir_mm;
    }
  }
  return gaps_mm;
}

/// Images of one subject, one after another on one clock, each timed.
class ScanTimer {
 public:
  ScanTimer(const ScanArguments& arguments, ScanSubject subject, ScanState state, Run& run)
      : scanner(arguments.threads),
        state_(std::move(state)),
        size_px_(arguments.size_px),
        rate_hz_(arguments.rate_hz),
        times_s_(arguments.times_s),
        breath_(arguments.breath),
        pulse_(arguments.pulse),
        motion_(subject.motion),
        run_(run) {
    scanner.show(std::move(subject));
    const StepClock clock(run_.report, "configure");
    scanner.prepare(state_, size_px_.x, size_px_.y);
  }

  DisplayImage make(const Pose& pose, bool isTimed = true) {
    state_.pose = pose;
    setTime();
    const auto start = std::chrono::steady_clock::now();
    const auto image = scanner.make(state_, size_px_.x, size_px_.y);
    const double took_us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    ++state_.number;
    if (isTimed) {
      run_.report.addStep("frame", took_us);
      latency.add(took_us);
    }
    for (const auto& time : scanner.lastTimes()) run_.report.addStep(nameOf(time.kind), time.measured_us);
    if (listens_) hear();
    return image;
  }
  /// From now on what the sample volume gives is kept as sound.
  void listen() {
    const Knobs& knobs = state_.knobs;
    const SpectralGate gate = spectralGateOf(state_.probe, knobs);
    listens_.emplace();
    listens_->configure(gate.prf_hz, knobs.spectral->baseline, kSound_hz);
  }
  [[nodiscard]] const std::vector<glm::vec2>& sound() const { return sound_; }

  Scanner scanner;
  LatencyHistogram latency;

 private:
  void hear() {
    const auto due = listens_->add(scanner.dopplerSamples());
    sound_.insert(sound_.end(), due.begin(), due.end());
  }

  /// Of body and blood. Of several times each image has its own, again from the first when there are no more; the beams of a strip stay
  /// 1 / rate apart. The body is at rest unless times or phases are asked for.
  void setTime() {
    double time_s = static_cast<double>(state_.number) / rate_hz_;
    if (times_s_.size() == 1) time_s += times_s_.front();
    state_.time_s = time_s;
    if (times_s_.size() > 1) time_s = times_s_[state_.number % times_s_.size()];
    if (state_.knobs.mode != DisplayMode::mMode) state_.time_s = time_s;
    if (!motion_) return;
    state_.body = times_s_.empty() ? BodyState{} : bodyAt(motion_->rhythms, time_s);
    if (breath_) state_.body.breath = *breath_;
    if (pulse_) state_.body.pulse = *pulse_;
  }

  ScanState state_;
  glm::ivec2 size_px_;
  double rate_hz_;
  std::vector<double> times_s_;
  std::optional<double> breath_, pulse_;
  std::shared_ptr<const TissueMotion> motion_;
  std::optional<DopplerSound> listens_;
  std::vector<glm::vec2> sound_;
  Run& run_;
};

/// Brought to nine tenths of full at its loudest.
std::vector<glm::vec2> asLoudAsFits(std::vector<glm::vec2> sound) {
  float loudest = 0.0F;
  for (const glm::vec2& both : sound) loudest = std::max({loudest, std::abs(both.x), std::abs(both.y)});
  if (loudest > 0.0F)
    for (glm::vec2& both : sound) both *= 0.9F / loudest;
  return sound;
}

bool isLit(ImageView<const std::uint8_t> frame) {
  for (int y = 0; y < frame.height; ++y)
    if (std::any_of(frame.row(y), frame.row(y) + frame.width, [](auto v) { return v > 0; })) return true;
  return false;
}

Result<void> write(Run& run, const std::filesystem::path& file, const DisplayImage& image, double pixel_mm) {
  const StepClock clock(run.report, "write");
  return writeDisplayImage(image, pixel_mm, run.outputs.staged(file));
}

void printPlan(std::ostream& out, const Scanner& scanner, const Report& report) {
  const auto& geometry = scanner.geometry();
  out << "Plan for " << geometry.width << " x " << geometry.height << " pixels of " << rounded(geometry.pixel_mm, 3) << " mm, depth "
      << rounded(geometry.depth_mm, 0) << " mm, sampled on " << (scanner.plan().onBeams ? "beams" : "the display's pixels") << ":\n";
  double estimated_us = 0.0, measured_us = 0.0;
  const auto line = [&](std::string name, double estimate_us, double measure_us) {
    std::string estimate = rounded(estimate_us, 0), measure = rounded(measure_us, 0);
    name.resize(std::max<std::size_t>(name.size(), 16), ' ');
    estimate.insert(0, 8 - std::min<std::size_t>(8, estimate.size()), ' ');
    measure.insert(0, 8 - std::min<std::size_t>(8, measure.size()), ' ');
    out << "  " << name << estimate << " us estimated" << measure << " us measured\n";
  };
  for (const auto& step : scanner.plan().steps) {
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
    return failure(ErrorCode::badUsage, say<"--contact-sheet makes an image of its own; give it without -o, --repeat and --plan.">());
  const glm::ivec2& size_px = arguments.size_px;
  if (glm::any(glm::lessThan(size_px, kSmallest_px)) || glm::any(glm::greaterThan(size_px, kLargest_px)))
    return failure(ErrorCode::badUsage,
                   say<"The tiles of a contact sheet are from 160x120 to 1024x768 pixels large; give --size 320x240.">());
  return run.output(arguments.contactSheet, ".png");
}

Result<int> makeContactSheet(const ScanArguments& arguments, const ScanSubject& subject, const Probe& probe, const std::vector<Pose>& poses,
                             Run& run) {
  auto probes = shippedProbes();
  if (!probes) return passOn(probes.error());
  const SheetSource source{
      .subject = subject, .probe = probe, .probes = std::move(*probes), .pose = poses.front(), .interfacePose = poses.back()};
  run.progress.report(say<"Making the contact sheet">(), kShareOfReading);
  const RgbImage sheet = contactSheet(source, arguments.size_px);
  if (auto written = writeDisplayImage(sheet, 1.0, run.outputs.staged(arguments.contactSheet)); !written) return passOn(written.error());
  run.say("Wrote a contact sheet of " + std::to_string(sheet.width) + " x " + std::to_string(sheet.height) + " pixels.");
  return kDone;
}

bool writesImages(const ScanArguments& arguments) { return arguments.repeat == 0 && !arguments.output.empty(); }

Result<void> checkScanUsage(const ScanArguments& arguments, Run& run) {
  if (!arguments.contactSheet.empty())
    if (auto usable = checkContactSheet(arguments, run); !usable) return usable;
  const bool writes = writesImages(arguments);
  if (!writes && arguments.repeat == 0 && !arguments.plan && arguments.contactSheet.empty())
    return failure(ErrorCode::badUsage,
                   say<"Say where the image goes with -o OUT.png, look at the plan with --plan, or measure with --repeat N.">());
  if (writes)
    if (auto fits = checkRoomForWarning(arguments.size_px.x, arguments.size_px.y, arguments.output); !fits)
      return failure(ErrorCode::badUsage, fits.error().message);
  return {};
}

/// Everything about a scan that is known before voxels are read.
struct ScanPlan {
  Wanted wanted;
  Knobs knobs;
  std::string preset;  ///< id of the one that `knobs` are; empty: they are given, or neutral
  Probe probe;
  std::vector<Pose> poses;
  std::vector<float> gaps_mm;

  [[nodiscard]] bool isStrip() const { return knobs.mode == DisplayMode::mMode; }
  [[nodiscard]] bool isSpectrum() const { return knobs.mode == DisplayMode::spectrum; }
  /// Of a strip one for all poses, of a spectrum below the last image.
  [[nodiscard]] std::size_t outputs() const { return isStrip() || isSpectrum() ? 1 : poses.size(); }
};

/// Probe and settings as the window begins the case with them. Poses of a file are images of their own: nothing of one shows in the next.
Result<void> beginLikeWindow(const Case& opened, bool choosesProbe, ScanPlan& plan) {
  const auto there = beginningsThere();
  if (!there) return passOn(there.error());
  const std::vector<Probe> usable = choosesProbe ? usableOf(opened.probes, there->probes) : std::vector<Probe>{plan.probe};
  const Preset* start = startPreset(presetsOf(opened), there->presets, usable);
  if (start == nullptr) return {};
  plan.probe = *std::find_if(usable.begin(), usable.end(), [&](const Probe& each) { return each.id == start->probe; });
  plan.knobs = applied(*start, plan.knobs);
  plan.knobs.persistence = 0.0;
  if (plan.knobs.colour) plan.knobs.colour->persistence = 0.0;
  plan.preset = start->id;
  return {};
}

Result<ScanPlan> readScanPlan(const ScanArguments& arguments, Run& run) {
  ScanPlan plan;
  if (!arguments.knobs.empty()) {
    if (auto kept = run.input(arguments.knobs); !kept) return passOn(kept.error());
    auto read = readKnobs(arguments.knobs);
    if (!read) return passOn(read.error());
    plan.knobs = *read;
  }
  auto wanted = readWanted(arguments, run);
  if (!wanted) return passOn(wanted.error());
  if (hasEnding(arguments.probe, ".json"))
    if (auto kept = run.protect(arguments.probe); !kept) return passOn(kept.error());
  auto probe = findProbe(arguments.probe, wanted->opened ? wanted->opened->probes : std::vector<std::string>());
  if (!probe) return passOn(probe.error());
  plan.probe = std::move(*probe);
  if (wanted->opened && arguments.knobs.empty())
    if (auto begun = beginLikeWindow(*wanted->opened, arguments.probe.empty(), plan); !begun) return passOn(begun.error());
  if (auto fits = checkDepth(plan.knobs, plan.probe); !fits) return passOn(fits.error());
  auto poses = posesFor(arguments, *wanted, run);
  if (!poses) return passOn(poses.error());
  if (arguments.seconds) {
    if (poses->size() != 1 || arguments.times_s.size() > 1)
      return failure(ErrorCode::badUsage, say<"--seconds looks at one pose for a while; give one pose and at most one time.">());
    poses->resize(1 + static_cast<std::size_t>(std::floor(*arguments.seconds * arguments.rate_hz)), poses->front());
  }
  if (plan.knobs.mode == DisplayMode::spectrum && !plan.knobs.spectral) plan.knobs.spectral.emplace();
  if (!arguments.sound.empty() && plan.knobs.mode != DisplayMode::spectrum)
    return failure(ErrorCode::badUsage, say<"Only a spectrum can be heard; give --knobs with \"mode\": \"spectrum\" to --sound.">());
  if (arguments.times_s.size() > 1 && poses->size() == 1) poses->resize(arguments.times_s.size(), poses->front());
  if (arguments.times_s.size() > 1 && poses->size() != arguments.times_s.size())
    return failure(ErrorCode::badUsage, say<"There are %1 times and %2 poses; give one time, one pose, or as many of one as of the other.">(
                                            arguments.times_s.size(), poses->size()));
  auto gaps_mm = gapsOf(arguments.offSkin);
  if (!gaps_mm) return passOn(gaps_mm.error());
  const bool hasContact = wanted->opened ? wanted->opened->scene.contact.has_value() : wanted->scene && wanted->scene->contact;
  if (!gaps_mm->empty() && !hasContact)
    run.remark(
        say<"Nothing shows that a part of the face is off the skin, because the scene has no contact effect; give one with --scene.">());
  plan.wanted = std::move(*wanted);
  plan.poses = std::move(*poses);
  plan.gaps_mm = std::move(*gaps_mm);
  return plan;
}

nlohmann::json scanOptions(const ScanArguments& arguments, const ScanPlan& plan, const ScanSubject& subject) {
  return {{"probe", plan.probe.id},
          {"pose", arguments.pose},
          {"poses", plan.poses.size()},
          {"knobs", toJson(plan.knobs)},
          {"preset", plan.preset},
          {"scene", toJson(subject.scene)},
          {"size", {arguments.size_px.x, arguments.size_px.y}},
          {"repeat", arguments.repeat},
          {"threads", arguments.threads},
          {"rate_hz", arguments.rate_hz},
          {"off_skin", arguments.offSkin},
          {"times_s", arguments.times_s},
          {"breath", arguments.breath ? nlohmann::json(*arguments.breath) : nlohmann::json()},
          {"pulse", arguments.pulse ? nlohmann::json(*arguments.pulse) : nlohmann::json()},
          {"mapped", subject.voxels.volume() == nullptr}};
}

/// The last image, and below it the spectrum.
Result<void> writeWithSpectrum(Run& run, const std::filesystem::path& file, const DisplayImage& image, const ScanPlan& plan,
                               const Scanner& scanner) {
  const Still still = stillOf(image, scanner.strip(), scanner.geometry(), plan.probe, plan.knobs);
  if (const auto* grey = std::get_if<GreyImage>(&still.pixels)) return write(run, file, {viewOf(*grey)}, scanner.geometry().pixel_mm);
  const StepClock clock(run.report, "write");
  return writeDisplayImage(std::get<RgbImage>(still.pixels), scanner.geometry().pixel_mm, run.outputs.staged(file));
}

/// Every pose, as often as it is to be measured; images and strip are written when they are asked for.
/// @return how many of the images are not black
Result<std::size_t> scanPoses(const ScanArguments& arguments, const ScanPlan& plan, const ScanVoxels& voxels, ScanTimer& timed, Run& run) {
  const bool writes = writesImages(arguments);
  const double pixel_mm = timed.scanner.geometry().pixel_mm;
  const int rounds = std::max(1, arguments.repeat);
  const double total = static_cast<double>(rounds) * static_cast<double>(plan.poses.size());
  double done = 0.0;
  std::size_t litImages = 0;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t n = 0; n < plan.poses.size(); ++n) {
      if (run.progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">());
      if (auto whole = voxels.unchanged(); !whole) return passOn(whole.error());
      const auto frame = timed.make(plan.poses[n]);
      if (round == 0) {
        if (isLit(frame.grey))
          ++litImages;
        else
          run.remark(say<"The image of pose %1 is black; the probe looks past the volume or the gain is 0.">(n + 1));
      }
      if (writes && plan.isSpectrum() && round == 0 && n + 1 == plan.poses.size())
        if (auto written = writeWithSpectrum(run, numbered(arguments.output, 0, 1), frame, plan, timed.scanner); !written)
          return passOn(written.error());
      if (writes && !plan.isStrip() && !plan.isSpectrum())
        if (auto written = write(run, numbered(arguments.output, n, plan.outputs()), frame, pixel_mm); !written)
          return passOn(written.error());
      run.progress.report(say<"Scanning">(), kShareOfReading + (1.0 - kShareOfReading) * ++done / total);
    }
  if (writes && plan.isStrip())
    if (auto written = write(run, numbered(arguments.output, 0, 1), {timed.scanner.strip()}, pixel_mm); !written)
      return passOn(written.error());
  return litImages;
}

void reportScan(const ScanTimer& timed, std::size_t litImages, Report& report) {
  report.quality = {{"pictures_not_black", litImages},
                    {"pose_to_picture_p50_us", timed.latency.quantile_us(0.5)},
                    {"pose_to_picture_p95_us", timed.latency.quantile_us(0.95)},
                    {"pose_to_picture_p99_us", timed.latency.quantile_us(0.99)},
                    {"pose_to_picture_max_us", timed.latency.max_us()},
                    {"pose_to_picture_count", timed.latency.count()}};
  report.details["plan"] = nlohmann::json::array();
  for (const auto& step : timed.scanner.plan().steps)
    report.details["plan"].push_back(
        {{"name", nameOf(step.kind)}, {"estimated_us", step.estimated_us}, {"measured_us", report.median_us(nameOf(step.kind))}});
  report.details["on_beams"] = timed.scanner.plan().onBeams;
}

/// Remarks on what is asked for and cannot be seen.
void tellWhatDoesNotShow(const ScanArguments& arguments, const Knobs& knobs, const ScanSubject& subject, Run& run) {
  const bool movesBody = arguments.breath || arguments.pulse;
  const bool showsTime = subject.changesIn(subject.scene, knobs), showsBody = subject.movesIn(subject.scene);
  if ((!arguments.times_s.empty() && !showsTime) || (movesBody && !showsBody))
    run.remark(subject.motion ? say<"The body stands still, because the scene has no live echoes or no motion; give one with --scene.">()
               : showsTime    ? say<"This case does not move; --breath and --pulse change nothing.">()
                              : say<"This case does not move; --time, --breath and --pulse change nothing.">());
  if (knobs.mode == DisplayMode::spectrum && !subject.showsColour())
    run.remark(say<"This case does not say how blood flows, so there is no spectrum; a virtual patient whose recipe has flow shows it.">());
  if (knobs.colour && !subject.showsColour())
    run.remark(
        say<"This case does not say how blood flows, so the image has no colour; a virtual patient whose recipe has flow shows it.">());
}

Result<int> scan(const ScanArguments& arguments, Run& run) {
  if (auto usable = checkScanUsage(arguments, run); !usable) return passOn(usable.error());
  auto plan = readScanPlan(arguments, run);
  if (!plan) return passOn(plan.error());
  const bool writes = writesImages(arguments);
  if (writes)
    for (std::size_t n = 0; n < plan->outputs(); ++n)
      if (auto announced = run.output(numbered(arguments.output, n, plan->outputs()), ".png .mha"); !announced)
        return passOn(announced.error());
  if (!arguments.sound.empty())
    if (auto announced = run.output(arguments.sound, ".wav"); !announced) return passOn(announced.error());
  auto subject = readSubject(arguments, plan->wanted, {plan->probe, plan->knobs, plan->poses}, run);
  if (!subject) return passOn(subject.error());
  if (!arguments.contactSheet.empty()) return makeContactSheet(arguments, *subject, plan->probe, plan->poses, run);

  tellWhatDoesNotShow(arguments, plan->knobs, *subject, run);
  run.report.options = scanOptions(arguments, *plan, *subject);
  const ScanVoxels voxels = subject->voxels;
  const Scene scene = subject->scene;
  ScanTimer timed(arguments, std::move(*subject),
                  {.probe = plan->probe, .knobs = plan->knobs, .pan = {}, .scene = scene, .pose = {}, .gaps_mm = plan->gaps_mm}, run);
  run.report.options["pixel_mm"] = timed.scanner.geometry().pixel_mm;
  run.report.options["depth_mm"] = timed.scanner.geometry().depth_mm;
  const bool hears = !arguments.sound.empty() && timed.scanner.spectrogram() != nullptr;
  if (hears) timed.listen();
  const auto litImages = scanPoses(arguments, *plan, voxels, timed, run);
  if (!litImages) return passOn(litImages.error());
  if (arguments.plan && arguments.repeat == 0)
    for (int n = 0; n < kWarmFrames; ++n) timed.make(plan->poses.front(), false);
  if (hears)
    if (auto written = writeSound(asLoudAsFits(timed.sound()), kSound_hz, run.outputs.staged(arguments.sound)); !written)
      return passOn(written.error());
  reportScan(timed, *litImages, run.report);
  run.progress.clear();
  if (arguments.plan) printPlan(run.out(), timed.scanner, run.report);
  if (writes)
    run.say(plan->isSpectrum() ? "Wrote the spectrum of " + counted(plan->poses.size(), "image") + ", probe " + plan->probe.name + "."
            : plan->isStrip()  ? "Wrote the strip of " + counted(plan->poses.size(), "beam") + ", probe " + plan->probe.name + "."
                               : "Wrote " + counted(plan->poses.size(), "scan") + ", probe " + plan->probe.name + ".");
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
             "\n\nWithout --knobs a case is scanned with the preset it begins with in the window, but without persistence: each pose is a\n"
             "image of its own.\n"
             "KNOBS.json is one object; what is missing stays neutral:\n"
             "  { \"gain_db\": 3, \"tgc_db\": [-6, -3, 0, 0, 0, 2, 4, 6], \"depth_mm\": 160, \"focus_mm\": [60, 100] }\n" +
             knobsManual() +
             "Without \"gain_law\" the one acts whose values are given: gain_db and tgc_db in decibels along the beams, or gain and dgc,\n"
             "factors on grey levels by rows (Eq. 3-5).\n"
             "With \"colour\": true, or an object of its settings, a box of colour Doppler lies over the image of a case that says how\n"
             "blood flows, such as neck-carotid-thyroid; with \"mode\": \"spectrum\" the spectrum of a sample volume below it.\n"
             "With \"mode\": \"m\" the output is the strip of one beam over the poses, which are 1/30 s apart (--rate).\n"
             "SCENE.json is one object; an effect that is missing does not run:\n"
             "  { \"focus\": true, \"attenuation\": { \"expected_db_per_cm_mhz\": 0.5 } }\n" +
             sceneManual());
  app.add_option("SOURCE", arguments->source, "A volume (.mha, .mhd, .nrrd, .nii, .nii.gz), a case folder, a case.json, or a case's id")
      ->required()
      ->type_name("");
  app.add_option("--probe", arguments->probe, "A probe's id or name, or a probe's .json file (a case: its first probe)")->type_name("NAME");
  app.add_option(
         "--pose", arguments->pose,
         "16 numbers, row by row, from probe to world in mm (LPS), or a file with one pose a line (a case: its start pose). Several "
         "poses number their outputs: out_0000.png …")
      ->type_name("POSE");
  app.add_option("--knobs", arguments->knobs, "Settings of the console (a case: its preset; else neutral)")->type_name("KNOBS.json");
  app.add_option("--scene", arguments->scene, "Which effects the scene calls for (the case's, or none)")->type_name("SCENE.json");
  addSize(app, "--size", arguments->size_px, "Pixels of the image (640x480)");
  app.add_option("-o,--output", arguments->output,
                 "The image: .png, which carries 'simulation, not for diagnosis', or .mha, the bare frame")
      ->type_name("OUT");
  app.add_option("--contact-sheet", arguments->contactSheet,
                 "One image of many tiles of --size: every effect off and on, then every probe, at the first pose; reverberation at the "
                 "last")
      ->type_name("OUT.png");
  app.add_flag("--plan", arguments->plan, "Print what a frame runs, with estimated and measured microseconds");
  app.add_flag("--map", arguments->map,
               "Leave an uncompressed volume in its file and read it by the page, as files from 1 GiB on always are");
  app.add_option(
         "--time", arguments->times_s,
         "Where breath, pulse, bowel and blood stand: seconds on the patient's clock. One time: the clock runs on at --rate from there; "
         "several with one pose: a series (the body at rest)")
      ->expected(1, 10000)
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("S...");
  app.add_option("--breath", arguments->breath, "The breath held: 0 end of expiration, 1 full inspiration")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("SHARE");
  app.add_option("--pulse", arguments->pulse, "The pulse held: 0 end of diastole, 1 vessels at their widest")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("SHARE");
  app.add_option("--off-skin", arguments->offSkin,
                 "A part of the face off the skin, from -1 (its -x end) to 1; may be given several times. Acts when the scene has contact")
      ->allow_extra_args(false)
      ->type_name("FROM:TO");
  addNumber(app, "--rate", arguments->rate_hz, {0.1, 1000.0}, "Poses a second, for M-mode and spectra (30)");
  addNumber(app, "--seconds", arguments->seconds, {0.0, 600.0}, "How long one pose is looked at, for M-mode and spectra (one image)");
  app.add_option("--sound", arguments->sound,
                 "What the sample volume of a spectrum lets hear, as stereo: towards the probe left, away right")
      ->type_name("OUT.wav");
  addCount(app, "--threads", arguments->threads, 0, 256, "Threads of one frame; 0: all cores; the image does not depend on it (1)");
  addCount(app, "--repeat", arguments->repeat, 1, 1000000, "Run the whole list N times and write nothing but the report");
}

}  // namespace ew::cli
