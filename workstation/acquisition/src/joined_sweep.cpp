#include "ew/acquisition/joined_sweep.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "body_signal.h"
#include "ew/core/contract.h"
#include "ew/core/ending.h"
#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/io/cine_reader.h"
#include "ew/io/pose_table.h"
#include "pose_track.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// From one named frame to another.
using Way = std::pair<std::string, std::string>;

/// A moment to the millisecond, whatever its zero is.
Message shownMoment(double time_s) { return numeral(textOf(std::round(time_s * 1e3) / 1e3)); }

bool isTable(const fs::path& file) { return hasEnding(file, ".csv") || hasEnding(file, ".tsv") || hasEnding(file, ".txt"); }

bool mayBeSequence(const fs::path& file) {
  return hasEnding(file, ".mha") || hasEnding(file, ".mhd") || hasEnding(file, ".nrrd") || hasEnding(file, ".nhdr") ||
         hasEnding(file, ".nii") || hasEnding(file, ".nii.gz");
}

tl::unexpected<Error> rateUnknown(const fs::path& file) {
  return failure(ErrorCode::badField,
                 say<"\"%1\" does not say when its images were recorded, so that poses cannot be joined with them; give the images' rate.">(
                     file.filename()),
                 {{"file", file.string()}, {"field", "time"}, {"ask", "rate"}});
}

/// The slices of a volume as images, in the order in which they are stored.
Result<Sequence> slicesOf(const fs::path& file, Progress& progress, const ReaderLimits& limits) {
  auto read = readVolume(file, progress, limits);
  if (!read) return passOn(read.error());
  const glm::ivec3 dims = read->volume.grid.dims;
  Sequence images;
  images.width = dims.x;
  images.height = dims.y;
  SequenceFrame frame;
  frame.imageStatus = PoseStatus::ok;
  images.frames.assign(static_cast<std::size_t>(dims.z), frame);
  images.pixels = std::move(read->volume.echo);
  images.notes = std::move(read->notes);
  images.notes.push_back(
      say<"\"%1\" is a volume; each of its %2 slices was taken for an image, and what it says of its place was not used.">(file.filename(),
                                                                                                                           dims.z));
  return images;
}

/// Everything that CineReader reads, as images in memory.
Result<Sequence> imagesOf(const fs::path& file, const std::optional<double>& rate_hz, Progress& progress, const ReaderLimits& limits) {
  PartOfProgress opening(progress, 0.0, 0.1), reading(progress, 0.1, 1.0);
  auto reader = CineReader::open(file, opening, limits, {}, rate_hz);
  if (!reader) return passOn(reader.error());
  const CineInfo& info = reader->info();
  if (info.assumedRate_hz > 0.0) return rateUnknown(file);
  Sequence images;
  images.width = info.width_px;
  images.height = info.height_px;
  images.imageType = "BRIGHTNESS";
  const Message what = say<"Reading frames">();
  CineFrame image;
  while (true) {
    const auto got = reader->next(image, progress);
    if (!got) return passOn(got.error());
    if (!*got) break;
    if (images.pixels.size() + image.level.pixels.size() > limits.maxBytes)
      return failure(ErrorCode::tooLarge,
                     say<"The images of \"%1\" need more than the %2 MiB of memory that a recording may take; cut it into parts.">(
                         file.filename(), limits.maxBytes >> 20),
                     {{"file", file.string()}});
    SequenceFrame frame;
    frame.time_s = image.time_s;
    frame.imageStatus = PoseStatus::ok;
    images.frames.push_back(std::move(frame));
    images.pixels.insert(images.pixels.end(), image.level.pixels.begin(), image.level.pixels.end());
    if (info.frames > 0) reading.report(what, std::min(1.0, static_cast<double>(images.frames.size()) / static_cast<double>(info.frames)));
  }
  images.notes = info.notes;
  if (reader->brokenOff()) images.notes.push_back(reader->brokenOff()->message);
  if (images.frames.empty())
    return failure(ErrorCode::truncated, say<"'%1' has no frames that can be read.">(file.filename()), {{"file", file.string()}});
  return images;
}

