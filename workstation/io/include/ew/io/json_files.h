#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <utility>
#include <vector>

#include "ew/core/result.h"

namespace ew {

/// A file that is one JSON object.
/// @param where how sentences name it: say<"the measurement package %1">(file.string())
/// @error notFound, notReadable, tooLarge (more than maxBytes), badHeader (not JSON, with line and column)
[[nodiscard]] Result<nlohmann::json> readJsonFile(const std::filesystem::path& file, const Message& where, std::size_t maxBytes = 4u << 20);

/// The .json files right in a folder, by name.
/// @param what it is the folder of, in words: say<"measurement packages">() @error notFound, notReadable
[[nodiscard]] Result<std::vector<std::filesystem::path>> jsonFilesIn(const std::filesystem::path& folder, const Message& what);

/// Reads every .json file of a folder; a file that cannot be read is an error, not a gap.
/// @error as jsonFilesIn and `read`
template <class Value>
[[nodiscard]] Result<std::vector<Value>> readEvery(const std::filesystem::path& folder, const Message& what,
                                                   Result<Value> (*read)(const std::filesystem::path&)) {
  const auto files = jsonFilesIn(folder, what);
  if (!files) return passOn(files.error());
  std::vector<Value> values;
  for (const std::filesystem::path& file : *files) {
    auto value = read(file);
    if (!value) return passOn(value.error());
    values.push_back(std::move(*value));
  }
  return values;
}

}  // namespace ew
