#include <algorithm>
#include <cmath>
#include <new>

#include "dicom/dicom_fields.h"
#include "dicom/plane_stack.h"
#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/io/dicom.h"
#include "files/grey_samples.h"
#include "files/image_header.h"
#include "files/volume_extent.h"

namespace ew {
namespace detail {
namespace {

/// The first item of a functional group's sequence: the frame's own, or the one all frames share.
const DicomItem* groupOf(const DicomItem* frame, const DicomItem* shared, DicomTag sequence) {
  for (const DicomItem* where : {frame, shared})
    if (where != nullptr)
      if (const auto items = where->items(sequence); !items.empty()) return &items.front();
  return nullptr;
}

bool allFinite(const std::vector<double>& values, std::size_t count) {
  return values.size() >= count &&
         std::all_of(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count), [](double v) { return std::abs(v) < 1e7; });
}

}  // namespace

Result<std::vector<VolumePlane>> volumePlanesOf(const DicomFile& dicom, const PixelLayout& layout) {
  const auto sharedItems = dicom.data.items(0x52009229u);
  const auto frameItems = dicom.data.items(0x52009230u);
  const DicomItem* const shared = sharedItems.empty() ? nullptr : &sharedItems.front();
  if (frameItems.size() < layout.frames)
    return badField(dicom.file, verbatim("Per-frame Functional Groups Sequence"), say<"%1 items">(frameItems.size()),
                    say<"%1, one a frame">(layout.frames));
  std::vector<VolumePlane> planes;
  for (std::uint64_t n = 0; n < layout.frames; ++n) {
    const DicomItem* const frame = &frameItems[n];
    const DicomItem* const position = groupOf(frame, shared, 0x0020930Eu);
    const DicomItem* const orientation = groupOf(frame, shared, 0x0020930Fu);
    const DicomItem* const measures = groupOf(frame, shared, 0x00289110u);
    const auto origin = position == nullptr ? std::vector<double>() : position->numbers(0x00209301u);
    if (!allFinite(origin, 3))
      return badField(dicom.file, say<"Image Position (Volume) of frame %1">(n + 1), say<"nothing usable">(), say<"three numbers in mm">());
    const auto cosines = orientation == nullptr ? std::vector<double>() : orientation->numbers(0x00209302u);
    if (!allFinite(cosines, 6))
      return badField(dicom.file, say<"Image Orientation (Volume) of frame %1">(n + 1), say<"nothing usable">(),
                      say<"six direction cosines">());
    const auto spacing = measures == nullptr ? std::vector<double>() : measures->numbers(0x00280030u);
    if (!allFinite(spacing, 2) || !(spacing[0] > 1e-6) || !(spacing[1] > 1e-6))
      return badField(dicom.file, say<"Pixel Spacing of frame %1">(n + 1), say<"nothing usable">(), say<"two lengths above 0 mm">());
    VolumePlane plane;
    plane.frame = n;
    plane.origin_mm = {origin[0], origin[1], origin[2]};
    const glm::dvec3 across(cosines[0], cosines[1], cosines[2]), down(cosines[3], cosines[4], cosines[5]);
    if (std::abs(glm::length(across) - 1.0) > 1e-3 || std::abs(glm::length(down) - 1.0) > 1e-3 || std::abs(glm::dot(across, down)) > 1e-3)
      return badField(dicom.file, say<"Image Orientation (Volume) of frame %1">(n + 1), say<"other lengths or angles">(),
                      say<"two unit vectors at right angles">());
    // Pixel Spacing names the distance of rows first.
    plane.across_mm = glm::normalize(across) * spacing[1];
    plane.down_mm = glm::normalize(down) * spacing[0];
    if (const DicomItem* const time = groupOf(frame, shared, 0x00209310u); time != nullptr) {
      plane.time_s = time->number(0x0020930Du).value_or(0.0);
      if (!std::isfinite(plane.time_s)) plane.time_s = 0.0;
    }
    if (const DicomItem* const type = groupOf(frame, shared, 0x00189807u); type != nullptr) {
      const std::string name = type->text(0x00189808u);
      plane.isTissue = name.empty() || name == "TISSUE_INTENSITY";
    }
    planes.push_back(plane);
  }
  return planes;
}

std::vector<double> timeStepsOf(const std::vector<VolumePlane>& planes) {
  std::vector<double> times_s;
  for (const VolumePlane& plane : planes)
    if (plane.isTissue) times_s.push_back(plane.time_s);
  std::sort(times_s.begin(), times_s.end());
  times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
  return times_s;
}

}  // namespace detail