/// Every way that the poses state, over their times.
class TransformTimeline {
 public:
  /// @error badField
  static Result<TransformTimeline> of(const Sequence& poses, const fs::path& name) {
    TransformTimeline ways;
    for (std::size_t n = 0; n < poses.frames.size(); ++n) {
      const SequenceFrame& frame = poses.frames[n];
      if (!frame.time_s)
        return failure(ErrorCode::badField,
                       say<"Pose %1 of \"%2\" has no time, so that it cannot be joined with images; export the tracking with its times.">(
                           n, name.filename()),
                       {{"file", name.string()}, {"field", "time"}});
      if (n > 0 && *frame.time_s < ways.time_s_.back())
        return failure(ErrorCode::badField,
                       say<"In \"%1\" time runs backwards at pose %2 (%3 s after %4 s); put the poses in the order of time.">(
                           name.filename(), n, shownMoment(*frame.time_s), shownMoment(ways.time_s_.back())),
                       {{"file", name.string()}, {"field", "time"}});
      ways.time_s_.push_back(*frame.time_s);
    }
    EW_EXPECTS(!ways.time_s_.empty());
    std::map<Way, FramePoses> given;
    for (std::size_t n = 0; n < poses.frames.size(); ++n)
      for (const FrameTransform& one : poses.frames[n].transforms) {
        FramePoses& way = given[{one.from, one.to}];
        way.resize(poses.frames.size());
        if (one.status == PoseStatus::ok) way[n] = Transform<frame::World, frame::Image>{one.matrix};
      }
    ways.longestGap_s_ = longestGapOf(0.0, ways.time_s_);
    for (const auto& [way, there] : given) ways.tracks_.emplace(way, PoseTrack(ways.time_s_, there, glm::dvec2(0.0), ways.longestGap_s_));
    return ways;
  }

  [[nodiscard]] double first_s() const { return time_s_.front(); }
  [[nodiscard]] double last_s() const { return time_s_.back(); }
  [[nodiscard]] double longestGap_s() const { return longestGap_s_; }
  [[nodiscard]] bool states(const FrameTransform& one) const {
    return tracks_.contains({one.from, one.to}) || tracks_.contains({one.to, one.from});
  }

  /// A time of a pose that is the same moment but for how two files round it, else the time itself.
  [[nodiscard]] double nearestMoment(double t_s) const {
    const double same_s = std::max(1e-6, 1e-15 * std::abs(t_s));
    const auto after = std::lower_bound(time_s_.begin(), time_s_.end(), t_s - same_s);
    return after != time_s_.end() && *after <= t_s + same_s ? *after : t_s;
  }

  /// How far the two poses lie apart between which a moment lies; 0 at the moment of a pose and outside of all.
  [[nodiscard]] double stepAround_s(double t_s) const {
    const auto after = std::lower_bound(time_s_.begin(), time_s_.end(), t_s);
    if (after == time_s_.begin() || after == time_s_.end() || *after == t_s) return 0.0;
    return *after - *std::prev(after);
  }

  /// The transforms of a moment; those that are not known are marked invalid.
  [[nodiscard]] std::vector<FrameTransform> at(double t_s) const {
    std::vector<FrameTransform> all;
    for (const auto& [way, track] : tracks_) {
      const auto pose = track.at(t_s);
      all.push_back({way.first, way.second, pose ? pose->matrix : glm::dmat4(1.0), pose ? PoseStatus::ok : PoseStatus::invalid});
    }
    return all;
  }

 private:
  std::vector<double> time_s_;
  double longestGap_s_ = 0.0;
  std::map<Way, PoseTrack> tracks_;
};

/// The first and the last moment of the images. @error badField (an image without a time)
Result<std::pair<double, double>> momentsOf(const Sequence& images) {
  std::pair<double, double> range_s(HUGE_VAL, -HUGE_VAL);
  for (std::size_t n = 0; n < images.frames.size(); ++n) {
    const auto& time_s = images.frames[n].time_s;
    if (!time_s)
      return failure(ErrorCode::badField,
                     say<"Image %1 of the recording has no time, so that poses cannot be joined with it; give the images' rate.">(n),
                     {{"field", "time"}, {"ask", "rate"}});
    range_s = {std::min(range_s.first, *time_s), std::max(range_s.second, *time_s)};
  }
  return range_s;
}

/// The usual time between two images; 0: there is one alone.
double stepOf(const Sequence& images) {
  std::vector<double> steps_s;
  for (std::size_t n = 1; n < images.frames.size(); ++n)
    steps_s.push_back(std::abs(*images.frames[n].time_s - *images.frames[n - 1].time_s));
  return medianOrZero(std::move(steps_s));
}

