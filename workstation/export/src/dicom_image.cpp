#include "ew/export/dicom_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "dicom_elements.h"
#include "ew/core/contract.h"
#include "ew/core/word_table.h"
#include "ew/imaging/caption.h"
#include "ew/imaging/colour_doppler.h"
#include "ew/imaging/spectral_doppler.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {
using namespace exporting;

constexpr int kLargest_px = 65535;                     // Rows and Columns are 16 bit
constexpr std::size_t kMostFrames = 8000;              // a frame time vector has at most 65534 bytes, a time at most 8 with its backslash
constexpr std::uint64_t kMostPixelBytes = 0xFFFFFFFE;  // of a value of defined length
constexpr double kMm_per_cm = 10.0;

// PS3.3, C.8.5.5.1
constexpr std::uint32_t kFormatImage = 1, kFormatStrip = 2, kFormatSpectrum = 3;
constexpr std::uint32_t kTissue = 1, kColourFlow = 2, kPulsedWave = 3;
constexpr std::uint32_t kCm = 3, kSeconds = 4, kCmPerS = 7;

/// Format, type and units of a kind of region.
struct RegionCodes {
  std::uint32_t format, type, unitX, unitY;
};
RegionCodes codesOf(RegionCalibration::Kind kind) {
  switch (kind) {
    case RegionCalibration::Kind::image:
      return {kFormatImage, kTissue, kCm, kCm};
    case RegionCalibration::Kind::strip:
      return {kFormatStrip, kTissue, kSeconds, kCm};
    case RegionCalibration::Kind::colour:
      return {kFormatImage, kColourFlow, kCm, kCm};
    case RegionCalibration::Kind::spectrum:
      return {kFormatSpectrum, kPulsedWave, kSeconds, kCmPerS};
  }
  return {kFormatImage, kTissue, kCm, kCm};
}
std::uint32_t roundedOf(double value) { return static_cast<std::uint32_t>(std::lround(value)); }

void putDoppler(Elements& inside, const RegionCalibration::Doppler& doppler, bool isSpectrum) {
  inside.whole(DCM_PulseRepetitionFrequency, roundedOf(doppler.prf_hz));
  if (isSpectrum) inside.real(DCM_DopplerCorrectionAngle, doppler.angle_deg);
  inside.real(DCM_SteeringAngle, doppler.steering_deg);
  if (!doppler.volume_px) return;
  inside.signedWhole(DCM_DopplerSampleVolumeXPosition, doppler.volume_px->x);
  inside.signedWhole(DCM_DopplerSampleVolumeYPosition, doppler.volume_px->y);
}

void putRegions(Elements& elements, std::span<const RegionCalibration> regions, double carrier_hz) {
  for (const RegionCalibration& region : regions) {
    auto item = std::make_unique<DcmItem>();
    Elements inside(*item);
    const RegionCodes codes = codesOf(region.kind);
    inside.whole(DCM_RegionSpatialFormat, codes.format);
    inside.whole(DCM_RegionDataType, codes.type);
    inside.whole(DCM_RegionFlags, 0);  // opaque, not scrolled by whoever shows it
    inside.whole(DCM_RegionLocationMinX0, static_cast<std::uint32_t>(region.rect.x));
    inside.whole(DCM_RegionLocationMinY0, static_cast<std::uint32_t>(region.rect.y));
    inside.whole(DCM_RegionLocationMaxX1, static_cast<std::uint32_t>(region.rect.x + region.rect.width - 1));
    inside.whole(DCM_RegionLocationMaxY1, static_cast<std::uint32_t>(region.rect.y + region.rect.height - 1));
    inside.whole(DCM_PhysicalUnitsXDirection, codes.unitX);
    inside.whole(DCM_PhysicalUnitsYDirection, codes.unitY);
    inside.signedWhole(DCM_ReferencePixelX0, region.reference_px.x);
    inside.signedWhole(DCM_ReferencePixelY0, region.reference_px.y);
    inside.real(DCM_ReferencePixelPhysicalValueX, region.referenceValue.x);
    inside.real(DCM_ReferencePixelPhysicalValueY, region.referenceValue.y);
    inside.real(DCM_PhysicalDeltaX, region.delta.x);
    inside.real(DCM_PhysicalDeltaY, region.delta.y);
    const double sent_hz = region.doppler ? region.doppler->carrier_hz : carrier_hz;
    if (sent_hz > 0.0) inside.whole(DCM_TransducerFrequency, roundedOf(sent_hz / 1000.0));  // kHz
    if (region.doppler) putDoppler(inside, *region.doppler, region.kind == RegionCalibration::Kind::spectrum);
    elements.keep(inside.check() ? EC_Normal : EC_IllegalCall, "Sequence of Ultrasound Regions");
    elements.keep(elements.item().insertSequenceItem(DCM_SequenceOfUltrasoundRegions, item.release()), "Sequence of Ultrasound Regions");
  }
}

