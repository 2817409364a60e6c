#pragma once

#include <cstdint>
#include <string_view>

namespace ew {

/// What a file held when it was read. Compared with what it holds when it is about to be written over, it tells whether somebody else has
/// written it since: by the content, because times of files are coarse, and because the same content written again is no change. Not
/// against somebody who wants two contents to look alike.
struct Fingerprint {
  std::uint64_t size_bytes = 0;
  std::uint64_t hash = 0;
  bool operator==(const Fingerprint&) const = default;
};

/// @param content the whole file, any bytes
[[nodiscard]] Fingerprint fingerprintOf(std::string_view content);

}  // namespace ew
