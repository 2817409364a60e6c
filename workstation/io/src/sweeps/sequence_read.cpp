#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "ew/core/contract.h"
#include "ew/core/numbers.h"
#include "ew/io/sequence.h"
#include "files/grey_samples.h"
#include "files/header_fields.h"
#include "files/image_header.h"
#include "sweeps/transform_name.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

/// Of recordings the poses say how large a pixel is, not the header's own geometry.
constexpr std::array kSequenceFields{FieldTableRow{"spacing", FieldTouches::geometry}};

struct Layout {
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  std::uint64_t frames = 0;
};

Result<Layout> layoutOf(const ImageHeader& header) {
  const auto& sizes = header.sizes;
  // Newer writers give each frame a third axis of one slice.
  const bool flatFrames = sizes.size() == 4 && sizes[2] == 1;
  if (sizes.size() != 2 && sizes.size() != 3 && !flatFrames)
    return failure(
        ErrorCode::unsupported,
        say<"%1 has sizes %2, but a recording is width x height x frames; sequences of volumes are not read, export its frames.">(
            quoted(header.file), sizesText(sizes)),
        {{"file", header.file.string()}, {"sizes", sizesText(sizes)}});
  const Layout layout{sizes[0], sizes[1], sizes.size() == 2 ? 1 : sizes.back()};
  constexpr std::uint64_t largest = 1u << 30;
  if (layout.width > largest || layout.height > largest || layout.frames > largest)
    return failure(ErrorCode::tooLarge,
                   say<"The header of %1 promises %2 samples, but an axis may have %3 at most; check that the file is undamaged.">(
                       quoted(header.file), sizesText(sizes), largest),
                   {{"file", header.file.string()}, {"promised", sizesText(sizes)}, {"limit", std::to_string(largest)}});
  if (layout.frames == 0) return badField(header.file, say<"the number of frames">(), verbatim("0"), say<"at least one frame">());
  return layout;
}

Result<void> checkFrameCount(const ImageHeader& header, const Layout& layout, const ReaderLimits& limits) {
  std::uint64_t headerBytes = 0;
  for (const auto& [key, value] : header.fields) headerBytes += key.size() + value.size();
  // Frames without pixels exist only through their fields, so a recording of poses cannot have more frames than header bytes.
  if (layout.width * layout.height == 0 && layout.frames > headerBytes)
    return failure(ErrorCode::badHeader,
                   say<"The header of %1 promises %2 frames without pixels, but describes far fewer in its %3 bytes of fields; check that "
                       "the file is undamaged.">(quoted(header.file), layout.frames, headerBytes),
                   {{"file", header.file.string()}, {"frames", std::to_string(layout.frames)}});
  if (layout.frames > limits.maxBytes / sizeof(SequenceFrame))
    return failure(ErrorCode::tooLarge,
                   say<"The header of %1 promises %2 frames, but only %3 fit the memory limit; cut the recording into parts.">(
                       quoted(header.file), layout.frames, limits.maxBytes / sizeof(SequenceFrame)),
                   {{"file", header.file.string()}, {"frames", std::to_string(layout.frames)}});
  return {};
}

PoseStatus statusOf(std::string_view text) {
  const std::string word = lowerCase(text);  // programs write OK, some in small letters
  if (word == "ok") return PoseStatus::ok;
  return word == "missing" ? PoseStatus::missing : PoseStatus::invalid;
}

/// What the reader noticed on the way, told once instead of once per frame.
struct Remarks {
  std::uint64_t withoutStatus = 0;
  std::uint64_t beyondEnd = 0;
};

/// Whether a transform of this frame waits for its status, by position.
struct OpenFrame {
  std::vector<std::pair<std::string, std::string>> statuses;
};

Result<void> takeTransform(const ImageHeader& header, std::string_view key, std::string_view value, const TransformName& name,
                           SequenceFrame& frame) {
  const auto numbers = parseNumbers(value);
  if (!numbers || numbers->size() != 16)
    return badField(header.file, verbatim(std::string(key)), verbatim(std::string(value)), say<"16 numbers (4 x 4, row by row)">());
  std::array<double, 16> rows{};
  std::copy_n(numbers->begin(), 16, rows.begin());
  const FrameTransform read{name.from, name.to, matrixFromRows(rows), PoseStatus::ok};
  // Real recordings have a handful; looking each one up among the others must not become the work of a broken file.
  constexpr std::size_t most = 1000;
  if (frame.transforms.size() >= most)
    return failure(ErrorCode::unsupported,
                   say<"%1 gives more than %2 transforms for one frame; check that the file is undamaged.">(quoted(header.file), most),
                   {{"file", header.file.string()}, {"field", std::string(key)}});
  const auto same = std::find_if(frame.transforms.begin(), frame.transforms.end(),
                                 [&](const FrameTransform& known) { return known.from == name.from && known.to == name.to; });
  if (same == frame.transforms.end())
    frame.transforms.push_back(read);
  else
    *same = read;
  return {};
}

