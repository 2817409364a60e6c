#include "ew/acquisition/import.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "clip_spans.h"
#include "ew/acquisition/joined_sweep.h"
#include "ew/acquisition/line_data.h"
#include "ew/acquisition/sweep_geometry.h"
#include "ew/core/contract.h"
#include "ew/core/elapsed.h"
#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/io/gating_fields.h"
#include "meant_size.h"

namespace ew {
namespace {

using Clock = std::chrono::steady_clock;

Result<void> checkImages(const Sequence& sequence) {
  if (sequence.width < 1 || sequence.height < 1)
    return failure(
        ErrorCode::unsupported,
        say<"The recording holds poses but no images, so there is nothing to reconstruct; choose the recording with the images.">());
  if (sequence.imageType.starts_with("RF"))
    return failure(
        ErrorCode::unsupported,
        say<"The recording holds %1 data, no brightness. EchoWeave does not read radio frequency lines: record again with B-mode images, "
            "or have the program that recorded it make them (in PLUS the RfProcessing of the device set).">(sequence.imageType),
        {{"orientation", sequence.orientation}, {"imageType", sequence.imageType}});
  return {};
}

/// Turns every image to MF. An orientation that says nothing is taken as MF, which is what the calibration of such files counts in.
Result<void> turnToMarkerFar(Sequence& sequence, std::vector<Message>& notes, Progress& progress) {
  const std::string& orientation = sequence.orientation;
  if (orientation.size() < 2) {
    notes.push_back(say<"The recording does not name its image orientation; MF (marker side first, far side last) was assumed.">());
    return {};
  }
  const bool mirrored = orientation[0] == 'U', upsideDown = orientation[1] == 'N';
  if ((orientation[0] != 'M' && !mirrored) || (orientation[1] != 'F' && !upsideDown))
    return failure(ErrorCode::badField,
                   say<"The image orientation %1 is not known; expected two of the letters M or U and F or N, as in MF.">(orientation),
                   {{"field", "UltrasoundImageOrientation"}, {"found", orientation}});
  if (!mirrored && !upsideDown) return {};
  const auto width = static_cast<std::ptrdiff_t>(sequence.width), height = static_cast<std::ptrdiff_t>(sequence.height);
  for (auto frame = sequence.pixels.begin(); frame != sequence.pixels.end(); frame += width * height) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The import was stopped before it was complete.">());
    if (upsideDown)
      for (std::ptrdiff_t y = 0; y < height / 2; ++y)
        std::swap_ranges(frame + y * width, frame + (y + 1) * width, frame + (height - 1 - y) * width);
    if (mirrored)
      for (std::ptrdiff_t y = 0; y < height; ++y) std::reverse(frame + y * width, frame + (y + 1) * width);
  }
  notes.push_back(say<"The images are stored in orientation %1 and were turned to MF.">(orientation));
  sequence.orientation = "MF";
  return {};
}

enum class ClipSaidBy { deviceSet, recording };

Message clippedTo(bool fan, ClipSaidBy who) {
  switch (who) {
    case ClipSaidBy::deviceSet:
      return fan ? say<"The images were clipped to the fan of the device set.">()
                 : say<"The images were clipped to the rectangle of the device set.">();
    case ClipSaidBy::recording:
      return fan ? say<"The images were clipped to the fan of the recording.">()
                 : say<"The images were clipped to the rectangle of the recording.">();
  }
  return {};
}

Message apexUnsaid(ClipSaidBy who) {
  switch (who) {
    case ClipSaidBy::deviceSet:
      return say<"The device set states the angles of a fan without its apex (FanOriginPixel); the pixel (0, 0) was taken.">();
    case ClipSaidBy::recording:
      return say<"The recording states the angles of a fan without its apex (FanOriginPixel); the pixel (0, 0) was taken.">();
  }
  return {};
}

/// Of a fan everything but its angles. Zeros are what is written where there is no fan.
Message fanWithoutAngles(const DeviceSet& device, ClipSaidBy who) {
  std::vector<Message> parts;
  if (const auto& apex_px = device.fanOrigin_px; apex_px && *apex_px != glm::dvec2(0.0))
    parts.push_back(say<"apex (%1, %2)">(numeral(textOf(apex_px->x)), numeral(textOf(apex_px->y))));
  if (device.fanRadiusStart_px.value_or(0.0) > 0.0) parts.push_back(say<"begin at radius %1">(numeral(textOf(*device.fanRadiusStart_px))));
  if (device.fanRadiusStop_px) parts.push_back(say<"end at radius %1">(numeral(textOf(*device.fanRadiusStop_px))));
  if (parts.empty()) return {};
  const Message fan = joined(std::move(parts), ", ");
  switch (who) {
    case ClipSaidBy::deviceSet:
      return say<"The device set states a fan (%1) without its angles (FanAnglesDeg), so that it is not used.">(fan);
    case ClipSaidBy::recording:
      return say<"The recording states a fan (%1) without its angles (FanAnglesDeg), so that it is not used.">(fan);
  }
  return {};
}

std::optional<Clip> clipOf(const DeviceSet& device, ClipSaidBy who, std::vector<Message>& notes) {
  const bool fan = device.fanAngles_deg.has_value();
  if (Message unused = fan ? Message() : fanWithoutAngles(device, who); !unused.empty()) notes.push_back(std::move(unused));
  if (fan && !device.fanOrigin_px) notes.push_back(apexUnsaid(who));
  if (!device.clipSize_px && !fan) return std::nullopt;
  Clip clip;
  clip.origin_px = device.clipOrigin_px.value_or(glm::dvec2(0.0));
  clip.size_px = device.clipSize_px;
  if (fan) {
    const glm::dvec2 angles_rad = *device.fanAngles_deg * (std::numbers::pi / 180.0);
    clip.fan = ClipFan{device.fanOrigin_px.value_or(glm::dvec2(0.0)), angles_rad.x, angles_rad.y, device.fanRadiusStart_px.value_or(0.0),
                       device.fanRadiusStop_px.value_or(1e9)};
  }
  notes.push_back(clippedTo(fan, who));
  return clip;
}

Result<void> takeSpacing(const DeviceSet& device, ReconstructOptions& options) {
  if (!device.outputSpacing_mm) return {};
  const glm::dvec3 spacing_mm = *device.outputSpacing_mm;
  if (spacing_mm.x != spacing_mm.y || spacing_mm.x != spacing_mm.z)
    return failure(ErrorCode::badField,
                   say<"The OutputSpacing of the device set differs between axes (%1, %2, %3 mm), but voxels are cubes; choose their size "
                       "yourself.">(figureText(spacing_mm.x), figureText(spacing_mm.y), figureText(spacing_mm.z)),
                   {{"field", "OutputSpacing"}});
  options.spacing_mm = spacing_mm.x;
  return {};
}

Result<void> takeInterpolation(const DeviceSet& device, ReconstructOptions& options) {
  const std::string interpolation = device.interpolation.value_or("");
  if (interpolation == "NEAREST_NEIGHBOR") {
    options.interpolation = Interpolation::nearest;
  } else if (interpolation == "LINEAR") {
    options.interpolation = Interpolation::linear;
  } else if (!interpolation.empty()) {
    return failure(ErrorCode::badField,
                   say<"The device set asks for the interpolation %1; expected NEAREST_NEIGHBOR or LINEAR.">(interpolation),
                   {{"field", "Interpolation"}, {"found", interpolation}});
  }
  return {};
}

Result<void> takeCompounding(const DeviceSet& device, ReconstructOptions& options, std::vector<Message>& notes) {
  const std::string written = device.compounding.value_or("");
  std::string compounding = written;
  std::transform(compounding.begin(), compounding.end(), compounding.begin(), [](unsigned char c) { return std::toupper(c); });
  // Before there were modes, compounding could only be switched: on averaged, off kept the newest pixel.
  const bool isSwitch = compounding == "ON" || compounding == "OFF";
  if (compounding == "MEAN" || compounding == "ON") {
    options.compounding = Compounding::mean;
  } else if (compounding == "MAXIMUM") {
    options.compounding = Compounding::maximum;
  } else if (compounding == "LATEST" || compounding == "OFF") {
    options.compounding = Compounding::latest;
  } else if (!compounding.empty()) {
    return failure(ErrorCode::badField,
                   say<"The device set asks for the compounding %1; expected MEAN, MAXIMUM or LATEST. Correct it there, or choose the "
                       "compounding yourself.">(written),
                   {{"field", "CompoundingMode"}, {"found", written}});
  }
  if (isSwitch)
    notes.push_back(compounding == "ON"
                        ? say<"The device set says Compounding \"%1\", as old ones do; that was taken as the mean of all views.">(written)
                        : say<"The device set says Compounding \"%1\", as old ones do; that was taken as the latest view.">(written));
  return {};
}

/// Images that know the size of their pixels alone (frame Picture of the import) before a probe whose face lies at the middle of their
/// upper edge.
std::optional<Transform<frame::Probe, frame::Image>> faceAtUpperEdge(const Sequence& sequence) {
  if (sequence.frames.empty()) return std::nullopt;
  const auto imageToPlane = chain(sequence.frames.front().transforms, "Image", "Picture");
  if (!imageToPlane) return std::nullopt;
  glm::dmat4 imageToProbe = *imageToPlane;
  imageToProbe[3] = glm::dvec4(-0.5 * (sequence.width - 1) * glm::dvec3(imageToProbe[0]), 1.0);
  return Transform<frame::Probe, frame::Image>{imageToProbe};
}

/// Poses in the frame of choice, else in the one that the device set names as its reference, where a way leads to it.
Result<SweepPoses> trackedPoses(const Sequence& sequence, const DeviceSet* calibration, const std::string& toFrame) {
  if (!toFrame.empty() || calibration == nullptr || calibration->referenceFrame.empty()) return sweepPoses(sequence, calibration, toFrame);
  auto named = sweepPoses(sequence, calibration, calibration->referenceFrame);
  if (named) {
    named->notes.push_back(say<"The poses of the images are those in the frame %1, which the device set names as its reference.">(
        calibration->referenceFrame));
    return named;
  }
  auto usual = sweepPoses(sequence, calibration, {});
  if (usual)
    usual->notes.push_back(
        say<"The device set names %1 as its reference, but no valid way leads there, so it was not used.">(calibration->referenceFrame));
  return usual;
}

/// Poses of the motor where there is one, else of the tracker.
Result<SweepPoses> acquiredPoses(const Sequence& sequence, const DeviceSet* calibration, const SweepImportOptions& options) {
  if (options.motor.empty() && !options.statedMotor) return trackedPoses(sequence, calibration, options.toFrame);
  auto motor = options.statedMotor               ? Result<MotorSweep>(*options.statedMotor)
               : options.motor == kRecordedMotor ? recordedMotor(sequence)
                                                 : readMotorSweep(options.motor);
  if (!motor) return passOn(motor.error());
  auto poses = motorPoses(sequence, *motor, calibration);
  if (poses || poses.error().code != ErrorCode::missingCalibration) return poses;
  motor->imageToProbe = faceAtUpperEdge(sequence);
  if (!motor->imageToProbe) return poses;
  auto assumed = motorPoses(sequence, *motor, calibration);
  if (assumed)
    assumed->notes.push_back(
        say<"Nobody says where pixels lie before the probe; its face was taken to be at the middle of their upper edge.">());
  return assumed;
}

std::string milliseconds(double time_s) { return textOf(std::round(time_s * 1e4) / 10.0) + " ms"; }

/// @param lost frames that have no pose any more
Message delayTakenAway(const PoseDelay& delay, bool estimated, std::size_t lost) {
  const std::string lag = milliseconds(delay.delay_s), spread = milliseconds(delay.uncertainty_s);
  if (estimated && lost > 0)
    return say<
        "Poses lag %1 behind the images (+- %2, from the %3); they were moved in time, and %4 frames beside gaps and ends have none left.">(
        lag, spread, delay.seenBy, lost);
  if (estimated) return say<"Poses lag %1 behind the images (+- %2, from the %3); they were moved in time.">(lag, spread, delay.seenBy);
  if (lost > 0)
    return say<"Poses lag %1 behind the images; they were moved in time, and %2 frames beside gaps and ends have none left.">(lag, lost);
  return say<"Poses lag %1 behind the images; they were moved in time.">(lag);
}

/// Times of all frames; NaN where one has none.
std::vector<double> timesOf(const Sequence& sequence) {
  std::vector<double> time_s;
  for (const SequenceFrame& frame : sequence.frames) time_s.push_back(frame.time_s.value_or(std::numeric_limits<double>::quiet_NaN()));
  return time_s;
}

/// By how much poses lag, as it was given, else as it is estimated.
Result<PoseDelay> delayOf(const SweepInput& opened, const SweepImportOptions& options, Progress& progress) {
  if (options.poseDelay_s) return PoseDelay{.verdict = DelayVerdict::found, .delay_s = *options.poseDelay_s};
  const Sequence& sequence = opened.sequence;
  std::vector<ImageView<const std::uint8_t>> images;
  for (std::size_t n = 0; n < sequence.frames.size(); ++n)
    images.push_back({sequence.framePixels(n).data(), sequence.width, sequence.height, sequence.width});
  PoseDelayOptions estimating;
  estimating.threads = options.reconstruct.threads;
  return estimatePoseDelay(images, timesOf(sequence), opened.poses.imageToWorld, estimating, progress);
}

/// Moves the recording's own poses in time, and says what was done. Poses of a file of their own were joined with the delay.
Result<void> takeDelayAway(SweepInput& opened, const PoseDelay& delay, const SweepImportOptions& options) {
  const Sequence& sequence = opened.sequence;
  opened.plan.poseDelay = delay;
  if (delay.verdict == DelayVerdict::cannotTell) {
    opened.plan.notes.push_back(say<"By how much the poses lag behind the images cannot be told. %1">(delay.why));
    return {};
  }
  if (!options.poses.empty()) {
    if (!options.poseDelay_s) opened.plan.notes.push_back(delayTakenAway(delay, true, 0));
    return {};
  }
  const glm::dvec2 centre_px(0.5 * (sequence.width - 1), 0.5 * (sequence.height - 1));
  auto moved = posesDelayedBy(delay.delay_s, timesOf(sequence), opened.poses.imageToWorld, centre_px);
  if (!moved) return passOn(moved.error());
  opened.poses.imageToWorld = *std::move(moved);
  const auto usable = static_cast<std::size_t>(
      std::count_if(opened.poses.imageToWorld.begin(), opened.poses.imageToWorld.end(), [](const auto& pose) { return pose.has_value(); }));
  const std::size_t lost = opened.poses.usable - std::min(usable, opened.poses.usable);
  opened.poses.missing += lost;
  opened.poses.usable = usable;
  opened.plan.notes.push_back(delayTakenAway(delay, !options.poseDelay_s, lost));
  if (usable == 0)
    return failure(ErrorCode::noValidPose, say<"With this delay no frame has a pose; check the delay, it is in seconds.">(),
                   {{"field", "delay"}});
  return {};
}

}  // namespace

