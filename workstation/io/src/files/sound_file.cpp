#include "ew/io/sound_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>

#include "ew/core/contract.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

constexpr std::uint32_t kChannels = 2, kBytesOfSample = 2, kHead_bytes = 44;
constexpr std::uint64_t kMost_bytes = 0xFFFFFFFFULL - kHead_bytes;

/// @param bytes how many of the lowest, the first one first
void put(std::string& text, std::uint32_t value, int bytes) {
  for (int n = 0; n < bytes; ++n) text += static_cast<char>(value >> (8 * n) & 0xFFU);
}

std::string headOf(std::uint32_t rate_hz, std::uint32_t sound_bytes) {
  constexpr std::uint32_t kFormat_bytes = 16, kPcm = 1;
  std::string head = "RIFF";
  put(head, sound_bytes + kHead_bytes - 8, 4);
  head += "WAVEfmt ";
  put(head, kFormat_bytes, 4);
  put(head, kPcm, 2);
  put(head, kChannels, 2);
  put(head, rate_hz, 4);
  put(head, rate_hz * kChannels * kBytesOfSample, 4);
  put(head, kChannels * kBytesOfSample, 2);
  put(head, 8 * kBytesOfSample, 2);
  head += "data";
  put(head, sound_bytes, 4);
  return head;
}

}  // namespace

Result<void> writeSound(std::span<const glm::vec2> samples, int rate_hz, const std::filesystem::path& file) {
  EW_EXPECTS(rate_hz >= 1 && rate_hz <= 192000);
  if (samples.size() * std::uint64_t{kChannels * kBytesOfSample} > kMost_bytes)
    return failure(ErrorCode::tooLarge, say<"%1 would have more than 4 GiB of sound, which a WAV cannot hold; give a shorter time.">(file));
  return writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    std::string bytes =
        headOf(static_cast<std::uint32_t>(rate_hz), static_cast<std::uint32_t>(samples.size() * kChannels * kBytesOfSample));
    for (const glm::vec2& both : samples)
      for (const float side : {both.x, both.y}) {
        const float kept = std::isfinite(side) ? std::clamp(side, -1.0F, 1.0F) : 0.0F;
        put(bytes, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(32767.0F * kept))), kBytesOfSample);
      }
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return {};
  });
}

}  // namespace ew
