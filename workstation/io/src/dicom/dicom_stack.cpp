#include "ew/io/dicom_stack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <set>

#include "dicom/dicom_fields.h"
#include "dicom/plane_stack.h"
#include "dicom/stack_image.h"
#include "ew/core/ending.h"
#include "ew/core/numbers.h"
#include "files/grey_samples.h"
#include "files/image_header.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

constexpr std::size_t kMostStills = 20'000;
constexpr DicomTag kSeries = 0x0020000Eu, kPosition = 0x00200032u, kOrientation = 0x00200037u, kBurnedIn = 0x00280301u;

/// What is known of the stills of a folder after they were looked at once.
struct Stills {
  std::vector<fs::path> files;
  std::vector<VolumePlane> planes;  ///< VolumePlane::frame is the number of the file
  std::uint64_t columns = 0, rows = 0;
  std::int32_t lowest = std::numeric_limits<std::int32_t>::max();  ///< of deep samples, over all stills
  std::int32_t highest = std::numeric_limits<std::int32_t>::min();
  bool deep = false;
  bool burnedIn = false;
  std::set<std::string> series;
  std::size_t unplaced = 0;
  Removed removed;
  std::vector<Message> notes;
};

tl::unexpected<Error> notOneVolume(const fs::path& folder, Message why) {
  return failure(ErrorCode::unsupported, std::move(why), {{"file", folder.string()}});
}

/// Where a still lies; empty: it does not say.
std::optional<VolumePlane> planeOf(const DicomItem& data, const glm::dvec2& pixel_mm) {
  const auto position = data.numbers(kPosition), cosines = data.numbers(kOrientation);
  const auto finite = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::abs(value) < 1e7; });
  };
  if (position.size() != 3 || cosines.size() != 6 || !finite(position) || !finite(cosines)) return std::nullopt;
  const glm::dvec3 across(cosines[0], cosines[1], cosines[2]), down(cosines[3], cosines[4], cosines[5]);
  if (std::abs(glm::length(across) - 1.0) > 1e-3 || std::abs(glm::length(down) - 1.0) > 1e-3 || std::abs(glm::dot(across, down)) > 1e-3)
    return std::nullopt;
  VolumePlane plane;
  plane.origin_mm = {position[0], position[1], position[2]};
  plane.across_mm = glm::normalize(across) * pixel_mm.x;
  plane.down_mm = glm::normalize(down) * pixel_mm.y;
  return plane;
}

/// Files of a folder that seem to be stills by their names, or hold nothing at all, and are none: a copy that broke off leaves such.
std::vector<fs::path> brokenStillsIn(const fs::path& folder, const std::vector<fs::path>& stills) {
  std::set<std::string> endings;
  for (const fs::path& each : stills) endings.insert(endingOf(each));
  std::vector<fs::path> broken;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const fs::path& file = entry.path();
    if (!entry.is_regular_file(ignored) || file.filename().string().starts_with('.')) continue;
    const bool seemsStill = fs::file_size(file, ignored) == 0 || endings.contains(endingOf(file));
    if (seemsStill && !isDicom(file)) broken.push_back(file);
  }
  std::sort(broken.begin(), broken.end());
  return broken;
}

/// The names of files; of many the first ones.
Message namesOf(const std::vector<fs::path>& files) {
  constexpr std::size_t kMost = 5;
  std::vector<Message> names;
  for (std::size_t n = 0; n < std::min(files.size(), kMost); ++n) names.push_back(quoted(files[n]));
  if (files.size() > kMost) names.push_back(say<"and %1 more">(files.size() - kMost));
  return joined(names, ", ");
}

