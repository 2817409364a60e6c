
#include "ew/core/contract.h"
#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/io/sequence.h"
#include "files/image_header.h"
#include "sweeps/transform_name.h"
#include "volumes/meta_writer.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

constexpr WordTable<PoseStatus, 3> kPoseStatusWords{
    {{"OK", PoseStatus::ok}, {"INVALID", PoseStatus::invalid}, {"MISSING", PoseStatus::missing}}};
const char* textOfStatus(PoseStatus status) { return wordIn(kPoseStatusWords, status); }

std::string prefixOf(std::size_t frame) {
  std::string number = std::to_string(frame);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return "Seq_Frame" + number + "_";
}

Result<void> addFrame(const fs::path& file, const SequenceFrame& frame, const std::string& prefix, Fields& fields) {
  for (const FrameTransform& transform : frame.transforms) {
    const std::string joined = transform.from + "To" + transform.to;
    const auto split = splitTransformName(joined);
    if (!split || split->from != transform.from || split->to != transform.to)
      return badField(file, say<"a transform's name">(), verbatim(joined), say<"two frame names that \"To\" joins in one way only">());
    std::string numbers;
    for (const double value : rowsOf(transform.matrix)) numbers += (numbers.empty() ? "" : " ") + textOf(value);
    fields.emplace_back(prefix + joined + "Transform", numbers);
    fields.emplace_back(prefix + joined + "TransformStatus", textOfStatus(transform.status));
  }
  if (frame.time_s) fields.emplace_back(prefix + "Timestamp", textOf(*frame.time_s));
  for (const auto& [key, value] : frame.otherFields) fields.emplace_back(prefix + key, value);
  if (frame.imageStatus != PoseStatus::missing) fields.emplace_back(prefix + "ImageStatus", textOfStatus(frame.imageStatus));
  return {};
}

/// Everything but the pixels. @param hasImages whether there are any
Result<MetaText> metaTextOf(const Sequence& sequence, const fs::path& file, bool hasImages) {
  if (!lowerCase(file.filename().string()).ends_with(".mha"))
    return failure(ErrorCode::unsupported, say<"%1 has an ending that is not written; end its name in .igs.mha.">(quoted(file)),
                   {{"file", file.string()}});
  if (sequence.frames.empty())
    return failure(ErrorCode::badField, say<"The recording has no frames, so %1 was not written; record or open one first.">(quoted(file)),
                   {{"file", file.string()}});
  const std::uint64_t width = hasImages ? static_cast<std::uint64_t>(sequence.width) : 0;
  const std::uint64_t height = hasImages ? static_cast<std::uint64_t>(sequence.height) : 0;
  MetaText text{
      .sizes = {width, height, sequence.frames.size()}, .geometry = {}, .kinds = "domain domain list", .samples = hasImages, .fields = {}};
  if (!sequence.orientation.empty()) text.fields.emplace_back("UltrasoundImageOrientation", sequence.orientation);
  if (!sequence.imageType.empty()) text.fields.emplace_back("UltrasoundImageType", sequence.imageType);
  text.fields.insert(text.fields.end(), sequence.otherFields.begin(), sequence.otherFields.end());
  for (std::size_t frame = 0; frame < sequence.frames.size(); ++frame)
    if (auto added = addFrame(file, sequence.frames[frame], prefixOf(frame), text.fields); !added) return passOn(added.error());
  return text;
}

}  // namespace

Result<void> writeSequence(const Sequence& sequence, const fs::path& file, Progress& progress) {
  const bool hasImages = !sequence.pixels.empty();
  const auto text = metaTextOf(sequence, file, hasImages);
  if (!text) return passOn(text.error());
  const bool complete =
      sequence.width >= 0 && sequence.height >= 0 && sequence.pixels.size() == text->sizes[0] * text->sizes[1] * sequence.frames.size();
  EW_EXPECTS(complete);
  if (!complete)
    return failure(ErrorCode::internal, say<"The recording's pixels do not match its size, so %1 was not written.">(quoted(file)));
  return writeMetaFile(file, *text, sequence.pixels, true, say<"Writing frames">(), progress);
}

Result<void> writeSequence(const Sequence& sequence, const NextFrame& next, const fs::path& file, Progress& progress) {
  EW_EXPECTS(sequence.pixels.empty() && sequence.width > 0 && sequence.height > 0);
  const auto text = metaTextOf(sequence, file, true);
  if (!text) return passOn(text.error());
  const std::size_t size = static_cast<std::size_t>(sequence.width) * static_cast<std::size_t>(sequence.height);
  std::size_t given = 0;
  const auto more = [&]() -> Result<std::span<const std::uint8_t>> {
    if (given == sequence.frames.size()) return std::span<const std::uint8_t>();
    auto pixels = next();
    if (!pixels) return passOn(pixels.error());
    if (pixels->size() != size)
      return failure(ErrorCode::truncated,
                     say<"The recording gave %1 of the %2 frames it has, so %3 was not written; check that the file is still there.">(
                         given, sequence.frames.size(), quoted(file)));
    ++given;
    progress.report(say<"Writing frames">(), static_cast<double>(given) / static_cast<double>(sequence.frames.size()));
    return pixels;
  };
  return writeMetaStream(file, *text, more, progress);
}

}  // namespace ew
