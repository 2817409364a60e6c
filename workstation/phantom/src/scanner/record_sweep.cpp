#include "scanner/record_sweep.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>

#include "ew/core/numbers.h"
#include "ew/core/parallel.h"
#include "ew/core/word_table.h"
#include "ew/imaging/scan_conversion.h"
#include "ew/io/gating_fields.h"
#include "ew/phantom/contact_pressure.h"
#include "patient/skin_contact.h"
#include "scanner/tracker_errors.h"
#include "scanner/trajectory.h"

namespace ew {
namespace phantom {
namespace {

constexpr double kRad_deg = 180.0 / std::numbers::pi;
constexpr int kMargin_px = 2;
constexpr int kLargestSide_px = 8192;

double depthOf(const Probe& probe, const SweepRecipe& recipe) {
  return recipe.formation.depth_mm > 0.0 ? recipe.formation.depth_mm : probe.defaultDepth_mm;
}

double imagePixelOf(const Probe& probe, const SweepRecipe& recipe) {
  return recipe.pixel_mm > 0.0 && !recipe.scanLines ? recipe.pixel_mm : depthOf(probe, recipe) / 512.0;
}

/// Samples that are written of a line, first and last at its ends.
int writtenSamplesOf(const Probe& probe, const SweepRecipe& recipe) {
  const double depth_mm = depthOf(probe, recipe);
  const double apart_mm = recipe.pixel_mm > 0.0 ? recipe.pixel_mm : depth_mm / 1024.0;
  return 1 + std::max(1, static_cast<int>(std::lround(std::min(depth_mm / apart_mm, 1e6))));
}

std::string listOf(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : " ") + textOf(number);
  return text;
}

std::string listOf(const glm::dmat4& matrix) {
  std::string text;
  for (const double number : rowsOf(matrix)) text += (text.empty() ? "" : " ") + textOf(number);
  return text;
}

Result<SweepForecast> forecast(const Patient& patient, const Probe& probe, const SweepRecipe& recipe) {
  const double depth_mm = depthOf(probe, recipe);
  if (!(depth_mm >= probe.minDepth_mm && depth_mm <= probe.maxDepth_mm))
    return failure(ErrorCode::badField,
                   say<"The sweep asks for a depth of %1 mm, but %2 sees from %3 to %4 mm; change machine.depth_mm or the probe.">(
                       textOf(depth_mm), probe.id, textOf(probe.minDepth_mm), textOf(probe.maxDepth_mm)),
                   {{"field", "machine.depth_mm"}, {"found", textOf(depth_mm)}});
  if (recipe.frames < 1 || !(recipe.framesPerSecond > 0.0))
    return failure(ErrorCode::badField, say<"The sweep has no frames or no frame rate; give at least one frame and a rate above 0.">(),
                   {{"field", "frames"}});
  if ((recipe.breathing || recipe.pulsating || recipe.ecg || recipe.respiration) && !moves(patient))
    return failure(ErrorCode::badField,
                   say<"The sweep asks for breath, pulse or their signals, but this patient's recipe describes no motion; switch "
                       "breathing, pulsating, ecg and respiration off or describe the motion.">(),
                   {{"field", "breathing"}});
  SweepForecast result{.frames = recipe.frames};
  const DisplayGeometry image = imageOf(probe, depth_mm, imagePixelOf(probe, recipe));
  result.width_px = recipe.scanLines ? writtenSamplesOf(probe, recipe) : image.width;
  result.height_px = recipe.scanLines ? probe.lines : image.height;
  if (result.width_px > kLargestSide_px || result.height_px > kLargestSide_px)
    return failure(ErrorCode::tooLarge,
                   say<"Frames of this sweep would be %1 x %2 pixels, but a side may have %3 at most; use a larger pixel_mm.">(
                       result.width_px, result.height_px, kLargestSide_px),
                   {{"field", "pixel_mm"}});
  // Beside the frames: the table of the conversion, and some beams per processor at about eight samples a wavelength.
  const double carrier_hz = recipe.formation.carrier_hz > 0.0 ? recipe.formation.carrier_hz : probe.carrier_hz;
  const double samples = 8.0 * depth_mm * carrier_hz / 1.54e6;
  const auto pixels = static_cast<std::uint64_t>(result.width_px) * static_cast<std::uint64_t>(result.height_px);
  result.bytes = pixels * static_cast<std::uint64_t>(recipe.frames) + 8 * pixels +
                 static_cast<std::uint64_t>(static_cast<double>(threadCount(0)) * 32.0 * samples * probe.lines);
  return result;
}

/// As recordings name the way a motor moves.
constexpr WordTable<SweepKind, 4> kSweepKindWords{
    {{"", SweepKind::freehand}, {"PARALLEL", SweepKind::parallel}, {"FAN", SweepKind::fan}, {"ROTATIONAL", SweepKind::rotational}}};
const char* motorWordOf(SweepKind kind) { return wordIn(kSweepKindWords, kind); }

/// Fields of the whole recording.
void describe(const Probe& probe, const SweepRecipe& recipe, const Trajectory& trajectory, const DisplayGeometry& image,
              Sequence& sequence) {
  const auto add = [&](std::string_view name, std::string value) { sequence.otherFields.emplace_back(name, std::move(value)); };
  if (!recipe.name.empty()) add("SweepName", recipe.name);
  add("SweepOrigin", "virtual patient, simulation, not for diagnosis");
  add("ProbeName", probe.id);
  if (recipe.kind != SweepKind::freehand) {
    add(fields::kMotorKind, motorWordOf(recipe.kind));
    if (recipe.kind == SweepKind::fan) add(fields::kMotorAxisBehindFace, textOf(recipe.axisBehindFace_mm));
    add(fields::kMotorStart, listOf(trajectory.start().matrix));
  }
  if (!recipe.scanLines) return;
  if (isSector(probe.kind)) {
    add(fields::kTransducerGeometry, "CURVILINEAR");
    add(fields::kRadiusStart, textOf(probe.radius_mm));
    add(fields::kRadiusStop, textOf(probe.radius_mm + image.depth_mm));
    add(fields::kThetaStart, textOf(-probe.halfAngle_rad * kRad_deg));
    add(fields::kThetaStop, textOf(probe.halfAngle_rad * kRad_deg));
  } else {
    add(fields::kTransducerGeometry, "LINEAR");
    add(fields::kImagingDepth, textOf(image.depth_mm));
    add(fields::kTransducerWidth, textOf(probe.width_mm));
  }
  add(fields::kOutputSpacing, listOf({image.pixel_mm, image.pixel_mm}));
  add(fields::kOutputSize, std::to_string(image.width) + " " + std::to_string(image.height));
  add(fields::kTransducerCentre, listOf({image.face_px.x, image.face_px.y}));
}

DeviceSet deviceSetOf(const Probe& probe, const DisplayGeometry& image, const glm::dmat4& writtenImageToProbe) {
  DeviceSet set;
  set.transforms.push_back({"Image", "Probe", writtenImageToProbe, PoseStatus::ok});
  set.clipOrigin_px = glm::dvec2(0.0);
  set.clipSize_px = glm::dvec2(image.width, image.height);
  if (isSector(probe.kind)) {
    set.fanAngles_deg = glm::dvec2(-probe.halfAngle_rad, probe.halfAngle_rad) * kRad_deg;
    set.fanOrigin_px = image.face_px - glm::dvec2(0.0, probe.radius_mm / image.pixel_mm);
    set.fanRadiusStart_px = probe.radius_mm / image.pixel_mm;
    set.fanRadiusStop_px = (probe.radius_mm + image.depth_mm) / image.pixel_mm;
    return set;
  }
  const glm::dvec2 half(0.5 * probe.width_mm / image.pixel_mm, 0.0);
  const glm::dvec2 first = glm::ceil(image.face_px - half - 1e-6);
  const glm::dvec2 last = glm::floor(image.face_px + half + glm::dvec2(0.0, image.depth_mm / image.pixel_mm) + 1e-6);
  set.clipOrigin_px = first;
  set.clipSize_px = last - first + 1.0;
  return set;
}

/// The sector in the recording itself, for whoever has no device set beside it.
void describeClip(const DeviceSet& set, Sequence& sequence) {
  const auto add = [&](std::string_view name, std::string value) { sequence.otherFields.emplace_back(name, std::move(value)); };
  add(fields::kClipOrigin, listOf({set.clipOrigin_px->x, set.clipOrigin_px->y}));
  add(fields::kClipSize, listOf({set.clipSize_px->x, set.clipSize_px->y}));
  if (!set.fanAngles_deg) return;
  add(fields::kFanAngles, listOf({set.fanAngles_deg->x, set.fanAngles_deg->y}));
  add(fields::kFanOrigin, listOf({set.fanOrigin_px->x, set.fanOrigin_px->y}));
  add(fields::kFanRadiusStart, textOf(*set.fanRadiusStart_px));
  add(fields::kFanRadiusStop, textOf(*set.fanRadiusStop_px));
}

SequenceFrame frameOf(const Patient& patient, const SweepRecipe& recipe, const Trajectory& trajectory, const Pose& tracked,
                      double unfilteredTime_s, const glm::dmat4& writtenImageToProbe) {
  SequenceFrame frame;
  frame.time_s = tracked.time_s;
  frame.transforms.push_back({"Probe", "Reference", tracked.probeToWorld.matrix, tracked.status});
  frame.transforms.push_back({"Image", "Probe", writtenImageToProbe, PoseStatus::ok});
  const auto add = [&](std::string_view name, double value) { frame.otherFields.emplace_back(name, textOf(value)); };
  add("UnfilteredTimestamp", unfilteredTime_s);
  if (recipe.ecg) add(fields::kEcg, ecgAt_mv(patient, tracked.time_s));
  if (recipe.respiration) add(fields::kRespiration, stateAt(patient, tracked.time_s).breath);
  if (recipe.kind == SweepKind::parallel) add(fields::kMotorPosition, trajectory.motorAt(tracked.time_s));
  if (recipe.kind == SweepKind::fan || recipe.kind == SweepKind::rotational) add(fields::kMotorAngle, trajectory.motorAt(tracked.time_s));
  return frame;
}

/// The push of a face that was put on the skin and then pressed in along its central beam.
ContactPressure pressureOf(const Patient& patient, const Probe& probe, const Transform<frame::World, frame::Probe>& probeToWorld,
                           double indentation_mm) {
  constexpr int kFacePoints = 33;
  constexpr double kFarthestSkin_mm = 100.0;
  if (indentation_mm <= 0.0) return {probe, probeToWorld, 0.0};
  auto touching = probeToWorld;
  touching.matrix[3] -= indentation_mm * touching.matrix[1];
  return {probe, probeToWorld, indentation_mm, gapsToSkin_mm(*patient.skin, probe, touching, kFacePoints, kFarthestSkin_mm)};
}

/// Breath and pulse, then the probe's pressure.
class WhileRecording final : public Deformation {
 public:
  WhileRecording(std::unique_ptr<Deformation> body, ContactPressure pressure)
      : body_(std::move(body)), pressure_(std::move(pressure)), both_(body_ ? *body_ : restingBody(), pressure_) {}
  [[nodiscard]] glm::dvec3 moved(const glm::dvec3& rest_mm) const override { return both_.moved(rest_mm); }
  [[nodiscard]] glm::dvec3 rest(const glm::dvec3& moved_mm) const override { return both_.rest(moved_mm); }
  [[nodiscard]] double reach_mm() const override { return both_.reach_mm(); }