Result<ReconstructOptions> defaultsFor(std::span<const TrackedFrame> frames, const DeviceSet* calibration, const SweepDefaults& usual,
                                       const ReconstructOptions& said, std::vector<Message>& notes) {
  ReconstructOptions made = said;
  const DeviceSet none;
  const DeviceSet& device = calibration != nullptr ? *calibration : none;
  if (usual.spacing) {
    made.spacing_mm = carriedSpacing_mm(frames);
    if (const auto taken = takeSpacing(device, made); !taken) return passOn(taken.error());
  }
  if (usual.interpolation) {
    made.interpolation = Interpolation::linear;
    if (const auto taken = takeInterpolation(device, made); !taken) return passOn(taken.error());
  }
  if (usual.compounding) {
    made.compounding = Compounding::mean;
    if (const auto taken = takeCompounding(device, made, notes); !taken) return passOn(taken.error());
  }
  if (usual.fillReach) made.fillReach_mm = usualFillReach_mm(frames, made.spacing_mm);
  return made;
}

std::vector<TrackedFrame> posedFrames(const SweepInput& opened) {
  std::vector<TrackedFrame> frames;
  frames.reserve(opened.poses.usable);
  const Sequence& sequence = opened.sequence;
  for (std::size_t n = 0; n < sequence.frames.size(); ++n)
    if (opened.poses.imageToWorld[n])
      frames.push_back({{sequence.framePixels(n).data(), sequence.width, sequence.height, sequence.width}, *opened.poses.imageToWorld[n]});
  return frames;
}

