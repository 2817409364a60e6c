#include <algorithm>
#include <numbers>

#include "commands/reconstruct_phases.h"
#include "ew/acquisition/import.h"
#include "ew/acquisition/reconstruct_words.h"
#include "ew/core/figures.h"
#include "ew/core/memory.h"
#include "ew/core/numbers.h"
#include "ew/io/volume_file.h"
#include "ew/stitching/common_grid.h"
#include "run/arguments.h"
#include "run/asked_option.h"
#include "run/command.h"

namespace ew::cli {
namespace {

struct ReconstructArguments {
  std::string sweep;
  std::string output;
  std::vector<std::string> calibrations;
  std::string poses;  // empty: the recording's own
  std::optional<double> imageRate_hz;
  std::string toFrame;
  std::string coverage;
  std::string provenance;
  std::optional<double> spacing_mm;
  std::string interpolation;  // empty: the calibration file's, else linear
  std::string compounding;    // empty: the calibration file's, else mean
  std::string confidence;     // empty: beamwise
  std::optional<double> fillReach_mm;
  std::optional<int> fillReach_voxels;
  bool fill = false;
  std::string fillMethod = "sweep";
  int threads = 0;
  std::optional<std::vector<double>> clip_px;  // x y width height
  std::optional<std::vector<double>> fan;      // left right (degrees), apex x y, start stop radius (pixels)
  bool noClip = false;
  bool acceptsSmall = false;
  bool isBeyondMemory = false;
  AcquisitionArguments acquisition;
};

Clip clipOf(const ReconstructArguments& arguments) {
  Clip clip;
  if (arguments.clip_px) {
    const auto& c = *arguments.clip_px;
    clip.origin_px = {c[0], c[1]};
    clip.size_px = glm::dvec2(c[2], c[3]);
  }
  if (arguments.fan) {
    constexpr double degree_rad = std::numbers::pi / 180.0;
    const auto& f = *arguments.fan;
    clip.fan = ClipFan{.origin_px = {f[2], f[3]},
                       .leftAngle_rad = f[0] * degree_rad,
                       .rightAngle_rad = f[1] * degree_rad,
                       .startRadius_px = f[4],
                       .stopRadius_px = f[5]};
  }
  return clip;
}

nlohmann::json toJson(const Clip& clip) {
  nlohmann::json json = {{"origin_px", {clip.origin_px.x, clip.origin_px.y}}, {"size_px", nullptr}, {"fan", nullptr}};
  if (clip.size_px) json["size_px"] = {clip.size_px->x, clip.size_px->y};
  if (clip.fan) {
    constexpr double rad_deg = 180.0 / std::numbers::pi;
    json["fan"] = {{"angles_deg", {clip.fan->leftAngle_rad * rad_deg, clip.fan->rightAngle_rad * rad_deg}},
                   {"origin_px", {clip.fan->origin_px.x, clip.fan->origin_px.y}},
                   {"radius_px", {clip.fan->startRadius_px, clip.fan->stopRadius_px}}};
  }
  return json;
}

SweepImportOptions importOptionsOf(const ReconstructArguments& arguments) {
  SweepImportOptions options;
  options.calibrations.assign(arguments.calibrations.begin(), arguments.calibrations.end());
  options.poses = arguments.poses;
  options.imageRate_hz = arguments.imageRate_hz;
  options.toFrame = arguments.toFrame;
  options.acceptsSmall = arguments.acceptsSmall;
  options.clipFromCalibration = !arguments.noClip && !arguments.clip_px && !arguments.fan;
  options.usual = {.spacing = !arguments.spacing_mm,
                   .interpolation = arguments.interpolation.empty(),
                   .compounding = arguments.compounding.empty(),
                   .fillReach = arguments.fill};
  options.confidence.method = meaningIn(kConfidenceMethodWords, arguments.confidence).value_or(options.confidence.method);
  auto& reconstruction = options.reconstruct;
  if (arguments.spacing_mm) reconstruction.spacing_mm = *arguments.spacing_mm;
  if (!arguments.interpolation.empty()) reconstruction.interpolation = *meaningIn(kInterpolationWords, arguments.interpolation);
  if (!arguments.compounding.empty()) reconstruction.compounding = *meaningIn(kCompoundingWords, arguments.compounding);
  reconstruction.fillReach_mm = arguments.fillReach_mm.value_or(0.0);
  options.fillReach_voxels = arguments.fillReach_voxels;
  reconstruction.fillMethod = meaningIn(kFillMethodWords, arguments.fillMethod).value_or(reconstruction.fillMethod);
  reconstruction.keepSource = !arguments.provenance.empty();
  reconstruction.threads = arguments.threads;
  reconstruction.clip = clipOf(arguments);
  return options;
}

nlohmann::json optionsReport(const ReconstructArguments& arguments, const ImportPlan& plan) {
  const auto& done = plan.reconstruct;
  return {{"calibration", arguments.calibrations},
          {"poses", arguments.poses.empty() ? nlohmann::json() : nlohmann::json(arguments.poses)},
          {"image_to", plan.toFrame},
          {"spacing_mm", done.spacing_mm},
          {"interpolation", wordIn(kInterpolationWords, done.interpolation)},
          {"compounding", wordIn(kCompoundingWords, done.compounding)},
          {"confidence", done.compounding == Compounding::weighted ? nlohmann::json(wordIn(kConfidenceMethodWords, plan.confidence.method))
                                                                   : nlohmann::json()},
          {"fill_reach_mm", done.fillReach_mm},
          {"fill_method", wordIn(kFillMethodWords, done.fillMethod)},
          {"threads", done.threads},
          {"clip", toJson(done.clip)}};
}

/// 1 + the number in the file of each frame that is used. Frames beyond what 16 bits can say become 0, unknown.
std::vector<std::uint16_t> usedFrames(const SweepPoses& poses) {
  std::vector<std::uint16_t> numbers;
  for (std::size_t n = 0; n < poses.imageToWorld.size(); ++n)
    if (poses.imageToWorld[n]) numbers.push_back(n < 65535 ? static_cast<std::uint16_t>(n + 1) : std::uint16_t{0});
  return numbers;
}

Result<void> checkReconstruction(const ReconstructArguments& arguments) {
  if (arguments.imageRate_hz && arguments.poses.empty())
    return failure(ErrorCode::badUsage,
                   say<"--rate times the images that poses of a file of their own are joined with; give --poses too.">());
  if (arguments.noClip && (arguments.clip_px || arguments.fan))
    return failure(ErrorCode::badUsage, say<"--no-clip contradicts --clip and --fan; give one of them.">());
  if (arguments.fill && (arguments.fillReach_mm || arguments.fillReach_voxels))
    return failure(ErrorCode::badUsage, say<"--fill chooses the reach itself; leave it out beside --fill-reach-mm and --fill-reach.">());
  if (arguments.fillReach_mm && arguments.fillReach_voxels)
    return failure(ErrorCode::badUsage, say<"--fill-reach-mm and --fill-reach say the same in two units; give one of them.">());
  if (!arguments.confidence.empty() && arguments.compounding != "weighted")
    return failure(ErrorCode::badUsage, say<"--confidence says how pixels are weighted; give --compounding weighted with it.">());
  if (!arguments.provenance.empty() && arguments.acquisition.phases)
    return failure(ErrorCode::badUsage, say<"--provenance is written for one volume, not for phases; leave one of them out.">());
  return {};
}

Result<void> announceReconstruction(const ReconstructArguments& arguments, Run& run) {
  if (auto kept = run.input(arguments.sweep); !kept) return kept;
  for (const auto& file : arguments.calibrations)
    if (auto kept = run.input(file); !kept) return kept;
  if (!arguments.poses.empty())
    if (auto kept = run.input(arguments.poses); !kept) return kept;
  if (auto announced = announcePhases(run, arguments.output, arguments.coverage, arguments.acquisition.phases.value_or(1)); !announced)
    return announced;
  if (!arguments.provenance.empty())
    if (auto announced = run.output(arguments.provenance, ".mha .mhd"); !announced) return announced;
  return {};
}

Result<void> writeMade(const ReconstructArguments& arguments, const ReconstructResult& made, Run& run) {
  const StepClock clock(run.report, "write");
  PartOfProgress writing(run.progress, 0.9, arguments.coverage.empty() ? 1.0 : 0.95);
  if (auto written = writeVolume(made.volume, run.outputs.staged(arguments.output), writing); !written) return written;
  if (!arguments.coverage.empty()) {
    PartOfProgress writingCoverage(run.progress, 0.95, 1.0);
    if (auto written = writeCoverage(made.volume, run.outputs.staged(arguments.coverage), writingCoverage); !written) return written;
  }
  if (!arguments.provenance.empty()) {
    PartOfProgress writingSources(run.progress, 0.98, 1.0);
    if (auto written = writeSources(made.volume.grid, made.source, run.outputs.staged(arguments.provenance), writingSources); !written)
      return written;
  }
  return {};
}

void reportMade(const ReconstructArguments& arguments, const ImportPlan& plan, const ReconstructResult& made, Run& run) {
  const auto& grid = made.volume.grid;
  run.report.options = optionsReport(arguments, plan);
  run.report.quality = {{"frames_total", plan.frames.total},
                        {"frames_used", plan.frames.used},
                        {"frames_invalid", plan.frames.invalid},
                        {"frames_missing", plan.frames.missing},
                        {"pixels_pasted", made.pixelsPasted},
                        {"voxels", grid.voxelCount()},
                        {"voxels_measured", made.measuredVoxels},
                        {"voxels_interpolated", made.interpolatedVoxels},
                        {"forecast_mib", static_cast<double>(plan.bytes) / 1048576.0}};
  run.report.details["grid"] = {{"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
                                {"spacing_mm", {grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z}},
                                {"origin_mm", {grid.origin_mm.x, grid.origin_mm.y, grid.origin_mm.z}}};
  run.say("Wrote " + arguments.output + ": " + std::to_string(grid.dims.x) + " x " + std::to_string(grid.dims.y) + " x " +
          std::to_string(grid.dims.z) + " voxels of " + figureText(grid.spacing_mm.x) + " mm in the frame " + plan.toFrame + ".");
  std::string frames = "Used " + std::to_string(plan.frames.used) + " of " + counted(plan.frames.total, "frame");
  if (plan.frames.invalid + plan.frames.missing > 0)
    frames += " (" + std::to_string(plan.frames.invalid) + " invalid, " + std::to_string(plan.frames.missing) + " without a pose)";
  const double share = 100.0 / static_cast<double>(grid.voxelCount());
  run.say(frames + "; " + rounded(share * static_cast<double>(made.measuredVoxels), 1) + " % of the voxels are measured, " +
          rounded(share * static_cast<double>(made.interpolatedVoxels), 1) + " % interpolated.");
}

/// What it will take, said before it is taken; more than the machine has free is not begun unasked.
Result<void> tellForecast(const ReconstructArguments& arguments, const ImportPlan& plan, Run& run) {
  const glm::ivec3 dims = plan.grid.dims;
  const auto mebibytes = [](std::uint64_t bytes) { return std::max<std::uint64_t>(1, bytes >> 20); };
  run.remark(say<"Reconstructing %1 x %2 x %3 voxels of %4 mm needs about %5 MiB of memory.">(
      dims.x, dims.y, dims.z, numeral(figureText(plan.grid.spacing_mm.x)), mebibytes(plan.bytes)));
  const auto free = availableMemory_bytes();
  if (arguments.isBeyondMemory || !free || plan.bytes <= *free) return {};
  return failure(
      ErrorCode::tooLarge,
      say<"Reconstructing this needs about %1 MiB of memory, and %2 MiB are free; give a coarser --spacing, or --beyond-memory to "
          "do it all the same.">(mebibytes(plan.bytes), mebibytes(*free)),
      {{"bytes", std::to_string(plan.bytes)}, {"free", std::to_string(*free)}});
}

Result<int> reconstructSweep(const ReconstructArguments& arguments, Run& run) {
  if (auto usable = checkReconstruction(arguments); !usable) return passOn(usable.error());
  if (auto announced = announceReconstruction(arguments, run); !announced) return passOn(announced.error());
  auto importOptions = importOptionsOf(arguments);
  if (auto applied = applyTo(importOptions, arguments.acquisition, run); !applied) return passOn(applied.error());

  PartOfProgress opening(run.progress, 0.0, 0.3);
  auto opened = openSweep(arguments.sweep, importOptions, opening);
  if (!opened) return withOption(opened.error());
  for (const auto& note : opened->plan.notes) run.remark(note);
  run.report.addStep("read", opened->readSeconds * 1e6);
  if (auto fits = tellForecast(arguments, opened->plan, run); !fits) return passOn(fits.error());
  if (delayUntold(opened->plan, run)) return kVerdict;
  if (arguments.acquisition.phases) {
    run.report.options = optionsReport(arguments, opened->plan);
    PartOfProgress making(run.progress, 0.3, 1.0);
    return writePhases(*opened, arguments.acquisition, arguments.output, arguments.coverage, run, making);
  }

  PartOfProgress pasting(run.progress, 0.3, 0.9);
  const auto numbers = usedFrames(opened->poses);
  auto imported = importSweep(std::move(*opened), pasting);
  if (!imported) return withOption(imported.error());
  // From counting the frames used to counting those of the file.
  for (std::uint16_t& source : imported->reconstruction.source)
    if (source > 0) source = numbers[source - 1u];
  const auto& plan = imported->plan;
  const auto& made = imported->reconstruction;
  run.report.addStep("paste", made.pasteSeconds * 1e6);
  if (plan.reconstruct.fillReach_mm > 0.0) run.report.addStep("fill", made.fillSeconds * 1e6);

  if (auto written = writeMade(arguments, made, run); !written) return passOn(written.error());
  reportMade(arguments, plan, made, run);
  return kDone;
}

void addAcquisitionOptions(CLI::App& app, AcquisitionArguments& arguments) {
  app.add_option("--motor", arguments.motor,
                 "Take the poses from a motor instead of a tracker: its file (parallel, fan or rotational), or 'recorded' for what the "
                 "recording itself says")
      ->type_name("MOTOR.json");
  app.add_option("--time-offset", arguments.timeOffset,
                 "Move the poses in time: by how many seconds they lag behind the images (positive: an image of time t has the pose of "
                 "t + S), or 'estimate' to find it from the movement in both")
      ->type_name("S");
  app.add_option("--phases", arguments.phases, "Gate: write this many volumes of one cycle of heart or breath, numbered")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  app.add_option("--gate", arguments.gate, "What tells the phase: the recorded ECG or respiration, or the images (the first that can)")
      ->check(CLI::IsMember({"automatic", "ecg", "respiration", "images"}))
      ->type_name("KIND");
  app.add_option("--rhythm", arguments.rhythm, "What to look for in images: heart or breath (heart)")
      ->check(CLI::IsMember({"heart", "breath"}))
      ->type_name("KIND");
}

}  // namespace

void addReconstruct(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<ReconstructArguments>();
  auto& app = addCommand(root, selection, "reconstruct", "Turn a tracked sweep into a volume",
                         {"reconstruct sweep.igs.mha -o volume.mha --calibration deviceset.xml --spacing 0.5",
                          "reconstruct sweep.igs.mha -o volume.mha --interpolation nearest --fill-reach-mm 3 --coverage coverage.mha",
                          "reconstruct sweep.igs.mha -o phase.mha --phases 8 --gate ecg",
                          "reconstruct film.mp4 --poses tracker.csv --time-offset 0.12 --calibration deviceset.xml -o volume.mha",
                          "reconstruct sweep.igs.mha -o volume.mha --clip 0 0 739 593 --fan -30.28 30.28 369 -139.33 161.34 724.35"},
                         [arguments](Run& run) { return reconstructSweep(*arguments, run); });
  app.add_option("SWEEP", arguments->sweep,
                 "The tracked sequence: .igs.mha, .igs.mhd, .igs.nrrd and the like; with --poses also images alone: a film, a DICOM cine, "
                 "a TIFF, a folder of images, a volume of slices")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", arguments->output, "The volume: .mha, or .mhd with its .raw")->required()->type_name("VOLUME.mha");
  app.add_option("--calibration", arguments->calibrations,
                 "Device set of the recording: calibration, and clip, spacing and method if it has them; may be given several times, "
                 "then the earlier file counts where two say the same")
      ->type_name("XML")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--poses", arguments->poses,
                 "Poses in a file of their own, joined with the images by time: a tracked sequence, or a table (.csv) with the columns "
                 "time_s, x_mm, y_mm, z_mm, qw, qx, qy, qz, see resources/docs/science/acquisition.md")
      ->type_name("FILE");
  addNumber(app, "--rate", arguments->imageRate_hz, {0.001, 100000.0},
            "With --poses: images a second, of images that do not say their times, or say them wrongly");
  app.add_option("--image-to", arguments->toFrame,
                 "The recording's frame that becomes the world (the calibration file's reference, else Reference, Tracker or World)")
      ->type_name("FRAME");
  app.add_flag("--beyond-memory", arguments->isBeyondMemory, "Begin also when it needs more memory than is free");
  addNumber(app, "--spacing", arguments->spacing_mm, {1e-6, 1e6},
            "Size of a voxel in mm (the calibration file's, else from pixels and the distance of the frames, 0.3 to 1)");
  app.add_option(
         "--interpolation", arguments->interpolation,
         "nearest: a pixel goes into one voxel; linear: it is shared among eight, smoother and slower; centred: as nearest, then each "
         "measured voxel is read from the frames at its centre (the calibration file's, else linear)")
      ->check(CLI::IsMember({"nearest", "linear", "centred"}))
      ->type_name("KIND");
  app.add_option("--compounding", arguments->compounding,
                 "What a voxel takes from several pixels: mean, maximum, latest, or weighted: the mean by the confidence in each, so that "
                 "shadows count less (the calibration file's, else mean)")
      ->check(CLI::IsMember({"mean", "maximum", "latest", "weighted"}))
      ->type_name("KIND");
  app.add_option(
         "--confidence", arguments->confidence,
         "With --compounding weighted: beamwise, a millisecond or two a frame, or randomwalk, tens of them and also sure of shadows "
         "with echoes in them (beamwise)")
      ->check(CLI::IsMember({"beamwise", "randomwalk"}))
      ->type_name("KIND");
  addNumber(app, "--fill-reach-mm", arguments->fillReach_mm, {0.0, 1e6},
            "Fill holes between measured voxels that are at most so many mm apart, whatever the spacing; 0: none (0)");
  addCount(app, "--fill-reach", arguments->fillReach_voxels, 0, 1000, "The same, counted in voxels of the spacing");
  app.add_flag(
      "--fill", arguments->fill,
      "Fill the holes of the sweep as far as the window and stitching do: three voxels or 2.5 times the distance of the frames. Without "
      "it and the two above holes stay, so that every voxel of the file was measured");
  app.add_option("--fill-method", arguments->fillMethod,
                 "sweep: between successive frames along the way of the probe, then bridges for what is left; bridges: between measured "
                 "voxels in 13 directions (sweep)")
      ->check(CLI::IsMember({"sweep", "bridges"}))
      ->type_name("KIND");
  app.add_option("--provenance", arguments->provenance,
                 "Also write which frame of the sweep each voxel came from: 16 bit, 1 + the frame's number in the file, 0 for none")
      ->type_name("OUT.mha");
  app.add_option("--coverage", arguments->coverage, "Also write what is known of each voxel: 0 absent, 1 interpolated, 2 measured")
      ->type_name("OUT.mha");
  addCount(app, "--threads", arguments->threads, 0, 1024, "Threads; 0: all cores; the voxels do not depend on it (0)");
  addNumberList(app, "--clip", arguments->clip_px, 4, "X Y W H",
                "Use this rectangle of a frame, in pixels; replaces the calibration file's clip");
  addNumberList(app, "--fan", arguments->fan, 6, "LEFT RIGHT X Y START STOP",
                "Use this fan of a frame: two angles in degrees from straight down, apex and two radii in pixels; replaces the calibration "
                "file's clip");
  addAcquisitionOptions(app, arguments->acquisition);
  app.add_flag("--no-clip", arguments->noClip, "Use the whole frame, whatever the calibration file says");
  app.add_flag("--accept-small", arguments->acceptsSmall,
               "Make the volume also when less than a tenth of the pixels or of the frames is used, or when its size can hardly be meant");
}

}  // namespace ew::cli
