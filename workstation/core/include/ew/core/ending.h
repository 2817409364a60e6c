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

}  // namespace ew
