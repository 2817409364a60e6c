#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

namespace ew {

/// Whether a name ends so (".csv", ".seq.mha"), in whatever case of its letters A to Z: who types "sheet.CSV" wants what "sheet.csv" is.
[[nodiscard]] inline bool hasEnding(const std::filesystem::path& file, std::string_view ending) {
  const std::string name = file.filename().string();
  const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return name.size() >= ending.size() && std::equal(ending.begin(), ending.end(), name.end() - static_cast<std::ptrdiff_t>(ending.size()),
                                                    [&](char a, char b) { return lower(a) == lower(b); });
}

/// What stands behind the last point, with it, its letters A to Z in small; empty when the name has none.
[[nodiscard]] inline std::string endingOf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

}  // namespace ew
