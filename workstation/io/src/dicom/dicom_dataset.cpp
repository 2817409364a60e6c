#include "dicom/dicom_dataset.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>

#include "ew/core/file_errors.h"
#include "ew/core/find_entry.h"
#include "ew/core/numbers.h"
#include "files/grey_samples.h"
#include "files/image_header.h"

namespace ew::detail {
namespace {
namespace fs = std::filesystem;

constexpr std::uint32_t kUndefined = 0xFFFFFFFFu;
constexpr DicomTag kItem = 0xFFFEE000u;
constexpr DicomTag kItemEnd = 0xFFFEE00Du;
constexpr DicomTag kSequenceEnd = 0xFFFEE0DDu;
constexpr DicomTag kPixelData = 0x7FE00010u;
constexpr int kDeepest = 16;
constexpr std::size_t kMostElements = 2'000'000;

template <class T>
T numberAt(Bytes bytes, std::size_t at, bool bigEndian) {
  std::array<std::uint8_t, sizeof(T)> copy;
  std::memcpy(copy.data(), bytes.data() + at, sizeof(T));
  if (bigEndian != (std::endian::native == std::endian::big)) std::reverse(copy.begin(), copy.end());
  return std::bit_cast<T>(copy);
}

/// Sequences a reader here looks into although an implicit file does not say that they are sequences.
bool isKnownSequence(DicomTag tag) {
  switch (tag) {
    case 0x00186011u:  // ultrasound regions
    case 0x52009229u:  // shared functional groups
    case 0x52009230u:  // per-frame functional groups
    case 0x0020930Eu:  // plane position (volume)
    case 0x0020930Fu:  // plane orientation (volume)
    case 0x00289110u:  // pixel measures
    case 0x00209310u:  // temporal position
    case 0x00189807u:  // image data type
    case 0x00209111u:  // frame content
      return true;
    default:
      return false;
  }
}

bool is(const std::array<char, 2>& kind, std::string_view name) { return kind[0] == name[0] && kind[1] == name[1]; }

bool hasLongLength(const std::array<char, 2>& kind) {
  for (const char* name : {"OB", "OW", "OF", "OD", "OL", "OV", "SQ", "UC", "UR", "UT", "UN", "SV", "UV"})
    if (is(kind, name)) return true;
  return false;
}

bool isKind(std::uint8_t a, std::uint8_t b) { return a >= 'A' && a <= 'Z' && b >= 'A' && b <= 'Z'; }

/// The value representations there are (PS3.5, 6.2).
bool isNamedKind(const std::array<char, 2>& kind) {
  constexpr std::string_view all = "AE AS AT CS DA DS DT FD FL IS LO LT OB OD OF OL OV OW PN SH SL SQ SS ST SV TM UC UI UL UN UR US UT UV";
  for (std::size_t at = 0; at < all.size(); at += 3)
    if (is(kind, all.substr(at, 2))) return true;
  return false;
}

/// Whether bytes are the first elements of a data set in little endian: tags that rise from group 2 or the beginning of group 8, kinds that
/// there are, lengths that lead from one to the next.
bool beginsWithElements(Bytes bytes) {
  if (bytes.size() < 16) return false;
  const bool explicitKinds = isKind(bytes[4], bytes[5]);
  constexpr int enough = 3;
  int met = 0;
  std::uint32_t before = 0, firstGroup = 0;
  for (std::size_t at = 0; at + 8 <= bytes.size() && met < enough; ++met) {
    const std::uint32_t group = numberAt<std::uint16_t>(bytes, at, false), number = numberAt<std::uint16_t>(bytes, at + 2, false);
    const DicomTag tag = group << 16 | number;
    if (met == 0) {
      firstGroup = group;
      if (!(group == 2u && number <= 0x102u) && !(group == 8u && number <= 0x70u)) return false;
    } else if (group != firstGroup && firstGroup == 2u) {
      return group == 8u;  // written in a way of its own
    } else if (tag <= before) {
      return false;
    }
    before = tag;
    std::uint32_t length = numberAt<std::uint32_t>(bytes, at + 4, false);
    std::size_t head = 8;
    if (explicitKinds) {
      const std::array<char, 2> kind{static_cast<char>(bytes[at + 4]), static_cast<char>(bytes[at + 5])};
      if (!isNamedKind(kind)) return false;
      length = numberAt<std::uint16_t>(bytes, at + 6, false);
      if (hasLongLength(kind)) {
        if (at + 12 > bytes.size()) return met > 0;
        length = numberAt<std::uint32_t>(bytes, at + 8, false);
        head = 12;
      }
    } else if (met == 0 && length >= 256) {
      return false;
    }
    if (number == 0 && length != 4) return false;  // a group's own length
    if (length > bytes.size() - at - head) return met > 0 || explicitKinds;
    at += head + length;
  }
  return met > 1;
}

bool hasPreamble(Bytes bytes) { return bytes.size() >= 132 && std::memcmp(bytes.data() + 128, "DICM", 4) == 0; }

/// Walks the bytes of one file.
class Parser {
 public:
  Parser(Bytes bytes, bool explicitKinds, bool bigEndian) : bytes_(bytes), explicit_(explicitKinds), bigEndian_(bigEndian) {}

