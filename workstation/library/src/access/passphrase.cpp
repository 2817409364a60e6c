#include "ew/library/passphrase.h"

#include <algorithm>

#include "access/sodium_ready.h"

namespace ew {

Result<void> readySodium() {
  static const int ready = ::sodium_init();
  if (ready >= 0) return {};
  return failure(ErrorCode::internal, say<"The system gives no random numbers to make keys from; restart it, and please report it.">());
}

std::string base64Of(std::span<const std::uint8_t> bytes) {
  std::string text(sodium_base64_ENCODED_LEN(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
  ::sodium_bin2base64(text.data(), text.size(), bytes.data(), bytes.size(), sodium_base64_VARIANT_ORIGINAL);
  text.resize(text.size() - 1);  // its final zero
  return text;
}

bool fromBase64(const std::string& text, std::span<std::uint8_t> bytes) {
  std::size_t count = 0;
  const char* end = nullptr;
  return ::sodium_base642bin(bytes.data(), bytes.size(), text.data(), text.size(), nullptr, &count, &end, sodium_base64_VARIANT_ORIGINAL) ==
             0 &&
         count == bytes.size() && end == text.data() + text.size();
}

tl::unexpected<Error> noMemoryFor(const PassphraseCost& cost) {
  return failure(
      ErrorCode::tooLarge,
      say<"There are not the %1 MiB of memory that a passphrase needs; close other programs and try again.">(cost.memory_bytes >> 20));
}

Passphrase::~Passphrase() { ::sodium_memzero(words_.data(), words_.size()); }

Passphrase::Passphrase(Passphrase&& other) noexcept
    : words_(other.words_) {  // NOLINT(performance-move-constructor-init): a short text is copied even when it is moved
  ::sodium_memzero(other.words_.data(), other.words_.size());
  other.words_.clear();
}

Result<void> checkNewPassphrase(const Passphrase& passphrase) {
  const std::string_view words = passphrase.words();
  const auto isContinued = [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; };  // of a UTF-8 character
  const auto characters =
      static_cast<std::size_t>(words.size()) - static_cast<std::size_t>(std::count_if(words.begin(), words.end(), isContinued));
  if (characters < kShortestPassphrase)
    return failure(ErrorCode::badUsage,
                   say<"The passphrase is too short; take at least %1 characters, best several words.">(kShortestPassphrase));
  const bool hasControl = std::any_of(words.begin(), words.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; });
  if (words.size() > kLongestPassphrase_bytes || hasControl)
    return failure(ErrorCode::badUsage,
                   say<"The passphrase is longer than %1 bytes or holds characters that cannot be typed; take another one.">(
                       kLongestPassphrase_bytes));
  return {};
}

Result<std::string> hashOf(const Passphrase& passphrase, const PassphraseCost& cost) {
  if (auto ready = readySodium(); !ready) return passOn(ready.error());
  std::string hash(crypto_pwhash_STRBYTES, '\0');
  const auto words = passphrase.words();
  if (::crypto_pwhash_str(hash.data(), words.data(), words.size(), cost.passes, cost.memory_bytes) != 0) return noMemoryFor(cost);
  hash.resize(hash.find('\0'));
  return hash;
}

bool fits(const Passphrase& passphrase, const std::string& hash) {
  if (!readySodium() || hash.size() >= crypto_pwhash_STRBYTES || !hash.starts_with(crypto_pwhash_STRPREFIX)) return false;
  const auto words = passphrase.words();
  return ::crypto_pwhash_str_verify(hash.c_str(), words.data(), words.size()) == 0;
}

}  // namespace ew
