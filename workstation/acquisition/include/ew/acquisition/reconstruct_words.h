#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "ew/acquisition/confidence.h"
#include "ew/acquisition/reconstruct.h"

namespace ew {

// The words that files and commands use for the methods of a reconstruction.
inline constexpr std::array<std::pair<const char*, Interpolation>, 3> kInterpolationWords{
    {{"nearest", Interpolation::nearest}, {"linear", Interpolation::linear}, {"centred", Interpolation::centred}}};
inline constexpr std::array<std::pair<const char*, Compounding>, 4> kCompoundingWords{
    {{"mean", Compounding::mean}, {"maximum", Compounding::maximum}, {"latest", Compounding::latest}, {"weighted", Compounding::weighted}}};
inline constexpr std::array<std::pair<const char*, FillMethod>, 2> kFillMethodWords{
    {{"sweep", FillMethod::sweep}, {"bridges", FillMethod::bridges}}};
inline constexpr std::array<std::pair<const char*, ConfidenceMethod>, 2> kConfidenceMethodWords{
    {{"beamwise", ConfidenceMethod::beamwise}, {"randomwalk", ConfidenceMethod::randomWalk}}};

/// The word of a value; every value has one.
template <class E, std::size_t N>
[[nodiscard]] const char* wordOf(const std::array<std::pair<const char*, E>, N>& words, E value) {
  return std::find_if(words.begin(), words.end(), [&](const auto& each) { return each.second == value; })->first;
}

/// The value that a word stands for; empty for any other word.
template <class E, std::size_t N>
[[nodiscard]] std::optional<E> meaningOf(const std::array<std::pair<const char*, E>, N>& words, std::string_view word) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& each) { return word == each.first; });
  return found == words.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace ew
