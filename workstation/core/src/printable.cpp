#include "ew/core/printable.h"

#include <algorithm>

namespace ew {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";

unsigned char byteOf(char letter) { return static_cast<unsigned char>(letter); }

/// Of a first byte; 0 of what begins nothing.
std::size_t lengthFrom(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first <= 0xdf) return 2;
  if (first >= 0xe0 && first <= 0xef) return 3;
  return first >= 0xf0 && first <= 0xf4 ? 4 : 0;
}

/// The length of the character that `text` begins with; 0 when it is none. Not too long for what they say, no surrogates, none beyond
/// U+10FFFF (Unicode 15, table 3-7).
std::size_t characterAt(std::string_view text) {
  const unsigned char first = byteOf(text.front());
  const std::size_t length = lengthFrom(first);
  if (length == 0 || text.size() < length) return 0;
  if (length == 1) return 1;
  const unsigned char second = byteOf(text[1]);
  const unsigned char lowest = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
  const unsigned char highest = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
  if (second < lowest || second > highest) return 0;
  for (std::size_t n = 2; n < length; ++n)
    if ((byteOf(text[n]) & 0xc0) != 0x80) return 0;
  return length;
}

bool isControl(std::string_view character) {
  const unsigned char first = byteOf(character.front());
  if (character.size() == 1) return (first < 0x20 && first != '\n' && first != '\t') || first == 0x7f;
  return first == 0xc2 && byteOf(character[1]) < 0xa0;  // U+0080 to U+009F
}

}  // namespace

std::string printable(std::string_view text) {
  std::string made;
  made.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = characterAt(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    text.remove_prefix(character.size());
    if (character == "\r" && text.starts_with('\n')) continue;
    made += length == 0 || isControl(character) ? kReplacement : character;
  }
  return made;
}

std::string printableLine(std::string_view text) {
  std::string made = printable(text);
  std::replace_if(
      made.begin(), made.end(), [](char letter) { return letter == '\n' || letter == '\t'; }, ' ');
  return made;
}

std::size_t unfinishedBytes(std::string_view text) {
  for (std::size_t back = 1; back <= std::min<std::size_t>(3, text.size()); ++back) {
    const unsigned char byte = byteOf(text[text.size() - back]);
    if ((byte & 0xc0) == 0x80) continue;  // goes on
    return lengthFrom(byte) > back ? back : 0;
  }
  return 0;
}

}  // namespace ew
