#include <openssl/evp.h>

#include <array>
#include <cctype>

#include "ew/records/xapi.h"

namespace ew {
namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

std::string hexOf(const unsigned char* bytes, std::size_t count) {
  std::string text;
  for (std::size_t n = 0; n < count; ++n) {
    text += kHexDigits[bytes[n] >> 4];
    text += kHexDigits[bytes[n] & 15];
  }
  return text;
}

/// The 16 bytes of a UUID's text.
std::string bytesOfUuid(std::string_view text) {
  std::string bytes;
  int half = -1;
  for (const char letter : text) {
    if (letter == '-') continue;
    const auto digit = static_cast<int>(kHexDigits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(letter)))));
    if (half >= 0) bytes += static_cast<char>(half * 16 + digit);
    half = half >= 0 ? -1 : digit;
  }
  return bytes;
}

}  // namespace

bool isUuid(std::string_view text) {
  if (text.size() != 36) return false;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const bool isDash = n == 8 || n == 13 || n == 18 || n == 23;
    if (isDash ? text[n] != '-' : std::isxdigit(static_cast<unsigned char>(text[n])) == 0) return false;
  }
  return true;
}

std::string uuidOfName(std::string_view space, std::string_view name) {
  const std::string content = bytesOfUuid(space) + std::string(name);
  std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
  unsigned size = 0;
  EVP_Digest(content.data(), content.size(), sum.data(), &size, EVP_sha1(), nullptr);
  sum[6] = static_cast<unsigned char>((sum[6] & 0x0f) | 0x50);  // version 5
  sum[8] = static_cast<unsigned char>((sum[8] & 0x3f) | 0x80);  // variant of RFC 4122
  std::string text = hexOf(sum.data(), 16);
  for (const std::size_t dash : {8u, 13u, 18u, 23u}) text.insert(dash, "-");
  return text;
}

}  // namespace ew