/// Refuses to read poses between neighbours that lie much farther apart than the images do, where a probe may have been anywhere.
/// @param step_s of the two poses around an image, the longest
Result<void> checkDense(double step_s, const Sequence& images, const fs::path& name) {
  constexpr double longestStep_s = 1.0, mostImages = 10.0;
  const double imageStep_s = stepOf(images);
  if (step_s <= longestStep_s || imageStep_s <= 0.0 || step_s <= mostImages * imageStep_s) return {};
  return failure(ErrorCode::badField,
                 say<"Images lie between poses of \"%1\" that are %2 s apart, while the images are %3 s apart: do the poses count "
                     "milliseconds? Correct their times (in a table a column time_ms counts milliseconds), or export the tracking with "
                     "more poses.">(name.filename(), numeral(figureText(step_s, 3)), numeral(figureText(imageStep_s, 3))),
                 {{"file", name.string()}, {"field", "time"}});
}

/// Where the poses come from, and which one an image has.
Message joinedFrom(const fs::path& name, std::size_t poses, double first_s, double last_s, double offset_s) {
  const Message moment = offset_s < 0.0 ? say<"t - %1 s">(numeral(textOf(-offset_s))) : say<"t + %1 s">(numeral(textOf(offset_s)));
  if (poses == 1)
    return say<"The poses come from \"%1\", where there is one alone, at %2 s; an image of time t has the pose of %3.">(
        name.filename(), shownMoment(first_s), moment);
  return say<"The poses come from \"%1\", where there are %2 from %3 to %4 s; an image of time t has the pose of %5.">(
      name.filename(), poses, shownMoment(first_s), shownMoment(last_s), moment);
}

/// The size of a pixel by a transform from Image or to it; empty: it is none, or not usable.
std::optional<glm::dvec2> pixelSizeBy_mm(const FrameTransform& one) {
  if (one.status != PoseStatus::ok || (one.from != "Image" && one.to != "Image")) return std::nullopt;
  const glm::dmat4 from = one.from == "Image" ? one.matrix : glm::inverse(one.matrix);
  return glm::dvec2(glm::length(glm::dvec3(from[0])), glm::length(glm::dvec3(from[1])));
}

}  // namespace

Result<Sequence> readPoses(const fs::path& file, Progress& progress, const ReaderLimits& limits) {
  if (!isTable(file) && !mayBeSequence(file))
    return failure(
        ErrorCode::unsupported,
        say<"\"%1\" has an ending of which no poses are read; give a table of text (.csv, .tsv, .txt) or a tracked sequence (.mha, "
            ".mhd, .nrrd, .nhdr).">(file.filename()),
        {{"file", file.string()}});
  auto poses = isTable(file) ? readPoseTable(file) : readSequence(file, progress, limits);
  if (!poses) return passOn(poses.error());
  const bool isTracked =
      std::any_of(poses->frames.begin(), poses->frames.end(), [](const SequenceFrame& frame) { return !frame.transforms.empty(); });
  if (!isTracked)
    return failure(ErrorCode::noValidPose,
                   say<"\"%1\" holds no poses; give the file with the tracking: a tracked sequence, or a table (.csv) of times and poses.">(
                       file.filename()),
                   {{"file", file.string()}});
  poses->pixels = {};
  if (!isTable(file))
    for (Message& note : poses->notes) note = say<"Of \"%1\": %2">(file.filename(), note);
  return poses;
}

Result<void> checkPixelsOf(const Sequence& poses, const DeviceSet& device, const fs::path& name) {
  const glm::dvec2 one_mm(1.0);
  const auto differs = [&](const std::optional<glm::dvec2>& pixel_mm) { return pixel_mm && glm::distance(*pixel_mm, one_mm) > 1e-3; };
  const auto calibrated = std::find_if(device.transforms.begin(), device.transforms.end(),
                                       [&](const FrameTransform& each) { return differs(pixelSizeBy_mm(each)); });
  if (calibrated == device.transforms.end()) return {};
  const glm::dvec2 pixel_mm = *pixelSizeBy_mm(*calibrated);
  for (const SequenceFrame& frame : poses.frames)
    for (const FrameTransform& each : frame.transforms) {
      const auto posed_mm = pixelSizeBy_mm(each);
      if (!posed_mm) continue;
      if (differs(posed_mm)) return {};
      return failure(
          ErrorCode::badField,
          say<"The poses of \"%1\" lead from %2 to %3 and make a pixel 1 x 1 mm, as quaternions do, but the device set says %4 x "
              "%5 mm. If they are those of the probe, name them so (transform: ProbeToTracker); else give matrices that scale, or "
              "leave the device set away.">(name.filename(), each.from, each.to, numeral(figureText(pixel_mm.x, 3)),
                                            numeral(figureText(pixel_mm.y, 3))),
          {{"file", name.string()}, {"field", "transform"}});
    }
  return {};
}

