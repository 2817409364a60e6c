#include "dicom/pixel_layout.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

#include "files/image_header.h"

namespace ew::detail {
namespace {

struct Syntax {
  const char* uid;
  const char* name;
};

constexpr std::array kSyntaxes{
    Syntax{"1.2.840.10008.1.2", "uncompressed"},   Syntax{"1.2.840.10008.1.2.1", "uncompressed"},
    Syntax{"1.2.840.10008.1.2.2", "uncompressed"}, Syntax{"1.2.840.10008.1.2.1.99", "uncompressed"},
    Syntax{"1.2.840.10008.1.2.4.50", "JPEG"},      Syntax{"1.2.840.10008.1.2.4.51", "JPEG"},
    Syntax{"1.2.840.10008.1.2.4.57", "JPEG"},      Syntax{"1.2.840.10008.1.2.4.70", "JPEG"},
    Syntax{"1.2.840.10008.1.2.4.80", "JPEG-LS"},   Syntax{"1.2.840.10008.1.2.4.81", "JPEG-LS"},
    Syntax{"1.2.840.10008.1.2.4.90", "JPEG 2000"}, Syntax{"1.2.840.10008.1.2.4.91", "JPEG 2000"},
    Syntax{"1.2.840.10008.1.2.5", "RLE"},
};

std::uint64_t thinnedBytesPerFrame(const PixelLayout& layout) { return layout.rows * ((layout.columns + 1) / 2 * 4); }

std::uint64_t fullBytesPerFrame(const PixelLayout& layout) {
  return layout.pixelsPerFrame() * static_cast<std::uint64_t>(layout.samples) * static_cast<std::uint64_t>(layout.bitsAllocated / 8);
}

/// Packed images that the fragments of pixels hold.
std::uint64_t packedImages(const PixelLayout& layout, const DicomElement& pixels) {
  if (pixels.fragments.empty()) return 0;
  return static_cast<std::uint64_t>(
      std::count_if(pixels.fragments.begin() + 1, pixels.fragments.end(), [&](Bytes fragment) { return layout.beginsImage(fragment); }));
}

bool isEmpty(const DicomItem& data, DicomTag tag) {
  const DicomElement* const element = data.find(tag);
  return element != nullptr && data.text(tag).empty();
}

/// A whole number of the file, within its limits; `otherwise` where the file has none, which also one that is there and empty is.
Result<std::uint64_t> numberOf(const DicomFile& dicom, DicomTag tag, const char* name, std::uint64_t lowest, std::uint64_t highest,
                               std::optional<std::uint64_t> otherwise, std::vector<Message>& notes) {
  const DicomItem& data = dicom.data;
  const auto value = data.count(tag);
  const bool empty = isEmpty(data, tag);
  if (!value && otherwise && (empty || data.find(tag) == nullptr)) {
    if (empty) notes.push_back(say<"%1 is there and empty; %2 was taken, which follows from the rest.">(verbatim(name), *otherwise));
    return *otherwise;
  }
  if (!value || *value < lowest || *value > highest)
    return badField(dicom.file, verbatim(name),
                    value                                ? verbatim(std::to_string(*value))
                    : data.find(tag) == nullptr || empty ? say<"nothing">()
                                                         : verbatim(shortened(data.text(tag))),
                    lowest == highest ? verbatim(std::to_string(lowest)) : say<"a whole number from %1 to %2">(lowest, highest));
  return *value;
}

/// Size, frames and how samples are stored (PS3.3, C.7.6.3).
Result<void> readNumbers(const DicomFile& dicom, PixelLayout& layout) {
  std::vector<Message>& notes = layout.notes;
  const auto rows = numberOf(dicom, 0x00280010u, "Rows", 1, 65535, std::nullopt, notes);
  if (!rows) return passOn(rows.error());
  const auto columns = numberOf(dicom, 0x00280011u, "Columns", 1, 65535, std::nullopt, notes);
  if (!columns) return passOn(columns.error());
  const auto frames = numberOf(dicom, 0x00280008u, "Number of Frames", 0, 1u << 24, 1, notes);
  if (!frames) return passOn(frames.error());
  if (*frames == 0) notes.push_back(say<"The file says that it has 0 frames; it was read as one image.">());
  const auto samples = numberOf(dicom, 0x00280002u, "Samples per Pixel", 1, 3, 1, notes);
  if (!samples) return passOn(samples.error());
  const auto allocated = numberOf(dicom, 0x00280100u, "Bits Allocated", 1, 64, std::nullopt, notes);
  if (!allocated) return passOn(allocated.error());
  if (*allocated != 8 && *allocated != 16)
    return failure(ErrorCode::unsupported, say<"%1 has %2 bits a sample; export it with 8 or 16.">(quoted(dicom.file), *allocated),
                   {{"file", dicom.file.string()}, {"bits", std::to_string(*allocated)}});
  const auto stored = numberOf(dicom, 0x00280101u, "Bits Stored", 1, *allocated, *allocated, notes);
  if (!stored) return passOn(stored.error());
  const auto high = numberOf(dicom, 0x00280102u, "High Bit", *stored - 1, *allocated - 1, *stored - 1, notes);
  if (!high) return passOn(high.error());
  const auto sign = numberOf(dicom, 0x00280103u, "Pixel Representation", 0, 1, 0, notes);
  if (!sign) return passOn(sign.error());
  const auto planar = numberOf(dicom, 0x00280006u, "Planar Configuration", 0, 1, 0, notes);
  if (!planar) return passOn(planar.error());
  layout.rows = *rows;
  layout.columns = *columns;
  layout.frames = std::max<std::uint64_t>(*frames, 1);
  layout.samples = static_cast<int>(*samples);
  layout.bitsAllocated = static_cast<int>(*allocated);
  layout.bitsStored = static_cast<int>(*stored);
  layout.highBit = static_cast<int>(*high);
  layout.isSigned = *sign == 1;
  layout.planar = *planar == 1 && layout.samples == 3;
  return {};
}

Result<void> readColours(const DicomFile& dicom, PixelLayout& layout) {
  layout.photometric = dicom.data.text(0x00280004u);
  const std::string& colours = layout.photometric;
  const bool grey = colours == "MONOCHROME1" || colours == "MONOCHROME2" || colours == "PALETTE COLOR";
  const bool three = colours == "RGB" || colours == "YBR_FULL" || colours == "YBR_FULL_422" || colours == "YBR_PARTIAL_422" ||
                     colours == "YBR_RCT" || colours == "YBR_ICT";
  if (!(grey && layout.samples == 1) && !(three && layout.samples == 3))
    return failure(ErrorCode::unsupported,
                   say<"%1 has the colours %2 in %3 samples a pixel, which is not read; export it as MONOCHROME2 or RGB.">(
                       quoted(dicom.file), colours.empty() ? say<"(none named)">() : verbatim(colours.substr(0, 32)), layout.samples),
                   {{"file", dicom.file.string()}, {"photometric", colours.substr(0, 32)}});
  layout.thinned = layout.codec == "uncompressed" && (colours == "YBR_FULL_422" || colours == "YBR_PARTIAL_422");
  if (three && layout.bitsAllocated != 8)
    return failure(ErrorCode::unsupported, say<"%1 has colours of %2 bits; export it with 8.">(quoted(dicom.file), layout.bitsAllocated),
                   {{"file", dicom.file.string()}});
  return {};
}

Result<void> checkMemory(const DicomFile& dicom, const PixelLayout& layout, const ReaderLimits& limits) {
  // Level, colour mask, and while they are mapped the stored values of one frame.
  const std::uint64_t needed = layout.pixelsPerFrame() * layout.frames * 2;
  if (needed > limits.maxBytes || layout.pixelsPerFrame() > (1ull << 28))
    return failure(ErrorCode::tooLarge,
                   say<"%1 promises %2 frames of %3 x %4 pixels, for which %5 bytes of memory would be needed, but the limit is %6; check "
                       "that the file is undamaged, or cut it into parts.">(quoted(dicom.file), layout.frames, layout.columns, layout.rows,
                                                                            needed, limits.maxBytes),
                   {{"file", dicom.file.string()}, {"needed", std::to_string(needed)}, {"limit", std::to_string(limits.maxBytes)}});
  return {};
}

/// How far the two colour differences are from none (128) if the pixels were stored thinned, or in full, in the mean of the first frame:
/// images of ultrasound are mostly grey.
double colourIf(bool thinned, const DicomElement& pixels, const PixelLayout& layout) {
  const std::size_t count = layout.pixelsPerFrame();
  std::uint64_t sum = 0, looked = 0;
  const auto look = [&](std::size_t at) {
    if (at >= pixels.value.size()) return;
    sum += static_cast<std::uint64_t>(std::abs(static_cast<int>(pixels.value[at]) - 128));
    ++looked;
  };
  if (thinned)
    for (std::size_t at = 2; at < thinnedBytesPerFrame(layout); at += at % 4 == 3 ? 3 : 1) look(at);
  else
    for (std::size_t n = count; n < 3 * count; ++n) look(layout.planar ? n : (n % 2 + 1) + 3 * ((n - count) / 2));
  return looked == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(looked);
}

/// Colours are thinned by the name of the colour model, but their bytes have the last word: files are stored in full under the name of
/// thinned colours, and the other way round.
void settleThinning(const DicomElement& pixels, PixelLayout& layout) {
  if (layout.codec != "uncompressed" || layout.samples != 3 || !layout.photometric.starts_with("YBR")) return;
  const std::uint64_t size = pixels.value.size();
  const std::uint64_t full = fullBytesPerFrame(layout) * layout.frames, thin = thinnedBytesPerFrame(layout) * layout.frames;
  // One byte more makes the length even.
  const auto is = [&](std::uint64_t bytes) { return size == bytes || size == bytes + bytes % 2; };
  if (layout.thinned && is(full) && full > thin && colourIf(false, pixels, layout) <= colourIf(true, pixels, layout)) {
    layout.thinned = false;
    layout.notes.push_back(
        say<"The colours are named %1, but each pixel has its own, by the length of the data; they were read so.">(layout.photometric));
  } else if (!layout.thinned && layout.photometric == "YBR_FULL" && is(thin) && thin < full && !layout.planar) {
    layout.thinned = true;
    layout.notes.push_back(
        say<"The colours are named %1, but two pixels share one, by the length of the data; they were read so.">(layout.photometric));
  }
}

/// Images there are, where the file does not say how many: a number that is missing, empty or 0 means one by the standard, but what is
/// stored is not dropped for that.
void settleFrames(const DicomFile& dicom, const DicomElement& pixels, PixelLayout& layout) {
  const std::uint64_t perFrame = layout.storedBytesPerFrame();
  const bool packed = layout.codec != "uncompressed";
  const std::uint64_t there = packed ? packedImages(layout, pixels) : pixels.value.size() / perFrame;
  const bool stated = dicom.data.count(0x00280008u).value_or(0) > 0;
  const bool whole = packed ? layout.codec != "RLE" : pixels.value.size() - there * perFrame <= 1;
  if (!stated && there > 1 && whole && there < (1u << 24)) {
    layout.frames = there;
    layout.notes.push_back(say<"The file does not say how many frames it has; %1 are stored in it and were read.">(there));
    return;
  }
  if (packed) {
    if (there > layout.frames && layout.codec != "RLE")
      layout.notes.push_back(counted<"The file says that it has %1 frame, but %2 images are stored in it; those beyond were not read.",
                                     "The file says that it has %1 frames, but %2 images are stored in it; those beyond were not read.">(
          layout.frames, there));
    return;
  }
  const std::uint64_t promised = perFrame * layout.frames;
  if (pixels.value.size() <= promised + 1) return;
  // So many bytes too many are no rest of something: other samples or frames than the header says were written.
  const std::uint64_t times = pixels.value.size() / promised, rest = pixels.value.size() % promised;
  if (times > 1 && rest <= times * promised % 2)
    layout.notes.push_back(
        counted<
            "The header promises %1 frame, which takes %2 bytes, but %3 are stored, exactly %4 times as many: the length and the layout "
            "disagree, so that the samples per pixel or the number of frames may be wrong; what lies beyond was not read.",
            "The header promises %1 frames, which take %2 bytes, but %3 are stored, exactly %4 times as many: the length and the layout "
            "disagree, so that the samples per pixel or the number of frames may be wrong; what lies beyond was not read.">(
            layout.frames, promised, pixels.value.size(), times));
  else
    layout.notes.push_back(counted<"The header promises %1 frame, which takes %2 bytes, but %3 are stored; what lies beyond was not read.",
                                   "The header promises %1 frames, which take %2 bytes, but %3 are stored; what lies beyond was not read.">(
        layout.frames, promised, pixels.value.size()));
}

/// Whether the file holds what its header promises.
Result<void> checkStored(const DicomFile& dicom, const DicomElement& pixels, const PixelLayout& layout) {
  const bool encapsulated = layout.codec != "uncompressed";
  if (encapsulated != !pixels.fragments.empty())
    return failure(ErrorCode::badHeader,
                   encapsulated
                       ? say<"%1 says its images are %2, but they are not stored so; export it again.">(quoted(dicom.file), layout.codec)
                       : say<"%1 says its images are uncompressed, but they are not stored so; export it again.">(quoted(dicom.file)),
                   {{"file", dicom.file.string()}});
  if (!encapsulated) {
    const std::uint64_t promised = layout.storedBytesPerFrame() * layout.frames;
    if (pixels.value.size() < promised)
      return failure(
          ErrorCode::truncated,
          say<"%1 is too short: it promises %2 bytes of pixels and has %3; get the file again.">(quoted(dicom.file), promised,
                                                                                                 pixels.value.size()),
          {{"file", dicom.file.string()}, {"promised", std::to_string(promised)}, {"found", std::to_string(pixels.value.size())}});
  } else if (pixels.fragments.size() < layout.frames + 1) {
    return failure(ErrorCode::truncated,
                   say<"%1 is too short: it promises %2 frames and has %3; get the file again.">(quoted(dicom.file), layout.frames,
                                                                                                 pixels.fragments.size() - 1),
                   {{"file", dicom.file.string()}});
  }
  return {};
}
}  // namespace

std::uint64_t PixelLayout::storedBytesPerFrame() const { return thinned ? thinnedBytesPerFrame(*this) : fullBytesPerFrame(*this); }

bool PixelLayout::beginsImage(Bytes fragment) const {
  if (codec == "RLE") return true;
  return fragment.size() > 2 && fragment[0] == 0xFF && (fragment[1] == 0xD8 || fragment[1] == 0x4F);
}

Result<PixelLayout> pixelLayoutOf(const DicomFile& dicom, const ReaderLimits& limits) {
  const DicomElement* const pixels = dicom.data.find(kPixelDataTag);
  if (pixels == nullptr)
    return failure(ErrorCode::unsupported,
                   say<"%1 is a DICOM file without images; choose the file that holds the images.">(quoted(dicom.file)),
                   {{"file", dicom.file.string()}});
  PixelLayout layout;
  const auto known = std::find_if(kSyntaxes.begin(), kSyntaxes.end(), [&](const Syntax& one) { return dicom.transferSyntax == one.uid; });
  if (known == kSyntaxes.end())
    return failure(ErrorCode::unsupported,
                   say<"The images of %1 are packed in a way that is not read (transfer syntax %2); export them uncompressed, as JPEG, "
                       "JPEG-LS, JPEG 2000 or RLE.">(quoted(dicom.file), dicom.transferSyntax.substr(0, 64)),
                   {{"file", dicom.file.string()}, {"transferSyntax", dicom.transferSyntax.substr(0, 64)}});
  layout.codec = known->name;
  if (const auto read = readNumbers(dicom, layout); !read) return passOn(read.error());
  if (const auto read = readColours(dicom, layout); !read) return passOn(read.error());
  layout.notes.insert(layout.notes.begin(), dicom.notes.begin(), dicom.notes.end());
  settleThinning(*pixels, layout);
  settleFrames(dicom, *pixels, layout);
  if (const auto fits = checkMemory(dicom, layout, limits); !fits) return passOn(fits.error());
  if (const auto complete = checkStored(dicom, *pixels, layout); !complete) return passOn(complete.error());
  return layout;
}

}  // namespace ew::detail
