#include <algorithm>
#include <cmath>
#include <map>
#include <new>

#include "dicom_fields.h"
#include "ew/core/numbers.h"
#include "ew/io/dicom.h"
#include "grey_samples.h"
#include "image_header.h"
#include "volume_extent.h"

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

Result<Opened> openPlanes(const fs::path& file, const DicomVolumeOptions& options, const ReadLimits& limits) {
  auto dicom = readDicomFile(file, limits.maxBytes);
  if (!dicom) return passOn(dicom.error());
  if (dicom->data.text(0x00080016u) != kEnhancedUsVolume)
    return failure(
        ErrorCode::unsupported,
        say<"%1 is no Enhanced US Volume: its pictures have no places in space; import it as a sequence of pictures.">(quoted(file)),
        {{"file", file.string()}});
  const auto layout = pixelLayoutOf(*dicom, limits);
  if (!layout) return passOn(layout.error());
  auto planes = volumePlanesOf(*dicom, *layout);
  if (!planes) return passOn(planes.error());
  Opened opened{std::move(*dicom), *layout, std::move(*planes), {}};
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
    opened.notes.push_back(say<"Volume %1 of %2 was read, %3 s after the first.">(step, times_s.size(), textOf(chosen_s)));
  opened.notes.push_back(
      say<"Coordinates are those of the file's own volume frame of reference, in mm; where it lies in the patient is not in the file.">());
  return opened;
}

/// The planes' grid along their common normal; empty `targets` when the planes lie evenly as they are.
struct Stack {
  Grid grid;
  std::vector<double> along_mm;  ///< of each plane, ascending
  bool even = true;
};

Result<Stack> stackOf(Opened& opened, const fs::path& file, const ReadLimits& limits) {
  std::vector<VolumePlane>& planes = opened.planes;
  const VolumePlane first = planes.front();
  if (planes.size() < 2)
    return failure(ErrorCode::emptyVolume, say<"%1 holds a single plane, not a volume; import it as a picture.">(quoted(file)),
                   {{"file", file.string()}});
  const glm::dvec3 right = glm::normalize(first.across_mm), down = glm::normalize(first.down_mm), normal = glm::cross(right, down);
  for (const VolumePlane& plane : planes)
    if (glm::length(plane.across_mm - first.across_mm) > 1e-3 * glm::length(first.across_mm) ||
        glm::length(plane.down_mm - first.down_mm) > 1e-3 * glm::length(first.down_mm))
      return failure(ErrorCode::unsupported,
                     say<"The planes of %1 are not parallel or differ in size, so that they are no regular grid; import them as a "
                         "sequence, which keeps the place of each, and reconstruct it.">(quoted(file)),
                     {{"file", file.string()}, {"ask", "sequence"}});
  std::sort(planes.begin(), planes.end(),
            [&](const VolumePlane& a, const VolumePlane& b) { return glm::dot(a.origin_mm, normal) < glm::dot(b.origin_mm, normal); });
  Stack stack;
  for (const VolumePlane& plane : planes) stack.along_mm.push_back(glm::dot(plane.origin_mm - planes.front().origin_mm, normal));
  const std::size_t last = planes.size() - 1;
  const glm::dvec3 step_mm = (planes[last].origin_mm - planes[0].origin_mm) / static_cast<double>(last);
  const double mean_mm = stack.along_mm[last] / static_cast<double>(last);
  if (!(mean_mm > 1e-6))
    return failure(ErrorCode::badField,
                   say<"The planes of %1 lie in one plane, so that there is no volume; export it again.">(quoted(file)),
                   {{"file", file.string()}, {"field", "Image Position (Volume)"}});
  double smallest_mm = mean_mm;
  for (std::size_t n = 0; n < planes.size(); ++n) {
    const glm::dvec3 off_mm = planes[n].origin_mm - planes[0].origin_mm - step_mm * static_cast<double>(n);
    const double along_mm = std::abs(glm::dot(off_mm, normal));
    // A hundredth of a voxel is rounding in the file.
    if (along_mm > 0.01 * mean_mm) stack.even = false;
    const double aside_mm = glm::length(off_mm - normal * glm::dot(off_mm, normal));
    if (aside_mm > 0.05 * std::min(glm::length(first.across_mm), glm::length(first.down_mm)))
      return failure(ErrorCode::unsupported,
                     say<"The planes of %1 are shifted sideways against each other unevenly, so that they are no regular grid; import them "
                         "as a sequence, which keeps the place of each, and reconstruct it.">(quoted(file)),
                     {{"file", file.string()}, {"ask", "sequence"}});
    if (n > 0) smallest_mm = std::min(smallest_mm, stack.along_mm[n] - stack.along_mm[n - 1]);
  }
  if (!(smallest_mm > 1e-6 * mean_mm))
    return failure(ErrorCode::badField, say<"Two planes of %1 lie in the same place; export the volume again.">(quoted(file)),
                   {{"file", file.string()}, {"field", "Image Position (Volume)"}});
  std::size_t slices = planes.size();
  glm::dvec3 between_mm = step_mm;
  if (!stack.even) {
    const double wanted = std::floor(stack.along_mm[last] / smallest_mm + 1e-6);
    const double voxels = (wanted + 1.0) * static_cast<double>(opened.layout.pixelsPerFrame());
    if (!(voxels < static_cast<double>(limits.maxBytes)) || wanted > 65536.0)
      return failure(
          ErrorCode::tooLarge,
          say<"The planes of %1 lie so unevenly that a regular grid would be too large; import them as a sequence and reconstruct it.">(
              quoted(file)),
          {{"file", file.string()}, {"ask", "sequence"}});
    slices = static_cast<std::size_t>(wanted) + 1;
    between_mm = step_mm * (stack.along_mm[last] / wanted / mean_mm);
    opened.notes.push_back(say<"The planes lie unevenly, %1 mm apart at the closest; they were resampled linearly to %2 even ones.">(
        textOf(std::round(smallest_mm * 1000.0) / 1000.0), slices));
  }
  stack.grid.dims = {static_cast<int>(opened.layout.columns), static_cast<int>(opened.layout.rows), static_cast<int>(slices)};
  stack.grid.spacing_mm = {glm::length(first.across_mm), glm::length(first.down_mm), glm::length(between_mm)};
  stack.grid.origin_mm = planes[0].origin_mm;
  stack.grid.directions = glm::dmat3(right, down, glm::normalize(between_mm));
  if (auto usable = checkGrid(stack.grid); !usable) return passOn(usable.error());
  if (glm::length(glm::cross(glm::normalize(between_mm), normal)) > 0.01)
    opened.notes.push_back(
        say<"The planes are shifted against each other evenly: the axes are not at right angles and were kept as they are.">());
  return stack;
}

}  // namespace