Result<void> checkMeant(const SweepInput& opened) {
  const ImportPlan& plan = opened.plan;
  if (plan.acceptsSmall || plan.smallQuestion.empty()) return {};
  return failure(ErrorCode::unsupported, plan.smallQuestion, {{"file", opened.sweep.string()}, {"ask", "accept-small"}});
}

Result<ConfidenceFrames> weighedFrames(const SweepInput& opened, Progress& progress) {
  if (auto meant = checkMeant(opened); !meant) return passOn(meant.error());
  ConfidenceFrames weighed{posedFrames(opened), {}};
  const ReconstructOptions& options = opened.plan.reconstruct;
  if (options.compounding != Compounding::weighted) return weighed;
  auto maps = confidenceOfFrames(weighed.frames, options.clip, opened.plan.confidence, options.threads, progress);
  if (!maps) return passOn(maps.error());
  weighed.confidence = *std::move(maps);
  for (std::size_t n = 0; n < weighed.frames.size(); ++n) weighed.frames[n].weights = viewOf(std::as_const(weighed.confidence[n]));
  return weighed;
}

std::uint64_t importBytes(const ImportPlan& plan, const Grid& grid, const ReconstructOptions& options) {
  const std::uint64_t frame = plan.frames.total > 0 ? plan.frameBytes / plan.frames.total : 0;
  const std::uint64_t maps = options.compounding == Compounding::weighted ? frame * plan.frames.used : 0;
  return plan.frameBytes + maps + forecastBytes(grid, options);
}