  /// Elements from `at` to `end`, or to the end marker of an item of undefined length.
  bool set(std::size_t& at, std::size_t end, bool toMarker, int depth, DicomItem& into) {
    if (depth > kDeepest) return fails(say<"sequences are nested too deeply">());
    into.bigEndian = bigEndian_;
    bool hasPixels = false;
    while (at < end) {
      const std::size_t begin = at;
      if (end - at < 8) return mayEnd(hasPixels, begin, end) || short_(say<"it ends inside an element's head">());
      const DicomTag tag = tagAt(at);
      if (tag == kItemEnd && toMarker) {
        at += 8;
        return true;
      }
      // Behind the pixels only a few elements can come, all of higher groups.
      if (hasPixels && tag < kPixelData && mayEnd(hasPixels, begin, end)) return true;
      if (++elements_ > kMostElements) return fails(say<"it has too many elements">());
      DicomElement element;
      if (!one(at, end, depth, element)) return mayEnd(hasPixels, begin, end);
      hasPixels = hasPixels || (depth == 0 && element.tag == kPixelData);
      into.elements.push_back(std::move(element));
    }
    return !toMarker || short_(say<"it ends inside an item's end">());
  }

  /// Elements of group 2 alone.
  bool meta(std::size_t& at, DicomItem& into) {
    into.bigEndian = false;
    while (bytes_.size() - at >= 8 && tagAt(at) >> 16 == 2u) {
      if (++elements_ > kMostElements) return fails(say<"it has too many elements">());
      DicomElement element;
      if (!one(at, bytes_.size(), 0, element)) return false;
      into.elements.push_back(std::move(element));
    }
    return true;
  }

  [[nodiscard]] const Message& why() const { return why_; }
  /// Bytes behind the pixels that were passed over.
  [[nodiscard]] std::size_t tail() const { return tail_; }
  /// Whether the mark that ends the pixels was not there.
  [[nodiscard]] bool endsUnmarked() const { return endsUnmarked_; }
  /// Whether the last byte that the file states is not there, where it can only be the one that makes a length even.
  [[nodiscard]] bool endsUnpadded() const { return endsUnpadded_; }
  [[nodiscard]] bool endsEarly() const { return short_read_; }

 private:
  [[nodiscard]] DicomTag tagAt(std::size_t at) const {
    return static_cast<DicomTag>(numberAt<std::uint16_t>(bytes_, at, bigEndian_)) << 16 |
           numberAt<std::uint16_t>(bytes_, at + 2, bigEndian_);
  }
  /// Whatever stands behind the pixels and is no element is padding of whoever stored or sent the file.
  bool mayEnd(bool hasPixels, std::size_t begin, std::size_t end) {
    if (!hasPixels) return false;
    tail_ = end - begin;
    return true;
  }
  bool fails(Message why) {
    why_ = std::move(why);
    return false;
  }
  bool short_(Message why) {
    short_read_ = true;
    return fails(std::move(why));
  }

