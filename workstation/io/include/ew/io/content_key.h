#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ew/core/frames.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// A name for everything that shapes a result, one part after the other: XXH3 of 128 bits. Parts say of what kind and how long they are, so
/// that ("ab", "c") is not ("a", "bc"), nor the number 1 the text "1". No protection against malice.
class ContentKey {
 public:
  ContentKey& add(std::span<const std::uint8_t> bytes);
  ContentKey& add(std::string_view text);
  ContentKey& add(const char* text) { return add(std::string_view(text)); }
  ContentKey& add(const std::string& text) { return add(std::string_view(text)); }
  ContentKey& add(std::uint64_t number);
  ContentKey& add(int number) { return add(static_cast<std::uint64_t>(static_cast<std::int64_t>(number))); }
  ContentKey& add(bool yes) { return add(static_cast<std::uint64_t>(yes)); }
  ContentKey& add(double number);  ///< every bit of it
  ContentKey& add(const glm::dvec3& v) { return add(v.x).add(v.y).add(v.z); }
  ContentKey& add(const glm::dmat4& matrix);
  template <class To, class From>
  ContentKey& add(const Transform<To, From>& t) {
    return add(t.matrix);
  }
  [[nodiscard]] std::string text() const;  ///< 32 hexadecimal digits

 private:
  void part(char kind, const void* bytes, std::size_t count);
  std::string collected_;  ///< of long parts their XXH3
};

/// Whether a text could be that of a key: 32 hexadecimal digits, in small letters.
[[nodiscard]] bool isContentKey(std::string_view text);

/// The name of what a file holds; that of the same bytes in memory is the same.
[[nodiscard]] std::string contentOf(std::span<const std::byte> bytes);
/// @return empty when the file cannot be opened
/// @error notReadable, cancelled
[[nodiscard]] Result<std::optional<std::string>> contentOf(const std::filesystem::path& file, const Progress& progress);

}  // namespace ew
