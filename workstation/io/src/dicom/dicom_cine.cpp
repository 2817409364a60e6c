#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <new>
#include <numeric>

#include "dicom/dicom_fields.h"
#include "ew/core/numbers.h"
#include "ew/io/dicom.h"
#include "ew/io/retention.h"
#include "files/grey_samples.h"
#include "files/image_header.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

std::string number(double value) { return textOf(std::round(value * 1e6) / 1e6); }

std::string percent(double share) { return textOf(std::round(share * 10000.0) / 100.0) + " %"; }

Message listed(const std::vector<UltrasoundRegion>& regions) {
  std::vector<Message> list;
  for (std::size_t n = 0; n < regions.size(); ++n) list.push_back(regions[n].describe(n + 1));
  return joined(std::move(list), "; ");
}

/// How rectangles lie to each other, as in "two images side by side".
Message arrangementOf(const std::vector<UltrasoundRegion>& regions, const std::vector<std::size_t>& chosen) {
  bool areSame = false, isInside = false, overlap = false, besideAll = true, aboveAll = true;
  for (std::size_t n = 0; n < chosen.size(); ++n)
    for (std::size_t m = n + 1; m < chosen.size(); ++m) {
      const PixelRect &a = regions[chosen[n]].rect, &b = regions[chosen[m]].rect;
      const auto contains = [](const PixelRect& outer, const PixelRect& inner) {
        return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
               inner.y + inner.height <= outer.y + outer.height;
      };
      const bool beside = a.x + a.width <= b.x || b.x + b.width <= a.x, above = a.y + a.height <= b.y || b.y + b.height <= a.y;
      areSame = areSame || a == b;
      isInside = isInside || contains(a, b) || contains(b, a);
      overlap = overlap || (!beside && !above);
      besideAll = besideAll && beside;
      aboveAll = aboveAll && above;
    }
  if (areSame) return say<"of which two take the same place">();
  if (isInside) return chosen.size() == 2 ? say<"one inside the other">() : say<"of which one lies inside another">();
  if (overlap) return say<"that overlap">();
  if (besideAll) return say<"side by side">();
  return aboveAll ? say<"one above the other">() : say<"apart from each other">();
}

/// The shape of a pixel, as in "its pixels are 2 times as high as wide".
Message shapeOf(double heightByWidth) {
  const double ratio = std::round(heightByWidth * 100.0) / 100.0;
  return ratio == 1.0 ? say<"as high as wide">() : say<"%1 times as high as wide">(numeral(textOf(ratio)));
}

struct Chosen {
  PixelRect rect;
  glm::dvec2 pixel_mm{0.0};
  const UltrasoundRegion* region = nullptr;  ///< null: the whole image
};

/// The size of a pixel given for a whole image, held against what the file says of its shape.
void noteShape(const DicomScale& scale, const glm::dvec2& given_mm, std::vector<Message>& notes) {
  const double given = given_mm.y / given_mm.x;
  if (scale.spacing_mm && glm::length(*scale.spacing_mm - given_mm) > 0.01 * glm::length(given_mm))
    notes.push_back(say<"The size of a pixel was given: %1 x %2 mm instead of the %3 x %4 mm of Pixel Spacing.">(
        number(given_mm.x), number(given_mm.y), number(scale.spacing_mm->x), number(scale.spacing_mm->y)));
  else if (scale.heightByWidth && std::abs(given - *scale.heightByWidth) > 0.01 * given)
    notes.push_back(
        say<"The size of a pixel was given as %1 x %2 mm, but by its Pixel Aspect Ratio the file has pixels that are %3; check it.">(
            number(given_mm.x), number(given_mm.y), shapeOf(*scale.heightByWidth)));
}

/// What the file says of its pixels although it does not say how large they are.
Message hintOf(const DicomScale& scale) {
  std::vector<Message> hints = scale.hints;
  if (scale.heightByWidth) hints.push_back(say<"Pixel Aspect Ratio: they are %1">(shapeOf(*scale.heightByWidth)));
  return hints.empty() ? Message() : say<"Of its pixels the file says: %1.">(joined(std::move(hints), ", "));
}