namespace {

Result<std::optional<DeviceSet>> deviceOf(const SweepImportOptions& options) {
  std::optional<DeviceSet> device;
  if (options.calibrations.empty()) return device;
  auto read = readDeviceSets(options.calibrations);
  if (!read) return passOn(read.error());
  device = std::move(*read);
  return device;
}

/// A clip that reaches beyond the images, whoever gives it, was made for others.
Result<void> checkStated(const Clip& clip, const Sequence& sequence) {
  // Writers count the last pixel in or out.
  if (!clip.size_px ||
      (clip.origin_px.x + clip.size_px->x <= sequence.width + 1.0 && clip.origin_px.y + clip.size_px->y <= sequence.height + 1.0))
    return {};
  return failure(ErrorCode::badField,
                 say<"The clip rectangle of %1 x %2 px from (%3, %4) on reaches beyond the %5 x %6 px frame, so that it was made for other "
                     "images; give one that lies inside, or take the whole frame.">(textOf(clip.size_px->x), textOf(clip.size_px->y),
                                                                                    textOf(clip.origin_px.x), textOf(clip.origin_px.y),
                                                                                    sequence.width, sequence.height),
                 {{"field", "ClipRectangleSize"}});
}

/// The files beside the images that say where they lie.
struct PlacingFiles {
  std::optional<DeviceSet> device = {};
  std::optional<Sequence> poses = {};  ///< where they are not those of the images' file
  [[nodiscard]] const DeviceSet* calibration() const { return device ? &*device : nullptr; }
};

Result<PlacingFiles> placingFilesOf(const SweepImportOptions& options, Progress& progress) {
  PlacingFiles files;
  auto device = deviceOf(options);
  if (!device) return passOn(device.error());
  files.device = *std::move(device);
  if (options.poses.empty()) return files;
  if (!options.motor.empty() || options.statedMotor)
    return failure(ErrorCode::badUsage, say<"Poses cannot come from a motor and from a file of their own; give one of them.">());
  auto poses = readPoses(options.poses, progress, {options.reconstruct.maxBytes});
  if (!poses) return passOn(poses.error());
  if (files.device)
    if (auto fits = checkPixelsOf(*poses, *files.device, options.poses); !fits) return passOn(fits.error());
  files.poses = *std::move(poses);
  return files;
}

/// Whether images of which the header alone is known can be placed.
Result<void> checkPlaced(const Sequence& described, const PlacingFiles& files, const SweepImportOptions& options) {
  if (const auto checked = checkImages(described); !checked) return passOn(checked.error());
  if (holdsScanLines(described)) return {};
  Sequence joined = described;
  if (files.poses) {
    if (options.imageRate_hz) timeEvenly(joined, *options.imageRate_hz);
    if (const auto notes = joinPoses(joined, *files.poses, options.poseDelay_s.value_or(0.0), options.poses); !notes)
      return passOn(notes.error());
  }
  const auto poses = acquiredPoses(joined, files.calibration(), options);
  return poses ? Result<void>() : passOn(poses.error());
}

/// Finds the pose of every image, after joining poses of a file of their own at this offset.
Result<void> placeImages(SweepInput& opened, const PlacingFiles& files, double offset_s, const SweepImportOptions& options) {
  if (opened.ownFrames.empty() && files.poses) opened.ownFrames = opened.sequence.frames;
  if (!opened.ownFrames.empty()) opened.sequence.frames = opened.ownFrames;
  std::vector<Message> joining;
  if (files.poses) {
    if (options.imageRate_hz) timeEvenly(opened.sequence, *options.imageRate_hz);
    auto joined = joinPoses(opened.sequence, *files.poses, offset_s, options.poses);
    if (!joined) return passOn(joined.error());
    joining = *std::move(joined);
  }
  auto poses = acquiredPoses(opened.sequence, files.calibration(), options);
  if (!poses) return passOn(poses.error());
  opened.poses = *std::move(poses);
  opened.poses.notes.insert(opened.poses.notes.begin(), joining.begin(), joining.end());
  return {};
}

/// Places the images and finds out how far poses lag behind them, where that is asked for.
Result<std::optional<PoseDelay>> placeInTime(SweepInput& opened, const PlacingFiles& files, const SweepImportOptions& options,
                                             Progress& progress) {
  if (auto placed = placeImages(opened, files, options.poseDelay_s.value_or(0.0), options); !placed) return passOn(placed.error());
  if (!options.poseDelay_s && !options.estimatePoseDelay) return std::optional<PoseDelay>();
  auto delay = delayOf(opened, options, progress);
  if (!delay) return passOn(delay.error());
  const bool isFoundOut = !options.poseDelay_s && delay->verdict == DelayVerdict::found;
  if (files.poses && isFoundOut)
    if (auto placed = placeImages(opened, files, delay->delay_s, options); !placed) return passOn(placed.error());
  return std::optional<PoseDelay>(*std::move(delay));
}

/// How much of the recording the plan keeps, how large it gets, and what there is to ask about it.
Result<void> tellKept(SweepInput& opened, std::span<const TrackedFrame> frames, const SweepImportOptions& options) {
  const Sequence& sequence = opened.sequence;
  ImportPlan& plan = opened.plan;
  plan.frames = {sequence.frames.size(), opened.poses.usable, opened.poses.invalid, opened.poses.missing};
  const auto spans = ClipSpans::of(plan.reconstruct.clip, sequence.width, sequence.height);
  if (!spans) return passOn(spans.error());
  plan.kept = {.pixels = spans->pixelCount(),
               .pixelsOf = static_cast<std::uint64_t>(sequence.width) * static_cast<std::uint64_t>(sequence.height),
               .frames = plan.frames.used,
               .framesOf = plan.frames.total};
  const auto clipped = clipRectangle(plan.reconstruct.clip, sequence.width, sequence.height);
  if (!clipped) return passOn(clipped.error());
  plan.smallQuestion = questionAboutSize(frames, *clipped, plan.reconstruct.spacing_mm);
  const bool isTracked = options.motor.empty() && !options.statedMotor;
  if (plan.smallQuestion.empty() && isTracked) plan.smallQuestion = questionAboutMovement(frames, *clipped, plan.reconstruct.spacing_mm);
  if (plan.smallQuestion.empty()) plan.smallQuestion = questionAbout(plan.kept, opened.sweep);
  plan.acceptsSmall = options.acceptsSmall;
  if (!plan.smallQuestion.empty()) plan.notes.push_back(plan.smallQuestion);
  return {};
}

/// Everything about an opened sweep but its pixels.
Result<void> arrange(SweepInput& opened, const PlacingFiles& files, const SweepImportOptions& options, Progress& progress) {
  const DeviceSet* const calibration = files.calibration();
  opened.plan = {};
  std::optional<Clip> sector = opened.sectorOfScanLines;
  std::vector<Message> sectorNotes;
  if (!sector && options.clipFromCalibration) {
    const auto stated = clipStatedIn(opened.sequence);
    if (!stated) return passOn(stated.error());
    sectorNotes = stated->notes;
    sector = clipOf(*stated, ClipSaidBy::recording, sectorNotes);
    if (!sector) opened.plan.notes.insert(opened.plan.notes.end(), sectorNotes.begin(), sectorNotes.end());
  }
  const auto delay = placeInTime(opened, files, options, progress);
  if (!delay) return passOn(delay.error());
  ImportPlan& plan = opened.plan;
  for (const auto* notes : {&opened.readNotes, &opened.poses.notes, &opened.turnNotes})
    plan.notes.insert(plan.notes.end(), notes->begin(), notes->end());
  if (calibration != nullptr) plan.notes.insert(plan.notes.end(), calibration->notes.begin(), calibration->notes.end());
  if (*delay)
    if (const auto moved = takeDelayAway(opened, **delay, options); !moved) return passOn(moved.error());
  const auto frames = posedFrames(opened);
  ReconstructOptions said = options.reconstruct;
  if (options.clipFromCalibration && calibration != nullptr)
    if (auto clip = clipOf(*calibration, ClipSaidBy::deviceSet, plan.notes)) {
      if (auto fits = checkStated(*clip, opened.sequence); !fits) return fits;
      said.clip = *clip;
    }
  if (auto fits = checkStated(options.reconstruct.clip, opened.sequence); !fits) return fits;
  auto made = defaultsFor(frames, calibration, options.usual, said, plan.notes);
  if (!made) return passOn(made.error());
  plan.reconstruct = *made;
  if (sector && plan.reconstruct.clip == Clip{}) {
    if (auto fits = checkStated(*sector, opened.sequence); !fits) return fits;
    plan.reconstruct.clip = *sector;
    plan.notes.insert(plan.notes.end(), sectorNotes.begin(), sectorNotes.end());
  }
  if (options.looksForFan && plan.reconstruct.clip == Clip{}) {
    auto fan = fanOf(opened.sequence, progress);
    if (!fan) return passOn(fan.error());
    if (*fan) {
      plan.reconstruct.clip.fan = **fan;
      plan.notes.push_back(say<"The images show a fan of %1 degrees; what lies around it is not taken.">(
          textOf(std::round(10.0 * glm::degrees((*fan)->rightAngle_rad - (*fan)->leftAngle_rad)) / 10.0)));
    }
  }
  if (auto told = tellKept(opened, frames, options); !told) return told;
  if (options.fillReach_voxels) plan.reconstruct.fillReach_mm = *options.fillReach_voxels * plan.reconstruct.spacing_mm;
  plan.toFrame = opened.poses.toFrame;

  ReconstructOptions unlimited = plan.reconstruct;
  unlimited.maxBytes = std::numeric_limits<std::uint64_t>::max();
  const auto grid = gridFor(frames, unlimited);
  if (!grid) return passOn(grid.error());
  if (grid->voxelCount() == 1)
    return failure(ErrorCode::badField,
                   say<"With voxels of %1 mm the whole recording would be one voxel; use a finer spacing, or check the calibration for a "
                       "wrong scale.">(figureText(plan.reconstruct.spacing_mm)),
                   {{"field", "spacing"}});
  plan.grid = *grid;
  plan.frameBytes = opened.sequence.pixels.size();
  plan.confidence = options.confidence;
  plan.bytes = importBytes(plan, plan.grid, plan.reconstruct);
  plan.fits = plan.bytes <= plan.reconstruct.maxBytes;
  return {};
}

}  // namespace