constexpr WordTable<ProbeKind, 5> kProbeKindWords{{{"LINEAR", ProbeKind::linear},
                                                   {"CURVED LINEAR", ProbeKind::convex},
                                                   {"SECTOR_PHASED", ProbeKind::phased},
                                                   {"ENDOCAV_CLA", ProbeKind::endocavity},
                                                   {"SECTOR_MECH", ProbeKind::sweptSector}}};
const char* transducerOf(ProbeKind kind) { return wordIn(kProbeKindWords, kind); }

/// The modes in an image, as value 4 of Image Type has them (PS3.3, C.8.5.6.1.1): 1 is two-dimensional, 2 M-mode, 8 pulsed wave Doppler,
/// 10 colour Doppler.
std::string modesOf(std::span<const RegionCalibration> regions, bool isColour) {
  unsigned modes = 0;
  bool hasBox = isColour;
  for (const RegionCalibration& region : regions) {
    if (region.kind == RegionCalibration::Kind::strip) modes |= 2U;
    if (region.kind == RegionCalibration::Kind::image) modes |= 1U;
    if (region.kind == RegionCalibration::Kind::spectrum) modes |= 8U;
    hasBox = hasBox || region.kind == RegionCalibration::Kind::colour;
  }
  constexpr const char* kDigits = "0123456789ABCDEF";
  return std::string("00") + (hasBox ? '1' : '0') + kDigits[modes];
}

struct Shape {
  glm::ivec2 size_px{0};
  bool isColour = false;
  std::size_t frames = 1;
  [[nodiscard]] std::uint64_t bytes() const {
    return static_cast<std::uint64_t>(size_px.x) * static_cast<std::uint64_t>(size_px.y) * (isColour ? 3 : 1) * frames;
  }
};

void putImage(Elements& elements, const Shape& shape, std::span<const RegionCalibration> regions, const DicomImageOptions& options) {
  elements.text(DCM_PatientOrientation, "");
  elements.text(DCM_Laterality, "");
  elements.text(DCM_ContentDate, dicomDate(options.taken));
  elements.text(DCM_ContentTime, dicomTime(options.taken));
  elements.text(DCM_AcquisitionDate, dicomDate(options.taken));
  elements.text(DCM_AcquisitionTime, dicomTime(options.taken));
  // Derived: no echo of a patient was received; an image is formed from a volume or from a virtual patient.
  elements.text(DCM_ImageType, "DERIVED\\PRIMARY\\\\" + modesOf(regions, shape.isColour));
  elements.text(DCM_DerivationDescription, std::string("Simulated ultrasound picture, formed from a volume. ") + kSimulation);
  std::string comments = options.label.empty() ? "" : fitting(options.label, 500, false) + " ";
  elements.text(DCM_ImageComments, comments + kSimulation + " These words are burnt into the lower edge.");
  elements.text(DCM_QualityControlImage, "YES");
  // Always: the warning below, and in an image of the window title, date and time, which may name somebody. Whoever hands it on must look.
  elements.text(DCM_BurnedInAnnotation, "YES");
  elements.text(DCM_LossyImageCompression, "00");

  elements.text(DCM_TransducerData, fitting(options.probe.name.empty() ? options.probe.id : options.probe.name, 64));
  elements.text(DCM_TransducerType, transducerOf(options.probe.kind));
  if (options.depth_mm > 0.0) elements.text(DCM_DepthOfScanField, std::to_string(std::lround(options.depth_mm)));

  elements.whole(DCM_SamplesPerPixel, shape.isColour ? 3 : 1);
  elements.text(DCM_PhotometricInterpretation, shape.isColour ? "RGB" : "MONOCHROME2");
  if (shape.isColour) elements.whole(DCM_PlanarConfiguration, 0);
  elements.whole(DCM_Rows, static_cast<std::uint32_t>(shape.size_px.y));
  elements.whole(DCM_Columns, static_cast<std::uint32_t>(shape.size_px.x));
  elements.whole(DCM_BitsAllocated, 8);
  elements.whole(DCM_BitsStored, 8);
  elements.whole(DCM_HighBit, 7);
  elements.whole(DCM_PixelRepresentation, 0);
  elements.whole(DCM_UltrasoundColorDataPresent, shape.isColour ? 1 : 0);
  putRegions(elements, regions, options.carrier_hz > 0.0 ? options.carrier_hz : options.probe.carrier_hz);
}

