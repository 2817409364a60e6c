#include "dicom/dicom_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <optional>

#include "dicom/packed_frame.h"
#include "ew/core/numbers.h"
#include "files/grey_samples.h"
#include "files/image_header.h"

namespace ew::detail {
namespace {
namespace fs = std::filesystem;

constexpr DicomTag kPixelDataTag = 0x7FE00010u;

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

Codec codecOf(const std::string& name) {
  if (name == "JPEG 2000") return Codec::jpeg2000;
  return name == "JPEG-LS" ? Codec::jpegLs : Codec::jpeg;
}

std::uint64_t thinnedBytesPerFrame(const PixelLayout& layout) { return layout.rows * ((layout.columns + 1) / 2 * 4); }

std::uint64_t fullBytesPerFrame(const PixelLayout& layout) {
  return layout.pixelsPerFrame() * static_cast<std::uint64_t>(layout.samples) * static_cast<std::uint64_t>(layout.bitsAllocated / 8);
}

std::uint64_t storedBytesPerFrame(const PixelLayout& layout) {
  return layout.thinned ? thinnedBytesPerFrame(layout) : fullBytesPerFrame(layout);
}

/// Whether a packed picture begins with this fragment.
bool beginsPicture(const PixelLayout& layout, Bytes fragment) {
  if (layout.codec == "RLE") return true;
  return fragment.size() > 2 && fragment[0] == 0xFF && (fragment[1] == 0xD8 || fragment[1] == 0x4F);
}

/// Packed pictures that the fragments of pixels hold.
std::uint64_t packedPictures(const PixelLayout& layout, const DicomElement& pixels) {
  if (pixels.fragments.empty()) return 0;
  return static_cast<std::uint64_t>(
      std::count_if(pixels.fragments.begin() + 1, pixels.fragments.end(), [&](Bytes fragment) { return beginsPicture(layout, fragment); }));
}

/// The three tables of a palette, unfolded where they come in segments (PS3.3, C.7.9.2).
Result<std::vector<std::uint16_t>> tableOf(const DicomFile& dicom, int colour, std::size_t entries, int bits) {
  const auto offset = static_cast<DicomTag>(colour);
  const auto damaged = [&](const Message& what) {
    return badField(dicom.file, verbatim("Palette Color Lookup Table Data"), what, say<"%1 entries">(entries));
  };
  const bool bigEndian = dicom.data.bigEndian;
  const auto word = [&](Bytes bytes, std::size_t n) {
    const unsigned first = bytes[2 * n], second = bytes[2 * n + 1];
    return static_cast<std::uint16_t>(bigEndian ? first << 8 | second : second << 8 | first);
  };
  std::vector<std::uint16_t> table;
  if (const DicomElement* const plain = dicom.data.find(0x00281201u + offset); plain != nullptr) {
    const Bytes bytes = plain->value;
    // Tables of 8 bit entries are stored as bytes, or as words by some.
    if (bits == 8 && bytes.size() >= entries && bytes.size() < 2 * entries) {
      table.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(entries));
      return table;
    }
    if (bytes.size() < 2 * entries) return damaged(say<"too few">());
    for (std::size_t n = 0; n < entries; ++n) table.push_back(word(bytes, n));
    return table;
  }
  const DicomElement* const segmented = dicom.data.find(0x00281221u + offset);
  if (segmented == nullptr) return damaged(say<"none">());
  const Bytes bytes = segmented->value;
  const bool bytewise = bits == 8 && segmented->kind[1] == 'B';
  const std::size_t count = bytewise ? bytes.size() : bytes.size() / 2;
  const auto at = [&](std::size_t n) -> std::uint32_t { return bytewise ? bytes[n] : word(bytes, n); };
  // One segment at `from`; says where the next begins, or nothing when it is damaged.
  const auto unfold = [&](std::size_t from, bool mayPoint, const auto& self) -> std::optional<std::size_t> {
    if (from + 2 > count) return std::nullopt;
    const std::uint32_t kind = at(from), length = at(from + 1);
    if (kind == 0) {
      if (length == 0 || length > count - from - 2 || table.size() + length > entries) return std::nullopt;
      for (std::uint32_t n = 0; n < length; ++n) table.push_back(static_cast<std::uint16_t>(at(from + 2 + n)));
      return from + 2 + length;
    }
    if (kind == 1) {
      if (from + 3 > count || table.empty() || length == 0 || table.size() + length > entries) return std::nullopt;
      const double begin = table.back(), end = at(from + 2);
      for (std::uint32_t n = 1; n <= length; ++n)
        table.push_back(static_cast<std::uint16_t>(std::lround(begin + (end - begin) * n / length)));
      return from + 3;
    }
    if (kind == 2 && mayPoint) {
      if (from + 4 > count) return std::nullopt;
      std::size_t there = at(from + 2) | static_cast<std::size_t>(at(from + 3)) << (bytewise ? 8 : 16);
      for (std::uint32_t n = 0; n < length; ++n) {
        const auto next = self(there, false, self);
        if (!next) return std::nullopt;
        there = *next;
      }
      return from + 4;
    }
    return std::nullopt;
  };
  for (std::size_t from = 0; table.size() < entries;) {
    const auto next = unfold(from, true, unfold);
    if (!next) return damaged(say<"segments that do not fit together">());
    from = *next;
  }
  return table;
}

int clampedByte(double value) { return static_cast<int>(std::lround(std::clamp(value, 0.0, 255.0))); }

/// Full-range YCbCr to RGB (PS3.3, C.7.6.3.1.2, solved for R, G, B); `partial` is the video range of the retired YBR_PARTIAL_422.
std::array<int, 3> rgbOf(double y, double cb, double cr, bool partial) {
  if (partial) {
    y = (y - 16.0) * 255.0 / 219.0;
    cb = 128.0 + (cb - 128.0) * 255.0 / 224.0;
    cr = 128.0 + (cr - 128.0) * 255.0 / 224.0;
  }
  return {clampedByte(y + 1.402 * (cr - 128.0)), clampedByte(y - 0.344136 * (cb - 128.0) - 0.714136 * (cr - 128.0)),
          clampedByte(y + 1.772 * (cb - 128.0))};
}

std::int32_t luminance(const std::array<int, 3>& rgb) {
  return static_cast<std::int32_t>(std::lround(0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2]));
}