Result<Chosen> choose(const fs::path& file, const PixelLayout& layout, const DicomScale& scale, const CineOptions& options,
                      std::vector<Message>& notes) {
  const std::vector<UltrasoundRegion>& regions = scale.regions;
  const PixelRect whole{0, 0, static_cast<int>(layout.columns), static_cast<int>(layout.rows)};
  const auto ask = [&](const char* what, Message sentence) {
    Message hint = std::string_view(what) == "pixel-mm" ? hintOf(scale) : Message();
    // The hint first: what is to be done stands last.
    if (!hint.empty()) sentence = joined({std::move(hint), std::move(sentence)});
    return failure(ErrorCode::missingCalibration, std::move(sentence), {{"file", file.string()}, {"ask", what}});
  };
  if (options.pixel_mm)
    for (int axis = 0; axis < 2; ++axis)
      if (!std::isfinite((*options.pixel_mm)[axis]) || !((*options.pixel_mm)[axis] > 0.0))
        return failure(ErrorCode::badUsage, say<"The size of a pixel must be above 0 mm in both directions.">());
  const auto take = [&](std::size_t index) -> Result<Chosen> {
    const UltrasoundRegion& region = regions[index];
    if (!region.usable() && (region.rect.width < 1 || region.stale))
      return ask("pixel-mm", say<"Region %1 of %2 cannot be used; take the whole image and give the size of a pixel in mm.">(
                                 region.describe(index + 1), quoted(file)));
    if (!region.usable() && !options.pixel_mm)
      return ask("pixel-mm", say<"Region %1 of %2 cannot be used as it is; give the size of a pixel in mm, or choose another region.">(
                                 region.describe(index + 1), quoted(file)));
    if (options.pixel_mm && region.usable())
      notes.push_back(say<"The size of a pixel was given: %1 x %2 mm instead of the %3 x %4 mm of the region.">(
          number(options.pixel_mm->x), number(options.pixel_mm->y), number(region.pixel_mm().x), number(region.pixel_mm().y)));
    return Chosen{region.rect, options.pixel_mm.value_or(region.pixel_mm()), &region};
  };
  const auto takeWhole = [&] {
    if (options.pixel_mm)
      noteShape(scale, *options.pixel_mm, notes);
    else
      notes.push_back(say<"The file has no ultrasound region; the size of a pixel is that of its Pixel Spacing, %1 x %2 mm.">(
          number(scale.spacing_mm->x), number(scale.spacing_mm->y)));
    return Chosen{whole, options.pixel_mm.value_or(scale.spacing_mm.value_or(glm::dvec2(0.0))), nullptr};
  };
  if (options.region && *options.region > 0) {
    if (static_cast<std::size_t>(*options.region) > regions.size())
      return ask("region", counted<"%2 has %1 region, no region %3; choose one that is there, or 0 for the whole image.",
                                   "%2 has %1 regions, no region %3; choose one that is there, or 0 for the whole image.">(
                               regions.size(), quoted(file), *options.region));
    return take(static_cast<std::size_t>(*options.region) - 1);
  }
  if (options.region) {  // the whole image
    if (!options.pixel_mm && !scale.spacing_mm)
      return ask("pixel-mm", say<"The whole image of %1 has no size of a pixel of its own; give it in mm.">(quoted(file)));
    return takeWhole();
  }
  if (scale.onlyRegion) return take(*scale.onlyRegion);
  if (scale.bModes.size() > 1)
    return ask("region", say<"%1 shows %2 calibrated images %3 (%4); choose one of the regions.">(
                             quoted(file), scale.bModes.size(), arrangementOf(regions, scale.bModes), listed(regions)));
  if (options.pixel_mm || scale.spacing_mm) return takeWhole();
  if (regions.empty())
    return ask("pixel-mm",
               say<"%1 does not say how large its pixels are (it has no ultrasound regions); give the size in mm.">(quoted(file)));
  return ask(
      "pixel-mm",
      say<"No region of %1 tells how large a pixel is (%2); give the size of a pixel in mm, or choose a region that you know to be right.">(
          quoted(file), listed(regions)));
}

