#pragma once

#include <cstdint>
#include <optional>

namespace ew {

/// Memory that a volume, or the work on one, may take unless somebody says otherwise: a forecast above it is refused before it is taken.
inline constexpr std::uint64_t kLargestVolume_bytes = std::uint64_t{16} << 30;

/// Memory the system can give now, with what it only keeps of files; empty where it does not say.
[[nodiscard]] std::optional<std::uint64_t> availableMemory_bytes();

}  // namespace ew
