#pragma once

#include <cstddef>
#include <vector>

#include "ew/core/message.h"

namespace ew::registration {

inline constexpr std::size_t kMostNames = 8;  ///< a sentence that names more is not read

/// "a, b and c"; of more than `most` names the rest is counted.
[[nodiscard]] Message listed(std::vector<Message> names, std::size_t most = kMostNames);

}  // namespace ew::registration