Result<SweepInput> openSweep(const std::filesystem::path& sweep, const SweepImportOptions& options, Progress& progress) {
  const auto started = Clock::now();
  const auto files = placingFilesOf(options, progress);
  if (!files) return passOn(files.error());
  // Before minutes of reading: what the header says tells already whether images and a way into the world are there.
  const auto usable = [&](const Sequence& described) { return checkPlaced(described, *files, options); };
  const ReaderLimits limits{options.reconstruct.maxBytes};
  auto sequence =
      files->poses ? readImages(sweep, options.imageRate_hz, progress, limits, usable) : readSequence(sweep, progress, limits, usable);
  if (!sequence) return passOn(sequence.error());
  SweepInput opened;
  opened.sweep = sweep;
  if (holdsScanLines(*sequence)) {
    const auto geometry = lineGeometryOf(*sequence, files->calibration());
    if (!geometry) return passOn(geometry.error());
    auto converted = convertLines(std::move(*sequence), *geometry, options.reconstruct.threads, progress, options.reconstruct.maxBytes);
    if (!converted) return passOn(converted.error());
    sequence = std::move(converted);
    opened.sectorOfScanLines = clipOf(*geometry);
    opened.readNotes.push_back(say<"The recording holds scan lines; they were converted to images of %1 x %2 pixels of %3 mm.">(
        sequence->width, sequence->height, figureText(geometry->pixel_mm)));
  }
  opened.readNotes.insert(opened.readNotes.begin(), sequence->notes.begin(), sequence->notes.end());
  opened.sequence = std::move(*sequence);
  if (const auto turned = turnToMarkerFar(opened.sequence, opened.turnNotes, progress); !turned) return passOn(turned.error());
  if (const auto arranged = arrange(opened, *files, options, progress); !arranged) return passOn(arranged.error());
  opened.readSeconds = secondsSince(started);
  return opened;
}