 private:
  std::unique_ptr<Deformation> body_;
  ContactPressure pressure_;
  DeformationChain both_;
};

/// What a worker needs for itself.
struct Bench {
  std::unique_ptr<VirtualScanner::Scratch> scratch;
  Image<float> envelope;
  BeamImage levels;
};

void toLevels(const Image<float>& envelope, double dynamicRange_db, BeamImage& levels) {
  levels.width = envelope.width;
  levels.height = envelope.height;
  levels.pixels.resize(envelope.pixels.size());
  const auto slope = static_cast<float>(255.0 / dynamicRange_db * 20.0);
  for (std::size_t n = 0; n < levels.pixels.size(); ++n)
    levels.pixels[n] = std::clamp(255.0F + slope * std::log10(std::max(envelope.pixels[n], 1e-20F)), 0.0F, 255.0F);
}

/// One line a row, samples along the row; between the machine's samples in a straight line.
void writeLines(const BeamImage& levels, int samples, std::uint8_t* out) {
  for (int line = 0; line < levels.width; ++line) {
    for (int s = 0; s < samples; ++s) {
      const double at = static_cast<double>(s) * (levels.height - 1) / (samples - 1);
      const int above = std::min(static_cast<int>(at), levels.height - 2);
      const auto below = static_cast<float>(at - above);
      const auto index = static_cast<std::size_t>(above) * static_cast<std::size_t>(levels.width) + static_cast<std::size_t>(line);
      const float level = (1.0F - below) * levels.pixels[index] + below * levels.pixels[index + static_cast<std::size_t>(levels.width)];
      *out++ = static_cast<std::uint8_t>(std::lround(level));
    }
  }
}

tl::unexpected<Error> recordingStopped() { return failure(ErrorCode::cancelled, say<"Recording the sweep was stopped.">()); }

/// Fresh memory is slow to touch: bit by bit, so that the wish to cancel is heard.
Result<void> makeRoom(std::size_t frames, const Progress& progress, Sequence& sequence) {
  const std::size_t framePixels = static_cast<std::size_t>(sequence.width) * static_cast<std::size_t>(sequence.height);
  try {
    sequence.pixels.reserve(frames * framePixels);
    for (std::size_t n = 0; n < frames; ++n) {
      if (progress.cancelRequested()) return recordingStopped();
      sequence.pixels.resize((n + 1) * framePixels);
    }
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::tooLarge, say<"There is not enough memory for the frames of this sweep; use fewer or a larger pixel_mm.">());
  }
  sequence.frames.resize(frames);
  return {};
}

}  // namespace

