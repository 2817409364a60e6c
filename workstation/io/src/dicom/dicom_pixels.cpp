#include "dicom/dicom_pixels.h"

#include <algorithm>
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

Codec codecOf(const std::string& name) {
  if (name == "JPEG 2000") return Codec::jpeg2000;
  return name == "JPEG-LS" ? Codec::jpegLs : Codec::jpeg;
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
    const std::size_t size = layout.storedBytesPerFrame();
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
    // A second image behind the only one that is named is not a part of it.
    const auto second = layout.codec == "RLE" || all.size() < 3
                            ? all.end()
                            : std::find_if(all.begin() + 2, all.end(), [&](Bytes fragment) { return layout.beginsImage(fragment); });
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
    if (n > 1 && layout.beginsImage(all[n])) ++frame;
    if (frame >= layout.frames) break;
    reader.packed_[frame].push_back(all[n]);
  }
  if (frame + 1 < layout.frames)
    return failure(ErrorCode::badHeader,
                   say<"%1 holds %2 packed images, but promises %3 frames; export it again.">(quoted(dicom.file), frame + 1, layout.frames),
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
  if (auto there = unpackerThere(); !there) return passOn(there.error());
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
                                  const ReaderLimits& limits, Progress& progress, std::vector<Message>& notes) try {
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
  if (inverted) notes.push_back(say<"The images are stored with black as the highest value (MONOCHROME1) and were turned over.">());
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
    return failure(ErrorCode::badHeader, say<"%1 is not a JPEG of 8 bits that can be read; save the image again.">(quoted(file)),
                   {{"file", file.string()}});
  if (head->width * head->height > mostPixels)
    return failure(
        ErrorCode::tooLarge,
        say<"%1 promises %2 pixels, but the limit is %3; save a smaller image.">(quoted(file), head->width * head->height, mostPixels),
        {{"file", file.string()}});
  if (auto there = unpackerThere(); !there) return passOn(there.error());
  const auto unpacked = unpack(Codec::jpeg, bytes, *head, 8, 8, false, progress);
  if (!unpacked && progress.cancelRequested()) return stopped(file);
  if (!unpacked)
    return failure(ErrorCode::badHeader, say<"%1 is a damaged JPEG; save the image again.">(quoted(file)), {{"file", file.string()}});
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