/// Times by the rate that was given, else by the file.
std::vector<double> timesOf(const DicomItem& data, std::uint64_t frames, const std::optional<double>& rate_hz,
                            std::vector<Message>& notes) {
  if (!rate_hz) return frameTimes(data, frames, notes);
  std::vector<Message> ignored;
  const auto stated_s = frameTimes(data, frames, ignored);
  std::vector<double> times_s;
  for (std::uint64_t n = 0; n < frames; ++n) times_s.push_back(static_cast<double>(n) / *rate_hz);
  if (!stated_s.empty() && std::abs(stated_s.back() - times_s.back()) > 0.01 * times_s.back())
    notes.push_back(say<"The rate of the frames was given: they last %1 s instead of the %2 s that the file states.">(
        number(times_s.back()), number(stated_s.back())));
  return times_s;
}

/// The pixels of `rect`, frame by frame, to the front of the same memory.
void crop(std::vector<std::uint8_t>& pixels, std::size_t frames, const PixelLayout& layout, const PixelRect& rect) {
  if (pixels.empty()) return;
  std::uint8_t* to = pixels.data();
  for (std::size_t frame = 0; frame < frames; ++frame)
    for (int y = 0; y < rect.height; ++y) {
      const std::size_t from =
          (frame * layout.rows + static_cast<std::size_t>(rect.y + y)) * layout.columns + static_cast<std::size_t>(rect.x);
      std::memmove(to, pixels.data() + from, static_cast<std::size_t>(rect.width));
      to += rect.width;
    }
  pixels.resize(frames * static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height));
  pixels.shrink_to_fit();
}

