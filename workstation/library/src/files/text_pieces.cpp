#include "files/text_pieces.h"

#include <algorithm>

namespace ew {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80; }
bool isWhite(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

std::vector<TextPiece> piecesOf(std::string_view text) {
  std::vector<TextPiece> pieces;
  bool isApart = true;
  for (std::size_t at = 0; at < text.size();) {
    if (isWhite(text[at])) {
      isApart = true;
      ++at;
      continue;
    }
    const auto kind = isDigit(text[at]) ? TextPiece::Kind::digits : isLetter(text[at]) ? TextPiece::Kind::word : TextPiece::Kind::mark;
    std::size_t end = at + 1;
    if (kind == TextPiece::Kind::digits)
      end = static_cast<std::size_t>(std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), isDigit) - text.begin());
    if (kind == TextPiece::Kind::word)
      end = static_cast<std::size_t>(std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), isLetter) - text.begin());
    pieces.push_back({kind, text.substr(at, end - at), at, isApart});
    isApart = false;
    at = end;
  }
  return pieces;
}

long valueOf(const TextPiece& digits) {
  if (digits.text.size() > 9) return -1;
  long value = 0;
  for (const char each : digits.text) value = 10 * value + (each - '0');
  return value;
}

bool isCapitalised(std::string_view word) {
  if (word.empty()) return false;
  if (word.front() >= 'A' && word.front() <= 'Z') return true;
  // Capital letters of Latin-1 in UTF-8: 0xC3 0x80 to 0x9E.
  return word.size() > 1 && static_cast<unsigned char>(word[0]) == 0xC3 && static_cast<unsigned char>(word[1]) >= 0x80 &&
         static_cast<unsigned char>(word[1]) <= 0x9E;
}

std::string inSmallLetters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return small;
}

}  // namespace ew