bool isColoured(const std::array<int, 3>& rgb) {
  const auto [lowest, highest] = std::minmax_element(rgb.begin(), rgb.end());
  return *highest - *lowest > FrameReader::kColourStep;
}

tl::unexpected<Error> badFrame(const fs::path& file, std::uint64_t frame, const std::string& codec) {
  return failure(ErrorCode::badHeader,
                 say<"Frame %1 of %2 is damaged: its %3 stream cannot be unpacked into the size the file gives; get the file again.">(
                     frame + 1, quoted(file), codec),
                 {{"file", file.string()}, {"frame", std::to_string(frame)}});
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
  if (*frames == 0) notes.push_back(say<"The file says that it has 0 frames; it was read as one picture.">());
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

Result<void> checkMemory(const DicomFile& dicom, const PixelLayout& layout, const ReadLimits& limits) {
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
/// pictures of ultrasound are mostly grey.
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

/// Pictures there are, where the file does not say how many: a number that is missing, empty or 0 means one by the standard, but what is
/// stored is not dropped for that.
void settleFrames(const DicomFile& dicom, const DicomElement& pixels, PixelLayout& layout) {
  const std::uint64_t perFrame = storedBytesPerFrame(layout);
  const bool packed = layout.codec != "uncompressed";
  const std::uint64_t there = packed ? packedPictures(layout, pixels) : pixels.value.size() / perFrame;
  const bool stated = dicom.data.count(0x00280008u).value_or(0) > 0;
  const bool whole = packed ? layout.codec != "RLE" : pixels.value.size() - there * perFrame <= 1;
  if (!stated && there > 1 && whole && there < (1u << 24)) {
    layout.frames = there;
    layout.notes.push_back(say<"The file does not say how many frames it has; %1 are stored in it and were read.">(there));
    return;
  }
  if (packed) {
    if (there > layout.frames && layout.codec != "RLE")
      layout.notes.push_back(counted<"The file says that it has %1 frame, but %2 pictures are stored in it; those beyond were not read.",
                                     "The file says that it has %1 frames, but %2 pictures are stored in it; those beyond were not read.">(
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
                       ? say<"%1 says its pictures are %2, but they are not stored so; export it again.">(quoted(dicom.file), layout.codec)
                       : say<"%1 says its pictures are uncompressed, but they are not stored so; export it again.">(quoted(dicom.file)),
                   {{"file", dicom.file.string()}});
  if (!encapsulated) {
    const std::uint64_t promised = storedBytesPerFrame(layout) * layout.frames;
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

/// Where samples of a frame go: stored bits to whole numbers.
struct SampleWriter {
  std::int32_t* samples;
  int shift;
  int signBit;  ///< below 0: not signed
  std::uint32_t mask;

  SampleWriter(const PixelLayout& layout, std::int32_t* to)
      : samples(to),
        shift(layout.highBit + 1 - layout.bitsStored),
        signBit(layout.isSigned ? layout.bitsStored - 1 : -1),
        mask((1u << layout.bitsStored) - 1u) {}
  void put(std::size_t n, std::uint32_t stored) const {
    const std::uint32_t value = stored >> shift & mask;
    const bool negative = signBit >= 0 && (value >> signBit & 1u) != 0;
    samples[n] = static_cast<std::int32_t>(value) - (negative ? static_cast<std::int32_t>(mask) + 1 : 0);
  }
};

/// The bytes of one frame that is not packed.
struct PlainFrame {
  Bytes bytes;
  bool bigEndian;
  bool swapped;  ///< words of a big endian file hold the second 8 bit sample in front

  PlainFrame(const DicomFile& dicom, const PixelLayout& layout, std::uint64_t frame) : bigEndian(dicom.data.bigEndian) {
    const DicomElement& element = *dicom.data.find(kPixelDataTag);
    const std::size_t size = storedBytesPerFrame(layout);
    bytes = element.value.subspan(frame * size, size);
    swapped = bigEndian && layout.bitsAllocated == 8 && element.kind[1] == 'W';
  }
  [[nodiscard]] std::uint32_t byteAt(std::size_t n) const {
    const std::size_t other = n ^ 1u;
    return bytes[swapped && other < bytes.size() ? other : n];
  }
  [[nodiscard]] std::uint32_t wordAt(std::size_t n) const {
    const std::uint32_t first = bytes[2 * n], second = bytes[2 * n + 1];
    return bigEndian ? first << 8 | second : second << 8 | first;
  }
};

/// Two luminances and the colours they share: Y Y Cb Cr.
void readThinned(const PlainFrame& from, const PixelLayout& layout, std::vector<std::int32_t>& samples) {
  const std::size_t pairs = (layout.columns + 1) / 2;
  for (std::size_t y = 0; y < layout.rows; ++y)
    for (std::size_t x = 0; x < layout.columns; ++x) {
      const std::size_t group = (y * pairs + x / 2) * 4, to = (y * layout.columns + x) * 3;
      samples[to] = static_cast<std::int32_t>(from.byteAt(group + x % 2));
      samples[to + 1] = static_cast<std::int32_t>(from.byteAt(group + 2));
      samples[to + 2] = static_cast<std::int32_t>(from.byteAt(group + 3));
    }
}

void readPlain(const PlainFrame& from, const PixelLayout& layout, std::size_t count, SampleWriter to) {
  const bool bytewise = layout.bitsAllocated == 8;
  for (std::size_t n = 0; n < count; ++n) to.put(n, bytewise ? from.byteAt(n) : from.wordAt(n));
}

/// Planes of bytes, the high ones first, one colour after the other (PS3.5, annex G).
bool readRle(Bytes stream, const PixelLayout& layout, SampleWriter to) {
  const std::size_t pixels = layout.pixelsPerFrame(), bytesEach = static_cast<std::size_t>(layout.bitsAllocated) / 8;
  const auto planes = unpackRle(stream, static_cast<std::size_t>(layout.samples) * bytesEach, pixels);
  if (!planes) return false;
  for (std::size_t sample = 0; sample < static_cast<std::size_t>(layout.samples); ++sample)
    for (std::size_t n = 0; n < pixels; ++n) {
      std::uint32_t stored = 0;
      for (std::size_t byte = 0; byte < bytesEach; ++byte) stored = stored << 8 | (*planes)[(sample * bytesEach + byte) * pixels + n];
      to.put(sample * pixels + n, stored);
    }
  return true;
}

void readUnpacked(const std::vector<std::uint8_t>& bytes, const PixelLayout& layout, std::size_t count, SampleWriter to) {
  const bool bytewise = layout.bitsAllocated == 8;
  for (std::size_t n = 0; n < count; ++n) {
    if (bytewise) {
      to.put(n, bytes[n]);
    } else {
      std::uint16_t value = 0;
      std::memcpy(&value, bytes.data() + 2 * n, 2);
      to.put(n, value);
    }
  }
}

}  // namespace

Result<PixelLayout> pixelLayoutOf(const DicomFile& dicom, const ReadLimits& limits) {
  const DicomElement* const pixels = dicom.data.find(kPixelDataTag);
  if (pixels == nullptr)
    return failure(ErrorCode::unsupported,
                   say<"%1 is a DICOM file without pictures; choose the file that holds the pictures.">(quoted(dicom.file)),
                   {{"file", dicom.file.string()}});
  PixelLayout layout;
  const auto known = std::find_if(kSyntaxes.begin(), kSyntaxes.end(), [&](const Syntax& one) { return dicom.transferSyntax == one.uid; });
  if (known == kSyntaxes.end())
    return failure(ErrorCode::unsupported,
                   say<"The pictures of %1 are packed in a way that is not read (transfer syntax %2); export them uncompressed, as JPEG, "
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

Result<FrameReader> FrameReader::open(const DicomFile& dicom, const PixelLayout& layout) {
  FrameReader reader(dicom, layout);
  if (layout.photometric == "PALETTE COLOR") {
    std::array<std::vector<std::uint16_t>, 3> tables;
    std::size_t entries = 0;
    bool wide = false;
    for (int colour = 0; colour < 3; ++colour) {
      const auto descriptor = dicom.data.numbers(0x00281101u + static_cast<DicomTag>(colour));
      if (descriptor.size() < 3 || (descriptor[2] != 8.0 && descriptor[2] != 16.0))
        return badField(dicom.file, verbatim("Palette Color Lookup Table Descriptor"),
                        descriptor.size() < 3 ? say<"nothing">() : say<"other bits">(), say<"entries, first value and 8 or 16 bits">());
      const auto here = descriptor[0] == 0.0 ? std::size_t{65536} : static_cast<std::size_t>(static_cast<std::uint16_t>(descriptor[0]));
      if (colour > 0 && here != entries)
        return badField(dicom.file, verbatim("Palette Color Lookup Table Descriptor"), say<"tables of different lengths">(),
                        say<"three of one length">());
      entries = here;
      reader.paletteFirst_ = static_cast<int>(descriptor[1]);
      auto table = tableOf(dicom, colour, entries, static_cast<int>(descriptor[2]));
      if (!table) return passOn(table.error());
      tables[static_cast<std::size_t>(colour)] = *std::move(table);
      wide = wide || std::any_of(tables[static_cast<std::size_t>(colour)].begin(), tables[static_cast<std::size_t>(colour)].end(),
                                 [](std::uint16_t value) { return value > 255; });
    }
    reader.palette_.resize(entries);
    for (std::size_t n = 0; n < entries; ++n)
      for (std::size_t colour = 0; colour < 3; ++colour)
        // Tables that say 16 bits but stay below 256 mean 8.
        reader.palette_[n][colour] = static_cast<std::uint8_t>(wide ? tables[colour][n] >> 8 : tables[colour][n]);
  }
  const DicomElement& pixels = *dicom.data.find(kPixelDataTag);
  if (layout.codec == "uncompressed") return reader;
  const std::vector<Bytes>& all = pixels.fragments;
  reader.packed_.resize(layout.frames);
  if (layout.frames == 1) {
    // A second picture behind the only one that is named is not a part of it.
    const auto second = layout.codec == "RLE" || all.size() < 3
                            ? all.end()
                            : std::find_if(all.begin() + 2, all.end(), [&](Bytes fragment) { return beginsPicture(layout, fragment); });
    reader.packed_[0].assign(all.begin() + 1, second);
    return reader;
  }
  if (all.size() == layout.frames + 1) {
    for (std::size_t frame = 0; frame < layout.frames; ++frame) reader.packed_[frame] = {all[frame + 1]};
    return reader;
  }
  // Several fragments a frame: a new frame begins where a stream begins.
  std::size_t frame = 0;
  for (std::size_t n = 1; n < all.size(); ++n) {
    if (n > 1 && beginsPicture(layout, all[n])) ++frame;
    if (frame >= layout.frames) break;
    reader.packed_[frame].push_back(all[n]);
  }
  if (frame + 1 < layout.frames)
    return failure(
        ErrorCode::badHeader,
        say<"%1 holds %2 packed pictures, but promises %3 frames; export it again.">(quoted(dicom.file), frame + 1, layout.frames),
        {{"file", dicom.file.string()}});
  return reader;
}

Result<void> FrameReader::samplesOf(std::uint64_t frame, std::vector<std::int32_t>& samples, bool& planar, bool& lumaChroma,
                                    const Progress& progress) const {
  const std::size_t count = layout_.pixelsPerFrame() * static_cast<std::size_t>(layout_.samples);
  lumaChroma = layout_.photometric.starts_with("YBR");
  planar = layout_.planar;
  samples.resize(count);
  if (layout_.codec == "uncompressed") {
    const PlainFrame from(*dicom_, layout_, frame);
    if (layout_.thinned) {
      readThinned(from, layout_, samples);
      planar = false;
    } else {
      readPlain(from, layout_, count, {layout_, samples.data()});
    }
    return {};
  }
  std::vector<std::uint8_t> joined;
  Bytes stream = packed_[frame].empty() ? Bytes() : packed_[frame].front();
  if (packed_[frame].size() > 1) {
    for (const Bytes part : packed_[frame]) joined.insert(joined.end(), part.begin(), part.end());
    stream = joined;
  }
  if (layout_.codec == "RLE") {
    if (!readRle(stream, layout_, {layout_, samples.data()})) return badFrame(dicom_->file, frame, layout_.codec);
    planar = layout_.samples == 3;
    return {};
  }
  const Codec codec = codecOf(layout_.codec);
  const auto head = packedHead(codec, stream);
  if (!head || head->width != layout_.columns || head->height != layout_.rows || head->components != layout_.samples ||
      (head->bits > 8 ? 16 : 8) != layout_.bitsAllocated)
    return badFrame(dicom_->file, frame, layout_.codec);
  const auto unpacked = unpack(codec, stream, *head, layout_.bitsAllocated, layout_.bitsStored, layout_.isSigned, progress);
  if (!unpacked && progress.cancelRequested()) return stopped(dicom_->file);
  if (!unpacked) return badFrame(dicom_->file, frame, layout_.codec);
  readUnpacked(*unpacked, layout_, count, {layout_, samples.data()});
  planar = head->byPlanes && layout_.samples == 3;
  if (codec == Codec::jpeg2000) {
    // The decoder turns the colours back itself where the stream says that they were turned.
    if (layout_.photometric != "YBR_FULL" && layout_.photometric != "YBR_FULL_422") lumaChroma = false;
  } else if (codec == Codec::jpeg && layout_.photometric == "RGB") {
    lumaChroma = head->namesColours && head->lumaChroma;
  }
  return {};
}

Result<void> FrameReader::read(std::uint64_t frame, std::vector<std::int32_t>& level, std::vector<std::uint8_t>& coloured,
                               const Progress& progress, std::vector<Rgb>* colour) const {
  const std::size_t pixels = layout_.pixelsPerFrame();
  if (colour != nullptr) colour->resize(layout_.inColour() ? pixels : 0);
  coloured.assign(layout_.inColour() ? pixels : 0, 0);
  bool planar = false, lumaChroma = false;
  if (!layout_.inColour()) return samplesOf(frame, level, planar, lumaChroma, progress);
  std::vector<std::int32_t> samples;
  if (auto got = samplesOf(frame, samples, planar, lumaChroma, progress); !got) return got;
  level.resize(pixels);
  if (!palette_.empty()) {
    const auto last = static_cast<std::int64_t>(palette_.size()) - 1;
    for (std::size_t n = 0; n < pixels; ++n) {
      const auto& entry = palette_[static_cast<std::size_t>(std::clamp<std::int64_t>(samples[n] - paletteFirst_, 0, last))];
      const std::array<int, 3> rgb{entry[0], entry[1], entry[2]};
      level[n] = luminance(rgb);
      coloured[n] = isColoured(rgb) ? 1 : 0;
      if (colour != nullptr) (*colour)[n] = Rgb(entry[0], entry[1], entry[2]);
    }
    return {};
  }
  const bool partial = layout_.photometric == "YBR_PARTIAL_422";
  for (std::size_t n = 0; n < pixels; ++n) {
    const auto sample = [&](std::size_t c) { return samples[planar ? c * pixels + n : 3 * n + c]; };
    const std::array<int, 3> rgb =
        lumaChroma ? rgbOf(sample(0), sample(1), sample(2), partial) : std::array<int, 3>{sample(0), sample(1), sample(2)};
    // The luminance of full-range YCbCr is Y itself; through RGB and back it would be rounded twice.
    level[n] = lumaChroma && !partial ? sample(0) : luminance(rgb);
    coloured[n] = isColoured(rgb) ? 1 : 0;
    if (colour != nullptr) (*colour)[n] = Rgb(rgb[0], rgb[1], rgb[2]);
  }
  return {};
}

Result<GreyFrames> readGreyFrames(const DicomFile& dicom, const PixelLayout& layout, const std::vector<std::uint64_t>& which,
                                  const ReadLimits& limits, Progress& progress, std::vector<Message>& notes) try {
  const auto reader = FrameReader::open(dicom, layout);
  if (!reader) return passOn(reader.error());
  const std::size_t pixels = layout.pixelsPerFrame();
  if (pixels * which.size() * 2 > limits.maxBytes)
    return failure(ErrorCode::tooLarge,
                   say<"%1 would need %2 bytes of memory, but the limit is %3; cut it into parts.">(
                       quoted(dicom.file), pixels * which.size() * 2, limits.maxBytes),
                   {{"file", dicom.file.string()}});
  std::vector<std::int32_t> level;
  std::vector<std::uint8_t> coloured;
  const Message reading = say<"Reading frames">();
  const bool direct = layout.inColour() || (layout.bitsStored == 8 && !layout.isSigned);
  std::int32_t lowest = std::numeric_limits<std::int32_t>::max(), highest = std::numeric_limits<std::int32_t>::min();
  for (std::size_t n = 0; !direct && n < which.size(); ++n) {
    if (progress.cancelRequested()) return stopped(dicom.file);
    if (auto got = reader->read(which[n], level, coloured, progress); !got) return passOn(got.error());
    const auto [low, high] = std::minmax_element(level.begin(), level.end());
    lowest = std::min(lowest, *low);
    highest = std::max(highest, *high);
    progress.report(reading, 0.5 * static_cast<double>(n + 1) / static_cast<double>(which.size()));
  }
  if (direct) {
    lowest = 0;
    highest = 255;
  } else {
    notes.push_back(
        layout.isSigned
            ? say<"The samples have %1 bits with sign: values from %2 to %3 were mapped to 0 to 255.">(layout.bitsStored, lowest, highest)
            : say<"The samples have %1 bits: values from %2 to %3 were mapped to 0 to 255.">(layout.bitsStored, lowest, highest));
  }
  const bool inverted = layout.photometric == "MONOCHROME1";
  if (inverted) notes.push_back(say<"The pictures are stored with black as the highest value (MONOCHROME1) and were turned over.">());
  GreyFrames grey;
  grey.level.resize(pixels * which.size());
  if (layout.inColour()) grey.coloured.resize(pixels * which.size());
  const double span = std::max(1, highest - lowest);
  bool any = false;
  for (std::size_t n = 0; n < which.size(); ++n) {
    if (progress.cancelRequested()) return stopped(dicom.file);
    if (auto got = reader->read(which[n], level, coloured, progress); !got) return passOn(got.error());
    std::uint8_t* const out = grey.level.data() + n * pixels;
    for (std::size_t p = 0; p < pixels; ++p) {
      const int value = direct ? std::clamp(level[p], 0, 255) : static_cast<int>(std::lround(255.0 * (level[p] - lowest) / span));
      out[p] = static_cast<std::uint8_t>(inverted ? 255 - value : value);
    }
    if (layout.inColour()) {
      std::copy(coloured.begin(), coloured.end(), grey.coloured.begin() + static_cast<std::ptrdiff_t>(n * pixels));
      any = any || std::any_of(coloured.begin(), coloured.end(), [](std::uint8_t one) { return one != 0; });
    }
    progress.report(reading, (direct ? 0.0 : 0.5) + (direct ? 1.0 : 0.5) * static_cast<double>(n + 1) / static_cast<double>(which.size()));
  }
  if (!any) grey.coloured.clear();
  return grey;
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for the frames of %1; close other programs.">(quoted(dicom.file)),
                 {{"file", dicom.file.string()}});
}

Result<JpegGrey> readJpeg(Bytes bytes, const fs::path& file, std::uint64_t mostPixels, const Progress& progress) {
  const auto head = packedHead(Codec::jpeg, bytes);
  if (!head || head->bits != 8)
    return failure(ErrorCode::badHeader, say<"%1 is not a JPEG of 8 bits that can be read; save the picture again.">(quoted(file)),
                   {{"file", file.string()}});
  if (head->width * head->height > mostPixels)
    return failure(
        ErrorCode::tooLarge,
        say<"%1 promises %2 pixels, but the limit is %3; save a smaller picture.">(quoted(file), head->width * head->height, mostPixels),
        {{"file", file.string()}});
  const auto unpacked = unpack(Codec::jpeg, bytes, *head, 8, 8, false, progress);
  if (!unpacked && progress.cancelRequested()) return stopped(file);
  if (!unpacked)
    return failure(ErrorCode::badHeader, say<"%1 is a damaged JPEG; save the picture again.">(quoted(file)), {{"file", file.string()}});
  JpegGrey grey;
  grey.width = static_cast<int>(head->width);
  grey.height = static_cast<int>(head->height);
  if (head->components == 1) {
    grey.level = *unpacked;
    return grey;
  }
  const std::size_t pixels = head->width * head->height;
  grey.level.resize(pixels);
  grey.coloured.resize(pixels);
  const bool lumaChroma = !head->namesColours || head->lumaChroma;
  for (std::size_t n = 0; n < pixels; ++n) {
    const std::uint8_t* const p = unpacked->data() + 3 * n;
    const std::array<int, 3> rgb = lumaChroma ? rgbOf(p[0], p[1], p[2], false) : std::array<int, 3>{p[0], p[1], p[2]};
    grey.level[n] = static_cast<std::uint8_t>(lumaChroma ? p[0] : luminance(rgb));
    grey.coloured[n] = isColoured(rgb) ? 1 : 0;
  }
  return grey;
}

}  // namespace ew::detail
