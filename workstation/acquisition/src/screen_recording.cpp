#include "ew/acquisition/screen_recording.h"

#include <algorithm>
#include <cmath>

#include "ew/core/numbers.h"

namespace ew {
namespace {

constexpr double kRadian_deg = 57.29577951308232;

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + textOf(std::round(value * 1e4) / 1e4);
  return text;
}

/// The middle of the probe's face, and the way its beams go.
glm::dvec2 faceOf(const FanOutline& outline) {
  if (outline.shape == FanShape::linear) return 0.5 * (outline.corners_px[0] + outline.corners_px[1]);
  const double middle = 0.5 * (outline.left_rad + outline.right_rad);
  return outline.apex_px + outline.near_px * glm::dvec2(std::sin(middle), std::cos(middle));
}

/// Frames of the recording, those that cannot be read with them. One that was read to its end has what it gave, whatever it promises; of
/// one that broke off a guessed number is made anew, by the mean rate of what was read.
std::uint64_t framesThere(const ScreenSurvey& opened) {
  const std::uint64_t given = opened.times_s.size();
  if (!opened.brokenOff) return given;
  const CineInfo& info = opened.reader.info();
  const double read_s = opened.times_s.back();
  if (!info.framesGuessed || !(read_s > 0.0) || !(info.rate_hz > 0.0)) return std::max(info.frames, given);
  const double whole_s = static_cast<double>(info.frames) / info.rate_hz;
  constexpr double kMost = 1e9;
  const double steps = static_cast<double>(given - 1) * whole_s / read_s;
  return std::max(given, 1 + static_cast<std::uint64_t>(std::round(std::min(steps, kMost))));
}

}  // namespace

Result<ScreenSurvey> openScreen(const std::filesystem::path& recording, const std::optional<FanOutline>& outline, Progress& progress,
                                const ReaderLimits& limits, int mostFrames, const Orientation& turned,
                                const std::optional<double>& rate_hz) {
  PartOfProgress opening(progress, 0.0, 0.05), looking(progress, 0.05, 0.9);
  auto reader = CineReader::open(recording, opening, limits, turned, rate_hz);
  if (!reader) return passOn(reader.error());
  ScreenSurvey opened{.recording = recording, .reader = *std::move(reader), .found = {}, .times_s = {}, .image = {}, .brokenOff = {}};
  const CineInfo& info = opened.reader.info();
  ScreenStatistics statistics(info.width_px, info.height_px);
  const std::uint64_t promised = std::max<std::uint64_t>(info.frames, 1);
  const bool isCounted = info.frames > 0 && !info.framesGuessed;
  const auto most = static_cast<std::uint64_t>(std::max(mostFrames, 2));
  std::uint64_t every = isCounted ? std::max<std::uint64_t>(1, promised / most) : 1;
  CineFrame frame;
  const Message what = say<"Looking at the frames">();
  while (true) {
    const auto got = opened.reader.next(frame, progress);
    if (!got) return passOn(got.error());
    if (!*got) break;
    const std::uint64_t n = opened.times_s.size();
    opened.times_s.push_back(frame.time_s);
    // A film that does not say how many frames it has: the later, the sparser.
    if (!isCounted && n >= 2 * every * most) every *= 2;
    if (n % every == 0) statistics.add(frame);
    if (n == 0 || n == promised / 2) opened.image = frame.level;
    looking.report(what, std::min(1.0, static_cast<double>(n + 1) / static_cast<double>(promised)));
  }
  if (opened.times_s.empty())
    return failure(ErrorCode::truncated, say<"'%1' has no frames that can be read.">(recording.filename()), {{"file", recording.string()}});
  opened.brokenOff = opened.reader.brokenOff();
  if (outline) {
    const ScreenAnalysis none{.width_px = info.width_px, .height_px = info.height_px};
    if (const auto usable = corrected(none, {.outline = outline}); !usable) return passOn(usable.error());
  }
  opened.found = findScreen(statistics, outline);
  opened.found.scales = info.scales;
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Looking at the frames was stopped.">());
  progress.report(what, 1.0);
  return opened;
}

