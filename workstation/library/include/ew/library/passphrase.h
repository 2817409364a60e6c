#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "ew/core/result.h"

namespace ew {

/// Words that a person remembers. Its bytes are wiped when it ends; it is never written anywhere, and no error names it.
class Passphrase {
 public:
  Passphrase() = default;
  explicit Passphrase(std::string words) : words_(std::move(words)) {}
  ~Passphrase();
  Passphrase(const Passphrase&) = default;
  Passphrase(Passphrase&& other) noexcept;
  Passphrase& operator=(const Passphrase&) = delete;
  Passphrase& operator=(Passphrase&&) = delete;
  [[nodiscard]] std::string_view words() const { return words_; }
  [[nodiscard]] bool empty() const { return words_.empty(); }

 private:
  std::string words_;
};

inline constexpr std::size_t kShortestPassphrase = 8;  ///< characters
inline constexpr std::size_t kLongestPassphrase_bytes = 1000;

/// What trying one passphrase costs whoever guesses (Argon2id, RFC 9106; libsodium's crypto_pwhash).
struct PassphraseCost {
  std::uint64_t passes = 3;
  std::uint64_t memory_bytes = 256ull << 20;
  bool operator==(const PassphraseCost&) const = default;
};

/// Whether a new passphrase will do: long enough, not too long, no control characters. @error badUsage
[[nodiscard]] Result<void> checkNewPassphrase(const Passphrase& passphrase);

/// A text by which a passphrase is recognised and from which it cannot be read: Argon2id with a salt of its own.
/// @error tooLarge (no memory for it)
[[nodiscard]] Result<std::string> hashOf(const Passphrase& passphrase, const PassphraseCost& cost = {});
/// Whether a passphrase is the one of a hash; a text that is no hash fits none.
[[nodiscard]] bool fits(const Passphrase& passphrase, const std::string& hash);

}  // namespace ew
