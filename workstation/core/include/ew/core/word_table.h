#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "ew/core/contract.h"

namespace ew {

/// The word of each value of an enumeration that counts from 0, as files, commands and reports have it; JsonFields::word reads by it.
template <class E, std::size_t N>
using WordTable = std::array<std::pair<const char*, E>, N>;

/// Whether an enumerator has this value: compilers write "E::name" for one, and "(E)7" for any other value.
template <auto kValue>
[[nodiscard]] consteval bool isEnumerator() {
  return std::string_view(__PRETTY_FUNCTION__).find("kValue = (") == std::string_view::npos;
}

/// The word of `value`. Each enumerator stands in the table once: one that is added later does not compile until it has its word.
template <class E, std::size_t N>
[[nodiscard]] constexpr const char* wordIn(const WordTable<E, N>& words, E value) {
  static_assert(isEnumerator<static_cast<E>(N - 1)>() && !isEnumerator<static_cast<E>(N)>(), "a value has no word, or a word no value");
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