bool overlap(const PixelRect& a, const PixelRect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/// What becomes of coloured pixels: as `rule` says, and told in the notes.
Result<void> settleColours(Cine& cine, ColourRule rule, bool flowRegion, const fs::path& file) {
  const auto count = static_cast<double>(std::count(cine.coloured.begin(), cine.coloured.end(), 1));
  cine.colouredShare = cine.coloured.empty() ? 0.0 : count / static_cast<double>(cine.coloured.size());
  if (count == 0.0) {
    cine.coloured.clear();
    return {};
  }
  const std::string share = percent(cine.colouredShare);
  // A few pixels are a marker or the noise of a codec, not a Doppler image.
  constexpr double few = 0.0005;
  if (rule == ColourRule::ask && (cine.colouredShare > few || flowRegion))
    return failure(ErrorCode::unsupported,
                   flowRegion ? say<"In %1 %2 of the pixels are coloured, in a colour flow region, as by Doppler, and echo levels cannot "
                                    "show that; say whether to keep them as grey or to drop them.">(quoted(file), share)
                              : say<"In %1 %2 of the pixels are coloured, as by Doppler, and echo levels cannot show that; say whether to "
                                    "keep them as grey or to drop them.">(quoted(file), share),
                   {{"file", file.string()}, {"ask", "colour"}, {"coloured", percent(cine.colouredShare)}});
  if (rule == ColourRule::dropColour) {
    for (std::size_t n = 0; n < cine.coloured.size(); ++n)
      if (cine.coloured[n] != 0) cine.sequence.pixels[n] = 0;
    cine.notes.push_back(
        flowRegion ? say<"%1 of the pixels are coloured, in a colour flow region; they were made black, and a mask tells where.">(share)
                   : say<"%1 of the pixels are coloured; they were made black, and a mask tells where.">(share));
  } else {
    cine.notes.push_back(
        flowRegion
            ? say<"%1 of the pixels are coloured, in a colour flow region; their luminance became the echo level, and a mask tells where.">(
                  share)
            : say<"%1 of the pixels are coloured; their luminance became the echo level, and a mask tells where.">(share));
  }
  return {};
}

/// The frames of a cine without poses, at these times (s; empty: unknown).
void addFrames(Cine& cine, const std::vector<double>& times_s, std::uint64_t frames) {
  glm::dmat4 imageToPlane(1.0);
  imageToPlane[0][0] = cine.pixel_mm.x;
  imageToPlane[1][1] = cine.pixel_mm.y;
  imageToPlane[2][2] = std::sqrt(cine.pixel_mm.x * cine.pixel_mm.y);
  for (std::uint64_t n = 0; n < frames; ++n) {
    SequenceFrame frame;
    if (!times_s.empty()) frame.time_s = times_s[n];
    frame.transforms.push_back({"Image", "Picture", imageToPlane, PoseStatus::ok});
    cine.sequence.frames.push_back(std::move(frame));
  }
}

/// Notes on where the images lie, and on text that may be burned in (`burnedIn`: the file's word on it).
void tellPlace(Cine& cine, const Chosen& chosen, const std::vector<UltrasoundRegion>& regions, const std::string& burnedIn) {
  cine.notes.push_back(
      say<"The images have no place in space: Picture counts mm from the middle of the upper left pixel, x to the right, y down, %1 x %2 "
          "mm a pixel; the file does not say on which side the probe's marker is.">(number(cine.pixel_mm.x), number(cine.pixel_mm.y)));
  if (chosen.region != nullptr) {
    const UltrasoundRegion& region = *chosen.region;
    cine.notes.push_back(say<"The images were cut to region %1.">(region.describe(static_cast<std::size_t>(&region - regions.data()) + 1)));
    if (region.referencePixel)
      cine.notes.push_back(say<"The region counts its own mm from pixel (%1, %2) of the cut image, where x is %3 and y is %4.">(
          number(region.referencePixel->x), number(region.referencePixel->y), number(10.0 * region.referenceValue.x),
          number(10.0 * region.referenceValue.y)));
  } else if (burnedIn != "NO") {
    cine.notes.push_back(burnedIn == "YES" ? say<"Text is burned into the images; check that what is left names nobody.">()
                                           : say<"The file does not rule out text burned into the images; check that they name nobody.">());
  }
}

}  // namespace

