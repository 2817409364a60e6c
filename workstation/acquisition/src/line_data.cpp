#include "ew/acquisition/line_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>

#include "ew/core/figures.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/core/parallel.h"
#include "ew/imaging/scan_conversion.h"
#include "ew/io/gating_fields.h"

namespace ew {
namespace {

constexpr std::string_view kPrefix = "ScanConversion";

/// Looks a field up in the recording, then in the device set, whose names lack the prefix.
class Stated {
 public:
  Stated(const Sequence& sequence, const DeviceSet* device) : sequence_(sequence), device_(device) {}

  [[nodiscard]] std::optional<std::string> text(std::string_view name) const {
    for (const auto& [field, value] : sequence_.otherFields)
      if (field == name) return value;
    if (device_ == nullptr) return std::nullopt;
    for (const auto& [field, value] : device_->scanConversion)
      if (field == name.substr(kPrefix.size())) return value;
    return std::nullopt;
  }

  std::vector<double> numbers(std::string_view name, std::size_t count, double lowest, double highest) {
    const auto found = text(name);
    std::vector<double> read;
    if (found) {
      std::istringstream in(*found);
      in.imbue(std::locale::classic());
      for (double value = 0.0; in >> value;) read.push_back(value);
      if (!in.eof()) read.clear();
    }
    const bool usable = read.size() == count && std::all_of(read.begin(), read.end(), [&](double value) {
                          return std::isfinite(value) && value >= lowest && value <= highest;
                        });
    if (usable) return read;
    if (!problem_) {
      const std::string field(name);
      const Message needed =
          count == 1 ? rangeText(lowest, highest) : say<"%1 numbers from %2 to %3">(count, textOf(lowest), textOf(highest));
      problem_ = Error{
          ErrorCode::badField,
          found ? say<"The scan lines' %1 is \"%2\"; give a device set whose ScanConversion says it with %3.">(field, *found, needed)
                : say<"The recording holds scan lines and does not say their %1; give a device set whose ScanConversion says it with %2.">(
                      field, needed),
          {{"field", field}, {"found", found.value_or("")}}};
    }
    return std::vector<double>(count, lowest);
  }
  double number(std::string_view name, double lowest, double highest) { return numbers(name, 1, lowest, highest).front(); }

  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