/// Milliseconds from each frame to the one before it, 0 for the first. Every sum of them is the frame's time to the microsecond.
std::string frameTimeVector(std::span<const double> times_s) {
  std::string vector = "0";
  std::int64_t before_us = 0;
  for (std::size_t n = 1; n < times_s.size(); ++n) {
    const std::int64_t now_us = std::llround((times_s[n] - times_s[0]) * 1e6);
    vector += "\\" + decimalString(static_cast<double>(now_us - before_us) / 1e3);
    before_us = now_us;
  }
  return vector;
}

void putFrames(Elements& elements, std::span<const double> times_s) {
  elements.text(DCM_NumberOfFrames, std::to_string(times_s.size()));
  elements.attribute(DCM_FrameIncrementPointer, DCM_FrameTimeVector);
  elements.text(DCM_FrameTimeVector, frameTimeVector(times_s));
  elements.whole(DCM_PreferredPlaybackSequencing, 0);  // from the first to the last, and again
  elements.text(DCM_StartTrim, "1");
  elements.text(DCM_StopTrim, std::to_string(times_s.size()));
  const double length_s = times_s.back() - times_s.front();
  if (length_s > 0.0) {
    const long rate = std::max(1L, std::lround(static_cast<double>(times_s.size() - 1) / length_s));
    elements.text(DCM_RecommendedDisplayFrameRate, std::to_string(rate));
    elements.text(DCM_CineRate, std::to_string(rate));
  }
}

Result<void> checkShape(const Shape& shape, std::span<const RegionCalibration> regions) {
  if (shape.size_px.x < kCaptionMinWidth_px || shape.size_px.y < kCaptionMinHeight_px)
    return failure(ErrorCode::badField, say<"An image of %1 x %2 pixels is too small for the words it must carry; give at least %3x%4.">(
                                            shape.size_px.x, shape.size_px.y, kCaptionMinWidth_px, kCaptionMinHeight_px));
  if (shape.size_px.x > kLargest_px || shape.size_px.y > kLargest_px)
    return failure(ErrorCode::badField, say<"An image of %1 x %2 pixels is larger than DICOM allows (%3 either way); give a smaller size.">(
                                            shape.size_px.x, shape.size_px.y, kLargest_px));
  if (shape.bytes() > kMostPixelBytes)
    return failure(ErrorCode::badField,
                   say<"%1 images of %2 x %3 pixels are more than one DICOM object can hold; store fewer of them, or smaller ones.">(
                       shape.frames, shape.size_px.x, shape.size_px.y));
  for (const RegionCalibration& region : regions) {
    const PixelRect& rect = region.rect;
    EW_EXPECTS(rect.x >= 0 && rect.y >= 0 && rect.width > 0 && rect.height > 0);
    EW_EXPECTS(rect.x + rect.width <= shape.size_px.x && rect.y + rect.height <= shape.size_px.y);
    // Velocities may rise up a spectrum, against its rows.
    const double down = region.kind == RegionCalibration::Kind::spectrum ? std::abs(region.delta.y) : region.delta.y;
    if (!std::isfinite(region.delta.x) || !std::isfinite(down) || !(region.delta.x > 0.0) || !(down > 0.0))
      return failure(ErrorCode::badField, say<"A region of the image has no size of a pixel, so that nobody could measure in it.">());
  }
  return {};
}

