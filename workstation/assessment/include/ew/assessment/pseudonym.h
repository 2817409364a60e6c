#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "ew/core/result.h"

namespace ew {

/// HMAC-SHA256 (RFC 2104) of a text. @return 64 hexadecimal digits in small letters
[[nodiscard]] std::string keyedHash(std::span<const std::byte> key, std::string_view text);

/// LIBRARY/assessment/pseudonyms.key
[[nodiscard]] std::filesystem::path pseudonymKeyFile(const std::filesystem::path& library);

/// Short codes in place of names, the same for the life of a library and of no use without its key: two libraries call one person
/// differently. A code has 40 bits of a keyed hash (Crockford's base 32, no I, L, O, U): of 10,000 attempts two share one in 1 of 20,000
/// libraries (decision 0057).
class Pseudonyms {
 public:
  static constexpr std::size_t kKey_bytes = 32;
  using Key = std::array<std::byte, kKey_bytes>;
  explicit Pseudonyms(const Key& key) : key_(key) {}
  /// With the library's key, which is made at the first call: random, in a file of mode 600, written whole or not at all (private_file.h).
  /// @error notReadable (another account's, or others may read it), badHeader (no key: it is never replaced, since all codes would change),
  ///        notWritable
  [[nodiscard]] static Result<Pseudonyms> ofLibrary(const std::filesystem::path& library);

  /// Of a person as they call themselves, wherever attempts are shown, reported, recorded or exported: "T-9DC4-XB0M".
  /// @param person Attempt::person; everybody without a name has the code of the empty one
  [[nodiscard]] std::string ofPerson(std::string_view person) const;
  /// Of who rates and comments: the same letters behind another first one, "R-9DC4-XB0M", so that nobody is taken for a trainee.
  [[nodiscard]] std::string ofReviewer(std::string_view person) const;

 private:
  Key key_;
};

}  // namespace ew
