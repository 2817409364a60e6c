#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "ew/core/contract.h"

namespace ew {

/// The word of each value of an enumeration, as files, commands and reports have it; JsonFields::word reads by it.
template <class E, std::size_t N>
using WordTable = std::array<std::pair<const char*, E>, N>;

/// The word of `value`, which stands in the table.
template <class E, std::size_t N>
[[nodiscard]] constexpr const char* wordIn(const WordTable<E, N>& words, E value) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& each) { return each.second == value; });
  EW_EXPECTS(found != words.end());
  return found == words.end() ? "" : found->first;
}

/// The value that `word` stands for; empty for any other word.
template <class E, std::size_t N>
[[nodiscard]] constexpr std::optional<E> meaningIn(const WordTable<E, N>& words, std::string_view word) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& each) { return word == each.first; });
  return found == words.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace ew