bool isDicom(const fs::path& file) {
  if (!checkIsFile(file)) return false;
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint8_t> beginning(256);
  in.read(reinterpret_cast<char*>(beginning.data()), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return looksLikeDicom(beginning);
}

Result<DicomSummary> inspectDicom(const fs::path& file, const ReaderLimits& limits) {
  const auto dicom = readDicomFile(file, limits.maxBytes);
  if (!dicom) return passOn(dicom.error());
  DicomSummary summary;
  summary.identifying = identifyingFields(dicom->data);
  if (!kretzInside(dicom->data).empty()) {
    summary.kind = DicomKind::kretz;
    return summary;
  }
  const auto layout = pixelLayoutOf(*dicom, limits);
  if (!layout) return passOn(layout.error());
  summary.columns = static_cast<int>(layout->columns);
  summary.rows = static_cast<int>(layout->rows);
  summary.frames = layout->frames;
  summary.photometric = layout->photometric;
  summary.codec = layout->codec;
  const DicomScale scale = scaleOf(dicom->data, layout->columns, layout->rows);
  summary.regions = scale.regions;
  summary.spacing_mm = scale.spacing_mm;
  const std::string burnedIn = dicom->data.text(0x00280301u);
  if (burnedIn == "YES" || burnedIn == "NO") summary.burnedInText = burnedIn == "YES";
  if (dicom->data.text(0x00080016u) == kEnhancedUsVolume) {
    summary.kind = DicomKind::enhancedVolume;
    const auto planes = volumePlanesOf(*dicom, *layout);
    if (!planes) return passOn(planes.error());
    summary.timeSteps_s = timeStepsOf(*planes);
  }
  return summary;
}

Result<Cine> readDicomCine(const fs::path& file, const CineOptions& options, Progress& progress, const ReaderLimits& limits) try {
  const auto dicom = readDicomFile(file, limits.maxBytes, progress);
  if (!dicom) return passOn(dicom.error());
  const auto layout = pixelLayoutOf(*dicom, limits);
  if (!layout) return passOn(layout.error());
  Cine cine;
  cine.notes = layout->notes;
  const DicomScale scale = scaleOf(dicom->data, layout->columns, layout->rows);
  const std::vector<UltrasoundRegion>& regions = scale.regions;
  cine.notes.insert(cine.notes.end(), scale.notes.begin(), scale.notes.end());
  const auto chosen = choose(file, *layout, scale, options, cine.notes);
  if (!chosen) return passOn(chosen.error());
  const auto areaOf = [](const PixelRect& one) { return static_cast<std::uint64_t>(one.width) * static_cast<std::uint64_t>(one.height); };
  if (auto enough = checkKept({.pixels = areaOf(chosen->rect), .pixelsOf = layout->pixelsPerFrame()}, options.acceptsSmall, file); !enough)
    return passOn(enough.error());
  const bool burnedIn = dicom->data.text(0x00280301u) == "YES";
  if (burnedIn && chosen->region == nullptr && options.blank.empty() && !options.keepText)
    return failure(ErrorCode::unsupported,
                   say<"The images of %1 have text burned in, which may name the patient; choose a region, name the rectangles to make "
                       "black, or say that the text may stay.">(quoted(file)),
                   {{"file", file.string()}, {"ask", "blank"}});

  const std::uint64_t frames = options.mostFrames > 0 ? std::min(options.mostFrames, layout->frames) : layout->frames;
  std::vector<std::uint64_t> wanted(frames);
  std::iota(wanted.begin(), wanted.end(), std::uint64_t{0});
  auto grey = readGreyFrames(*dicom, *layout, wanted, limits, progress, cine.notes);
  if (!grey) return passOn(grey.error());
  cine.removed = identifyingFields(dicom->data);
  const PixelRect& rect = chosen->rect;
  const int columns = static_cast<int>(layout->columns), rows = static_cast<int>(layout->rows);
  cine.removed.pixelsPerFrame = blank(grey->level, columns, rows, options.blank);
  blank(grey->coloured, columns, rows, options.blank);
  cine.removed.blanked = options.blank;
  crop(grey->level, frames, *layout, rect);
  crop(grey->coloured, frames, *layout, rect);
  if (chosen->region != nullptr) {
    cine.removed.blankedOutside.push_back(rect);
    const std::uint64_t kept = static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height);
    cine.removed.pixelsPerFrame = std::max(cine.removed.pixelsPerFrame, layout->pixelsPerFrame() - kept);
  }
  cine.sequence.width = rect.width;
  cine.sequence.height = rect.height;
  cine.sequence.pixels = std::move(grey->level);
  cine.coloured = std::move(grey->coloured);
  cine.sequence.imageType = "BRIGHTNESS";
  cine.pixel_mm = chosen->pixel_mm;
  for (Message& note : unusedFields(dicom->data, cine.pixel_mm)) cine.notes.push_back(std::move(note));
  const auto times_s = timesOf(dicom->data, layout->frames, options.rate_hz, cine.notes);
  addFrames(cine, times_s, frames);
  const bool flow = std::any_of(regions.begin(), regions.end(),
                                [&](const UltrasoundRegion& one) { return one.dataType == 2 && overlap(one.rect, rect); });
  if (auto settled = settleColours(cine, options.colour, flow, file); !settled) return passOn(settled.error());
  tellPlace(cine, *chosen, regions, dicom->data.text(0x00280301u));
  progress.report(say<"Reading frames">(), 1.0);
  return cine;
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for the frames of %1; close other programs.">(quoted(file)),
                 {{"file", file.string()}});
}

}  // namespace ew
