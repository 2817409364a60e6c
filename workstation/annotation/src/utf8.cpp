#include "utf8.h"

namespace ew::annotation {
namespace {

bool isContinuing(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

std::string oneLine(std::string_view text, std::size_t longest) {
  std::string line;
  bool isApart = false;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      isApart = !line.empty();
      continue;
    }
    if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F) continue;
    if (isApart) line += ' ';
    isApart = false;
    line += c;
  }
  if (line.size() > longest) {
    std::size_t end = longest;
    while (end > 0 && isContinuing(line[end])) --end;
    line.resize(end);
    while (line.ends_with(' ')) line.pop_back();
  }
  return line;
}

std::string smallLetters(std::string_view text) {
  std::string small(text);
  for (std::size_t n = 0; n < small.size(); ++n) {
    const auto byte = static_cast<unsigned char>(small[n]);
    if (byte >= 'A' && byte <= 'Z') small[n] = static_cast<char>(byte + 0x20U);
    // U+00C0 to U+00DE are C3 80 to C3 9E; U+00D7 is the sign of a product.
    const bool isLatin = n > 0 && static_cast<unsigned char>(small[n - 1]) == 0xC3U;
    if (isLatin && byte >= 0x80U && byte <= 0x9EU && byte != 0x97U) small[n] = static_cast<char>(byte + 0x20U);
  }
  return small;
}

}  // namespace ew::annotation
