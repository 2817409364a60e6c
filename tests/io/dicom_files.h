#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "files.h"

namespace ew::test {

/// Writes data elements as DICOM stores them (PS3.5): explicit or implicit, little or big endian.
class DicomWriter {
 public:
  explicit DicomWriter(bool explicitKinds = true, bool bigEndian = false) : explicit_(explicitKinds), big_(bigEndian) {}

  DicomWriter& raw(std::uint32_t tag, const char* kind, std::string value) {
    if (value.size() % 2 != 0) value += (kind[0] == 'O' || std::strcmp(kind, "UI") == 0 || std::strcmp(kind, "UN") == 0) ? '\0' : ' ';
    head(tag, kind, static_cast<std::uint32_t>(value.size()));
    out_ += value;
    return *this;
  }
  DicomWriter& text(std::uint32_t tag, const char* kind, const std::string& value) { return raw(tag, kind, value); }
  DicomWriter& us(std::uint32_t tag, std::uint16_t value) { return raw(tag, "US", bytes(value)); }
  DicomWriter& ul(std::uint32_t tag, std::uint32_t value) { return raw(tag, "UL", bytes(value)); }
  DicomWriter& sl(std::uint32_t tag, std::int32_t value) { return raw(tag, "SL", bytes(static_cast<std::uint32_t>(value))); }
  DicomWriter& fd(std::uint32_t tag, const std::vector<double>& values) {
    std::string all;
    for (const double value : values) all += bytes(value);
    return raw(tag, "FD", all);
  }
  /// @param undefined with end markers instead of lengths
  DicomWriter& sequence(std::uint32_t tag, const std::vector<std::string>& items, bool undefined = false) {
    std::string all;
    for (const std::string& item : items) {
      all += marker(0xFFFEE000u) + bytes(undefined ? 0xFFFFFFFFu : static_cast<std::uint32_t>(item.size())) + item;
      if (undefined) all += marker(0xFFFEE00Du) + bytes(std::uint32_t{0});
    }
    if (undefined) all += marker(0xFFFEE0DDu) + bytes(std::uint32_t{0});
    head(tag, "SQ", undefined ? 0xFFFFFFFFu : static_cast<std::uint32_t>(all.size()));
    out_ += all;
    return *this;
  }
  /// Packed images, one fragment each, with an empty offset table.
  DicomWriter& fragments(const std::vector<std::string>& images) {
    head(0x7FE00010u, "OB", 0xFFFFFFFFu);
    out_ += marker(0xFFFEE000u) + bytes(std::uint32_t{0});
    for (std::string image : images) {
      if (image.size() % 2 != 0) image += '\0';
      out_ += marker(0xFFFEE000u) + bytes(static_cast<std::uint32_t>(image.size())) + image;
    }
    out_ += marker(0xFFFEE0DDu) + bytes(std::uint32_t{0});
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return out_; }

  template <class T>
  [[nodiscard]] std::string bytes(T value) const {
    auto copy = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (big_) std::reverse(copy.begin(), copy.end());
    return {copy.begin(), copy.end()};
  }

 private:
  [[nodiscard]] std::string marker(std::uint32_t tag) const {
    return bytes(static_cast<std::uint16_t>(tag >> 16)) + bytes(static_cast<std::uint16_t>(tag & 0xFFFFu));
  }
  void head(std::uint32_t tag, const char* kind, std::uint32_t length) {
    out_ += marker(tag);
    if (!explicit_) {
      out_ += bytes(length);
      return;
    }
    out_ += kind;
    const std::string longOnes = "OB OW OF OD SQ UN UT";
    if (longOnes.find(kind) != std::string::npos)
      out_ += std::string(2, '\0') + bytes(length);
    else
      out_ += bytes(static_cast<std::uint16_t>(length));
  }