/// The words burnt in, then the bytes.
void writePixels(const Still& still, bool isColour, std::ostream& out) {
  const auto send = [&out](const auto& image) {
    out.write(reinterpret_cast<const char*>(image.pixels.data()),
              static_cast<std::streamsize>(image.pixels.size() * sizeof(image.pixels.front())));
  };
  if (const auto* grey = std::get_if<GreyImage>(&still.pixels); grey != nullptr && !isColour) {
    GreyImage marked = *grey;
    burnCaption(viewOf(marked), kNotForDiagnosis);
    send(marked);
    return;
  }
  RgbImage marked;
  if (const auto* grey = std::get_if<GreyImage>(&still.pixels)) {
    marked = RgbImage(grey->width, grey->height);
    std::transform(grey->pixels.begin(), grey->pixels.end(), marked.pixels.begin(), [](std::uint8_t level) { return Rgb(level); });
  } else {
    marked = std::get<RgbImage>(still.pixels);
  }
  burnCaption(viewOf(marked), kNotForDiagnosis);
  send(marked);
}

/// Pixels as the last element: tag, OB, length; one byte more when their number is odd.
void writePixelsHead(const Shape& shape, std::ostream& out) {
  const auto length = static_cast<std::uint32_t>(shape.bytes() + shape.bytes() % 2);
  const std::array<unsigned char, 12> head{0xE0,
                                           0x7F,
                                           0x10,
                                           0x00,
                                           'O',
                                           'B',
                                           0,
                                           0,  // little endian
                                           static_cast<unsigned char>(length),
                                           static_cast<unsigned char>(length >> 8U),
                                           static_cast<unsigned char>(length >> 16U),
                                           static_cast<unsigned char>(length >> 24U)};
  out.write(reinterpret_cast<const char*>(head.data()), head.size());
}

ObjectHead headOf(const char* classUid, const DicomImageOptions& options, const DicomStudy& study) {
  return {classUid, options.instanceUid, study.imagesUid, "US", 1, options.number, "Simulated ultrasound pictures", options.taken};
}

Result<std::vector<char>> headBytes(const Shape& shape, std::span<const RegionCalibration> regions, const DicomImageOptions& options,
                                    const DicomStudy& study, const char* classUid, std::span<const double> times_s) {
  if (auto named = checkIdentifiers(study, study.imagesUid, options.instanceUid); !named) return passOn(named.error());
  if (auto fits = checkShape(shape, regions); !fits) return passOn(fits.error());
  quietDcmtk();
  DcmFileFormat made;
  Elements elements(*made.getDataset());
  putPatientAndStudy(elements, study);
  putSeriesAndEquipment(elements, study, headOf(classUid, options, study));
  putImage(elements, shape, regions, options);
  if (!times_s.empty()) putFrames(elements, times_s);
  if (auto put = elements.check(); !put) return passOn(put.error());
  return bytesOf(made);
}

}  // namespace

RegionCalibration regionOf(const DisplayGeometry& geometry, glm::ivec2 corner_px) {
  RegionCalibration region;
  region.rect = {corner_px.x, corner_px.y, geometry.width, geometry.height};
  region.delta = glm::dvec2(geometry.pixel_mm / kMm_per_cm);
  // The reference is a whole pixel; the face is not.
  region.reference_px = glm::ivec2(glm::round(geometry.face_px));
  region.referenceValue = (glm::dvec2(region.reference_px) - geometry.face_px) * region.delta;
  return region;
}

RegionCalibration regionOfStrip(glm::ivec2 size_px, double sweep_s, double depth_mm, glm::ivec2 corner_px) {
  EW_EXPECTS(size_px.x > 0 && size_px.y > 0);
  RegionCalibration region;
  region.kind = RegionCalibration::Kind::strip;
  region.rect = {corner_px.x, corner_px.y, size_px.x, size_px.y};
  region.delta = {sweep_s / size_px.x, depth_mm / kMm_per_cm / size_px.y};
  region.referenceValue = {0.0,
                           0.5 * region.delta.y};  // column c is the moment c * sweep / width (m_mode.h); a row is as deep as its middle
  return region;
}

