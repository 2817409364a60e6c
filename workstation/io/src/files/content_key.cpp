#include "ew/io/content_key.h"

#define XXH_STATIC_LINKING_ONLY  // for a state that needs no memory of its own
#include <xxhash.h>

#include <array>
#include <bit>
#include <cstdio>
#include <fstream>
#include <vector>

namespace ew {
namespace {

constexpr std::size_t kDigits = 32;
constexpr std::size_t kShortPart_bytes = 256;
constexpr std::size_t kFileChunk_bytes = 1u << 20;

std::string digitsOf(const XXH128_hash_t& hash) {
  std::array<char, kDigits + 1> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return digits.data();
}

/// The bytes of a number are the same on every machine: the lowest first.
std::array<char, 8> bytesOfNumber(std::uint64_t number) {
  std::array<char, 8> bytes{};
  for (char& byte : bytes) {
    byte = static_cast<char>(number & 0xff);
    number >>= 8;
  }
  return bytes;
}

}  // namespace

void ContentKey::part(char kind, const void* bytes, std::size_t count) {
  collected_ += kind;
  const auto length = bytesOfNumber(count);
  collected_.append(length.data(), length.size());
  if (count <= kShortPart_bytes) {
    collected_.append(static_cast<const char*>(bytes), count);
  } else {
    collected_ += digitsOf(XXH3_128bits(bytes, count));
  }
}

ContentKey& ContentKey::add(std::span<const std::uint8_t> bytes) {
  part('b', bytes.data(), bytes.size());
  return *this;
}

ContentKey& ContentKey::add(std::string_view text) {
  part('t', text.data(), text.size());
  return *this;
}

ContentKey& ContentKey::add(std::uint64_t number) {
  const auto bytes = bytesOfNumber(number);
  part('n', bytes.data(), bytes.size());
  return *this;
}

ContentKey& ContentKey::add(double number) {
  const auto bytes = bytesOfNumber(std::bit_cast<std::uint64_t>(number));
  part('d', bytes.data(), bytes.size());
  return *this;
}

ContentKey& ContentKey::add(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) add(matrix[column][row]);
  return *this;
}

std::string ContentKey::text() const { return digitsOf(XXH3_128bits(collected_.data(), collected_.size())); }

bool isContentKey(std::string_view text) {
  return text.size() == kDigits && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string contentOf(std::span<const std::byte> bytes) { return digitsOf(XXH3_128bits(bytes.data(), bytes.size())); }

Result<std::optional<std::string>> contentOf(const std::filesystem::path& file, const Progress& progress) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::optional<std::string>();
  XXH3_state_t state;
  XXH3_128bits_reset(&state);
  std::vector<char> chunk(kFileChunk_bytes);
  while (in) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Reading was cancelled.">());
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    if (in.gcount() > 0) XXH3_128bits_update(&state, chunk.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad())
    return failure(ErrorCode::notReadable, say<"\"%1\" cannot be read; check the medium it is on.">(file.string()),
                   {{"file", file.string()}});
  return std::optional(digitsOf(XXH3_128bits_digest(&state)));
}

}  // namespace ew