/// That no still is missing between others that lie evenly: its image would be made up of those next to it.
Result<void> checkNoGap(const PlaneStack& stack, const std::vector<fs::path>& broken, const fs::path& folder) {
  double closest_mm = stack.along_mm.back();
  for (std::size_t n = 1; n < stack.along_mm.size(); ++n) closest_mm = std::min(closest_mm, stack.along_mm[n] - stack.along_mm[n - 1]);
  long missing = 0;
  for (std::size_t n = 1; n < stack.along_mm.size(); ++n) {
    const double steps = (stack.along_mm[n] - stack.along_mm[n - 1]) / closest_mm;
    if (std::abs(steps - std::round(steps)) > 0.02 * steps) return {};  // uneven throughout: no still is missed
    missing += std::lround(steps) - 1;
  }
  if (missing == 0) return {};
  const auto ask = [&](Message sentence) {
    return failure(ErrorCode::unsupported, std::move(sentence), {{"file", folder.string()}, {"ask", "accept-small"}});
  };
  const double apart_mm = std::round(closest_mm * 1000.0) / 1000.0;
  if (broken.empty())
    return ask(say<"The DICOM stills of %1 lie %2 mm apart; missing between them, and made up of those next to them: %3. Get the missing "
                   "files, or accept that.">(quoted(folder), textOf(apart_mm), missing));
  return ask(say<"The DICOM stills of %1 lie %2 mm apart; missing between them, and made up of those next to them: %3. Get the files anew "
                 "that hold no DICOM data (%4), or accept that.">(quoted(folder), textOf(apart_mm), missing, namesOf(broken)));
}

/// Takes one still into what is known of all.
Result<void> lookAt(const DicomFile& dicom, const PixelLayout& layout, Stills& stills, const fs::path& folder, const Progress& progress) {
  if (layout.frames > 1)
    return notOneVolume(folder, say<"%1 holds a cine of %2 frames among the stills of %3; import it by itself.">(
                                    quoted(dicom.file), layout.frames, quoted(folder)));
  if (stills.files.empty()) {
    stills.columns = layout.columns;
    stills.rows = layout.rows;
    stills.notes = layout.notes;
  } else if (layout.columns != stills.columns || layout.rows != stills.rows) {
    return notOneVolume(folder,
                        say<"The DICOM stills of %1 have different sizes (%2 x %3 and %4 x %5 pixels), so that they are no volume; put "
                            "those of one volume into a folder, or import them one by one.">(quoted(folder), stills.columns, stills.rows,
                                                                                             layout.columns, layout.rows));
  }
  const DicomScale scale = scaleOf(dicom.data, layout.columns, layout.rows);
  const auto pixel_mm = scale.spacing_mm   ? scale.spacing_mm
                        : scale.onlyRegion ? std::optional(scale.regions[*scale.onlyRegion].pixel_mm())
                                           : std::nullopt;
  if (stills.files.empty())
    for (Message& note : unusedFields(dicom.data, pixel_mm, true)) stills.notes.push_back(std::move(note));
  const auto plane = pixel_mm ? planeOf(dicom.data, *pixel_mm) : std::nullopt;
  if (plane) {
    stills.planes.push_back(*plane);
    stills.planes.back().frame = stills.files.size();
  } else {
    ++stills.unplaced;
  }
  stills.series.insert(dicom.data.text(kSeries));
  stills.burnedIn = stills.burnedIn || dicom.data.text(kBurnedIn) == "YES";
  const Removed removed = identifyingFields(dicom.data);
  for (const Message& field : removed.fields)
    if (std::find(stills.removed.fields.begin(), stills.removed.fields.end(), field) == stills.removed.fields.end())
      stills.removed.fields.push_back(field);
  stills.removed.privateFields = std::max(stills.removed.privateFields, removed.privateFields);
  stills.files.push_back(dicom.file);
  if (layout.inColour() || (layout.bitsStored == 8 && !layout.isSigned)) return {};
  stills.deep = true;
  const auto reader = FrameReader::open(dicom, layout);
  if (!reader) return passOn(reader.error());
  std::vector<std::int32_t> level;
  std::vector<std::uint8_t> coloured;
  if (auto got = reader->read(0, level, coloured, progress); !got) return got;
  const auto [low, high] = std::minmax_element(level.begin(), level.end());
  stills.lowest = std::min(stills.lowest, *low);
  stills.highest = std::max(stills.highest, *high);
  return {};
}