Result<DicomVolume> readDicomVolume(const fs::path& file, const DicomVolumeOptions& options, Progress& progress,
                                    const ReadLimits& limits) try {
  auto opened = openPlanes(file, options, limits);
  if (!opened) return passOn(opened.error());
  const auto stack = stackOf(*opened, file, limits);
  if (!stack) return passOn(stack.error());
  std::vector<std::uint64_t> frames;
  for (const VolumePlane& plane : opened->planes) frames.push_back(plane.frame);
  auto grey = readGreyFrames(opened->dicom, opened->layout, frames, limits, progress, opened->notes);
  if (!grey) return passOn(grey.error());
  DicomVolume made;
  made.removed = identifyingFields(opened->dicom.data);
  made.notes = std::move(opened->notes);
  if (!grey->coloured.empty()) made.notes.push_back(say<"Some pixels are coloured; their luminance became the echo level.">());
  made.volume.grid = stack->grid;
  if (stack->even) {
    made.volume.echo = std::move(grey->level);
    return made;
  }
  const std::size_t pixels = opened->layout.pixelsPerFrame();
  made.volume.echo.resize(made.volume.grid.voxelCount());
  const double step_mm = stack->along_mm.back() / (stack->grid.dims.z - 1);
  std::size_t below = 0;
  for (int k = 0; k < stack->grid.dims.z; ++k) {
    if (progress.cancelRequested()) return stopped(file);
    const double at_mm = step_mm * k;
    while (below + 2 < stack->along_mm.size() && stack->along_mm[below + 1] <= at_mm) ++below;
    const double share = std::clamp((at_mm - stack->along_mm[below]) / (stack->along_mm[below + 1] - stack->along_mm[below]), 0.0, 1.0);
    const std::uint8_t* const a = grey->level.data() + below * pixels;
    const std::uint8_t* const b = a + pixels;
    std::uint8_t* const out = made.volume.echo.data() + static_cast<std::size_t>(k) * pixels;
    for (std::size_t p = 0; p < pixels; ++p) out[p] = static_cast<std::uint8_t>(std::lround((1.0 - share) * a[p] + share * b[p]));
  }
  return made;
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for the planes of %1; close other programs.">(quoted(file)),
                 {{"file", file.string()}});
}

Result<Cine> readDicomPlanes(const fs::path& file, const DicomVolumeOptions& options, Progress& progress, const ReadLimits& limits) try {
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
