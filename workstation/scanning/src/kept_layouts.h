#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "ew/imaging/layout_times.h"

namespace ew {

/// What was timed on this processor with the instruction set in use, for volumes of about as many bytes (to a factor of two); nothing when
/// it was not, is damaged or of another format.
[[nodiscard]] std::optional<LayoutTimes> readLayoutTimes(const std::filesystem::path& folder, std::uint64_t volume_bytes);

/// Keeps it for the next time. What cannot be kept is measured again.
void keepLayoutTimes(const std::filesystem::path& folder, std::uint64_t volume_bytes, const LayoutTimes& times);

}  // namespace ew