Result<Stills> lookThrough(const fs::path& folder, Progress& progress, const ReaderLimits& limits) {
  const auto files = dicomFilesIn(folder);
  if (files.size() > kMostStills)
    return failure(
        ErrorCode::tooLarge,
        say<"%1 holds %2 DICOM files, more than are joined (%3); put fewer into the folder.">(quoted(folder), files.size(), kMostStills),
        {{"file", folder.string()}});
  Stills stills;
  for (std::size_t n = 0; n < files.size(); ++n) {
    if (progress.cancelRequested()) return stopped(folder);
    const auto dicom = readDicomFile(files[n], limits.maxBytes, progress);
    if (!dicom) return passOn(dicom.error());
    if (dicom->data.find(0x7FE00010u) == nullptr) continue;  // a DICOMDIR or a report beside the images
    const auto layout = pixelLayoutOf(*dicom, limits);
    if (!layout) return passOn(layout.error());
    if (auto looked = lookAt(*dicom, *layout, stills, folder, progress); !looked) return passOn(looked.error());
    progress.report(say<"Looking at the stills">(), 0.5 * static_cast<double>(n + 1) / static_cast<double>(files.size()));
  }
  if (stills.files.empty())
    return notOneVolume(folder, say<"%1 holds no images (.png, .jpg, .pgm) and no DICOM files with images.">(quoted(folder)));
  return stills;
}

Result<void> checkOneVolume(const Stills& stills, const fs::path& folder) {
  if (stills.series.size() > 1)
    return notOneVolume(
        folder, say<"%1 holds DICOM stills of %2 series; put those of one volume into a folder of their own, or import one by one.">(
                    quoted(folder), stills.series.size()));
  if (stills.unplaced > 0)
    return notOneVolume(
        folder,
        say<"%1 of the %2 DICOM stills of %3 do not say where they lie (Pixel Spacing, Image Position and Orientation), so that they "
            "cannot be joined to a volume; import them one by one.">(stills.unplaced, stills.files.size(), quoted(folder)));
  return {};
}

/// Levels of one still, mapped as those of all are.
Result<void> addStill(const fs::path& file, const Stills& stills, const DicomStackOptions& options, const ReaderLimits& limits,
                      StackVolume& made, std::uint64_t& colouredPixels, const Progress& progress) {
  const auto dicom = readDicomFile(file, limits.maxBytes, progress);
  if (!dicom) return passOn(dicom.error());
  const auto layout = pixelLayoutOf(*dicom, limits);
  if (!layout) return passOn(layout.error());
  const auto reader = FrameReader::open(*dicom, *layout);
  if (!reader) return passOn(reader.error());
  std::vector<std::int32_t> level;
  std::vector<std::uint8_t> coloured;
  if (auto got = reader->read(0, level, coloured, progress); !got) return got;
  const bool inverted = layout->photometric == "MONOCHROME1";
  const double lowest = stills.deep ? stills.lowest : 0.0;
  const double span = stills.deep ? std::max(1.0, static_cast<double>(stills.highest) - stills.lowest) : 255.0;
  std::vector<std::uint8_t> grey(level.size());
  for (std::size_t p = 0; p < level.size(); ++p) {
    const auto value = static_cast<int>(std::lround(255.0 * std::clamp((level[p] - lowest) / span, 0.0, 1.0)));
    grey[p] = static_cast<std::uint8_t>(inverted ? 255 - value : value);
  }
  const int columns = static_cast<int>(stills.columns), rows = static_cast<int>(stills.rows);
  blank(coloured, columns, rows, options.blank);
  made.removed.pixelsPerFrame = blank(grey, columns, rows, options.blank);
  colouredPixels += static_cast<std::uint64_t>(std::count(coloured.begin(), coloured.end(), 1));
  if (options.colour == ColourRule::dropColour)
    for (std::size_t p = 0; p < coloured.size(); ++p)
      if (coloured[p] != 0) grey[p] = 0;
  made.volume.echo.insert(made.volume.echo.end(), grey.begin(), grey.end());
  return {};
}

}  // namespace

