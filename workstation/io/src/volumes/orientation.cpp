#include "ew/io/orientation.h"

#include <cmath>
#include <cstring>
#include <string_view>

namespace ew {
namespace {

using ExifBytes = std::span<const std::uint8_t>;

/// Numbers of a TIFF header, in its own order of bytes.
struct TiffNumbers {
  ExifBytes bytes;
  bool big = false;

  [[nodiscard]] std::optional<std::uint32_t> at(std::size_t from, std::size_t count) const {
    if (from > bytes.size() || bytes.size() - from < count) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t n = 0; n < count; ++n) value = value << 8 | bytes[from + (big ? n : count - 1 - n)];
    return value;
  }
};

std::uint32_t bigEndian(ExifBytes bytes, std::size_t from, std::size_t count) {
  return TiffNumbers{bytes, true}.at(from, count).value_or(0);
}

bool hasTextAt(ExifBytes bytes, std::size_t from, std::string_view text) {
  return bytes.size() >= text.size() && from <= bytes.size() - text.size() &&
         std::memcmp(bytes.data() + from, text.data(), text.size()) == 0;
}

/// Exif data lie in the first segment APP1 that begins with its name; behind the start of the scan there is none.
Orientation orientationOfJpeg(ExifBytes file) {
  for (std::size_t at = 2; at + 4 <= file.size() && file[at] == 0xFF;) {
    const std::uint8_t marker = file[at + 1];
    if (marker == 0xFF) {  // fill bytes
      ++at;
      continue;
    }
    const std::size_t length = bigEndian(file, at + 2, 2);
    if (marker == 0xDA || length < 2 || length > file.size() - at - 2) return {};
    using namespace std::string_view_literals;
    if (marker == 0xE1 && length >= 8 && hasTextAt(file, at + 4, "Exif\0\0"sv)) return orientationOfExif(file.subspan(at + 10, length - 8));
    at += 2 + length;
  }
  return {};
}

Orientation orientationOfPng(ExifBytes file) {
  for (std::size_t at = 8; at + 12 <= file.size();) {
    const std::size_t length = bigEndian(file, at, 4);
    if (length > file.size() - at - 12) return {};
    if (hasTextAt(file, at + 4, "eXIf")) return orientationOfExif(file.subspan(at + 8, length));
    at += 12 + length;
  }
  return {};
}

}  // namespace

Orientation then(const Orientation& first, const Orientation& second) {
  // A turn before a mirror is the opposite turn behind it.
  const int turns = first.quarterTurns + (first.mirrored ? 4 - second.quarterTurns : second.quarterTurns);
  return {turns % 4, first.mirrored != second.mirrored};
}

std::optional<Orientation> orientationOfTag(int tag) {
  switch (tag) {
    case 1:
      return Orientation{};
    case 2:
      return Orientation{0, true};
    case 3:
      return Orientation{2, false};
    case 4:
      return Orientation{2, true};
    case 5:
      return Orientation{1, true};
    case 6:
      return Orientation{1, false};
    case 7:
      return Orientation{3, true};
    case 8:
      return Orientation{3, false};
    default:
      return std::nullopt;
  }
}

std::optional<Orientation> orientationOfMatrix(double a, double b, double c, double d) {
  constexpr double kStraight = 0.05;  // of the length: up to 3 degrees off
  const double across = std::hypot(a, b), down = std::hypot(c, d);
  if (!std::isfinite(across) || !std::isfinite(down) || !(across > 0.0) || !(down > 0.0)) return std::nullopt;
  const bool isUpright = std::abs(b) < kStraight * across && std::abs(c) < kStraight * down;
  const bool isTurned = std::abs(a) < kStraight * across && std::abs(d) < kStraight * down;
  if (isUpright) return d > 0.0 ? Orientation{0, a < 0.0} : Orientation{2, a > 0.0};
  if (isTurned) return b > 0.0 ? Orientation{1, c > 0.0} : Orientation{3, c < 0.0};
  return std::nullopt;
}

Orientation orientationOfExif(ExifBytes tiff) {
  if (!hasTextAt(tiff, 0, "II") && !hasTextAt(tiff, 0, "MM")) return {};
  const TiffNumbers numbers{tiff, tiff[0] == 'M'};
  if (numbers.at(2, 2) != 42u) return {};
  const std::size_t directory = numbers.at(4, 4).value_or(0);
  const std::size_t count = numbers.at(directory, 2).value_or(0);
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t entry = directory + 2 + 12 * n;
    const auto tag = numbers.at(entry, 2);
    if (!tag) return {};
    if (*tag == 274u) return orientationOfTag(static_cast<int>(numbers.at(entry + 8, 2).value_or(1))).value_or(Orientation{});
  }
  return {};
}

Orientation orientationOfImage(ExifBytes file) {
  using namespace std::string_view_literals;
  if (hasTextAt(file, 0, "\xFF\xD8"sv)) return orientationOfJpeg(file);
  if (hasTextAt(file, 0, "\x89PNG\r\n\x1A\n"sv)) return orientationOfPng(file);
  return {};
}

}  // namespace ew
