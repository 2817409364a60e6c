#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <span>

#include "ew/core/result.h"

namespace ew {

/// Writes stereo sound as WAV (RIFF, PCM of 16 bits, little endian), complete or not at all.
/// @param samples left and right, -1..1; what is louder is cut off @param rate_hz 1..192000
/// @error tooLarge (more than 4 GiB), notWritable
[[nodiscard]] Result<void> writeSound(std::span<const glm::vec2> samples, int rate_hz, const std::filesystem::path& file);

}  // namespace ew