std::optional<RegionCalibration> regionOfColour(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry,
                                                glm::ivec2 corner_px) {
  if (!knobs.colour) return std::nullopt;
  const glm::dmat4 toImage = inverse(geometry.imageToProbe()).matrix;
  glm::dvec2 low(1e300), high(-1e300);
  for (const glm::dvec2& at_mm : colourBoxOutline_mm(probe, knobs)) {
    const glm::dvec2 at_px(toImage * glm::dvec4(at_mm, 0.0, 1.0));
    low = glm::min(low, at_px);
    high = glm::max(high, at_px);
  }
  const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(low + 0.5)), glm::ivec2(0));
  const glm::ivec2 last = glm::min(glm::ivec2(glm::floor(high + 0.5)), glm::ivec2(geometry.width, geometry.height) - 1);
  if (last.x < first.x || last.y < first.y) return std::nullopt;
  RegionCalibration region = regionOf(geometry, corner_px);
  region.kind = RegionCalibration::Kind::colour;
  region.rect = {corner_px.x + first.x, corner_px.y + first.y, last.x - first.x + 1, last.y - first.y + 1};
  region.reference_px -= first;
  const ColourBox box = colourBoxOf(probe, knobs);
  region.doppler = {.prf_hz = box.prf_hz, .carrier_hz = box.carrier_hz, .steering_deg = glm::degrees(box.steering_rad)};
  return region;
}

RegionCalibration regionOfSpectrum(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry, glm::ivec2 size_px,
                                   double sweep_s, glm::ivec2 corner_px, glm::ivec2 image_px) {
  EW_EXPECTS(knobs.spectral.has_value() && size_px.x > 0 && size_px.y > 0);
  constexpr double kMmPerS_per_cmPerS = 10.0;
  const SpectralGate gate = spectralGateOf(probe, knobs);
  const double lowest = gate.shown_mmPerS.first / kMmPerS_per_cmPerS, highest = gate.shown_mmPerS.second / kMmPerS_per_cmPerS;
  const bool isInverted = knobs.spectral->invert;
  RegionCalibration region;
  region.kind = RegionCalibration::Kind::spectrum;
  region.rect = {corner_px.x, corner_px.y, size_px.x, size_px.y};
  region.delta = {sweep_s / size_px.x, (isInverted ? 1.0 : -1.0) * (highest - lowest) / size_px.y};
  // The row of the baseline, whose middle need not be 0 to the bit.
  const double top = isInverted ? lowest : highest;
  const double baseline = -top / region.delta.y - 0.5;
  region.reference_px = {0, static_cast<int>(std::lround(baseline))};
  region.referenceValue = {0.0, (region.reference_px.y - baseline) * region.delta.y};
  const glm::dvec2 volume(inverse(geometry.imageToProbe()).matrix * glm::dvec4(gate.middle_mm, 0.0, 1.0));
  region.doppler = {.prf_hz = gate.prf_hz,
                    .carrier_hz = gate.carrier_hz,
                    .steering_deg = glm::degrees(std::atan2(gate.direction.x, gate.direction.y)),
                    .angle_deg = glm::degrees(knobs.spectral->angle_rad),
                    .volume_px = image_px + glm::ivec2(glm::round(volume))};
  return region;
}

glm::ivec2 Still::size_px() const {
  return std::visit([](const auto& image) { return glm::ivec2(image.width, image.height); }, pixels);
}

