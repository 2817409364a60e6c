#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew::stitching {

/// A name for content: two things that differ have, but for chance of 1 in 2^100, different ones. No protection against malice.
class ContentKey {
 public:
  ContentKey& add(std::span<const std::uint8_t> bytes);
  ContentKey& add(std::string_view text);  ///< with its length, so that ("ab", "c") is not ("a", "bc")
  ContentKey& add(const char* text) { return add(std::string_view(text)); }
  ContentKey& add(const std::string& text) { return add(std::string_view(text)); }
  ContentKey& add(std::uint64_t number);
  ContentKey& add(int number) { return add(static_cast<std::uint64_t>(static_cast<std::int64_t>(number))); }
  ContentKey& add(bool yes) { return add(static_cast<std::uint64_t>(yes)); }
  ContentKey& add(double number);  ///< every bit of it
  ContentKey& add(const glm::dvec3& v) { return add(v.x).add(v.y).add(v.z); }
  ContentKey& add(const glm::dmat4& matrix);
  [[nodiscard]] std::string text() const;  ///< 32 hexadecimal digits

 private:
  std::uint64_t a_ = 0x9e3779b97f4a7c15u;
  std::uint64_t b_ = 0xc2b2ae3d27d4eb4fu;
};

/// The name of what a file holds; that of the same bytes in memory is the same.
[[nodiscard]] std::string contentOf(std::span<const std::byte> bytes);
/// @return empty when the file cannot be opened
/// @error notReadable, cancelled
[[nodiscard]] Result<std::optional<std::string>> contentOf(const std::filesystem::path& file, const Progress& progress);

}  // namespace ew::stitching