DisplayGeometry imageOf(const Probe& probe, double depth_mm, double pixel_mm) {
  Knobs knobs;
  knobs.depth_mm = depth_mm;
  glm::dvec2 lowest(0.0), highest(0.0);
  for (const glm::dvec2& point : fanOutline_mm(probe, knobs, depth_mm, 257)) {
    lowest = glm::min(lowest, point);
    highest = glm::max(highest, point);
  }
  DisplayGeometry image;
  image.pixel_mm = pixel_mm;
  image.markerLeft = false;
  image.depth_mm = depth_mm;
  const auto pixels = [&](double length_mm) { return static_cast<int>(std::min(std::ceil(length_mm / pixel_mm - 1e-6), 1e6)); };
  const int halfWidth = pixels(std::max(-lowest.x, highest.x)) + kMargin_px;
  const int above = pixels(-lowest.y) + kMargin_px;
  image.width = 2 * halfWidth + 1;
  image.height = above + pixels(highest.y) + kMargin_px + 1;
  image.face_px = {halfWidth, above};
  return image;
}

Result<VirtualSweep> recordWith(const VirtualScanner& scanner, const Patient& patient, const SweepRecipe& recipe, int threads,
                                Progress& progress, std::uint64_t maxBytes) {
  const Probe& probe = scanner.probe();
  const auto expected = forecast(patient, probe, recipe);
  if (!expected) return passOn(expected.error());
  if (expected->bytes > maxBytes)
    return failure(ErrorCode::tooLarge,
                   say<"Recording this sweep takes %1 MiB, but only %2 MiB may be used; use fewer frames or a larger pixel_mm.">(
                       expected->bytes >> 20, maxBytes >> 20),
                   {{"bytes", std::to_string(expected->bytes)}, {"limit", std::to_string(maxBytes)}});
  auto trajectory = Trajectory::along(patient, probe, recipe);
  if (!trajectory) return passOn(trajectory.error());

  const DisplayGeometry image = imageOf(probe, depthOf(probe, recipe), imagePixelOf(probe, recipe));
  VirtualSweep sweep;
  sweep.imageToProbe = image.imageToProbe().matrix;
  const glm::dmat4 writtenImageToProbe = recipe.tracker.calibrationError * sweep.imageToProbe;
  sweep.deviceSet = deviceSetOf(probe, image, writtenImageToProbe);
  Sequence& sequence = sweep.sequence;
  sequence.width = expected->width_px;
  sequence.height = expected->height_px;
  sequence.orientation = recipe.scanLines ? "FM" : "MF";
  sequence.imageType = "BRIGHTNESS";
  describe(probe, recipe, *trajectory, image, sequence);
  if (!recipe.scanLines) describeClip(sweep.deviceSet, sequence);

  const auto frames = static_cast<std::size_t>(recipe.frames);
  if (auto room = makeRoom(frames, progress, sequence); !room) return passOn(room.error());
  sweep.trueProbeToWorld.resize(frames);
  sweep.trueTime_s.resize(frames);
  sweep.trueState.resize(frames);
  PartOfProgress moving(progress, 0.0, 0.02), recording(progress, 0.02, 1.0);
  const auto tracked = track(*trajectory, recipe, threads, moving);
  if (!tracked) return recordingStopped();
  Knobs knobs;
  knobs.depth_mm = image.depth_mm;
  const ScanConversionTable conversion = recipe.scanLines ? ScanConversionTable{} : makeScanConversion(probe, knobs, scanner.grid(), image);

  const std::size_t framePixels = static_cast<std::size_t>(sequence.width) * static_cast<std::size_t>(sequence.height);
  std::vector<Bench> benches(static_cast<std::size_t>(threadCount(threads)));
  const bool finished =
      forEachTask(recipe.frames, threads, recording, say<"Recording the sweep">(), [&](int task, int worker, const auto& isStopped) {
        const auto n = static_cast<std::size_t>(task);
        Bench& bench = benches[static_cast<std::size_t>(worker)];
        if (!bench.scratch) bench.scratch = scanner.makeScratch();
        const double time_s = tracked->poses[n].time_s;
        const auto probeToWorld = trajectory->poseAt(time_s);
        sweep.trueTime_s[n] = time_s;
        sweep.trueProbeToWorld[n] = probeToWorld;
        const BodyState state = stateAt(patient, time_s);
        sweep.trueState[n] = {.breath = recipe.breathing ? state.breath : 0.0, .pulse = recipe.pulsating ? state.pulse : 0.0};

        const auto deformation = deformationOf(patient, probe, recipe, probeToWorld, sweep.trueState[n]);
        bench.scratch->stopped = isStopped;
        scanner.envelope(probeToWorld, *deformation, static_cast<std::uint64_t>(task), *bench.scratch, bench.envelope);
        if (bench.envelope.pixels.empty()) return;
        toLevels(bench.envelope, scanner.options().dynamicRange_db, bench.levels);
        std::uint8_t* out = sequence.pixels.data() + n * framePixels;
        if (recipe.scanLines) {
          writeLines(bench.levels, sequence.width, out);
        } else {
          scanConvert(conversion, viewOf(std::as_const(bench.levels)), 0, image.height, {out, image.width, image.height, image.width});
        }
        sequence.frames[n] = frameOf(patient, recipe, *trajectory, tracked->poses[n], tracked->unfilteredTime_s[n], writtenImageToProbe);
      });
  if (!finished) return recordingStopped();
  return sweep;
}

}  // namespace phantom

std::unique_ptr<Deformation> deformationOf(const Patient& patient, const Probe& probe, const SweepRecipe& recipe,
                                           const Transform<frame::World, frame::Probe>& probeToWorld, const BodyState& state) {
  const bool lives = recipe.breathing || recipe.pulsating;
  const bool pressed = recipe.onSkin && recipe.indentation_mm > 0.0;
  return std::make_unique<phantom::WhileRecording>(
      lives ? bodyMotion(patient, state) : nullptr,
      phantom::pressureOf(patient, probe, probeToWorld, pressed ? recipe.indentation_mm : 0.0));
}

Result<SweepForecast> forecastSweep(const Patient& patient, const Probe& probe, const SweepRecipe& recipe) {
  auto expected = phantom::forecast(patient, probe, recipe);
  if (!expected) return expected;
  if (auto trajectory = phantom::Trajectory::along(patient, probe, recipe); !trajectory) return passOn(trajectory.error());
  return expected;
}

}  // namespace ew