Result<void> takeFrameField(const ImageHeader& header, std::string_view key, std::string_view name, const std::string& value,
                            SequenceFrame& frame, OpenFrame& open) {
  constexpr std::string_view transform = "Transform";
  constexpr std::string_view transformStatus = "TransformStatus";
  if (name == "Timestamp") {
    const auto time = parseNumber(value);
    if (!time || !std::isfinite(*time))
      return badField(header.file, verbatim(std::string(key)), verbatim(value), say<"a time in seconds">());
    frame.time_s = *time;
    return {};
  }
  if (name == "ImageStatus" || name == "Status") {
    frame.imageStatus = statusOf(value);
    return {};
  }
  if (name.ends_with(transform))
    if (const auto split = splitTransformName(name.substr(0, name.size() - transform.size())))
      return takeTransform(header, key, value, *split, frame);
  if (name.ends_with(transformStatus) && splitTransformName(name.substr(0, name.size() - transformStatus.size()))) {
    open.statuses.emplace_back(name.substr(0, name.size() - transformStatus.size()), value);
    return {};
  }
  frame.otherFields.emplace_back(name, value);
  return {};
}

void applyStatuses(SequenceFrame& frame, OpenFrame& open, Remarks& remarks) {
  std::vector<bool> told(frame.transforms.size(), false);
  for (auto& [joined, value] : open.statuses) {
    const auto name = splitTransformName(joined);
    const auto found = std::find_if(frame.transforms.begin(), frame.transforms.end(),
                                    [&](const FrameTransform& known) { return known.from == name->from && known.to == name->to; });
    if (found == frame.transforms.end()) {
      frame.otherFields.emplace_back(joined + "TransformStatus", value);  // a status without numbers: kept, but no transform
      continue;
    }
    found->status = statusOf(value);
    told[static_cast<std::size_t>(found - frame.transforms.begin())] = true;
  }
  remarks.withoutStatus += static_cast<std::uint64_t>(std::count(told.begin(), told.end(), false));
}

