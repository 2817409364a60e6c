#include "ew/library/plain_image.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace ew {
namespace {

constexpr std::string_view kPngBegin = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kJpegBegin = "\xff\xd8\xff";
constexpr std::array<std::string_view, 8> kPngChunks = {"IHDR", "PLTE", "tRNS", "gAMA", "sRGB", "cHRM", "IDAT", "IEND"};

tl::unexpected<Error> damaged() { return failure(ErrorCode::badHeader, say<"The image is damaged; save it anew as a PNG.">()); }

std::uint32_t bigEndian(const std::string& bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t n = 0; n < count; ++n) value = (value << 8) | static_cast<std::uint8_t>(bytes[at + n]);
  return value;
}

Result<std::string> plainPng(const std::string& bytes) {
  constexpr std::size_t kAround = 12;  // length, name, sum
  std::string made(kPngBegin);
  for (std::size_t at = kPngBegin.size(); at + kAround <= bytes.size();) {
    const std::size_t length = bigEndian(bytes, at, 4);
    if (length > bytes.size() - at - kAround) return damaged();
    const std::string_view name(bytes.data() + at + 4, 4);
    if (std::find(kPngChunks.begin(), kPngChunks.end(), name) != kPngChunks.end()) made.append(bytes, at, length + kAround);
    if (name == "IEND") return made;
    at += length + kAround;
  }
  return damaged();
}

/// Where the entropy-coded samples that begin at `at` end: at the next marker that is none of their own.
std::size_t endOfSamples(const std::string& bytes, std::size_t at) {
  for (; at + 1 < bytes.size(); ++at) {
    if (static_cast<std::uint8_t>(bytes[at]) != 0xff) continue;
    const auto next = static_cast<std::uint8_t>(bytes[at + 1]);
    if (next != 0 && (next < 0xd0 || next > 0xd7)) return at;
  }
  return bytes.size();
}

Result<std::string> plainJpeg(const std::string& bytes) {
  constexpr std::uint8_t kEnd = 0xd9, kScan = 0xda, kComment = 0xfe, kAdobe = 0xee, kFirstApp = 0xe0, kLastApp = 0xef;
  std::string made = bytes.substr(0, 2);
  for (std::size_t at = 2; at + 2 <= bytes.size();) {
    if (static_cast<std::uint8_t>(bytes[at]) != 0xff) return damaged();
    const auto marker = static_cast<std::uint8_t>(bytes[at + 1]);
    if (marker == kEnd) return made + bytes.substr(at, 2);
    if (marker == 0xff) {  // filling
      ++at;
      continue;
    }
    if (at + 4 > bytes.size()) return damaged();
    const std::size_t length = bigEndian(bytes, at + 2, 2);
    if (length < 2 || length > bytes.size() - at - 2) return damaged();
    const std::size_t end = marker == kScan ? endOfSamples(bytes, at + 2 + length) : at + 2 + length;
    // Adobe's segment says which colours the numbers mean; all others of applications, and comments, are words about the image.
    const bool isWords = marker == kComment || (marker >= kFirstApp && marker <= kLastApp && marker != kAdobe);
    if (!isWords) made.append(bytes, at, end - at);
    at = end;
  }
  return damaged();
}

}  // namespace

Result<std::string> plainImage(const std::string& bytes, std::string& ending) {
  if (bytes.starts_with(kPngBegin)) {
    ending = ".png";
    return plainPng(bytes);
  }
  if (bytes.starts_with(kJpegBegin)) {
    ending = ".jpg";
    return plainJpeg(bytes);
  }
  return failure(ErrorCode::unsupported,
                 say<"Images of an examination are PNG or JPEG, of which it is known where words may hide; save it as one.">());
}

}  // namespace ew