  /// Values are made even by a byte behind them, which some writers count and do not write at the end of a file.
  [[nodiscard]] bool lacksPadding(std::uint32_t length, std::size_t there, std::size_t end) const {
    return length % 2 == 0 && length == there + 1 && end == bytes_.size();
  }
  /// Whether a packed image can be whole with this last fragment: one of the JPEG family ends with a mark; of the others whoever unpacks
  /// them sees it.
  [[nodiscard]] static bool mayEndStream(const DicomElement& pixels, Bytes last) {
    const Bytes first = pixels.fragments.size() > 1 ? pixels.fragments[1] : last;
    const bool isJpeg = first.size() > 2 && first[0] == 0xFF && (first[1] == 0xD8 || first[1] == 0x4F);
    return !isJpeg || (last.size() > 1 && last[last.size() - 2] == 0xFF && last.back() == 0xD9);
  }

  bool one(std::size_t& at, std::size_t end, int depth, DicomElement& element) {
    element.tag = tagAt(at);
    if (element.tag >> 16 == 0xFFFEu) return fails(say<"a marker stands where an element was expected">());
    std::uint32_t length = 0;
    std::size_t head = 8;
    if (explicit_) {
      element.kind = {static_cast<char>(bytes_[at + 4]), static_cast<char>(bytes_[at + 5])};
      if (!isKind(bytes_[at + 4], bytes_[at + 5])) return fails(say<"an element has no value representation">());
      if (hasLongLength(element.kind)) {
        if (end - at < 12) return short_(say<"it ends inside an element's head">());
        length = numberAt<std::uint32_t>(bytes_, at + 8, bigEndian_);
        head = 12;
      } else {
        length = numberAt<std::uint16_t>(bytes_, at + 6, bigEndian_);
      }
    } else {
      length = numberAt<std::uint32_t>(bytes_, at + 4, bigEndian_);
      if (isKnownSequence(element.tag)) element.kind = {'S', 'Q'};
    }
    at += head;
    if (length == kUndefined) {
      if (element.tag == kPixelData) return fragments(at, end, element);
      // A sequence of unknown kind is written implicitly inside (PS3.5, 6.2.2).
      const bool implicitInside = explicit_ && is(element.kind, "UN");
      element.kind = {'S', 'Q'};
      if (!implicitInside) return sequence(at, end, true, depth, element);
      explicit_ = false;
      const bool read = sequence(at, end, true, depth, element);
      explicit_ = true;
      return read;
    }
    if (length > end - at && lacksPadding(length, end - at, end) && depth == 0 && (element.tag == kPixelData || element.tag >> 16 & 1u)) {
      // Whether all samples are there is seen by whoever counts them.
      endsUnpadded_ = true;
      length = static_cast<std::uint32_t>(end - at);
    }
    if (length > end - at) {
      // Fragments of pixels that were cut off are told apart from lengths that make no sense by whoever needs them.
      return short_(say<"it ends inside an element of %1 bytes">(length));
    }
    element.value = bytes_.subspan(at, length);
    if (is(element.kind, "SQ")) {
      std::size_t inside = at;
      if (!sequence(inside, at + length, false, depth, element)) return false;
    }
    at += length;
    return true;
  }

  bool sequence(std::size_t& at, std::size_t end, bool toMarker, int depth, DicomElement& element) {
    while (at < end) {
      if (end - at < 8) return short_(say<"it ends inside a sequence">());
      const DicomTag tag = tagAt(at);
      const auto length = numberAt<std::uint32_t>(bytes_, at + 4, bigEndian_);
      at += 8;
      if (tag == kSequenceEnd && toMarker) return true;
      if (tag != kItem) return fails(say<"a sequence holds something that is no item">());
      if (++elements_ > kMostElements) return fails(say<"it has too many elements">());
      DicomItem item;
      if (length == kUndefined) {
        if (!set(at, end, true, depth + 1, item)) return false;
      } else {
        if (length > end - at) return short_(say<"it ends inside an item of a sequence">());
        std::size_t inside = at;
        if (!set(inside, at + length, false, depth + 1, item)) return false;
        at += length;
      }
      element.items.push_back(std::move(item));
    }
    return !toMarker || short_(say<"it ends inside a sequence">());
  }