/// The numbers under which a header says something about frames, each once, rising.
std::vector<std::uint64_t> frameNumbersOf(const ImageHeader& header) {
  std::vector<std::uint64_t> numbers;
  for (const auto& [key, value] : header.fields)
    if (const auto frame = frameKey(key); frame && (numbers.empty() || numbers.back() != frame->frame)) numbers.push_back(frame->frame);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Which frame of the recording a number of the header means: the one at that place, or, where numbers reach beyond the last frame and are
/// as many as the frames, the one at the number's place among them.
class FrameNumbering {
 public:
  /// @error badHeader (numbers that begin beyond 0, reach beyond the last frame and are more or fewer than the frames)
  static Result<FrameNumbering> of(const ImageHeader& header, std::size_t frames) {
    FrameNumbering numbering;
    std::vector<std::uint64_t> numbers = frameNumbersOf(header);
    if (numbers.empty() || numbers.back() < frames) return numbering;
    if (numbers.size() == frames) {
      numbering.inOrder_ = std::move(numbers);
      return numbering;
    }
    if (numbers.front() == 0) return numbering;
    return failure(
        ErrorCode::badHeader,
        say<"The header of %1 numbers its frames from %2 to %3 and says something about %4 of them, but the recording has %5, so that "
            "which is which cannot be told; number them from 0 to %6, as in Seq_Frame0000_Timestamp.">(
            quoted(header.file), numbers.front(), numbers.back(), numbers.size(), frames, frames - 1),
        {{"file", header.file.string()}, {"field", "Seq_Frame"}, {"found", std::to_string(numbers.front())}, {"expected", "0"}});
  }

  /// The place of the frame; the number of frames or more where there is none.
  [[nodiscard]] std::uint64_t placeOf(std::uint64_t number) const {
    if (inOrder_.empty()) return number;
    return static_cast<std::uint64_t>(std::lower_bound(inOrder_.begin(), inOrder_.end(), number) - inOrder_.begin());
  }
  void tell(std::vector<Message>& notes) const {
    if (inOrder_.empty()) return;
    notes.push_back(say<"The frames are numbered from %1 to %2 and not from 0 to %3; as they are as many as the images, they were taken in "
                        "their order.">(inOrder_.front(), inOrder_.back(), inOrder_.size() - 1));
  }

 private:
  std::vector<std::uint64_t> inOrder_;  ///< empty: each number is a place
};

Result<void> takeFields(const ImageHeader& header, Sequence& sequence, Progress& progress) {
  const auto numbering = FrameNumbering::of(header, sequence.frames.size());
  if (!numbering) return passOn(numbering.error());
  numbering->tell(sequence.notes);
  std::vector<OpenFrame> open(sequence.frames.size());
  Remarks remarks;
  std::size_t fieldsUntilPoll = 0;
  for (const auto& [key, value] : header.fields) {
    if (fieldsUntilPoll-- == 0) {
      if (progress.cancelRequested()) return stopped(header.file);
      fieldsUntilPoll = 4096;
    }
    if (const auto frame = frameKey(key)) {
      const auto index = static_cast<std::size_t>(numbering->placeOf(frame->frame));
      if (index >= sequence.frames.size()) {
        ++remarks.beyondEnd;
        sequence.otherFields.emplace_back(key, value);
        continue;
      }
      const auto taken = takeFrameField(header, key, frame->name, value, sequence.frames[index], open[index]);
      if (!taken) return passOn(taken.error());
    } else if (key == "UltrasoundImageOrientation") {
      sequence.orientation = value;
    } else if (key == "UltrasoundImageType") {
      sequence.imageType = value;
    } else {
      sequence.otherFields.emplace_back(key, value);
    }
  }
  for (std::size_t frame = 0; frame < sequence.frames.size(); ++frame) applyStatuses(sequence.frames[frame], open[frame], remarks);
  const auto silent = std::count_if(sequence.frames.begin(), sequence.frames.end(), [](const SequenceFrame& frame) {
    return !frame.time_s && frame.transforms.empty() && frame.otherFields.empty() && frame.imageStatus == PoseStatus::missing;
  });
  if (silent > 0)
    sequence.notes.push_back(
        say<"The header says nothing about %1 of %2 frames; their poses and times count as missing.">(silent, sequence.frames.size()));
  if (remarks.withoutStatus > 0)
    sequence.notes.push_back(
        counted<"%1 transform comes without a status and counts as valid.", "%1 transforms come without a status and count as valid.">(
            remarks.withoutStatus));
  if (remarks.beyondEnd > 0)
    sequence.notes.push_back(counted<"The header has %1 field about frames after the last image, number %2; they were kept but not used.",
                                     "The header has %1 fields about frames after the last image, number %2; they were kept but not used.">(
        remarks.beyondEnd, sequence.frames.size() - 1));
  return {};
}

/// Of a header that breaks off: the last frame that something is said of may be half of one and goes, with what is said of it.
Result<void> dropLastFrame(ImageHeader& header) {
  const std::vector<std::uint64_t> numbers = frameNumbersOf(header);
  if (numbers.size() < 2)
    return failure(ErrorCode::truncated, say<"%1 ends before its first frame is whole; nothing of it can be used.">(quoted(header.file)),
                   {{"file", header.file.string()}});
  const std::uint64_t last = numbers.back();
  std::erase_if(header.fields, [&](const auto& field) {
    const auto frame = frameKey(field.first);
    return frame && frame->frame == last;
  });
  // Frames of which nothing is said lie between those numbered from 0; numbers that begin elsewhere count the frames alone.
  header.sizes.back() = numbers.front() == 0 ? last : numbers.size() - 1;
  header.notes.push_back(
      counted<"The end of %2 is missing; the %1 frame before it was read.", "The end of %2 is missing; the %1 frames before it were read.">(
          header.sizes.back(), quoted(header.file)));
  return {};
}

Result<Sequence> sequenceOf(const Result<ImageHeader>& header, const fs::path& file, Progress& progress, const ReaderLimits& limits,
                            const SequenceCheck& beforePixels) {
  if (!header) return passOn(header.error());
  const std::string name = lowerCase(file.filename().string());
  if (name.ends_with(".nii") || name.ends_with(".nii.gz"))
    return failure(ErrorCode::unsupported, say<"%1 is a volume, not a recorded sweep; open it as a volume.">(quoted(file)),
                   {{"file", file.string()}});
  const bool asSequence = describesSequence(*header);
  if (!asSequence && header->hasGeometry && header->sizes.size() > 2)
    return failure(ErrorCode::unsupported,
                   say<"%1 is a volume, not a recorded sweep: its voxels have a place of their own; open it as a volume.">(quoted(file)),
                   {{"file", file.string()}});
  if (header->wantedChannel)
    return failure(
        ErrorCode::unsupported,
        say<"The first axis of %1 runs over its %2 frames, so that they are woven into each other; save it with that axis as the "
            "last.">(quoted(file), header->channels),
        {{"file", file.string()}});
  const auto layout = layoutOf(*header);
  if (!layout) return passOn(layout.error());
  const std::array<std::uint64_t, 3> sizes{layout->width, layout->height, layout->frames};
  const auto pixels = productOf(sizes);
  // What cannot be a real recording is refused before a single frame is made.
  if (!pixels || *pixels > limits.maxBytes)
    return failure(
        ErrorCode::tooLarge,
        say<"The header of %1 promises %2 samples, for which %3 bytes of memory would be needed, but the limit is %4; check that the file "
            "is undamaged, or cut it into parts.">(quoted(file), sizesText(sizes), countText(pixels), limits.maxBytes),
        {{"file", file.string()}, {"needed", countText(pixels).english()}, {"limit", std::to_string(limits.maxBytes)}});
  if (const auto counted = checkFrameCount(*header, *layout, limits); !counted) return passOn(counted.error());

  Sequence sequence;
  sequence.width = static_cast<int>(layout->width);
  sequence.height = static_cast<int>(layout->height);
  SequenceFrame untold;
  untold.imageStatus = PoseStatus::missing;
  sequence.frames.resize(static_cast<std::size_t>(layout->frames), untold);
  if (const auto taken = takeFields(*header, sequence, progress); !taken) return passOn(taken.error());
  if (beforePixels)
    if (const auto checked = beforePixels(sequence); !checked) return passOn(checked.error());
  std::vector<Message> notes = header->notes;
  HeaderFields fields(kSequenceFields);
  const glm::dvec3 spacing_mm = header->geometry.spacing_mm;
  if (spacing_mm.x != 1.0 || spacing_mm.y != 1.0)
    fields.meet("spacing", textOf(spacing_mm.x) + " x " + textOf(spacing_mm.y) + " mm a pixel");
  for (Message& note : fields.unused()) notes.push_back(std::move(note));
  if (!asSequence) notes.push_back(say<"The file does not say that it is a recording; each slice was taken for a frame.">());
  if (*pixels > 0) {
    auto grey = readGrey(*header, {.pixels = *pixels, .promised = *pixels, .what = say<"Reading frames">()}, limits, progress, notes);
    if (!grey) return passOn(grey.error());
    sequence.pixels = *std::move(grey);
  } else {
    notes.push_back(say<"The recording has poses but no images.">());
  }
  sequence.notes.insert(sequence.notes.begin(), notes.begin(), notes.end());
  progress.report(say<"Reading frames">(), 1.0);
  return sequence;
}

}  // namespace