Sequence cleanedHeader(const ScreenSurvey& opened, const ScreenGeometry& geometry, const PixelRect& kept) {
  Sequence sequence;
  sequence.width = kept.width;
  sequence.height = kept.height;
  sequence.imageType = "BRIGHTNESS";
  for (const double time_s : opened.times_s) {
    SequenceFrame frame;
    frame.time_s = time_s;
    frame.imageStatus = PoseStatus::ok;
    if (geometry.pixel_mm) {
      glm::dmat4 imageToPlane(*geometry.pixel_mm);
      imageToPlane[3][3] = 1.0;
      frame.transforms.push_back({"Image", "Picture", imageToPlane, PoseStatus::ok});
    }
    sequence.frames.push_back(std::move(frame));
  }
  auto& fields = sequence.otherFields;
  fields.emplace_back("ScreenCroppedFrom", numbers({static_cast<double>(kept.x), static_cast<double>(kept.y),
                                                    static_cast<double>(geometry.width_px), static_cast<double>(geometry.height_px)}));
  if (geometry.pixel_mm) fields.emplace_back("ScreenPixelMm", textOf(*geometry.pixel_mm));
  if (geometry.outline) {
    const FanOutline here = geometry.outline->movedBy(-glm::dvec2(kept.x, kept.y));
    fields.emplace_back("FanShape", here.word());
    if (here.shape == FanShape::linear) {
      const auto& c = here.corners_px;
      fields.emplace_back("FanCornersPixel", numbers({c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y, c[3].x, c[3].y}));
    } else {
      fields.emplace_back("FanOriginPixel", numbers({here.apex_px.x, here.apex_px.y}));
      fields.emplace_back("FanAnglesDeg", numbers({here.left_rad * kRadian_deg, here.right_rad * kRadian_deg}));
      fields.emplace_back("FanRadiusPixel", numbers({here.near_px, here.far_px}));
    }
  }
  return sequence;
}

DeviceSet deviceSetOf(const ScreenGeometry& geometry, const PixelRect& kept) {
  DeviceSet set;
  if (!geometry.outline) return set;
  const FanOutline here = geometry.outline->movedBy(-glm::dvec2(kept.x, kept.y));
  const Clip clip = clipOf(here);
  set.clipOrigin_px = clip.origin_px;
  set.clipSize_px = clip.size_px.value_or(glm::dvec2(kept.width, kept.height));
  if (clip.fan) {
    set.fanAngles_deg = glm::dvec2(clip.fan->leftAngle_rad, clip.fan->rightAngle_rad) * kRadian_deg;
    set.fanOrigin_px = clip.fan->origin_px;
    set.fanRadiusStart_px = clip.fan->startRadius_px;
    set.fanRadiusStop_px = clip.fan->stopRadius_px;
  }
  if (geometry.pixel_mm) {
    const double mm = *geometry.pixel_mm;
    const glm::dvec2 face = faceOf(here);
    glm::dmat4 imageToProbe(mm);
    imageToProbe[3] = glm::dvec4(-mm * face.x, -mm * face.y, 0.0, 1.0);
    set.transforms.push_back({"Image", "Probe", imageToProbe, PoseStatus::ok});
  }
  return set;
}

Retention keptOf(const ScreenSurvey& opened, const ScreenGeometry& geometry, const CleaningOptions& options) {
  const auto areaOf = [](std::uint64_t width, std::uint64_t height) { return width * height; };
  Retention kept{.frames = opened.times_s.size(), .framesOf = framesThere(opened)};
  kept.pixels = kept.pixelsOf = areaOf(static_cast<std::uint64_t>(geometry.width_px), static_cast<std::uint64_t>(geometry.height_px));
  if (!options.keepOutside && geometry.outline) {
    const PixelRect part = ScreenCleaner(geometry, options).kept();
    kept.pixels = areaOf(static_cast<std::uint64_t>(std::max(part.width, 0)), static_cast<std::uint64_t>(std::max(part.height, 0)));
  }
  return kept;
}

Result<ScreenCleaning> writeCleaned(ScreenSurvey& opened, const ScreenGeometry& geometry, const CleaningOptions& options,
                                    const std::filesystem::path& file, Progress& progress) {
  if (!geometry.outline && !options.keepOutside)
    return failure(ErrorCode::unsupported,
                   say<"Where the scan lies is not known, so the recording cannot be cleaned; state its outline in a correction.">());
  if (auto enough = checkKept(keptOf(opened, geometry, options), options.acceptsSmall, opened.recording); !enough)
    return passOn(enough.error());
  if (auto again = opened.reader.rewind(); !again) return passOn(again.error());
  const ScreenCleaner cleaner(geometry, options);
  CineFrame frame;
  GreyImage clean;
  const auto next = [&]() -> Result<std::span<const std::uint8_t>> {
    const auto got = opened.reader.next(frame, progress);
    if (!got) return passOn(got.error());
    if (!*got) return std::span<const std::uint8_t>();
    cleaner.clean(frame.level, clean);
    return std::span<const std::uint8_t>(clean.pixels);
  };
  const Sequence header = cleanedHeader(opened, geometry, cleaner.kept());
  if (auto written = writeSequence(header, next, file, progress); !written) return passOn(written.error());
  ScreenCleaning cleaned{.frames = opened.times_s.size(),
                         .kept = cleaner.kept(),
                         .pixelsInside = cleaner.pixelsInside(),
                         .pixelsFilled = cleaner.pixelsFilled(),
                         .removed = opened.reader.info().removed};
  cleaned.removed.blankedOutside = {cleaner.kept()};
  cleaned.removed.blanked = geometry.text;
  const auto all = static_cast<std::uint64_t>(geometry.width_px) * static_cast<std::uint64_t>(geometry.height_px);
  cleaned.removed.pixelsPerFrame = options.keepOutside ? cleaner.pixelsFilled() : all - cleaner.pixelsInside() + cleaner.pixelsFilled();
  return cleaned;
}

}  // namespace ew