Result<Sequence> readImages(const fs::path& file, const std::optional<double>& rate_hz, Progress& progress, const ReaderLimits& limits,
                            const SequenceCheck& beforePixels) {
  const auto ends = [&](std::initializer_list<const char*> endings) {
    return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return hasEnding(file, ending); });
  };
  if (!ends({".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".nii.gz"})) return imagesOf(file, rate_hz, progress, limits);
  const auto sequence = isSequence(file);
  if (!sequence) return passOn(sequence.error());
  auto images = *sequence ? readSequence(file, progress, limits, beforePixels) : slicesOf(file, progress, limits);
  if (!images) return passOn(images.error());
  if (rate_hz) timeEvenly(*images, *rate_hz);
  return images;
}

void timeEvenly(Sequence& images, double rate_hz) {
  EW_EXPECTS(rate_hz > 0.0);
  for (std::size_t n = 0; n < images.frames.size(); ++n) images.frames[n].time_s = static_cast<double>(n) / rate_hz;
}

Result<std::vector<Message>> joinPoses(Sequence& images, const Sequence& poses, double offset_s, const fs::path& name) {
  const auto ways = TransformTimeline::of(poses, name);
  if (!ways) return passOn(ways.error());
  const auto range_s = momentsOf(images);
  if (!range_s) return passOn(range_s.error());
  const double first_s = ways->nearestMoment(range_s->first + offset_s), last_s = ways->nearestMoment(range_s->second + offset_s);
  if (last_s < ways->first_s() || first_s > ways->last_s())
    return failure(
        ErrorCode::noValidPose,
        say<"The images and the poses of \"%1\" have no moment in common: images from %2 to %3 s (with an offset of %4 s), poses from "
            "%5 to %6 s; state the offset between their clocks.">(name.filename(), shownMoment(first_s), shownMoment(last_s),
                                                                  numeral(textOf(offset_s)), shownMoment(ways->first_s()),
                                                                  shownMoment(ways->last_s())),
        {{"file", name.string()}, {"field", "time"}, {"ask", "time-offset"}});
  std::size_t outside = 0, between = 0;
  double longestStep_s = 0.0;
  for (SequenceFrame& frame : images.frames) {
    const double t_s = ways->nearestMoment(*frame.time_s + offset_s);
    std::erase_if(frame.transforms, [&](const FrameTransform& own) { return ways->states(own); });
    std::vector<FrameTransform> joined = ways->at(t_s);
    const bool isOutside = t_s < ways->first_s() || t_s > ways->last_s();
    const bool isPosed = std::any_of(joined.begin(), joined.end(), [](const FrameTransform& one) { return one.status == PoseStatus::ok; });
    outside += isOutside ? 1 : 0;
    between += !isOutside && !isPosed ? 1 : 0;
    if (isPosed) longestStep_s = std::max(longestStep_s, ways->stepAround_s(t_s));
    frame.transforms.insert(frame.transforms.end(), std::make_move_iterator(joined.begin()), std::make_move_iterator(joined.end()));
  }
  if (auto dense = checkDense(longestStep_s, images, name); !dense) return passOn(dense.error());
  std::vector<Message> notes = poses.notes;
  notes.push_back(joinedFrom(name, poses.frames.size(), ways->first_s(), ways->last_s(), offset_s));
  if (outside > 0)
    notes.push_back(say<"Images outside the times of the poses, which count as invalid: %1 of %2.">(outside, images.frames.size()));
  if (between > 0)
    notes.push_back(say<"Images between poses that are not valid or more than %1 s apart, which count as invalid: %2 of %3.">(
        numeral(figureText(ways->longestGap_s())), between, images.frames.size()));
  return notes;
}

}  // namespace ew