std::span<const std::uint8_t> Sequence::framePixels(std::size_t frame) const {
  EW_EXPECTS(frame < frames.size());
  if (pixels.empty()) return {};
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return std::span(pixels).subspan(frame * size, size);
}

Result<bool> isSequence(const fs::path& file) {
  const auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  return describesSequence(*header);
}

Result<Sequence> readSequence(const fs::path& file, Progress& progress, const ReaderLimits& limits, const SequenceCheck& beforePixels) {
  try {
    return sequenceOf(readImageHeader(file), file, progress, limits, beforePixels);
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::tooLarge,
                   say<"There is not enough memory for the recording %1; close other programs, or cut it into parts.">(quoted(file)),
                   {{"file", file.string()}});
  }
}

Result<Sequence> readPoseSequence(const fs::path& file, Progress& progress, const ReaderLimits& limits) try {
  if (const auto status = checkIsFile(file); !status) return passOn(status.error());
  auto header = readMetaHeader(file, true);
  if (header && productOf(header->sizes) != std::optional<std::uint64_t>(0))
    return failure(ErrorCode::unsupported, say<"%1 holds images, not poses alone; open it as a sweep.">(quoted(file)),
                   {{"file", file.string()}});
  if (header && header->endsEarly)
    if (auto dropped = dropLastFrame(*header); !dropped) return passOn(dropped.error());
  return sequenceOf(header, file, progress, limits, {});
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge,
                 say<"There is not enough memory for the recording %1; close other programs, or cut it into parts.">(quoted(file)),
                 {{"file", file.string()}});
}

}  // namespace ew