std::vector<fs::path> dicomFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.is_regular_file(ignored) && isDicom(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Result<StackVolume> readDicomStack(const fs::path& folder, const DicomStackOptions& options, Progress& progress,
                                   const ReaderLimits& limits) try {
  auto stills = lookThrough(folder, progress, limits);
  if (!stills) return passOn(stills.error());
  if (auto one = checkOneVolume(*stills, folder); !one) return passOn(one.error());
  if (stills->burnedIn && options.blank.empty() && !options.keepText)
    return failure(ErrorCode::unsupported,
                   say<"The images of %1 have text burned in, which may name the patient; name the rectangles to make black, or say that "
                       "the text may stay.">(quoted(folder)),
                   {{"file", folder.string()}, {"ask", "blank"}});
  StackVolume made;
  made.notes = stills->notes;
  const auto stack = stackOf(stills->planes, static_cast<int>(stills->columns), static_cast<int>(stills->rows), folder, limits, made.notes);
  if (!stack && stack.error().code == ErrorCode::unsupported)
    return notOneVolume(folder,
                        say<"The DICOM stills of %1 do not lie parallel and in line, so that they are no volume; import them one by "
                            "one.">(quoted(folder)));
  if (!stack) return passOn(stack.error());
  const std::vector<fs::path> broken = brokenStillsIn(folder, stills->files);
  if (!options.acceptsSmall)
    if (auto whole = checkNoGap(*stack, broken, folder); !whole) return passOn(whole.error());
  if (!broken.empty()) made.notes.push_back(say<"Left out of %1, because they hold no DICOM data: %2.">(quoted(folder), namesOf(broken)));
  if (stack->grid.voxelCount() > limits.maxBytes)
    return failure(ErrorCode::tooLarge,
                   say<"The images would need %1 bytes of memory, but the limit is %2; take fewer or smaller ones.">(
                       stack->grid.voxelCount(), limits.maxBytes),
                   {{"file", folder.string()}});
  made.removed = stills->removed;
  std::uint64_t colouredPixels = 0;
  for (std::size_t n = 0; n < stills->planes.size(); ++n) {
    if (progress.cancelRequested()) return stopped(folder);
    const fs::path& file = stills->files[stills->planes[n].frame];
    if (auto added = addStill(file, *stills, options, limits, made, colouredPixels, progress); !added) return passOn(added.error());
    progress.report(say<"Reading images">(), 0.5 + 0.5 * static_cast<double>(n + 1) / static_cast<double>(stills->planes.size()));
  }
  made.removed.blanked = options.blank;
  if (auto settled = settleStackColours(colouredPixels, made.volume.echo.size(), options.colour, folder, made.notes); !settled)
    return passOn(settled.error());
  auto echo = echoOnto(*stack, std::move(made.volume.echo), folder, progress);
  if (!echo) return passOn(echo.error());
  made.volume.grid = stack->grid;
  made.volume.echo = *std::move(echo);
  if (stills->deep)
    made.notes.push_back(say<"The samples have more than 8 bits: values from %1 to %2 of all stills were mapped to 0 to 255.">(
        stills->lowest, stills->highest));
  made.notes.push_back(say<"%1 DICOM stills were joined by their positions, which became the volume's place, in mm to the patient's left, "
                           "posterior and superior.">(stills->planes.size()));
  if (!stills->burnedIn) made.notes.push_back(say<"Images may have text burned in; check that they name nobody.">());
  return made;
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for the images of %1; close other programs.">(quoted(folder)),
                 {{"file", folder.string()}});
}

Result<DicomStackImage> readFirstOfDicomStack(const fs::path& folder, Progress& progress, const ReaderLimits& limits) {
  DicomStackOptions all;
  all.colour = ColourRule::keepGrey;
  all.keepText = true;
  all.acceptsSmall = true;
  auto whole = readDicomStack(folder, all, progress, limits);
  if (!whole) return passOn(whole.error());
  DicomStackImage first;
  const Grid& grid = whole->volume.grid;
  first.level = GreyImage(grid.dims.x, grid.dims.y);
  std::copy_n(whole->volume.echo.begin(), first.level.pixels.size(), first.level.pixels.begin());
  first.spacing_mm = grid.spacing_mm;
  return first;
}

}  // namespace ew