  bool fragments(std::size_t& at, std::size_t end, DicomElement& element) {
    const auto unmarked = [&] {
      endsUnmarked_ = element.fragments.size() > 1;
      return endsUnmarked_;
    };
    while (at < end) {
      if (end - at < 8) {
        at = end;
        return unmarked() || short_(say<"it ends inside the pixels">());
      }
      const DicomTag tag = tagAt(at);
      const auto length = numberAt<std::uint32_t>(bytes_, at + 4, bigEndian_);
      // Zeros where the mark should be, as some devices write them: whether images are missing is seen by whoever counts them.
      if (tag == 0 && length == 0 && unmarked()) return true;
      at += 8;
      if (tag == kSequenceEnd) return true;
      if (tag != kItem) return fails(say<"the pixels hold something that is no fragment">());
      const std::size_t there = std::min<std::size_t>(length, end - at);
      const Bytes fragment = bytes_.subspan(at, there);
      if (there < length) {
        if (!lacksPadding(length, there, end) || !mayEndStream(element, fragment)) return short_(say<"it ends inside the pixels">());
        endsUnpadded_ = true;
      }
      if (++elements_ > kMostElements) return fails(say<"it has too many fragments">());
      element.fragments.push_back(fragment);
      at += there;
    }
    return unmarked() || short_(say<"it ends inside the pixels">());
  }

