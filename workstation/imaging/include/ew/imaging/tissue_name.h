#pragma once

#include <cstddef>

namespace ew {

/// What TissueAcoustics::name may have, in files and in the window.
inline constexpr std::size_t kLongestTissueName_bytes = 200;

}  // namespace ew