 private:
  const Sequence& sequence_;
  const DeviceSet* device_;
  std::optional<Error> problem_;
};

/// The probe whose beam grid these lines are.
Probe probeOf(const LineGeometry& geometry, int lines) {
  Probe probe;
  probe.lines = lines;
  if (geometry.curvilinear) {
    probe.kind = ProbeKind::convex;
    probe.radius_mm = geometry.radiusStart_mm;
    probe.halfAngle_rad = geometry.theta_rad;
  } else {
    probe.kind = ProbeKind::linear;
    probe.width_mm = geometry.transducerWidth_mm;
  }
  return probe;
}

double depthOf_mm(const LineGeometry& geometry) {
  return geometry.curvilinear ? geometry.radiusStop_mm - geometry.radiusStart_mm : geometry.imagingDepth_mm;
}

}  // namespace

bool holdsScanLines(const Sequence& sequence) {
  return sequence.orientation.size() >= 2 && (sequence.orientation[0] == 'F' || sequence.orientation[0] == 'N');
}

Result<LineGeometry> lineGeometryOf(const Sequence& sequence, const DeviceSet* device) {
  Stated stated(sequence, device);
  LineGeometry geometry;
  const std::string kind = stated.text(fields::kTransducerGeometry).value_or("");
  if (kind != "CURVILINEAR" && kind != "LINEAR")
    return failure(ErrorCode::badField,
                   kind.empty() ? say<"The recording holds scan lines and does not say where they lie; give a device set whose "
                                      "ScanConversion has TransducerGeometry=\"CURVILINEAR\" or \"LINEAR\".">()
                                : say<"The scan lines' TransducerGeometry is \"%1\"; give a device set whose ScanConversion has "
                                      "TransducerGeometry=\"CURVILINEAR\" or \"LINEAR\".">(kind),
                   {{"field", std::string(fields::kTransducerGeometry)}, {"found", kind}});
  geometry.curvilinear = kind == "CURVILINEAR";
  constexpr double kLargest_mm = 1000.0;
  if (geometry.curvilinear) {
    geometry.radiusStart_mm = stated.number(fields::kRadiusStart, 0.0, kLargest_mm);
    geometry.radiusStop_mm = stated.number(fields::kRadiusStop, geometry.radiusStart_mm + 0.1, 2 * kLargest_mm);
    const double start_deg = stated.number(fields::kThetaStart, -90.0, 90.0), stop_deg = stated.number(fields::kThetaStop, -90.0, 90.0);
    if (!stated.problem() && !(stop_deg > 0.0 && std::abs(start_deg + stop_deg) < 1e-3))
      return failure(ErrorCode::unsupported,
                     say<"The scan lines run from %1 to %2 degrees; only sectors as wide to the left as to the right, from minus to plus, "
                         "are converted.">(textOf(start_deg), textOf(stop_deg)),
                     {{"field", std::string(fields::kThetaStart)}});
    geometry.theta_rad = stop_deg * std::numbers::pi / 180.0;
  } else {
    geometry.imagingDepth_mm = stated.number(fields::kImagingDepth, 0.1, kLargest_mm);
    geometry.transducerWidth_mm = stated.number(fields::kTransducerWidth, 0.1, kLargest_mm);
  }
  const auto size = stated.numbers(fields::kOutputSize, 2, 2, 16384);
  const auto spacing_mm = stated.numbers(fields::kOutputSpacing, 2, 1e-3, 100.0);
  const auto face_px = stated.numbers(fields::kTransducerCentre, 2, -1e5, 1e5);
  if (stated.problem()) return passOn(*stated.problem());
  if (std::abs(spacing_mm[0] - spacing_mm[1]) > 1e-6 * spacing_mm[0])
    return failure(ErrorCode::unsupported,
                   say<"The converted image shall have pixels of %1 x %2 mm; give a ScanConversion with square pixels.">(
                       figureText(spacing_mm[0]), figureText(spacing_mm[1])),
                   {{"field", std::string(fields::kOutputSpacing)}});
  geometry.size_px = {static_cast<int>(size[0]), static_cast<int>(size[1])};
  geometry.pixel_mm = spacing_mm[0];
  geometry.face_px = {face_px[0], face_px[1]};
  return geometry;
}

Clip clipOf(const LineGeometry& geometry) {
  const double pixelsPerMm = 1.0 / geometry.pixel_mm;
  Clip clip;
  if (geometry.curvilinear) {
    clip.fan = ClipFan{.origin_px = geometry.face_px - glm::dvec2(0.0, geometry.radiusStart_mm * pixelsPerMm),
                       .leftAngle_rad = -geometry.theta_rad,
                       .rightAngle_rad = geometry.theta_rad,
                       .startRadius_px = geometry.radiusStart_mm * pixelsPerMm,
                       .stopRadius_px = geometry.radiusStop_mm * pixelsPerMm};
    return clip;
  }
  const glm::dvec2 lowest(geometry.face_px.x - 0.5 * geometry.transducerWidth_mm * pixelsPerMm, geometry.face_px.y);
  const glm::dvec2 highest(geometry.face_px.x + 0.5 * geometry.transducerWidth_mm * pixelsPerMm,
                           geometry.face_px.y + geometry.imagingDepth_mm * pixelsPerMm);
  const glm::dvec2 first = glm::clamp(glm::ceil(lowest - 1e-9), glm::dvec2(0.0), glm::dvec2(geometry.size_px - 1));
  const glm::dvec2 last = glm::clamp(glm::floor(highest + 1e-9), first, glm::dvec2(geometry.size_px - 1));
  clip.origin_px = first;
  clip.size_px = last - first + 1.0;
  return clip;
}

Result<Sequence> convertLines(Sequence lines, const LineGeometry& geometry, int threads, Progress& progress, std::uint64_t maxBytes) {
  if (!holdsScanLines(lines))
    return failure(ErrorCode::unsupported, say<"The recording holds images of orientation \"%1\", no scan lines.">(lines.orientation));
  if (lines.imageType.starts_with("RF"))
    return failure(ErrorCode::unsupported,
                   say<"The scan lines are %1, no brightness; convert them to B-mode brightness first.">(lines.imageType),
                   {{"imageType", lines.imageType}});
  const int samples = lines.width, count = lines.height;
  if (samples < 2 || count < 2)
    return failure(ErrorCode::badField,
                   say<"The recording has %1 scan lines of %2 samples; an image needs at least 2 of each.">(count, samples),
                   {{"field", "DimSize"}});
  const auto framePixels = static_cast<std::size_t>(geometry.size_px.x) * static_cast<std::size_t>(geometry.size_px.y);
  const std::size_t bytes = framePixels * lines.frames.size();
  const auto tooLarge = [&] {
    return failure(ErrorCode::tooLarge, say<"The converted images need %1 MiB of memory; convert them to fewer pixels.">(bytes >> 20),
                   {{"bytes", std::to_string(bytes)}});
  };
  if (bytes > maxBytes) return tooLarge();

  const Probe probe = probeOf(geometry, count);
  DisplayGeometry display;
  display.width = geometry.size_px.x;
  display.height = geometry.size_px.y;
  display.pixel_mm = geometry.pixel_mm;
  display.face_px = geometry.face_px;
  display.markerLeft = false;
  display.depth_mm = depthOf_mm(geometry);
  const Knobs knobs;
  BeamGrid grid = makeBeamGrid(probe, knobs, display.depth_mm, display.depth_mm / (samples - 1));
  grid.samples = samples;
  grid.sampleSpacing_mm = display.depth_mm / (samples - 1);
  const ScanConversionTable table = makeScanConversion(probe, knobs, grid, display);

  const bool nearFirst = lines.orientation[0] == 'F', markerLast = lines.orientation[1] == 'M';
  Sequence images = lines;
  try {
    images.pixels.assign(bytes, 0);
  } catch (const std::bad_alloc&) {
    return tooLarge();
  }
  images.width = display.width;
  images.height = display.height;
  images.orientation = "MF";
  const bool finished = forEachTask(static_cast<int>(lines.frames.size()), threads, progress, say<"Converting scan lines">(), [&](int n) {
    const auto recorded = lines.framePixels(static_cast<std::size_t>(n));
    BeamImage beams(count, samples);
    for (int line = 0; line < count; ++line) {
      const auto* const row = recorded.data() + static_cast<std::ptrdiff_t>(markerLast ? line : count - 1 - line) * samples;
      for (int sample = 0; sample < samples; ++sample)
        viewOf(beams).at(line, sample) = static_cast<float>(row[nearFirst ? sample : samples - 1 - sample]);
    }
    scanConvert(table, viewOf(std::as_const(beams)), 0, display.height,
                {images.pixels.data() + static_cast<std::size_t>(n) * framePixels, display.width, display.height, display.width});
  });
  if (!finished) return failure(ErrorCode::cancelled, say<"Converting the scan lines was stopped.">());
  return images;
}

}  // namespace ew