  std::string out_;
  bool explicit_;
  bool big_;
};

/// Preamble, "DICM" and the meta group in front of a data set.
inline std::string dicomFile(const std::string& transferSyntax, const std::string& dataSet,
                             const std::string& sopClass = "1.2.840.10008.5.1.4.1.1.3.1") {
  DicomWriter meta;
  meta.raw(0x00020001u, "OB", std::string("\0\1", 2));
  meta.text(0x00020002u, "UI", sopClass);
  meta.text(0x00020003u, "UI", "2.25.1");
  meta.text(0x00020010u, "UI", transferSyntax);
  meta.text(0x00020012u, "UI", "2.25.2");
  DicomWriter length;
  length.ul(0x00020000u, static_cast<std::uint32_t>(meta.bytes().size()));
  return std::string(128, '\0') + "DICM" + length.bytes() + meta.bytes() + dataSet;
}

inline constexpr const char* kImplicitLittle = "1.2.840.10008.1.2";
inline constexpr const char* kExplicitLittle = "1.2.840.10008.1.2.1";
inline constexpr const char* kExplicitBig = "1.2.840.10008.1.2.2";
inline constexpr const char* kDeflated = "1.2.840.10008.1.2.1.99";
inline constexpr const char* kJpegBaseline = "1.2.840.10008.1.2.4.50";
inline constexpr const char* kJpegLossless = "1.2.840.10008.1.2.4.70";
inline constexpr const char* kJpegLs = "1.2.840.10008.1.2.4.80";
inline constexpr const char* kJpeg2000 = "1.2.840.10008.1.2.4.90";
inline constexpr const char* kRle = "1.2.840.10008.1.2.5";

/// One ultrasound region; corners included.
struct RegionOf {
  std::uint32_t x0 = 0, y0 = 0, x1 = 7, y1 = 5;
  double deltaX = 0.02, deltaY = 0.03;  // cm
  std::uint16_t units = 3, format = 1, type = 1;
};
inline std::string regionItem(const RegionOf& region, bool explicitKinds = true, bool bigEndian = false) {
  DicomWriter item(explicitKinds, bigEndian);
  item.us(0x00186012u, region.format).us(0x00186014u, region.type).ul(0x00186016u, 0);
  item.ul(0x00186018u, region.x0).ul(0x0018601Au, region.y0).ul(0x0018601Cu, region.x1).ul(0x0018601Eu, region.y1);
  item.sl(0x00186020u, 4).sl(0x00186022u, 0).us(0x00186024u, region.units).us(0x00186026u, region.units);
  item.fd(0x0018602Cu, {region.deltaX}).fd(0x0018602Eu, {region.deltaY});
  return item.bytes();
}

/// A cine as a scanner stores it, with what the tests vary.
struct CineOf {
  std::string syntax = kExplicitLittle;
  std::uint16_t columns = 8, rows = 6;
  int frames = 3;
  std::string photometric = "MONOCHROME2";
  std::uint16_t samples = 1, bits = 8, stored = 8, sign = 0, planar = 0;
  std::string pixels;               ///< of all frames, uncompressed
  std::vector<std::string> packed;  ///< one a frame, instead of `pixels`
  std::vector<RegionOf> regions = {{}};
  std::string frameTime = "40";
  std::string frameTimes;  ///< Frame Time Vector, then it is the one that is pointed to
  std::string burnedIn;
  bool undefinedLengths = false;
  std::string extra;  ///< elements before the pixels (group 0028 and above, below 7FE0)
};

inline std::string dataSetOf(const CineOf& cine) {
  const bool explicitKinds = cine.syntax != kImplicitLittle, big = cine.syntax == kExplicitBig;
  DicomWriter set(explicitKinds, big);
  set.text(0x00080016u, "UI", "1.2.840.10008.5.1.4.1.1.3.1").text(0x00080018u, "UI", "2.25.1");
  set.text(0x00080060u, "CS", "US").text(0x00080080u, "LO", "Some Hospital");
  set.raw(0x00091001u, "UN", "private words");
  set.text(0x00100010u, "PN", "Doe^Jane").text(0x00100020u, "LO", "4711");
  if (cine.frameTimes.empty())
    set.text(0x00181063u, "DS", cine.frameTime);
  else
    set.text(0x00181065u, "DS", cine.frameTimes);
  std::vector<std::string> items;
  for (const RegionOf& region : cine.regions) items.push_back(regionItem(region, explicitKinds, big));
  if (!items.empty()) set.sequence(0x00186011u, items, cine.undefinedLengths);
  set.us(0x00280002u, cine.samples).text(0x00280004u, "CS", cine.photometric);
  if (cine.samples == 3) set.us(0x00280006u, cine.planar);
  set.text(0x00280008u, "IS", std::to_string(cine.frames));
  const std::uint16_t pointer = cine.frameTimes.empty() ? 0x1063 : 0x1065;
  set.raw(0x00280009u, "AT", set.bytes(std::uint16_t{0x0018}) + set.bytes(pointer));
  set.us(0x00280010u, cine.rows).us(0x00280011u, cine.columns);
  set.us(0x00280100u, cine.bits).us(0x00280101u, cine.stored).us(0x00280102u, static_cast<std::uint16_t>(cine.stored - 1));
  set.us(0x00280103u, cine.sign);
  if (!cine.burnedIn.empty()) set.text(0x00280301u, "CS", cine.burnedIn);
  std::string bytes = set.bytes() + cine.extra;
  DicomWriter pixels(explicitKinds, big);
  if (cine.packed.empty())
    pixels.raw(0x7FE00010u, cine.bits > 8 ? "OW" : "OB", cine.pixels);
  else
    pixels.fragments(cine.packed);
  return bytes + pixels.bytes();
}

inline std::string cineFile(const CineOf& cine) {
  std::string set = dataSetOf(cine);
  if (cine.syntax == kDeflated) {
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, set.size()) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(set.data());
    stream.avail_in = static_cast<uInt>(set.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    set = packed;
  }
  return dicomFile(cine.syntax, set);
}

/// RLE of DICOM with literal runs alone: byte planes of one frame.
inline std::string rleOf(const std::vector<std::string>& planes) {
  std::vector<std::string> segments;
  for (const std::string& plane : planes) {
    std::string segment;
    for (std::size_t at = 0; at < plane.size();) {
      std::size_t run = 1;
      while (at + run < plane.size() && run < 100 && plane[at + run] == plane[at]) ++run;
      if (run > 2) {
        segment += static_cast<char>(1 - static_cast<int>(run));
        segment += plane[at];
        at += run;
      } else {
        const std::size_t count = std::min<std::size_t>(plane.size() - at, 5);
        segment += static_cast<char>(count - 1);
        segment += plane.substr(at, count);
        at += count;
      }
    }
    if (segment.size() % 2 != 0) segment += '\0';
    segments.push_back(segment);
  }
  std::string head(64, '\0'), all;
  const auto put = [&](std::size_t n, std::uint32_t value) { std::memcpy(head.data() + 4 * n, &value, 4); };
  put(0, static_cast<std::uint32_t>(segments.size()));
  for (std::size_t n = 0; n < segments.size(); ++n) {
    put(n + 1, static_cast<std::uint32_t>(64 + all.size()));
    all += segments[n];
  }
  return head + all;
}

/// An Enhanced US Volume of 8 bit planes.
struct EnhancedOf {
  std::uint16_t columns = 5, rows = 4;
  std::vector<std::vector<double>> positions = {{1, 2, 3}, {1, 2, 5}, {1, 2, 7}};
  std::vector<std::vector<double>> orientations = {{1, 0, 0, 0, 1, 0}};  ///< one: shared
  std::vector<double> times = {};                                        ///< one a frame
  std::vector<std::string> types = {};
  std::string spacing = "0.5\\0.25";  ///< rows, columns
  std::string pixels;
};
inline std::string enhancedFile(const EnhancedOf& volume) {
  DicomWriter set;
  set.text(0x00080016u, "UI", "1.2.840.10008.5.1.4.1.1.6.2").text(0x00080018u, "UI", "2.25.3");
  set.text(0x00100010u, "PN", "Doe^Jane");
  set.us(0x00280002u, 1).text(0x00280004u, "CS", "MONOCHROME2").text(0x00280008u, "IS", std::to_string(volume.positions.size()));
  set.us(0x00280010u, volume.rows).us(0x00280011u, volume.columns);
  set.us(0x00280100u, 8).us(0x00280101u, 8).us(0x00280102u, 7).us(0x00280103u, 0);
  DicomWriter shared, measures;
  measures.text(0x00280030u, "DS", volume.spacing);
  if (volume.orientations.size() == 1) {
    DicomWriter orientation;
    orientation.fd(0x00209302u, volume.orientations[0]);
    shared.sequence(0x0020930Fu, {orientation.bytes()});
  }
  shared.sequence(0x00289110u, {measures.bytes()});
  std::vector<std::string> frames;
  for (std::size_t n = 0; n < volume.positions.size(); ++n) {
    DicomWriter frame, position;
    if (!volume.types.empty()) {
      DicomWriter type;
      type.text(0x00189808u, "CS", volume.types[n]);
      frame.sequence(0x00189807u, {type.bytes()});
    }
    position.fd(0x00209301u, volume.positions[n]);
    frame.sequence(0x0020930Eu, {position.bytes()});
    if (volume.orientations.size() > 1) {
      DicomWriter orientation;
      orientation.fd(0x00209302u, volume.orientations[n]);
      frame.sequence(0x0020930Fu, {orientation.bytes()});
    }
    if (!volume.times.empty()) {
      DicomWriter time;
      time.fd(0x0020930Du, {volume.times[n]});
      frame.sequence(0x00209310u, {time.bytes()});
    }
    frames.push_back(frame.bytes());
  }
  set.sequence(0x52009229u, {shared.bytes()});
  set.sequence(0x52009230u, frames, true);
  set.raw(0x7FE00010u, "OW", volume.pixels);
  return dicomFile(kExplicitLittle, set.bytes(), "1.2.840.10008.5.1.4.1.1.6.2");
}

}  // namespace ew::test