  Bytes bytes_;
  bool explicit_;
  bool bigEndian_;
  std::size_t elements_ = 0;
  Message why_;
  std::size_t tail_ = 0;
  bool endsUnmarked_ = false;
  bool endsUnpadded_ = false;
  bool short_read_ = false;
};

/// Unpacks a raw deflate stream.
Result<std::vector<std::uint8_t>> inflatedSet(Bytes packed, const fs::path& file, std::uint64_t maxBytes, const Progress& progress) {
  std::vector<std::uint8_t> out;
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
    return failure(ErrorCode::internal, say<"%1 could not be unpacked; close other programs.">(quoted(file)));
  const auto limit = std::min<std::uint64_t>(maxBytes, packed.size() * 1032ull + 1032ull);
  stream.next_in = const_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(std::min<std::size_t>(packed.size(), 0xFFFFFFFFu));
  int state = Z_OK;
  bool stoppedByUser = false;
  while (state == Z_OK && out.size() < limit && !stoppedByUser) {
    stoppedByUser = progress.cancelRequested();
    const std::size_t before = out.size();
    out.resize(std::min<std::uint64_t>(limit, before + (1u << 20)));
    stream.next_out = out.data() + before;
    stream.avail_out = static_cast<uInt>(out.size() - before);
    state = inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
    if (state == Z_OK && stream.avail_in == 0 && stream.avail_out > 0) state = Z_BUF_ERROR;
  }
  inflateEnd(&stream);
  if (stoppedByUser) return stopped(file);
  if (state != Z_STREAM_END)
    return failure(state == Z_OK ? ErrorCode::tooLarge : ErrorCode::truncated,
                   say<"The deflated data set of %1 cannot be unpacked whole; get the file again.">(quoted(file)),
                   {{"file", file.string()}});
  return out;
}

tl::unexpected<Error> refused(const fs::path& file, const Parser& parser) {
  return failure(parser.endsEarly() ? ErrorCode::truncated : ErrorCode::badHeader,
                 say<"%1 cannot be read as DICOM: %2; get the file again.">(quoted(file), parser.why()),
                 {{"file", file.string()}, {"reason", parser.why().english()}});
}

Result<DicomFile> readOrThrow(const fs::path& file, std::uint64_t maxBytes, const Progress& progress) {
  auto bytes = readWholeFile(file, maxBytes);
  if (!bytes) return passOn(bytes.error());
  DicomFile dicom;
  dicom.file = file;
  dicom.bytes = *std::move(bytes);
  const Bytes all = dicom.bytes;
  if (!looksLikeDicom(all.first(std::min<std::size_t>(all.size(), 256))))
    return failure(ErrorCode::badHeader, say<"%1 is not a DICOM file; check what kind of file it is.">(quoted(file)),
                   {{"file", file.string()}});
  std::size_t at = hasPreamble(all) ? 132 : 0;
  const auto namesKinds = [&] { return all.size() >= at + 6 && isKind(all[at + 4], all[at + 5]); };
  if (at == 0)
    dicom.notes.push_back(
        say<"%1 has not the beginning of a DICOM file (preamble and \"DICM\"); it was read as the data set that it holds.">(quoted(file)));
  Parser head(all, at == 132 || namesKinds(), false);
  if (!head.meta(at, dicom.meta)) return refused(file, head);
  dicom.transferSyntax = dicom.meta.text(0x00020010u);
  if (dicom.transferSyntax.empty()) dicom.transferSyntax = namesKinds() ? "1.2.840.10008.1.2.1" : "1.2.840.10008.1.2";
  const std::string& syntax = dicom.transferSyntax;
  const bool explicitKinds = syntax != "1.2.840.10008.1.2";
  const bool bigEndian = syntax == "1.2.840.10008.1.2.2";
  Bytes set = all;
  if (syntax == "1.2.840.10008.1.2.1.99") {
    auto unpacked = inflatedSet(all.subspan(at), file, maxBytes, progress);
    if (!unpacked) return passOn(unpacked.error());
    dicom.inflated = *std::move(unpacked);
    set = dicom.inflated;
    at = 0;
  }
  Parser parser(set, explicitKinds, bigEndian);
  if (!parser.set(at, set.size(), false, 0, dicom.data)) return refused(file, parser);
  if (parser.endsUnmarked())
    dicom.notes.push_back(say<"The mark that ends the pixels of %1 is missing; they were read as far as they go.">(quoted(file)));
  if (parser.endsUnpadded())
    dicom.notes.push_back(say<"%1 is one byte shorter than it says; it is the one that only makes the length even.">(quoted(file)));
  if (parser.tail() > 0)
    dicom.notes.push_back(
        counted<"%2 has %1 byte behind its pixels that is no part of them; it was passed over.",
                "%2 has %1 bytes behind its pixels that are no part of them; they were passed over.">(parser.tail(), quoted(file)));
  return dicom;
}

}  // namespace

Result<std::vector<std::uint8_t>> readWholeFile(const fs::path& file, std::uint64_t maxBytes) {
  if (const auto status = checkIsFile(file); !status) return passOn(status.error());
  std::error_code ec;
  const auto size = fs::file_size(file, ec);
  if (ec) return failure(ErrorCode::notReadable, say<"%1 cannot be read; check its permissions.">(quoted(file)), {{"file", file.string()}});
  if (size > maxBytes)
    return failure(ErrorCode::tooLarge, say<"%1 has %2 bytes, but the limit is %3; cut it into parts.">(quoted(file), size, maxBytes),
                   {{"file", file.string()}, {"bytes", std::to_string(size)}, {"limit", std::to_string(maxBytes)}});
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) return notOpened(file, errno);
  std::vector<std::uint8_t> bytes(size);
  if (size > 0 && !in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
    return failure(ErrorCode::notReadable, say<"%1 cannot be read; check its permissions.">(quoted(file)), {{"file", file.string()}});
  return bytes;
}

const DicomElement* DicomItem::find(DicomTag tag) const { return entryWith(elements, &DicomElement::tag, tag); }

std::span<const DicomItem> DicomItem::items(DicomTag tag) const {
  const DicomElement* const element = find(tag);
  return element == nullptr ? std::span<const DicomItem>() : std::span<const DicomItem>(element->items);
}

std::string DicomItem::text(DicomTag tag) const {
  const DicomElement* const element = find(tag);
  if (element == nullptr) return {};
  std::string text(element->value.begin(),
                   element->value.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(element->value.size(), 4u << 20)));
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  text.erase(0, text.find_first_not_of(' '));
  return text;
}

