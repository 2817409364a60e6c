#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/result.h"

namespace ew::assessment {

// A folder of files that are added and never changed: 0001.json, 0002.json and on.

struct SeriesFile {
  int number = 0;
  std::filesystem::path file;
};
/// By rising number; empty files, which a killed program claimed and did not fill, are left out.
[[nodiscard]] std::vector<SeriesFile> numberedFiles(const std::filesystem::path& folder);

/// Adds a file under the next number, whole or not at all; two programs at once get two numbers. Makes the folder.
/// @error notWritable
[[nodiscard]] Result<SeriesFile> addNumbered(const std::filesystem::path& folder, std::string_view text);

}  // namespace ew::assessment