namespace {
using namespace detail;
namespace fs = std::filesystem;

struct Opened {
  DicomFile dicom;
  PixelLayout layout;
  std::vector<VolumePlane> planes;  ///< tissue of the chosen time, in file order
  std::vector<Message> notes;
};

Result<Opened> openPlanes(const fs::path& file, const DicomVolumeOptions& options, const ReaderLimits& limits) {
  auto dicom = readDicomFile(file, limits.maxBytes);
  if (!dicom) return passOn(dicom.error());
  if (dicom->data.text(0x00080016u) != kEnhancedUsVolume)
    return failure(ErrorCode::unsupported,
                   say<"%1 is no Enhanced US Volume: its images have no places in space; import it as a sequence of images.">(quoted(file)),
                   {{"file", file.string()}});
  const auto layout = pixelLayoutOf(*dicom, limits);
  if (!layout) return passOn(layout.error());
  auto planes = volumePlanesOf(*dicom, *layout);
  if (!planes) return passOn(planes.error());
  Opened opened{std::move(*dicom), *layout, std::move(*planes), {}};
  opened.notes = layout->notes;
  for (Message& note : unusedFields(opened.dicom.data, {})) opened.notes.push_back(std::move(note));
  const std::size_t all = opened.planes.size();
  std::erase_if(opened.planes, [](const VolumePlane& plane) { return !plane.isTissue; });
  if (opened.planes.empty())
    return failure(ErrorCode::unsupported,
                   say<"%1 holds no tissue intensities (only flow or other data); export the B-mode volume.">(quoted(file)),
                   {{"file", file.string()}});
  if (opened.planes.size() < all)
    opened.notes.push_back(say<"%1 planes hold flow or other data instead of tissue; they were left out.">(all - opened.planes.size()));
  const auto times_s = timeStepsOf(opened.planes);
  if (times_s.size() > 1 && !options.timeStep)
    return failure(
        ErrorCode::missingCalibration,
        say<"%1 holds %2 volumes one after the other; choose one by its number, 1 to %3.">(quoted(file), times_s.size(), times_s.size()),
        {{"file", file.string()}, {"ask", "time-step"}, {"steps", std::to_string(times_s.size())}});
  const int step = options.timeStep.value_or(1);
  if (step < 1 || static_cast<std::size_t>(step) > times_s.size())
    return failure(ErrorCode::badUsage, noSuchVolume(file, times_s.size(), step), {{"file", file.string()}, {"ask", "time-step"}});
  const double chosen_s = times_s[static_cast<std::size_t>(step) - 1];
  std::erase_if(opened.planes, [&](const VolumePlane& plane) { return plane.time_s != chosen_s; });
  if (times_s.size() > 1)
    opened.notes.push_back(say<"Volume %1 of %2 was read, %3 s after the first.">(step, times_s.size(), figureText(chosen_s)));
  opened.notes.push_back(
      say<"Coordinates are those of the file's own volume frame of reference, in mm; where it lies in the patient is not in the file.">());
  return opened;
}

}  // namespace

Result<DicomVolume> readDicomVolume(const fs::path& file, const DicomVolumeOptions& options, Progress& progress,
                                    const ReaderLimits& limits) try {
  auto opened = openPlanes(file, options, limits);
  if (!opened) return passOn(opened.error());
  const auto stack =
      stackOf(opened->planes, static_cast<int>(opened->layout.columns), static_cast<int>(opened->layout.rows), file, limits, opened->notes);
  if (!stack) return passOn(stack.error());
  std::vector<std::uint64_t> frames;
  for (const VolumePlane& plane : opened->planes) frames.push_back(plane.frame);
  auto grey = readGreyFrames(opened->dicom, opened->layout, frames, limits, progress, opened->notes);
  if (!grey) return passOn(grey.error());
  DicomVolume made;
  made.removed = identifyingFields(opened->dicom.data);
  made.notes = std::move(opened->notes);
  if (!grey->coloured.empty()) made.notes.push_back(say<"Some pixels are coloured; their luminance became the echo level.">());
  auto echo = echoOnto(*stack, std::move(grey->level), file, progress);
  if (!echo) return passOn(echo.error());
  made.volume.grid = stack->grid;
  made.volume.echo = *std::move(echo);
  return made;
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for the planes of %1; close other programs.">(quoted(file)),
                 {{"file", file.string()}});
}

Result<Cine> readDicomPlanes(const fs::path& file, const DicomVolumeOptions& options, Progress& progress, const ReaderLimits& limits) try {
  auto opened = openPlanes(file, options, limits);
  if (!opened) return passOn(opened.error());
  std::vector<std::uint64_t> frames;
  for (const VolumePlane& plane : opened->planes) frames.push_back(plane.frame);
  auto grey = readGreyFrames(opened->dicom, opened->layout, frames, limits, progress, opened->notes);
  if (!grey) return passOn(grey.error());
  Cine cine;
  cine.removed = identifyingFields(opened->dicom.data);
  cine.notes = std::move(opened->notes);
  cine.coloured = std::move(grey->coloured);
  Sequence& sequence = cine.sequence;
  sequence.width = static_cast<int>(opened->layout.columns);
  sequence.height = static_cast<int>(opened->layout.rows);
  sequence.pixels = std::move(grey->level);
  sequence.imageType = "BRIGHTNESS";
  const VolumePlane& first = opened->planes.front();
  cine.pixel_mm = {glm::length(first.across_mm), glm::length(first.down_mm)};
  for (const VolumePlane& plane : opened->planes) {
    const glm::dvec3 normal = glm::cross(glm::normalize(plane.across_mm), glm::normalize(plane.down_mm));
    const double thickness_mm = std::sqrt(glm::length(plane.across_mm) * glm::length(plane.down_mm));
    SequenceFrame frame;
    frame.transforms.push_back({"Image", "Reference",
                                glm::dmat4(glm::dvec4(plane.across_mm, 0.0), glm::dvec4(plane.down_mm, 0.0),
                                           glm::dvec4(normal * thickness_mm, 0.0), glm::dvec4(plane.origin_mm, 1.0)),
                                PoseStatus::ok});
    sequence.frames.push_back(std::move(frame));
  }
  cine.notes.push_back(say<"Reference is the file's volume frame of reference; each frame has its own place in it.">());
  return cine;
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for the planes of %1; close other programs.">(quoted(file)),
                 {{"file", file.string()}});
}

}  // namespace ew
