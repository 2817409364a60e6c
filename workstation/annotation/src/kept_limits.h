#pragma once

#include <cstddef>

namespace ew::annotation {

// Of files: what is longer or more is a mistake.
inline constexpr std::size_t kLongestTitle = 80;  // bytes
inline constexpr std::size_t kMostRegions = 20;

}  // namespace ew::annotation