std::vector<double> DicomItem::numbers(DicomTag tag) const {
  const DicomElement* const element = find(tag);
  if (element == nullptr) return {};
  std::vector<double> values;
  const auto binary = [&]<class T>(T) {
    for (std::size_t at = 0; at + sizeof(T) <= element->value.size(); at += sizeof(T))
      values.push_back(static_cast<double>(numberAt<T>(element->value, at, bigEndian)));
  };
  const auto kindOf = [&]() -> std::array<char, 2> {
    if (!is(element->kind, "UN")) return element->kind;
    // What an implicit file leaves to the dictionary (PS3.6), for the elements that are asked for here.
    const std::uint32_t group = tag >> 16, number = tag & 0xFFFFu;
    if (group == 0x0018u && number >= 0x6012u && number <= 0x6014u) return {'U', 'S'};
    if (group == 0x0018u && (number == 0x6024u || number == 0x6026u)) return {'U', 'S'};
    if (group == 0x0018u && (number == 0x6020u || number == 0x6022u)) return {'S', 'L'};
    if (group == 0x0018u && ((number >= 0x6028u && number <= 0x602Eu) || number == 0x9073u)) return {'F', 'D'};
    if (group == 0x0018u && number >= 0x6016u && number <= 0x601Eu) return {'U', 'L'};
    if (group == 0x0020u && (number == 0x9301u || number == 0x9302u || number == 0x930Du)) return {'F', 'D'};
    if (tag == 0x00209128u) return {'U', 'L'};
    if (tag == 0x00280008u || tag == 0x00280030u || tag == 0x00281052u || tag == 0x00281053u) return {'D', 'S'};
    if (group == 0x0028u && (number <= 0x0011u || (number >= 0x0100u && number <= 0x0103u) || (number >= 0x1101u && number <= 0x1103u)))
      return {'U', 'S'};
    return {'D', 'S'};
  }();
  if (is(kindOf, "US")) {
    binary(std::uint16_t{});
  } else if (is(kindOf, "SS")) {
    binary(std::int16_t{});
  } else if (is(kindOf, "UL")) {
    binary(std::uint32_t{});
  } else if (is(kindOf, "SL")) {
    binary(std::int32_t{});
  } else if (is(kindOf, "FD")) {
    binary(double{});
  } else if (is(kindOf, "FL")) {
    binary(float{});
  } else {
    const std::string all = text(tag);
    for (std::size_t from = 0; from <= all.size();) {
      const std::size_t to = std::min(all.find('\\', from), all.size());
      std::string piece(trimmed(std::string_view(all).substr(from, to - from)));
      // A comma is no part of a number in DICOM, so that it can only be meant as a point.
      if (std::count(piece.begin(), piece.end(), ',') == 1) std::replace(piece.begin(), piece.end(), ',', '.');
      const auto value = parseNumber(piece);
      if (!value) break;
      values.push_back(*value);
      from = to + 1;
    }
  }
  return values;
}

bool DicomItem::hasDecimalCommas(DicomTag tag) const {
  const DicomElement* const element = find(tag);
  if (element == nullptr || !(is(element->kind, "DS") || is(element->kind, "IS") || is(element->kind, "UN"))) return false;
  return std::find(element->value.begin(), element->value.end(), std::uint8_t{','}) != element->value.end();
}

std::optional<double> DicomItem::number(DicomTag tag) const {
  const auto values = numbers(tag);
  if (values.empty()) return std::nullopt;
  return values.front();
}

std::optional<std::uint64_t> DicomItem::count(DicomTag tag) const {
  const auto value = number(tag);
  if (!value || !(*value >= 0.0) || *value > 4294967295.0 || *value != static_cast<double>(static_cast<std::uint64_t>(*value)))
    return std::nullopt;
  return static_cast<std::uint64_t>(*value);
}

bool looksLikeDicom(Bytes beginning) { return hasPreamble(beginning) || beginsWithElements(beginning); }

Result<DicomFile> readDicomFile(const fs::path& file, std::uint64_t maxBytes, const Progress& progress) try {
  return readOrThrow(file, maxBytes, progress);
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for %1; close other programs.">(quoted(file)),
                 {{"file", file.string()}});
}

}  // namespace ew::detail
