#include "logic/content_key.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <vector>

namespace ew::stitching {
namespace {

/// The finaliser of splitmix64 (public domain): each bit in changes half the bits out.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

constexpr std::size_t kChunk_bytes = 1u << 20;  ///< of a file, named one after the other

}  // namespace

ContentKey& ContentKey::add(std::uint64_t number) {
  a_ = mixed(a_ ^ number);
  b_ = mixed(std::rotl(b_, 23) + number * 0x9fb21c651e98df25u);
  return *this;
}

ContentKey& ContentKey::add(std::span<const std::uint8_t> bytes) {
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, 8);
    add(word);
  }
  std::uint64_t rest = 0;
  for (int shift = 0; at < bytes.size(); ++at, shift += 8) rest |= static_cast<std::uint64_t>(bytes[at]) << shift;
  return add(rest).add(static_cast<std::uint64_t>(bytes.size()));
}

ContentKey& ContentKey::add(std::string_view text) {
  return add(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

ContentKey& ContentKey::add(double number) { return add(std::bit_cast<std::uint64_t>(number)); }

ContentKey& ContentKey::add(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) add(matrix[column][row]);
  return *this;
}

std::string ContentKey::text() const {
  char digits[33] = {};
  std::snprintf(digits, sizeof digits, "%016llx%016llx", static_cast<unsigned long long>(a_), static_cast<unsigned long long>(b_));
  return digits;
}

std::string contentOf(std::span<const std::byte> bytes) {
  ContentKey key;
  for (std::size_t at = 0; at < bytes.size(); at += kChunk_bytes) {
    const auto chunk = bytes.subspan(at, std::min(kChunk_bytes, bytes.size() - at));
    key.add(std::span(reinterpret_cast<const std::uint8_t*>(chunk.data()), chunk.size()));
  }
  return key.text();
}

Result<std::optional<std::string>> contentOf(const std::filesystem::path& file, const Progress& progress) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::optional<std::string>();
  ContentKey key;
  std::vector<char> chunk(kChunk_bytes);
  while (in) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "The stitching was cancelled.");
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    if (in.gcount() > 0) key.add(std::span(reinterpret_cast<const std::uint8_t*>(chunk.data()), static_cast<std::size_t>(in.gcount())));
  }
  if (in.bad())
    return failure(ErrorCode::notReadable, "\"" + file.string() + "\" cannot be read; check the medium it is on.",
                   {{"file", file.string()}});
  return std::optional(key.text());
}

}  // namespace ew::stitching
