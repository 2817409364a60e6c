#pragma once

#include <cstdint>
#include <filesystem>

#include "ew/core/result.h"

namespace ew {

/// Below this share of the pixels or of the frames a result is asked about: a clip, a region or times that were understood wrongly leave
/// little, and what is left looks like a result.
inline constexpr double kLeastKeptShare = 0.1;

/// How much of a recording a result keeps.
struct Retention {
  std::uint64_t pixels = 1;  ///< of each image
  std::uint64_t pixelsOf = 1;
  std::uint64_t frames = 1;
  std::uint64_t framesOf = 1;
  bool operator==(const Retention&) const = default;
};

/// What there is to ask about, as a sentence; empty where enough is kept.
/// @param name of the recording, as in "liver.igs.mha"
[[nodiscard]] Message questionAbout(const Retention& kept, const std::filesystem::path& name);

/// Refuses a result that keeps too little and that nobody said yes to.
/// @error unsupported, with the context entry "ask": "accept-small"
[[nodiscard]] Result<void> checkKept(const Retention& kept, bool accepted, const std::filesystem::path& name);

}  // namespace ew