Still stillOf(const DisplayImage& display, ImageView<const std::uint8_t> strip, const DisplayGeometry& geometry, const Probe& probe,
              const Knobs& knobs) {
  const bool hasStrip = strip.width > 0 && knobs.mode != DisplayMode::bMode;
  const bool hasImage = !hasStrip || knobs.mode != DisplayMode::mMode;
  const int imageHeight = hasImage ? display.height() : 0;
  const glm::ivec2 size_px(display.width(), imageHeight + (hasStrip ? strip.height : 0));
  Still still;
  if (hasImage) still.regions.push_back(regionOf(geometry));
  if (hasImage && display.hasColour())
    if (auto box = regionOfColour(probe, knobs, geometry)) still.regions.push_back(*box);
  const glm::ivec2 strip_px(strip.width, strip.height), below_px(0, imageHeight);
  if (hasStrip && knobs.mode == DisplayMode::spectrum && knobs.spectral)
    still.regions.push_back(regionOfSpectrum(probe, knobs, geometry, strip_px, knobs.mSweep_s, below_px, glm::ivec2(0)));
  else if (hasStrip)
    still.regions.push_back(regionOfStrip(strip_px, knobs.mSweep_s, geometry.depth_mm, below_px));
  const auto rowsInto = [&](auto& image, int at, const auto& source) {
    using Pixel = typename std::decay_t<decltype(image.pixels)>::value_type;
    for (int y = 0; y < source.height; ++y)
      std::transform(source.row(y), source.row(y) + std::min(source.width, size_px.x), viewOf(image).row(at + y),
                     [](const auto& level) { return Pixel(level); });
  };
  if (hasImage && display.hasColour()) {
    RgbImage image(size_px.x, size_px.y);
    const RgbImage laid = composed(display);
    rowsInto(image, 0, viewOf(laid));
    if (hasStrip) rowsInto(image, imageHeight, strip);
    still.pixels = std::move(image);
  } else {
    GreyImage image(size_px.x, size_px.y);
    if (hasImage) rowsInto(image, 0, display.grey);
    if (hasStrip) rowsInto(image, imageHeight, strip);
    still.pixels = std::move(image);
  }
  return still;
}

DicomImageOptions imageOptions(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry, int number,
                               std::chrono::sys_seconds taken) {
  DicomImageOptions options;
  options.instanceUid = newDicomUid();
  options.number = number;
  options.probe = probe;
  options.carrier_hz = knobs.carrier_hz;
  options.depth_mm = geometry.depth_mm;
  options.taken = taken;
  return options;
}

Result<DicomReference> writeDicomImage(const Still& still, const DicomImageOptions& options, const DicomStudy& study,
                                       const std::filesystem::path& file) {
  const Shape shape{still.size_px(), still.isColour(), 1};
  const auto head = headBytes(shape, still.regions, options, study, kUsImageClass, {});
  if (!head) return passOn(head.error());
  auto written = writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    out.write(head->data(), static_cast<std::streamsize>(head->size()));
    writePixelsHead(shape, out);
    writePixels(still, shape.isColour, out);
    if (shape.bytes() % 2 != 0) out.put('\0');
    return {};
  });
  if (!written) return passOn(written.error());
  return DicomReference{kUsImageClass, options.instanceUid};
}

Result<DicomReference> writeDicomClip(const DicomClip& clip, const DicomImageOptions& options, const DicomStudy& study,
                                      const std::filesystem::path& file, Progress& progress) {
  const std::size_t frames = clip.times_s.size();
  if (frames == 0) return failure(ErrorCode::badField, say<"A clip without an image cannot be stored; record some first.">());
  if (frames > kMostFrames)
    return failure(ErrorCode::badField,
                   say<"%1 images are more than one DICOM clip holds (%2); store fewer of them.">(frames, kMostFrames));
  if (!std::all_of(clip.times_s.begin(), clip.times_s.end(), [](double t) { return std::isfinite(t); }) ||
      !std::is_sorted(clip.times_s.begin(), clip.times_s.end()))
    return failure(ErrorCode::badField, say<"The times of the images do not rise, so that no clip can be made of them.">());
  const Shape shape{clip.size_px, clip.isColour, frames};
  const auto head = headBytes(shape, clip.regions, options, study, kUsMultiframeClass, clip.times_s);
  if (!head) return passOn(head.error());
  auto written = writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    out.write(head->data(), static_cast<std::streamsize>(head->size()));
    writePixelsHead(shape, out);
    for (std::size_t n = 0; n < frames; ++n) {
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">());
      auto still = clip.still(n);
      if (!still) return passOn(still.error());
      if (still->size_px() != clip.size_px || (still->isColour() && !clip.isColour))
        return failure(ErrorCode::badField,
                       say<"Image %1 of the clip has another size or other colours than the clip; store the images apart.">(n + 1));
      writePixels(*still, clip.isColour, out);
      progress.report(say<"Writing the clip">(), static_cast<double>(n + 1) / static_cast<double>(frames));
    }
    if (shape.bytes() % 2 != 0) out.put('\0');
    return {};
  });
  if (!written) return passOn(written.error());
  return DicomReference{kUsMultiframeClass, options.instanceUid};
}

}  // namespace ew