Result<void> planAgain(SweepInput& opened, const SweepImportOptions& options, Progress& progress) {
  EW_EXPECTS(!opened.sectorOfScanLines);
  const auto files = placingFilesOf(options, progress);
  if (!files) return passOn(files.error());
  return arrange(opened, *files, options, progress);
}

Result<SweepImport> importSweep(SweepInput opened, Progress& progress) {
  const glm::ivec3 dims = opened.plan.grid.dims;
  if (!opened.plan.fits)
    return failure(
        ErrorCode::tooLarge,
        say<"The volume would have %1 x %2 x %3 voxels and need %4 of memory with the frames, more than the %5 that a volume may take; use "
            "a coarser spacing.">(dims.x, dims.y, dims.z, mebibytesText(static_cast<double>(opened.plan.bytes)),
                                  mebibytesText(static_cast<double>(opened.plan.reconstruct.maxBytes))),
        {{"bytes", std::to_string(opened.plan.bytes)}, {"maxBytes", std::to_string(opened.plan.reconstruct.maxBytes)}});
  const bool weighing = opened.plan.reconstruct.compounding == Compounding::weighted;
  PartOfProgress before(progress, 0.0, weighing ? 0.4 : 0.0), making(progress, weighing ? 0.4 : 0.0, 1.0);
  const auto weighed = weighedFrames(opened, before);
  if (!weighed) return passOn(weighed.error());
  auto reconstruction = reconstruct(weighed->frames, opened.plan.reconstruct, making);
  if (!reconstruction) return passOn(reconstruction.error());
  return SweepImport{std::move(*reconstruction), std::move(opened.plan)};
}

}  // namespace ew
