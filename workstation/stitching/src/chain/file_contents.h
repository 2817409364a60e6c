#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew::stitching {

/// The content of files by name, size and time of change; read again only when one of these changed. Remembered in
/// FOLDER/steps/inputs.json, where only a file of this program's own is written over.
class FileContents {
 public:
  /// @param folder of the results; what it remembers may be damaged or made by anybody
  explicit FileContents(const std::filesystem::path& folder);
  /// @return empty when the file cannot be opened
  /// @error notReadable, cancelled
  [[nodiscard]] Result<std::optional<std::string>> keyOf(const std::filesystem::path& file, const Progress& progress);
  /// Remembers what was read. Without room nothing is remembered, and nothing is lost.
  void save();

 private:
  std::filesystem::path memory_;
  nlohmann::json known_ = nlohmann::json::object();
  bool isForeign_ = false;  ///< somebody else's file has the name
  bool changed_ = false;
};

}  // namespace ew::stitching
