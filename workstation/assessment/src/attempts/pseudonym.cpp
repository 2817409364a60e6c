#include "ew/assessment/pseudonym.h"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "attempts/folder_lock.h"
#include "ew/io/private_file.h"
#include "ew/library/checksums.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlock_bytes = 64, kDigest_bytes = 32;  // of SHA-256

int valueOfDigit(char digit) {
  if (digit >= '0' && digit <= '9') return digit - '0';
  return digit >= 'a' && digit <= 'f' ? digit - 'a' + 10 : -1;
}

template <std::size_t N>
std::optional<std::array<std::byte, N>> bytesOfHex(std::string_view hex) {
  if (hex.size() != 2 * N) return std::nullopt;
  std::array<std::byte, N> bytes{};
  for (std::size_t n = 0; n < N; ++n) {
    const int high = valueOfDigit(hex[2 * n]), low = valueOfDigit(hex[2 * n + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    bytes[n] = static_cast<std::byte>(16 * high + low);
  }
  return bytes;
}

std::string hexOf(std::span<const std::byte> bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string hex;
  for (const std::byte each : bytes) {
    hex += kDigits[std::to_integer<std::size_t>(each) / 16];
    hex += kDigits[std::to_integer<std::size_t>(each) % 16];
  }
  return hex;
}

/// "7F3K-2QXM": the first 40 bits, five to a letter.
std::string codeOf(const std::string& hash) {
  constexpr std::string_view kLetters = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
  const std::uint64_t bits = std::stoull(hash.substr(0, 10), nullptr, 16);
  std::string code;
  for (int shift = 35; shift >= 0; shift -= 5) {
    code += kLetters[(bits >> static_cast<unsigned>(shift)) & 31U];
    if (shift == 20) code += '-';
  }
  return code;
}

/// A new key from the system's own random numbers.
Result<void> makeKey(const fs::path& file) {
  Pseudonyms::Key key{};
  if (::getentropy(key.data(), key.size()) != 0)
    return failure(ErrorCode::internal, say<"The system gives no random numbers for the key of the pseudonyms; try again.">(),
                   {{"file", file.string()}});
  return writePrivateFile(file, hexOf(key) + "\n");
}

Result<Pseudonyms::Key> readKey(const fs::path& file) {
  constexpr std::size_t kLongest_bytes = 1000;
  auto text = readPrivateFile(file, kLongest_bytes);
  if (!text && text.error().code != ErrorCode::tooLarge) return passOn(text.error());
  if (text && text->ends_with('\n')) text->pop_back();
  if (const auto key = text ? bytesOfHex<Pseudonyms::kKey_bytes>(*text) : std::nullopt) return *key;
  return failure(
      ErrorCode::badHeader,
      say<"'%1' is not the key of the pseudonyms; restore it from a copy, or move it away: everybody then gets other codes.">(file),
      {{"file", file.string()}});
}

}  // namespace

std::string keyedHash(std::span<const std::byte> key, std::string_view text) {
  std::array<std::byte, kBlock_bytes> inner{}, outer{};
  std::vector<std::byte> used(key.begin(), key.end());
  if (used.size() > kBlock_bytes) {
    Sha256 shorter;
    shorter.add(key);
    const auto digest = *bytesOfHex<kDigest_bytes>(shorter.hex());
    used.assign(digest.begin(), digest.end());
  }
  std::copy(used.begin(), used.end(), inner.begin());
  outer = inner;
  for (std::byte& each : inner) each ^= std::byte{0x36};
  for (std::byte& each : outer) each ^= std::byte{0x5c};
  Sha256 first, second;
  first.add(inner);
  first.add(std::as_bytes(std::span(text)));
  second.add(outer);
  second.add(*bytesOfHex<kDigest_bytes>(first.hex()));
  return second.hex();
}

fs::path pseudonymKeyFile(const fs::path& library) { return library / "assessment" / "pseudonyms.key"; }

Result<Pseudonyms> Pseudonyms::ofLibrary(const fs::path& library) {
  const fs::path file = pseudonymKeyFile(library);
  const auto isThere = [&] {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(file, ignored));
  };
  if (!isThere()) {
    const auto lock = assessment::lockFolder(file.parent_path());
    if (!lock) return passOn(lock.error());
    if (!isThere())  // nor has another window made it meanwhile
      if (auto made = makeKey(file); !made) return passOn(made.error());
  }
  const auto key = readKey(file);
  if (!key) return passOn(key.error());
  return Pseudonyms(*key);
}

std::string Pseudonyms::ofPerson(std::string_view person) const { return "T-" + codeOf(keyedHash(key_, "person:" + std::string(person))); }
std::string Pseudonyms::ofReviewer(std::string_view person) const { return "R" + ofPerson(person).substr(1); }

}  // namespace ew
